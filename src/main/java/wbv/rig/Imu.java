package wbv.rig;

import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.rig.platform.Seeds;

/**
 * One inertial sensor: it turns the motion of its place into its own axes with a small error of attitude, limits bandwidth and
 * range, averages down to the output rate, adds bias, drift and noise, and loses packets.
 *
 * <p>A channel {@code acc} has gravity removed as a sensor with an attitude filter does it: the filter knows how the segment
 * turns but for a constant error, through which g·sin(tilt) leaks. A channel {@code accg} is the specific force in the axes of
 * the sensor, which turn with the segment; a channel {@code mag} is the field of the earth in those axes, a channel
 * {@code force} that of a force plate between seat and sitter, in the axes of the world and on a wire. Every channel has its own noise,
 * every sensor its own tilt and its own losses.
 */
final class Imu {

    /** The field of the earth: north ahead, and up by 64° as in south-eastern Australia (assumed). */
    private static final double[] EARTH = {StrictMath.cos(Math.toRadians(64)), 0, StrictMath.sin(Math.toRadians(64))};

    private final int place;
    private final Pickup[] channels;
    private final RotationVector fixed = new RotationVector();
    private final RotationVector turning = new RotationVector();
    private final double[] tilt = new double[2];
    private final double[] world = new double[3];
    private final double[] free = new double[3];
    private final double[] specific = new double[3];
    private final double[] rate = new double[3];
    private final double[] field = new double[3];
    private final boolean turns;
    private final PacketLoss loss;

    /**
     * @param place    index of the place in the plant
     * @param location its name
     * @param wanted   channels of a recording; those of other places are passed over
     * @param seeds    of the whole experiment
     */
    Imu(int place, String location, List<Channel> wanted, ImuErrors errors, Effects effects, AntiAlias filter, double rate,
            double h, Seeds seeds) {
        this.place = place;
        Seeds own = seeds.of("imu " + location);
        RandomGenerator mount = own.source("tilt");
        if (effects.has(Effect.TILT)) {
            tilt[0] = errors.tilt() * mount.nextGaussian();
            tilt[1] = errors.tilt() * mount.nextGaussian();
        }
        fixed.set(tilt[0], tilt[1], 0);
        Supplier<Decimator> decimators = filter.decimators(1 / (rate * h));
        channels = IntStream.range(0, wanted.size())
                .filter(i -> wanted.get(i).location().equals(location))
                .mapToObj(i -> new Pickup(i, wanted.get(i), errors, effects, decimators, filter, rate, h, own))
                .toArray(Pickup[]::new);
        boolean seesTheWorldTurn = false;
        for (Pickup channel : channels) {
            seesTheWorldTurn |= channel.kind == Quantity.SPECIFIC_FORCE || channel.kind == Quantity.MAGNETIC_FIELD;
        }
        turns = seesTheWorldTurn;
        loss = new PacketLoss(effects.has(Effect.LOSS) ? errors.lossShare() : 0, errors.lossBurst(), own.source("loss"));
    }

    /** One inner step. */
    void sense(Plant plant) {
        if (channels.length == 0) {
            return;
        }
        PlaceMotion motion = plant.motion(place);
        world[0] = motion.acceleration[0];
        world[1] = motion.acceleration[1];
        world[2] = motion.acceleration[2] + ImuErrors.GRAVITY;
        fixed.turn(world, free);
        free[2] -= ImuErrors.GRAVITY;
        fixed.turn(motion.rate, rate);
        if (turns) {
            turning.set(motion.angle[0] + tilt[0], motion.angle[1] + tilt[1], motion.angle[2]);
            turning.turn(world, specific);
            turning.turn(EARTH, field);
        }
        for (Pickup channel : channels) {
            switch (channel.kind) {
                case ACCELERATION -> channel.accept(free[channel.axis], motion.acceleration[channel.axis]);
                case SPECIFIC_FORCE -> channel.accept(specific[channel.axis], specific[channel.axis]);
                case MAGNETIC_FIELD -> channel.accept(field[channel.axis], field[channel.axis]);
                case FORCE -> channel.accept(plant.seatForce()[channel.axis], plant.seatForce()[channel.axis]);
                default -> channel.accept(rate[channel.axis], motion.rate[channel.axis]);
            }
        }
    }

