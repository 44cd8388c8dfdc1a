package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** A bench whose force is measured with noise that nobody declared: by itself, and beside a law that does as little. */
class InputNoiseAloneTest {

    private static final Channel PUSH = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");
    private static final double PART = 0.005;

    private final Set<String> steps = new HashSet<>();

    /** @param softening by which part of its stiffness the spring of 8 kN/m is softer at 10 mm */
    private Diagnosis diagnosis(double softening, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        Bench bench = new Bench(200, 30, 50, 2).run((t, x, v, out) -> out[0] = push.applyAsDouble(t)
                - 8000 * x[0] * (1 - softening * x[0] * x[0] / 1e-4) - 25 * v[0]);
        Recording recording = bench.recording(PUSH, Bench.noisyBy(PART, bench.sampled(push), random), POSITION,
                Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random));
        Model model = Bench.oscillator(2, 8000, 25, POSITION);
        return Diagnoser.diagnose(model, recording, (step, share) -> steps.add(step));
    }

    @Test
    void byItselfItIsToldWithoutASearch() {
        Diagnosis diagnosis = diagnosis(0, 1);
        assertTrue(diagnosis.verdict().isQuiet(), diagnosis.sentence());
        assertTrue(diagnosis.sentence().contains("N of mass.force.z count as noise"), diagnosis.sentence());
        assertFalse(steps.contains("refitting"), steps.toString());
    }

    @Tag("slow")
    @Test
    void aLawThatDoesAsLittleIsNamedBesideIt() {
        Diagnosis diagnosis = diagnosis(0.02, 2);
        assertEquals(Diagnosis.Verdict.MISSING_PHYSICS, diagnosis.verdict(), diagnosis.sentence());
        assertEquals("stiffness.softening", diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
    }
}
