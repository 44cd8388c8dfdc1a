package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.diagnosis.search.Priors;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * A gear between two encoders that count from places of their own: the motor's drives it as measured, or a measured force pushes the motor.
 */
class GearTest {

    private static final Channel MOTOR = Channel.parse("motor.pos.z");
    private static final Channel LOAD = Channel.parse("load.pos.z");
    private static final Channel PUSH = Channel.parse("motor.force.z");
    private static final double STIFFNESS = 20000;
    private static final double DAMPING = 40;
    /** Where the load's encoder counts from [m]. */
    private static final double OFFSET = 0.013;

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"2e-4, 1", "2e-4, 2", "1e-4, 4"})
    void playIsNamedBehindAMeasuredMotor(double gap, long seed) {
        isPlay(Bench.diagnosed(driven(seed), behindMotor(gap, seed)), gap);
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1", "2", "3"})
    void withoutPlayNothingIsNamedBehindAMeasuredMotor(long seed) {
        Diagnosis d = Bench.diagnosed(driven(seed), behindMotor(0, seed));
        assertEquals(List.of(), d.missing(), d.sentence());
        assertTrue(d.verdict().isQuiet() && d.fit().heldAfter() < Priors.SILENT, d.sentence());
    }

    @Tag("exam")
    @ParameterizedTest
    @CsvSource({"2e-4, 1", "2e-4, 2", "1e-4, 3"})
    void playIsNamedUnderAMeasuredForce(double gap, long seed) {
        isPlay(Bench.diagnosed(pushed(seed), underForce(gap, seed)), gap);
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1", "2"})
    void withoutPlayNothingIsNamedUnderAMeasuredForce(long seed) {
        Diagnosis d = Bench.diagnosed(pushed(seed), underForce(0, seed));
        assertEquals(List.of(), d.missing(), d.sentence());
    }

    private static void isPlay(Diagnosis d, double gap) {
        assertEquals("contact.backlash at motor-load", d.missing().get(0).mechanism() + " at " + d.missing().get(0).where(), d.sentence());
        assertEquals(1, d.missing().size(), d.sentence());
        assertEquals(gap, d.missing().get(0).parameters().get("gap_m"), 0.1 * gap, d.sentence());
        assertTrue(d.fit().heldAfter() < Priors.SILENT, d.sentence() + " " + d.fit().heldAfter());
    }

    /** A number that is given a tenth wrong, more or less. */
    private static DoubleUnaryOperator wrong(long seed) {
        Random random = new Random(100 + seed);
        return value -> value * Math.exp(0.1 * random.nextGaussian());
    }

    private static Model driven(long seed) {
        DoubleUnaryOperator wrong = wrong(seed);
        return new Model("gear", Optional.empty(), 'z', new Model.Base("motor", Optional.of(MOTOR)),
                List.of(Bench.body("load", 2, Optional.of(LOAD))),
                List.of(Bench.link("motor", "load", wrong.applyAsDouble(STIFFNESS), wrong.applyAsDouble(DAMPING), Optional.empty())),
                List.of(), Optional.of(Model.Subject.RIG));
    }

    private static Model pushed(long seed) {
        DoubleUnaryOperator wrong = wrong(seed);
        return new Model("gear", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(Bench.body("motor", wrong.applyAsDouble(3), Optional.of(MOTOR)),
                        Bench.body("load", wrong.applyAsDouble(2), Optional.of(LOAD))),
                List.of(Bench.link("ground", "motor", 0, wrong.applyAsDouble(60), Optional.empty()),
                        Bench.link("motor", "load", wrong.applyAsDouble(STIFFNESS), wrong.applyAsDouble(DAMPING), Optional.empty()),
                        Bench.link("ground", "load", 0, wrong.applyAsDouble(30), Optional.empty())),
                List.of(new Model.Input("motor", PUSH)));
    }

    private static double spring(double stretch, double gap) {
        return Math.abs(stretch) <= gap ? 0 : STIFFNESS * (stretch - Math.copySign(gap, stretch));
    }

    /** 2 kg behind a motor that goes through twenty tones up to 12 Hz; 2 µm of noise, a tenth of a micrometre at the motor. */
    private static Recording behindMotor(double gap, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator motor = Bench.tones(20, 0.3, 0.61, 0.0004, random);
        DoubleUnaryOperator speed = t -> (motor.applyAsDouble(t + 1e-5) - motor.applyAsDouble(t - 1e-5)) / 2e-5;
        Bench bench = new Bench(500, 10, 40, 2)
                .run((t, x, v, out) -> out[0] = -spring(x[0] - motor.applyAsDouble(t), gap) - DAMPING * (v[0] - speed.applyAsDouble(t)));
        return bench.recording(MOTOR, Bench.noisy(bench.sampled(motor), 1e-7, random), LOAD,
                offset(Bench.noisy(bench.sampled(bench.position(0)), 2e-6, random)));
    }

    /** 3 kg and 2 kg, each with friction in oil, under thirty tones up to 12 Hz; 5 µm of noise. */
    private static Recording underForce(double gap, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(30, 0.3, 0.4, 8, random);
        Bench bench = new Bench(500, 10, 40, 3, 2).run((t, x, v, out) -> {
            double force = spring(x[1] - x[0], gap) + DAMPING * (v[1] - v[0]);
            out[0] = push.applyAsDouble(t) + force - 60 * v[0];
            out[1] = -force - 30 * v[1];
        });
        return bench.recording(PUSH, bench.sampled(push), MOTOR, Bench.noisy(bench.sampled(bench.position(0)), 5e-6, random),
                LOAD, offset(Bench.noisy(bench.sampled(bench.position(1)), 5e-6, random)));
    }

    private static double[] offset(double[] x) {
        double[] out = x.clone();
        java.util.Arrays.setAll(out, i -> x[i] + OFFSET);
        return out;
    }
}
