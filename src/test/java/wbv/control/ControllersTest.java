package wbv.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import wbv.exposure.Weighting;

class ControllersTest {

    private static final SeatHardware SEAT = SeatHardware.ASSUMED;
    private static final ApparentSitter MIDDLE = new ApparentSitter(5, 60, 5, 0.35);
    private static final FloorBand FLOOR = new FloorBand(2.2, 0.3, 1.7);

    private static SitterPrior prior() {
        return SitterPrior.wide(MIDDLE, 4.8, 0.35);
    }

    /** Two seconds of shaking in which a third of all readings is lost, then silence of everything. */
    private static void shake(SeatController controller, int samples, SeatReadings readings, SeatCommand command, RandomGenerator random,
            boolean silent) {
        for (int i = 0; i < samples; i++) {
            double t = i / SeatController.RATE;
            double swing = Math.sin(2 * Math.PI * 2.2 * t);
            readings.set(lost(3 * swing, random, silent), lost(-2 * swing + random.nextGaussian(), random, silent),
                    lost(0.02 * swing, random, silent), lost(780 - 120 * swing, random, silent), lost(-2.2 * swing, random, silent));
            controller.step(readings, command);
            assertTrue(command.damping() >= SEAT.leastDamping() && command.damping() <= SEAT.mostDamping(),
                    () -> "damping " + command.damping());
            assertTrue(Math.abs(command.force()) <= SEAT.mostForce(), () -> "force " + command.force());
        }
    }

    private static double lost(double value, RandomGenerator random, boolean silent) {
        return silent || random.nextInt(3) == 0 ? Double.NaN : value;
    }

    private static List<SeatController> all() {
        return List.of(new PassiveSeat(SEAT, 500), new SkyhookSeat(SEAT, SkyhookSeat.Kind.CONTINUOUS, 1500), new SkyhookSeat(SEAT,
                SkyhookSeat.Kind.ON_OFF, 900),
                new OptimalSeat(SEAT, OptimalSeat.Drive.DAMPER, OptimalSeat.Aim.MEAN, FLOOR, 0.4, new FollowedSitter(SEAT, prior())),
                new OptimalSeat(SEAT, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.MEAN, FLOOR, 0.4, new FollowedSitter(SEAT, prior())),
                new OptimalSeat(SEAT, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.WORST, FLOOR, 0.4, new FollowedSitter(SEAT, prior())));
    }

    @Test
    void everyControllerStaysWithinItsHardwareThroughLossesAndSilence() {
        for (SeatController controller : all()) {
            shake(controller, 500, new SeatReadings(), new SeatCommand(), new Well19937c(1), false);
            shake(controller, 500, new SeatReadings(), new SeatCommand(), new Well19937c(2), true);
            shake(controller, 500, new SeatReadings(), new SeatCommand(), new Well19937c(3), false);
        }
    }

    @Test
    void nothingIsAllocatedForASampleNorForANewDesign() {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        for (OptimalSeat.Aim aim : OptimalSeat.Aim.values()) {
            ToldSitter sitter = new ToldSitter(MIDDLE);
            SeatController controller = new OptimalSeat(SEAT, OptimalSeat.Drive.ACTUATOR, aim, FLOOR, 0.4, sitter);
            SeatReadings readings = new SeatReadings();
            SeatCommand command = new SeatCommand();
            ApparentSitter other = MIDDLE.times(0.8, 0.9, 1);
            run(controller, readings, command, sitter, other, 400);
            run(controller, readings, command, sitter, MIDDLE, 400);
            long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
            run(controller, readings, command, sitter, other, 2000);
            long bytes = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
            assertTrue(bytes < 2000, bytes + " bytes in 2000 samples and a design");
        }
    }

    private static void run(SeatController controller, SeatReadings readings, SeatCommand command, ToldSitter sitter, ApparentSitter who,
            int samples) {
        sitter.tell(who, 1);
        for (int i = 0; i < samples; i++) {
            double swing = Math.sin(0.05 * i);
            readings.set(swing, -swing, 0.01 * swing, 780, swing);
            controller.step(readings, command);
        }
    }

    @Test
    void aSilentFrameMakesItAPassiveSeat() {
        for (OptimalSeat.Drive drive : OptimalSeat.Drive.values()) {
            SeatController controller = new OptimalSeat(SEAT, drive, OptimalSeat.Aim.MEAN, FLOOR, 0.4, new ToldSitter(MIDDLE));
            SeatCommand command = new SeatCommand();
            SeatReadings readings = new SeatReadings();
            for (int i = 0; i < 30; i++) {
                readings.set(1, Double.NaN, 0.01, 780, 1);
                controller.step(readings, command);
            }
            assertEquals(OptimalSeat.RESERVE, command.damping());
            assertEquals(0, command.force());
        }
    }

    @Test
    void aSilentFloorMakesADamperAPassiveSeatAndLeavesTheActuatorToWork() {
        SeatCommand damper = new SeatCommand();
        SeatCommand actuator = new SeatCommand();
        SeatController clipped = new OptimalSeat(SEAT, OptimalSeat.Drive.DAMPER, OptimalSeat.Aim.MEAN, FLOOR, 0.4, new ToldSitter(MIDDLE));
        SeatController active = new OptimalSeat(SEAT, OptimalSeat.Drive.ACTUATOR, OptimalSeat.Aim.MEAN, FLOOR, 0.4, new ToldSitter(MIDDLE));
        SeatReadings readings = new SeatReadings();
        for (int i = 0; i < 30; i++) {
            readings.set(Double.NaN, 1, 0.01, 780, 1);
            clipped.step(readings, damper);
            active.step(readings, actuator);
        }
        assertEquals(OptimalSeat.RESERVE, damper.damping());
        assertTrue(actuator.force() != 0);
    }

