package wbv.rig.concealed;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.rig.ImuErrors;
import wbv.rig.platform.Seeds;

/**
 * A recording whose outputs have nothing to do with its input: the platform's sensor is on one ride, the sitter on another one or on a seat
 * that stands still, and moves as people do. The model is that of the sitter, as its user believes it to be. From such a recording nothing
 * can be learned of the model.
 */
final class Unrelated {

    private static final Channel FORCE = new Channel("mass", Quantity.FORCE, 'z');
    private static final Channel MOTION = new Channel("mass", Quantity.ACCELERATION, 'z');
    private static final double SHORTEST = 15;
    private static final double LONGEST = 60;
    /** Whole parts of {@link UniformSeries#RATE} [Hz]. */
    private static final double[] RATES = {60, 120, 240, 480};
    /** Part of the rides that hardly have more than one frequency, as a soft suspension leaves: chance makes the most of those. */
    private static final double NARROW = 0.5;
    /** Part of the recordings in which only verticals were recorded. */
    private static final double VERTICAL = 0.4;
    /** Root mean square of what a sitter does of his own accord while he does it [N]: a shift of weight, a reach, a nod to music. */
    private static final double LEAST = 4;
    private static final double MOST = 60;

    private Unrelated() {}

    static ConcealedCase make(ConcealedSpec spec) {
        Seeds seeds = new Seeds(spec.seed());
        RandomGenerator random = seeds.source("recording");
        OptionalDouble seconds = OptionalDouble.of(Math.rint(SHORTEST + (LONGEST - SHORTEST) * random.nextDouble()));
        double rate = RATES[random.nextInt(RATES.length)];
        if (spec.words().contains("unrelated.bench")) {
            return bench(spec, seconds.getAsDouble(), rate, seeds);
        }
        boolean all = random.nextDouble() >= VERTICAL;
        boolean boxcar = random.nextBoolean();
        boolean narrow = random.nextDouble() < NARROW;
        double beat = Math.pow(4, random.nextDouble());
        RideScene ride = ride(spec, seconds, narrow, beat, seeds.of("ride"));
        RideScene other = ride(spec, seconds, narrow, beat, seeds.of("sitter"));
        RideScene sitter = spec.words().contains("unrelated.rest") ? other.still() : other;
        int length = Math.min(ride.shaking().length(), sitter.shaking().length());
        Setup setup = new Setup(sitter.chain());
        RandomGenerator body = seeds.source("stirring");
        double newtons = sitter.setting().leastForce + (sitter.setting().mostForce - sitter.setting().leastForce) * body.nextDouble();
        setup.push(sitter.chain().body("torso"), Concealer.stirring(sitter.shaking().length(), newtons, body));
        double moving = LEAST * Math.pow(MOST / LEAST, body.nextDouble());
        double[] band = narrow ? new double[] {beat / 2, 2 * beat} : new double[] {0.2, 3};
        setup.push(sitter.chain().body("torso"), moving(sitter.shaking().length(), band, moving, body));
        Imus onRide = new Imus(ride, boxcar, rate);
        Imus onSitter = new Imus(sitter, boxcar, rate);
        Map<String, double[][]> sent = new LinkedHashMap<>(onSitter.sent(setup, sitter.play(setup), seeds.of("sensors")));
        Setup calm = new Setup(ride.chain());
        sent.put(Chain.PLATFORM, onRide.sent(calm, ride.calm(), seeds.of("platform")).get(Chain.PLATFORM));
        Map<String, double[][]> clean = new LinkedHashMap<>(onSitter.clean(setup, sitter.play(setup)));
        clean.put(Chain.PLATFORM, onRide.clean(calm, ride.calm()).get(Chain.PLATFORM));
        int rows = (int) (length * rate / UniformSeries.RATE);
        String model = Concealer.user(sitter.chain(), spec.exact(), seeds.source("user")).json("case " + spec.name(), sitter.blind())
                .toPrettyString() + "\n";
        return new ConcealedCase(Concealer.recording(cut(sent, rows), sitter.blind(), rate, all),
                Concealer.recording(cut(clean, rows), sitter.blind(), rate, false), model,
                key(spec, sitter, seconds.getAsDouble(), rate, newtons, moving).toPrettyString() + "\n");
    }

