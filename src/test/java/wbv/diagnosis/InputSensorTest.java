package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.diagnosis.search.Priors;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** What the channel of a force that drives a bench does to it, and sensors that read in steps. */
class InputSensorTest {

    private static final String PUSH = "mass.force.z";
    private static final String POSITION = "mass.pos.z";

    private interface Fault {
        double[] of(Bench bench, DoubleUnaryOperator push);
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"0.012, 1", "0.004, 2"})
    void aForceThatIsLateIsNamedAtItsOwnChannel(double delay, long seed) {
        Diagnosis d = diagnosed(0, 0, (bench, push) -> bench.sampled(t -> push.applyAsDouble(t - delay)), seed);
        isNamed(d, "sensor.delay", "delay_s", delay, 0.05);
    }

    @Tag("exam")
    @ParameterizedTest
    @CsvSource({"0.4, 3", "1.5, 4"})
    void aForceThatIsCoupledToAcIsNamedAtItsOwnChannel(double corner, long seed) {
        Diagnosis d = diagnosed(0, 0, (bench, push) -> {
            double[] force = new double[bench.position(0).length];
            Arrays.setAll(force, i -> push.applyAsDouble(i * bench.step()));
            return bench.sampled(Bench.coupled(force, bench.step(), corner));
        }, seed);
        isNamed(d, "sensor.ac-coupled", "corner_hz", corner, 0.05);
    }

    /** A force that reads two fifths too much: a model two fifths heavier, stiffer and more damped moves alike. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"5", "6"})
    void aForceOfAWrongGainIsNotToldFromTheModelsNumbers(long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = push(random);
        Bench bench = bench(push, 0);
        Recording recording = bench.recording(PUSH, bench.sampled(t -> 1.4 * push.applyAsDouble(t)), POSITION,
                Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random));
        Diagnosis d = Bench.diagnosed(Bench.oscillator(2, 8000, 25, Channel.parse(POSITION)), recording);
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, d.verdict(), d.sentence());
        assertTrue(d.sentence().contains(PUSH + " read 1.40 times the force"), d.sentence());
    }

    /** Steps of a quarter of what it measures, root mean square. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"7", "8"})
    void aSensorThatReadsInStepsIsNamed(long seed) {
        Diagnosis d = diagnosed(0, 0.25, (bench, push) -> bench.sampled(push), seed);
        assertEquals(List.of("sensor.quantised at " + POSITION), names(d), d.sentence());
        assertTrue(d.sentence().contains(" mm)"), d.sentence());
        assertTrue(d.fit().heldAfter() < Priors.SILENT, d.sentence());
    }

    @Tag("exam")
    @ParameterizedTest
    @CsvSource({"9", "10"})
    void beyondItsStepsASpringIsFound(long seed) {
        Diagnosis d = diagnosed(3e8, 0.25, (bench, push) -> bench.sampled(push), seed);
        assertEquals(List.of("sensor.quantised at " + POSITION, "stiffness.hardening at ground-mass"), names(d), d.sentence());
        assertEquals(3e8, d.missing().get(1).parameters().get("k3_N_per_m3"), 0.1 * 3e8, d.sentence());
    }

    /** What the steps of the force leave out counts as noise at the mass. */
    @ParameterizedTest
    @CsvSource({"11", "12"})
    void aForceThatIsReadInStepsIsNamedAndNoPhysics(long seed) {
        Diagnosis d = diagnosed(0, 0, (bench, push) -> stepped(bench.sampled(push), 0.25), seed);
        assertEquals(List.of("sensor.quantised at " + PUSH), names(d), d.sentence());
    }

    private static void isNamed(Diagnosis d, String mechanism, String key, double truth, double share) {
        assertEquals(List.of(mechanism + " at " + PUSH), names(d), d.sentence());
        assertEquals(truth, d.missing().get(0).parameters().get(key), share * truth, d.sentence());
    }

    private static List<String> names(Diagnosis d) {
        return d.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList();
    }

    private static double[] stepped(double[] x, double part) {
        double step = part * Bench.rms(x);
        return Arrays.stream(x).map(value -> step * Math.rint(value / step)).toArray();
    }

    private static DoubleUnaryOperator push(Random random) {
        DoubleUnaryOperator tones = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        return t -> tones.applyAsDouble(t) + 2 * Math.max(0, Math.min(1, t));
    }

    private static Bench bench(DoubleUnaryOperator push, double cubic) {
        return new Bench(200, 30, 50, 2)
                .run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 * x[0] - 25 * v[0] - cubic * x[0] * x[0] * x[0]);
    }

    /** @param steps of the position, in parts of its root mean square; 0 for 0.3 % of noise */
    private static Diagnosis diagnosed(double cubic, double steps, Fault fault, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = push(random);
        Bench bench = bench(push, cubic);
        double[] x = bench.sampled(bench.position(0));
        Recording recording = bench.recording(PUSH, fault.of(bench, push), POSITION,
                steps > 0 ? stepped(x, steps) : Bench.noisyBy(0.003, x, random));
        return Bench.diagnosed(Bench.oscillator(2 * Math.exp(0.05 * random.nextGaussian()), 8000 * Math.exp(0.05 * random.nextGaussian()),
                25 * Math.exp(0.05 * random.nextGaussian()), Channel.parse(POSITION)), recording);
    }
}