    /**
     * The output of one instant, put where the channels stand in the recording.
     *
     * @param fraction where the instant lies in the last inner step
     * @param row measured values, NaN if lost. Modified.
     * @param clean    what an ideal sensor would have given. Modified.
     * @param offset index of the first channel in both
     */
    void take(double fraction, double[] row, double[] clean, int offset) {
        boolean lost = loss.next();
        for (Pickup channel : channels) {
            double value = channel.take(fraction);
            row[offset + channel.index] = lost && channel.kind != Quantity.FORCE ? Double.NaN : value;
            clean[offset + channel.index] = channel.ideal.take(fraction);
        }
    }

    /** The constant errors of this sensor, by name: tilt about x and y [rad], bias of every channel in its unit. */
    void describe(Map<String, Double> into, String location) {
        if (channels.length == 0) {
            return;
        }
        into.put(location + ".tilt.x", tilt[0]);
        into.put(location + ".tilt.y", tilt[1]);
        for (Pickup channel : channels) {
            into.put(channel.name + ".bias", channel.bias);
        }
    }

    /** One channel on its way through the sensor. */
    private static final class Pickup {
        private final int index;
        private final String name;
        private final Quantity kind;
        private final int axis;
        private final double range;
        private final double bias;
        private final double noise;
        private final SlowWalk drift;
        private final double perStep;
        private final RandomGenerator random;
        private final Decimator measured;
        private final Decimator ideal;
        private final double decay;
        private final double before;
        private final double after;
        private double input = Double.NaN;
        private double output;

        Pickup(int index, Channel channel, ImuErrors errors, Effects effects, Supplier<Decimator> decimators,
                AntiAlias filter, double rate, double h, Seeds seeds) {
            this.index = index;
            this.name = channel.toString();
            this.kind = channel.quantity();
            this.axis = "xyz".indexOf(channel.axis());
            ImuErrors.Part part = part(errors);
            String own = word() + '.' + channel.axis();
            double offset = part.bias() * seeds.source("bias " + own).nextGaussian();
            this.bias = effects.has(Effect.BIAS) ? offset : 0;
            this.noise = effects.has(Effect.NOISE) ? part.noise() * Math.sqrt(filter.noiseBandwidth(rate, part.bandwidth())) : 0;
            this.drift = new SlowWalk(effects.has(Effect.DRIFT) ? part.drift() : 0, 1 / rate, seeds.source("drift " + own));
            this.perStep = effects.has(Effect.RESOLUTION) && part.step() > 0 ? Math.rint(1 / part.step()) : 0;
            this.random = seeds.source("noise " + own);
            this.range = part.range();
            this.measured = decimators.get();
            this.ideal = decimators.get();
            double a = 2 * Math.PI * part.bandwidth() * h;
            decay = StrictMath.exp(-a);
            before = (1 - decay) / a - decay;
            after = 1 - (1 - decay) / a;
        }

        private ImuErrors.Part part(ImuErrors errors) {
            return switch (kind) {
                case ANGULAR_RATE -> errors.rate();
                case MAGNETIC_FIELD -> errors.field();
                case FORCE -> errors.force();
                default -> errors.acceleration();
            };
        }

        /** Both kinds of acceleration are the same sensor's. */
        private String word() {
            return kind == Quantity.SPECIFIC_FORCE ? Quantity.ACCELERATION.symbol() : kind.symbol();
        }

        void accept(double value, double truth) {
            output = Double.isNaN(input) ? value : decay * output + before * input + after * value;
            input = value;
            measured.accept(Math.max(-range, Math.min(range, output + bias)));
            ideal.accept(truth);
        }

        double take(double fraction) {
            double value = measured.take(fraction) + drift.next() + noise * random.nextGaussian();
            // Dividing by a whole number gives the double nearest to a short decimal; + 0.0 makes -0 a 0.
            return perStep == 0 ? value : Math.rint(value * perStep) / perStep + 0.0;
        }
    }
}