    /** A mass on a spring and a dashpot: a force that was recorded, and how another force moved it. */
    private static ConcealedCase bench(ConcealedSpec spec, double seconds, double rate, Seeds seeds) {
        RandomGenerator random = seeds.source("bench");
        double mass = 20 + 60 * random.nextDouble();
        double omega = 2 * Math.PI * (2 + 6 * random.nextDouble());
        Chain chain = new Chain(List.of("mass"), new int[] {-1}, new double[] {mass}, new double[] {mass * omega * omega},
                new double[] {2 * (0.1 + 0.4 * random.nextDouble()) * mass * omega});
        int length = (int) (seconds * UniformSeries.RATE);
        double newtons = 20 * Math.pow(10, random.nextDouble());
        double[] recorded = UniformSeries.lines(length, 0.5, 15, 0, newtons, seeds.source("force"));
        Setup setup = new Setup(chain);
        setup.push(0, UniformSeries.lines(length, 0.5, 15, 0, newtons, seeds.source("other force")));
        double[] moved = new ChainPlant(setup, UniformSeries.RATE, ChainPlant.COARSE).run(new double[length], UniformSeries.RATE)
                .acceleration()[0];
        int ticks = (int) (UniformSeries.RATE / rate);
        double noise = ImuErrors.TABLE_3_2.acceleration().noise() * Math.sqrt(rate / 2);
        RandomGenerator sensor = seeds.source("sensors");
        double[] force = new double[length / ticks];
        double[] clean = new double[force.length];
        double[] motion = new double[force.length];
        for (int i = 0; i < force.length; i++) {
            force[i] = recorded[i * ticks];
            clean[i] = moved[i * ticks];
            motion[i] = clean[i] + noise * sensor.nextGaussian();
        }
        ObjectNode model = Concealer.user(chain, spec.exact(), seeds.source("user")).json("case " + spec.name(), List.of());
        model.putObject("base").put("name", "ground").putNull("sensor");
        model.putArray("inputs").addObject().put("body", "mass").put("sensor", FORCE.toString());
        ((ObjectNode) model.get("bodies").get(0)).put("sensor", MOTION.toString());
        ((ObjectNode) model.get("links").get(0)).put("from", "ground");
        ObjectNode key = root(spec, seconds, rate);
        key.set("true_linear_model", model);
        return new ConcealedCase(recording(rate, Map.of(FORCE, force, MOTION, motion)),
                recording(rate, Map.of(FORCE, force, MOTION, clean)), model.toPrettyString() + "\n", key.toPrettyString() + "\n");
    }

    private static Recording recording(double rate, Map<Channel, double[]> channels) {
        return Concealer.recording(ordered(channels), rate);
    }

    private static Map<Channel, double[]> ordered(Map<Channel, double[]> channels) {
        Map<Channel, double[]> out = new LinkedHashMap<>();
        List.of(FORCE, MOTION).forEach(channel -> out.put(channel, channels.get(channel)));
        return out;
    }

    /** A ride, or one that has hardly more than a beat [Hz]. */
    private static RideScene ride(ConcealedSpec spec, OptionalDouble seconds, boolean narrow, double beat, Seeds seeds) {
        RideScene broad = RideScene.of(spec.setting(), seconds, seeds);
        if (!narrow) {
            return broad;
        }
        double[] z = UniformSeries.lines(broad.shaking().length(), 0.8 * beat, 1.25 * beat, 0, UniformSeries.rms(broad.shaking().z()),
                seeds.source("beat"));
        UniformSeries.fade(z, 1);
        return broad.shaken(z);
    }

    /**
     * Now and then, swelling and fading.
     *
     * @param band lowest and highest frequency [Hz]
     * @param newtons root mean square while it lasts
     */
    private static double[] moving(int length, double[] band, double newtons, RandomGenerator random) {
        double[] out = UniformSeries.lines(length, band[0], band[1], -0.5, newtons, random);
        double phase = 2 * Math.PI * random.nextDouble();
        double period = (4 + 8 * random.nextDouble()) * UniformSeries.RATE;
        for (int i = 0; i < length; i++) {
            out[i] *= Math.min(1, Math.max(0, 0.7 + StrictMath.sin(phase + 2 * Math.PI * i / period)));
        }
        return out;
    }

    private static Map<String, double[][]> cut(Map<String, double[][]> six, int rows) {
        Map<String, double[][]> out = new LinkedHashMap<>();
        six.forEach((place, channels) -> {
            double[][] part = new double[channels.length][];
            for (int q = 0; q < part.length; q++) {
                part[q] = Arrays.copyOf(channels[q], rows);
            }
            out.put(place, part);
        });
        return out;
    }

    private static ObjectNode key(ConcealedSpec spec, RideScene scene, double seconds, double rate, double stirring, double moving) {
        ObjectNode root = root(spec, seconds, rate);
        root.put("stirring_N", Chain.rounded(stirring)).put("moving_N", Chain.rounded(moving));
        root.set("true_linear_model", scene.chain().json("true linear part", scene.blind()));
        root.put("first_resonance_hz", Chain.rounded(scene.chain().frequencies()[0]));
        return root;
    }

    private static ObjectNode root(ConcealedSpec spec, double seconds, double rate) {
        ObjectNode root = new ObjectMapper().createObjectNode();
        root.put("case", spec.name());
        root.putArray("mechanisms");
        root.put("unrelated", spec.words().get(0)).put("seconds", seconds).put("rate_hz", rate);
        root.put("strength", spec.strength()).put("setting", spec.setting().word()).put("exact_model", spec.exact());
        // No linear chain has any part in what the outputs do.
        root.put("linear_chi2", Double.MAX_VALUE).put("seed", spec.seed());
        return root;
    }
}
