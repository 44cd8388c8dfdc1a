package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import wbv.diagnosis.Bench;
import wbv.diagnosis.search.Search;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** The part of a bench's recording on which much is tried first. */
class ShakenPartTest {

    private static final Channel PUSH = Channel.parse("mass.force.z");
    private static final Channel ACCELERATION = Channel.parse("mass.acc.z");
    private static final double RATE = 200;
    /** Of 2.2 kg on 7 kN/m [Hz]. */
    private static final double GIVEN = Math.sqrt(7000 / 2.2) / (2 * Math.PI);

    @Test
    void aLongOneOfABenchIsItsBeginning() {
        Evidence part = evidence(40).brief().orElseThrow();
        int length = (int) (144 * RATE / GIVEN);
        assertEquals(length, part.recording().length());
        assertEquals(length, part.fit().start() + part.fit().length(), 0.02 * length, "nearly to its last sample");
        Fitter.State base = new Search(part, (step, share) -> {}).base(Baseline.of(part));
        // It begins where the bench did, so that the motion before it needs no explanation.
        assertTrue(base.reduced() < 1.2, "leaves " + base.reduced());
    }

    @Test
    void aShortOneHasNone() {
        assertTrue(evidence(6).brief().isEmpty());
    }

    private static Evidence evidence(double seconds) {
        Random random = new Random(1);
        DoubleUnaryOperator push = Bench.tones(60, 1, 1.49, 2.5, random);
        Bench bench = new Bench(RATE, seconds, 50, 2).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 * x[0] - 25 * v[0]);
        Recording recording = bench.recording(PUSH, bench.sampled(push), ACCELERATION,
                Bench.noisyBy(0.02, bench.sampled(bench.acceleration(0)), random));
        return new Evidence(Bench.oscillator(2.2, 7000, 30, ACCELERATION), recording);
    }
}
