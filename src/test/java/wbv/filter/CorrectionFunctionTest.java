package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.SimulatedSitter.Motion;
import wbv.filter.model.Spec;

class CorrectionFunctionTest {

    private static final SimulatedSitter SITTER = new SimulatedSitter(4.6, 0.33);
    private static final double NOISE = Spec.noise(SimulatedSitter.RATE);

    private static CorrectionFunction function(boolean adapts, double noise) {
        Motion motion = SITTER.steady(0.8, 2400, 5).measured(noise, 5);
        return new CorrectionFunction(Spec.at(60), motion.u(), motion.y(), adapts);
    }

    /** f pushes towards the body from every side of it, and is as good as nothing at it. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void correctionsPushTowardsTheBody(boolean adapts) {
        CorrectionFunction f = function(adapts, NOISE);
        assertTrue(f.at(4.2, 0.33).correction()[0] > 0);
        assertTrue(f.at(5.0, 0.33).correction()[0] < 0);
        assertTrue(f.at(4.6, 0.28).correction()[1] > 0);
        assertTrue(f.at(4.6, 0.39).correction()[1] < 0);
        assertTrue(Math.abs(f.at(4.6, 0.33).move()[0]) < 0.01);
        assertTrue(Math.abs(f.at(4.6, 0.33).move()[1]) < 0.01);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theyRestAtTheBodyAndNowhereElse(boolean adapts) {
        CorrectionFunction f = function(adapts, NOISE);
        for (double[] start : new double[][] {{1.5, 0.1}, {3, 0.8}, {5, 0.4}, {9, 0.15}}) {
            CorrectionFunction.Value rest = f.converge(start[0], start[1]);
            assertEquals(1, rest.frequency() / 4.6, 0.01);
            assertEquals(1, rest.damping() / 0.33, 0.02);
            assertTrue(rest.stable());
        }
    }

    /** Where the filter itself ends on the same samples is where its function is zero. */
    @Test
    void theFilterEndsWhereItsFunctionIsZero() {
        Motion motion = SITTER.steady(0.8, 6000, 5).measured(NOISE, 5);
        Estimator filter = EstimatorDesign.of(Method.EKF).estimator(new Spec(60, 5, 0.4, NOISE, NOISE, 1e-4), Silent::new);
        for (int i = 0; i < 6000; i++) {
            filter.step(motion.u()[i], motion.y()[i]);
        }
        CorrectionFunction.Value rest = new CorrectionFunction(Spec.at(60), motion.u(), motion.y(), false).converge(5, 0.4);
        assertEquals(filter.track().frequency(), rest.frequency(), 3 * filter.track().frequencyDeviation());
        assertEquals(filter.track().damping(), rest.damping(), 3 * filter.track().dampingDeviation());
    }

    @Test
    void aRecordingTooShortIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new CorrectionFunction(Spec.at(60), new double[9], new double[9],
                true));
    }
}