    /** Karnopp's rule: pulled only while frame and suspension move the same way. */
    @Test
    void skyhookDampsWhereItPullsTowardsTheSky() {
        SkyhookSeat seat = new SkyhookSeat(SEAT, SkyhookSeat.Kind.ON_OFF, 1200);
        SeatReadings readings = new SeatReadings();
        SeatCommand command = new SeatCommand();
        double w = 2 * Math.PI * 2;
        int right = 0;
        int all = 0;
        for (int i = 0; i < 2500; i++) {
            double t = i / SeatController.RATE;
            // the frame swings with velocity sin, the suspension's rate is 60° ahead of it
            double frame = Math.sin(w * t);
            double rate = 0.2 * Math.sin(w * t + Math.PI / 3);
            double rateSlope = 0.2 * w * Math.cos(w * t + Math.PI / 3);
            readings.set(w * Math.cos(w * t) - rateSlope, w * Math.cos(w * t), -0.2 / w * Math.cos(w * t + Math.PI / 3), 780, 0);
            seat.step(readings, command);
            if (i > 1250) {
                all++;
                right += (command.damping() == 1200) == (frame * rate > 0) ? 1 : 0;
            }
        }
        assertTrue(right > 0.85 * all, right + " of " + all + "; the integration forgets below 0.3 Hz, which turns its phase by some 15°");
    }

    /** The mass is weighed; where nothing was heard, the middle sitter is believed in. */
    @Test
    void aFollowedSitterIsWeighedAndElseTheMiddleOne() {
        FollowedSitter sitter = new FollowedSitter(SEAT, prior());
        assertEquals(MIDDLE.moving(), sitter.moving());
        assertEquals(MIDDLE.frequency(), sitter.frequency());
        SeatReadings readings = new SeatReadings();
        double light = 45;
        for (int i = 0; i < 2500; i++) {
            readings.set(Double.NaN, Double.NaN, Double.NaN, 9.80665 * (SEAT.frameMass() + light) + 100 * Math.sin(0.05 * i), Double.NaN);
            sitter.hear(readings);
        }
        assertEquals(light, sitter.rigid() + sitter.moving(), 3);
        assertTrue(sitter.rigid() + sitter.moving() > light, "drawn towards the middle sitter by what friction may hide");
        assertEquals(MIDDLE.frequency(), sitter.frequency());
    }

    @Test
    void onlyAnActuatorThatSingsLosesAuthority() {
        SingingGuard ride = new SingingGuard();
        SingingGuard song = new SingingGuard();
        for (int i = 0; i < 500; i++) {
            ride.hear(180 * Math.sin(2 * Math.PI * 2.2 * i / SeatController.RATE));
            song.hear(song.authority() * 180 * Math.sin(2 * Math.PI * 22 * i / SeatController.RATE));
        }
        assertEquals(1, ride.authority());
        assertTrue(song.authority() < 0.5, "authority " + song.authority());
    }

    /** The design's weighting against the exact one, over the band in which seats are judged. */
    @Test
    void weightingOfSecondOrderIsNearWk() {
        double[] w = SeatModel.WEIGHTING;
        for (double f = 1; f <= 20; f += 0.5) {
            double s = 2 * Math.PI * f;
            double modulus = Math.hypot(w[0], w[1] * s) / Math.hypot(w[2] - s * s, w[3] * s);
            assertEquals(Weighting.WK.factor(f), modulus, 0.1, "at " + f + " Hz");
        }
    }

    /** The closed loop of the design's own model dies out. */
    @ParameterizedTest
    @EnumSource(OptimalSeat.Aim.class)
    void theDesignHoldsItsOwnSeatAtRest(OptimalSeat.Aim aim) {
        SeatModel model = new SeatModel(SEAT, FLOOR, 0.4);
        SeatDesign design = aim == OptimalSeat.Aim.MEAN ? new MeanDesign(model, SEAT.leastDamping())
                : new WorstDesign(model, OptimalSeat.BESIDE);
        OptimalGains gains = new OptimalGains();
        design.begin(new ToldSitter(MIDDLE));
        while (!design.advance()) {
            // a doubling at a time
        }
        assertTrue(design.ready());
        gains.take(model, design);
        gains.correct(0.03, 2, -1);
        assertTrue(Math.abs(gains.force()) > 1, "a seat off its middle asks for a force");
        for (int i = 0; i < 5000; i++) {
            gains.foresee(gains.force());
        }
        assertEquals(0, gains.force(), 1e-6);
    }

    /**
     * A damper that is late does not grasp at a rate that will have turned: the same mean force, but none of the spikes where the rate is
     * nothing.
     */
    @Test
    void aLateDamperAsksForNoMoreThanTheRateWillGive() {
        RelativeMotion motion = new RelativeMotion(SEAT);
        SeatReadings readings = new SeatReadings();
        double w = 2 * Math.PI * 7.6;
        double most = 0;
        for (int i = 0; i < 2500; i++) {
            double swing = Math.sin(w * i / SeatController.RATE);
            readings.set(0, 2 * swing, -2 * swing / (w * w), 780, 0);
            motion.step(readings);
            most = i < 1250 ? 0 : Math.max(most, Math.abs(motion.damping(100)));
        }
        double sigma = (SEAT.delay() + SEAT.lag()) * 2 / Math.sqrt(2);
        assertEquals(100 / (2 * sigma), most, 0.1 * 100 / (2 * sigma), "v / (v² + σ²) is 1 / (2 σ) at most");
    }
}
