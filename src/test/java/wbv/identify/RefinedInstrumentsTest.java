package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Continuous time: against bodies whose answer is known in closed form. */
class RefinedInstrumentsTest {

    @ParameterizedTest
    @ValueSource(doubles = {20, 10})
    void aBodyIsFoundWithoutBias(double decibel) {
        int seeds = 8;
        double frequency = 0;
        double damping = 0;
        double error = 0;
        for (int seed = 0; seed < seeds; seed++) {
            TransferFit fit = new RefinedInstruments(2, 1, 30).fit(KnownSystem.body(5, 0.35, decibel, 3600, seed));
            assertTrue(fit.converged());
            Pole pole = fit.model().poles().modes().get(0);
            frequency += pole.frequency() / seeds;
            damping += pole.damping() / seeds;
            error += fit.deviations()[0] / (2 * 2 * Math.PI * 5) / seeds; // of a1 = 2ζω, as one of ζ
        }
        assertEquals(0.35, damping, 4 * error / Math.sqrt(seeds) + 0.01,
                "a sampled input straight between samples costs a little");
        assertEquals(5, frequency, 0.05);
    }

    @Test
    void aModelOfItsOwnIsRecoveredWithItsInitialState() {
        TransferModel truth = new TransferModel(new double[] {20, 1500}, new double[][] {{20, 1500}, {1, -3, 40}});
        double[] initial = {0.02, 1.5};
        double[][] u = {KnownSystem.input(900, new Well19937c(1)), KnownSystem.input(900, new Well19937c(2))};
        double[] y = truth.simulate(u, 60, initial);
        TransferFit fit = new RefinedInstruments(2, 2, 30).fit(new Samples(60, u, y));
        assertArrayEquals(truth.a(), fit.model().a(), 1e-4);
        assertArrayEquals(new double[] {0, 20, 1500}, fit.model().b()[0], 1e-4);
        assertArrayEquals(truth.b()[1], fit.model().b()[1], 1e-4);
        assertArrayEquals(initial, fit.initial(), 1e-6);
    }

    @Test
    void noiseOfTheOutputBiasesPlainLeastSquaresButNotInstruments() {
        double plain = 0;
        double refined = 0;
        for (int seed = 0; seed < 6; seed++) {
            Samples samples = KnownSystem.body(5, 0.35, 10, 3600, 50 + seed);
            plain += new PredictionError(new Orders(2, 3, 0, 0)).fit(samples).model().poles().modes().stream()
                    .mapToDouble(Pole::damping).max().orElse(1) / 6;
            refined += new RefinedInstruments(2, 1, 30).fit(samples).model().poles().modes().get(0).damping() / 6;
        }
        assertTrue(Math.abs(plain - 0.35) > 5 * Math.abs(refined - 0.35), plain + " against " + refined);
    }

    @Test
    void modulusIsTheClosedForm() {
        double w = 2 * Math.PI * 5;
        TransferModel body = new TransferModel(new double[] {0.7 * w, w * w}, new double[][] {{0.7 * w, w * w}});
        assertEquals(Math.hypot(1, 0.7) / 0.7, body.modulus(0, 5), 1e-12);
        assertEquals(1, body.modulus(0, 0), 1e-12);
    }

    @Test
    void pulseAndStepAreExact() {
        // 1/(s+2): pulse e^(-2t); a ramp's answer t/2 - 1/4 + e^(-2t)/4 is exact, for a ramp is straight between samples.
        CompanionForm filter = new CompanionForm(new double[] {2}, 0.1);
        double[] ramp = new double[50];
        for (int k = 0; k < ramp.length; k++) {
            ramp[k] = 0.1 * k;
        }
        for (int k = 0; k < ramp.length; k++) {
            double t = 0.1 * k;
            assertEquals(Math.exp(-2 * t), filter.pulse(50)[0][k], 1e-13);
            assertEquals(t / 2 - 0.25 + Math.exp(-2 * t) / 4, filter.filter(ramp)[0][k], 1e-13);
        }
    }

    @Test
    void polesOfBothPlanesAreSortedByWhatTheyAre() {
        // (s+3)(s²+2s+26): one decay, one mode at -1±5j
        PoleSet set = PoleSet.ofContinuous(new double[] {5, 32, 78});
        assertEquals(1, set.modes().size());
        assertEquals(-1, set.modes().get(0).re(), 1e-9);
        assertEquals(5, set.modes().get(0).im(), 1e-9);
        assertEquals(-3, set.decays().get(0), 1e-9);
        // z = 0.5, -0.5 and 0.9·e^(±0.4j): ln maps the first to a decay, the second nowhere, the pair to a mode
        double re = 2 * 0.9 * Math.cos(0.4);
        PoleSet discrete = PoleSet.ofDiscrete(new double[] {-re, 0.81 - 0.25, 0.25 * re, -0.25 * 0.81}, 10);
        assertEquals(1, discrete.mapless());
        assertEquals(10 * Math.log(0.5), discrete.decays().get(0), 1e-9);
        assertEquals(4, discrete.modes().get(0).im(), 1e-9);
        assertEquals(10 * Math.log(0.9), discrete.modes().get(0).re(), 1e-9);
        assertEquals(1, PoleSet.ofContinuous(new double[] {-2, 26}).growing().size());
    }
}
