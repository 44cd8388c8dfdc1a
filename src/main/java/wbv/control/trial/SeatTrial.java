package wbv.control.trial;

import java.util.Optional;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.control.ApparentSitter;
import wbv.control.FollowedSitter;
import wbv.control.OptimalSeat;
import wbv.control.PassiveSeat;
import wbv.control.SeatCommand;
import wbv.control.SeatController;
import wbv.control.SeatHardware;
import wbv.control.SeatReadings;
import wbv.control.SitterSource;
import wbv.control.ToldSitter;
import wbv.exposure.Cascade;
import wbv.exposure.Weighting;
import wbv.rig.Subject;
import wbv.rig.platform.Seeds;

/** One ride on one seat: the plant a thousand times a second, the controller every fourth of them. */
public final class SeatTrial {

    /** Steps of the plant in one of the controller. */
    private static final int EVERY = (int) (SuspendedPerson.RATE / SeatController.RATE);
    private static final int RING = 128;
    /** Noise of the accelerometers [m/s²], of the deflection [m] and of the spring's force [N], each reading by itself; assumed. */
    private static final double ACCELERATION_NOISE = 0.03;
    private static final double DEFLECTION_NOISE = 2e-4;
    private static final double FORCE_NOISE = 5;
    private static final double MILD = 800;

    private final SeatHardware hardware;
    private final Ride ride;

    /** A ride to be ridden. */
    public SeatTrial(SeatHardware hardware, Ride ride) {
        this.hardware = hardware;
        this.ride = ride;
    }

    /** Hears every instant of the judged part of a ride. */
    @FunctionalInterface
    public interface Listener {

        /** Hears nothing. */
        Listener NONE = (time, floor, seat, deflection, weightedSeat, weightedFloor) -> {};

        /**
         * Once a step of the controller.
         *
         * @param time since the judged part began [s]
         * @param floor acceleration [m/s²]
         * @param seat likewise
         * @param deflection [m]
         * @param weightedSeat acceleration [m/s²]
         * @param weightedFloor likewise
         */
        void hear(double time, double floor, double seat, double deflection, double weightedSeat, double weightedFloor);
    }

    /**
     * A ride with a controller that knows so much.
     *
     * @param tuning in the unit of the family
     */
    public TrialResult run(Maker maker, ControllerFamily family, Knowledge knowledge, double tuning) {
        return run(maker, family, knowledge, tuning, Listener.NONE);
    }

    /** The same, heard. */
    public TrialResult run(Maker maker, ControllerFamily family, Knowledge knowledge, double tuning, Listener listener) {
        SitterSource source = maker.source(knowledge, ride.sitter());
        Optional<ToldSitter> told = knowledge == Knowledge.ORACLE && source instanceof ToldSitter sitter ? Optional.of(sitter)
                : Optional.empty();
        return new Run(family.controller(maker, tuning, source), source, told, 1).play(listener);
    }

    /**
     * A ride with a controller that is told of the sitter wrongly.
     *
     * @param tuning in the unit of the family
     * @param wrong factor on the masses, the natural frequency and the damping ratio that are told
     */
    public TrialResult runMisled(Maker maker, ControllerFamily family, double tuning, double wrong) {
        ToldSitter source = new ToldSitter(Maker.apparent(ride.sitter()).times(wrong, wrong, wrong));
        return new Run(family.controller(maker, tuning, source), source, Optional.of(source), wrong).play(Listener.NONE);
    }

    /**
     * Lets an estimator hear a ride on a passive seat.
     *
     * @return factor on the sitter's stiffness at its end
     */
    double calibrate(FollowedSitter reading) {
        Run run = new Run(new PassiveSeat(hardware, MILD), reading, Optional.empty(), 1);
        run.listens = true;
        run.play(Listener.NONE);
        return run.seat.person().stiffnessFactor();
    }

    private final class Run {

        private final SeatController controller;
        private final SitterSource source;
        private final Optional<ToldSitter> told;
        private final double wrong;
        private final SuspendedPerson seat = new SuspendedPerson(hardware, ride.sitter());
        private final SeatReadings readings = new SeatReadings();
        private final SeatCommand command = new SeatCommand();
        private final double[] askedDamping = new double[RING];
        private final double[] askedForce = new double[RING];
        private final RandomGenerator noise = new Seeds(ride.seed()).source("sensors");
        private final RandomGenerator losses = new Seeds(ride.seed()).source("losses");
        private final Cascade floorWeighting = Weighting.WK.filter().cascade(SuspendedPerson.RATE);
        private final Cascade seatWeighting = Weighting.WK.filter().cascade(SuspendedPerson.RATE);
        private final Cascade headWeighting = Weighting.WK.filter().cascade(SuspendedPerson.RATE);
        private Subject subject = ride.sitter();
        private ApparentSitter truth;
        private boolean listens;
        private double damping;
        private double force;
        private double floorSquare;
        private double seatSquare;
        private double headSquare;
        private double deflectionSum;
        private double deflectionSquare;
        private double most;
        private double work;
        private double forceSquare;

        Run(SeatController controller, SitterSource source, Optional<ToldSitter> told, double wrong) {
            this.controller = controller;
            this.source = source;
            this.told = told;
            this.wrong = wrong;
            this.truth = Maker.apparent(subject).times(wrong, wrong, wrong);
        }

