package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.diagnosis.Bench;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** The noise of a force's sensor, told by what the model that is right leaves of two positions. */
class InputLevelTest {

    private static final Channel PUSH = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");
    private static final double PART = 0.005;

    private record Told(double level, double force) {}

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void whatAForceSensorAddsIsTold(long seed) {
        Told told = told(PART, seed);
        assertEquals(PART, told.level() / told.force(), 0.15 * PART);   // three standard errors, by the lines that show it
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(longs = {5, 6, 7, 8})
    void anExactOneHasNone(long seed) {
        Told told = told(0, seed);
        assertTrue(told.level() < 0.1 * PART * told.force(), told.toString());
    }

    /** @param part of the force's root mean square that its sensor adds */
    private static Told told(double part, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        Bench bench = new Bench(200, 30, 50, 2).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 * x[0] - 25 * v[0]);
        double[] force = bench.sampled(push);
        Recording recording = bench.recording(PUSH, Bench.noisyBy(part, force.clone(), random), POSITION,
                Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random));
        Model model = Bench.oscillator(2, 8000, 25, POSITION);
        Evidence evidence = new Evidence(model, recording);
        Fitter.State base = new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
        Map<Channel, Double> found = new InputLevel(evidence).of(base);
        return new Told(found.getOrDefault(PUSH, 0.0), Bench.rms(force));
    }
}
