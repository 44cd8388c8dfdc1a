package wbv.filter.drift;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.filter.model.Adaptation;

class StepTestTest {

    private static final double SLOPE = 4;

    /** Samples until it rings at innovations of this mean share of the slope, or as many as there are. */
    private static int delay(double step, int samples, long seed) {
        StepTest test = new StepTest(Adaptation.USUAL.changes());
        Random random = new Random(seed);
        for (int i = 0; i < samples; i++) {
            double slope = SLOPE * random.nextGaussian();
            if (test.hear(step * slope + random.nextGaussian(), slope)) {
                return i;
            }
        }
        return samples;
    }

    /** 5 h at 60 Hz of a body that does not change. */
    @Test
    void aBodyThatStaysIsLeftAlone() {
        assertEquals(1_080_000, delay(0, 1_080_000, 1));
    }

    /** The threshold over the information that a sample brings, δ²h²/2 on average (Wald 1947), to within the overshoot. */
    @Test
    void aStepIsHeardInTheTimeThatItsInformationTakes() {
        double sum = 0;
        for (int seed = 0; seed < 200; seed++) {
            sum += delay(seed % 2 == 0 ? 0.06 : -0.06, 10_000, seed) / 200.0;
        }
        double expected = 10 / (0.5 * 0.06 * 0.06 * SLOPE * SLOPE);
        assertEquals(expected, sum, 0.15 * expected);
    }

    @Test
    void aShockIsNoStep() {
        StepTest test = new StepTest(Adaptation.USUAL.changes());
        for (int i = 0; i < 8; i++) {
            assertTrue(!test.hear(1e9, 1e6), "rings at sample " + i);
        }
    }
}