        TrialResult play(Listener listener) {
            int settle = (int) Math.round(ride.settle() * SuspendedPerson.RATE);
            int judged = (int) Math.round(ride.seconds() * SuspendedPerson.RATE);
            int delay = (int) Math.round((hardware.delay() + ride.faults().delay()) * SuspendedPerson.RATE);
            long change = ride.faults().change().map(c -> settle + Math.round(c.at() * SuspendedPerson.RATE)).orElse(-1L);
            double[] floor = floor(settle, judged);
            int hitsBefore = 0;
            double before = 0;
            for (int i = 0; i < floor.length; i++) {
                if (i == change) {
                    seat.seat(ride.faults().change().orElseThrow().to());
                }
                if (i % EVERY == 0) {
                    sense(before, (double) (i - settle) / SuspendedPerson.RATE);
                    tell(i);
                    controller.step(readings, command);
                    if (listens) {
                        source.hear(readings);
                    }
                }
                if (i == settle) {
                    hitsBefore = seat.hits();
                }
                askedDamping[i % RING] = command.damping();
                askedForce[i % RING] = command.force();
                int past = Math.max(0, i - delay) % RING;
                double share = SuspendedPerson.STEP / hardware.lag();
                damping += share * (askedDamping[past] - damping);
                force += share * (askedForce[past] - force);
                seat.step(before, floor[i], damping, force);
                before = floor[i];
                judge(i - settle, floor[i], listener);
            }
            double n = judged;
            double mean = deflectionSum / n;
            boolean believes = controller instanceof OptimalSeat;
            return new TrialResult(Math.sqrt(seatSquare / floorSquare), Math.sqrt(headSquare / floorSquare),
                    Math.sqrt(Math.max(0, deflectionSquare / n - mean * mean)), most, seat.hits() - hitsBefore, work / n,
                    Math.sqrt(forceSquare / n), Math.sqrt(floorSquare / n), believes ? source.rigid() + source.moving() : Double.NaN,
                    believes ? source.frequency() : Double.NaN, believes ? source.damping() : Double.NaN);
        }

        private double[] floor(int settle, int judged) {
            double[] floor = ride.floor().ride(settle + judged, new Seeds(ride.seed()).source("floor"));
            int every = (int) (Ride.JOLT_EVERY * SuspendedPerson.RATE);
            int length = (int) (Ride.JOLT_LENGTH * SuspendedPerson.RATE);
            for (int i = 0; i < floor.length; i++) {
                int into = (i + every / 2) % every;
                floor[i] = ride.scale() * floor[i] + (into < length ? ride.jolt() * Math.sin(2 * Math.PI * into / length) : 0);
            }
            return floor;
        }

        /** The oracle hears every tenth of a second how soft its sitter is. */
        private void tell(int i) {
            if (told.isEmpty() || i % (SuspendedPerson.RATE / 10) != 0) {
                return;
            }
            if (!seat.person().subject().equals(subject)) {
                subject = seat.person().subject();
                truth = Maker.apparent(subject).times(wrong, wrong, wrong);
            }
            told.get().tell(truth, Math.sqrt(seat.person().stiffnessFactor()));
        }

        private void sense(double floor, double time) {
            readings.set(reading(Faults.Sensor.FLOOR, floor, ACCELERATION_NOISE, time),
                    reading(Faults.Sensor.FRAME, seat.frame(), ACCELERATION_NOISE, time),
                    reading(Faults.Sensor.DEFLECTION, seat.deflection(), DEFLECTION_NOISE, time),
                    reading(Faults.Sensor.SPRING, seat.spring(), FORCE_NOISE, time),
                    reading(Faults.Sensor.TRUNK, seat.trunk(), ACCELERATION_NOISE, time));
        }

        private double reading(Faults.Sensor sensor, double truth, double deviation, double time) {
            double value = truth + deviation * noise.nextGaussian();
            boolean silent = ride.faults().silence().isPresent() && ride.faults().silence().get().sensor() == sensor
                    && time >= ride.faults().silence().get().from();
            boolean lost = ride.faults().loss() > 0 && losses.nextDouble() < ride.faults().loss();
            return silent || lost ? Double.NaN : value;
        }

        private void judge(int i, double floor, Listener listener) {
            double weightedFloor = floorWeighting.step(floor);
            double weightedSeat = seatWeighting.step(seat.seat());
            double weightedHead = headWeighting.step(seat.head());
            if (i < 0) {
                return;
            }
            floorSquare += weightedFloor * weightedFloor;
            seatSquare += weightedSeat * weightedSeat;
            headSquare += weightedHead * weightedHead;
            deflectionSum += seat.deflection();
            deflectionSquare += seat.deflection() * seat.deflection();
            most = Math.max(most, Math.abs(seat.deflection()));
            work += Math.max(0, force * seat.rate());
            forceSquare += force * force;
            if (i % EVERY == 0) {
                listener.hear((double) i / SuspendedPerson.RATE, floor, seat.seat(), seat.deflection(), weightedSeat, weightedFloor);
            }
        }
    }
}
