package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.LongFunction;
import org.junit.jupiter.api.Test;

/** Deviations of natural frequency and damping ratio, against closed forms and against how estimates scatter over seeds. */
class ModeDeviationsTest {

    private static final int SEEDS = 60;

    /** A mode's deviations by difference quotients of its own closed form. */
    @Test
    void slopesAreThoseOfTheClosedForm() {
        double w = 2 * Math.PI * 4;
        double z = 0.3;
        double[] a = {2 * z * w, w * w};
        double[][] covariance = {{0.04, 0.3}, {0.3, 9}};
        EquivalentBody.Mode mode = ModeDeviations.ofContinuous(a, covariance).get(0);
        assertEquals(4, mode.frequency(), 1e-12);
        assertEquals(z, mode.damping(), 1e-12);
        // f = √a₂/2π, ζ = a₁/(2√a₂)
        assertEquals(Math.sqrt(9) / (2 * w) / (2 * Math.PI), mode.frequencyDeviation(), 1e-12);
        double byFirst = 1 / (2 * w);
        double bySecond = -z / (2 * w * w);
        assertEquals(Math.sqrt(byFirst * byFirst * 0.04 + 2 * byFirst * bySecond * 0.3 + bySecond * bySecond * 9), mode.dampingDeviation(),
                1e-12);
    }

    @Test
    void thePlaneDoesNotMatter() {
        double rate = 60;
        double h = 1e-6;
        double[] a = KnownSystem.A;
        double[][] covariance = {{1e-4, 2e-5}, {2e-5, 5e-5}};
        EquivalentBody.Mode mode = ModeDeviations.ofDiscrete(a, covariance, rate).get(0);
        double[] slope = new double[2];
        for (int i = 0; i < 2; i++) {
            double[] up = a.clone();
            double[] down = a.clone();
            up[i] += h;
            down[i] -= h;
            slope[i] = (PoleSet.ofDiscrete(up, rate).modes().get(0).frequency()
                    - PoleSet.ofDiscrete(down, rate).modes().get(0).frequency()) / (2 * h);
        }
        double expected = Math.sqrt(slope[0] * slope[0] * 1e-4 + 2 * slope[0] * slope[1] * 2e-5 + slope[1] * slope[1] * 5e-5);
        assertEquals(expected, mode.frequencyDeviation(), 1e-5 * expected);
    }

    @Test
    void armaxScattersAsItSays() {
        requireHonest(seed -> new PredictionError(new Orders(2, 3, 2, 0)).fit(KnownSystem.armax(10, 1800, seed)).modes(), 5, 0.35);
    }

    /** No noise polynomial, so that errors follow each other: the textbook's deviations would be wrong, these are not. */
    @Test
    void armaxScattersAsItSaysWhereTheModelIsWrong() {
        LongFunction<List<EquivalentBody.Mode>> fit = seed -> new PredictionError(new Orders(2, 3, 0, 0))
                .fit(KnownSystem.armax(15, 3600, seed)).modes();
        double f = 0;
        double z = 0;
        for (long seed = 0; seed < SEEDS; seed++) {
            f += fit.apply(1000 + seed).get(0).frequency() / SEEDS;
            z += fit.apply(1000 + seed).get(0).damping() / SEEDS;
        }
        requireHonest(fit, f, z);
    }

    @Test
    void instrumentsScatterAsTheySay() {
        double f = 0;
        double z = 0;
        LongFunction<List<
                EquivalentBody.Mode>> fit = seed -> new RefinedInstruments(2, 1, 30).fit(KnownSystem.body(5, 0.35, 15, 1800, seed)).modes();
        for (long seed = 0; seed < SEEDS; seed++) {
            f += fit.apply(1000 + seed).get(0).frequency() / SEEDS;
            z += fit.apply(1000 + seed).get(0).damping() / SEEDS;
        }
        requireHonest(fit, f, z);
    }

    /** Errors over what is stated have a mean square of one: between 0.55 and 1.35 for 60 seeds (χ², 1 in 1000, and Student's quantile). */
    private static void requireHonest(LongFunction<List<EquivalentBody.Mode>> fit, double frequency, double damping) {
        double ofFrequency = 0;
        double ofDamping = 0;
        for (long seed = 0; seed < SEEDS; seed++) {
            EquivalentBody.Mode mode = fit.apply(seed).get(0);
            ofFrequency += Math.pow((mode.frequency() - frequency) / mode.frequencyDeviation(), 2) / SEEDS;
            ofDamping += Math.pow((mode.damping() - damping) / mode.dampingDeviation(), 2) / SEEDS;
        }
        assertTrue(ofFrequency > 0.55 && ofFrequency < 1.6, "frequency: " + ofFrequency);
        assertTrue(ofDamping > 0.55 && ofDamping < 1.6, "damping: " + ofDamping);
    }
}
