package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.diagnosis.Bench;
import wbv.diagnosis.search.Search;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** How noisy a sensor is on a bench that is shaken in all of the band: no band of what it reads is quiet, what a fit leaves is. */
class NoiseBesideTest {

    private static final Channel PUSH = Channel.parse("mass.force.z");
    private static final Channel ACCELERATION = Channel.parse("mass.acc.z");
    private static final double PART = 0.02;

    private record Told(double noise, Evidence asRead, Optional<Evidence> beside) {}

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void itIsReadFromWhatAFitLeaves(long seed) {
        Told told = told((x, v) -> 0, seed);
        assertTrue(told.asRead().noise()[0] > 5 * told.noise(), told.toString());
        // The least of thirteen bands of five blocks scatters by a sixth.
        assertEquals(told.noise(), told.beside().orElseThrow().noise()[0], 0.35 * told.noise());
    }

    /** What is missing may be taken for noise, and noise never for what is missing. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void itIsNoLessWhereALawIsMissing(long seed) {
        Told told = told((x, v) -> 3 * Math.tanh(v / 0.01), seed);
        assertTrue(told.beside().orElse(told.asRead()).noise()[0] > 0.65 * told.noise(), told.toString());
    }

    private interface Extra {
        double force(double x, double v);
    }

    private static Told told(Extra extra, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(60, 1, 1.49, 2.5, random);
        Bench bench = new Bench(200, 6, 50, 2)
                .run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 * x[0] - 25 * v[0] - extra.force(x[0], v[0]));
        double[] exact = bench.sampled(bench.acceleration(0));
        Recording recording = bench.recording(PUSH, bench.sampled(push), ACCELERATION, Bench.noisyBy(PART, exact.clone(), random));
        Evidence evidence = new Evidence(Bench.oscillator(2.2, 7000, 30, ACCELERATION), recording);
        Fitter.State base = new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
        return new Told(PART * Bench.rms(exact), evidence, evidence.beside(base));
    }
}
