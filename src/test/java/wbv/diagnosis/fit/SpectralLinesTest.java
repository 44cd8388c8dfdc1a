package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A tone stands out of a whitened residual, and nothing does of noise alone. */
class SpectralLinesTest {

    private static final double RATE = 60;
    private static final Window WINDOW = new Window(120, 6000, RATE);

    /** @param tone amplitude in standard deviations of a sample */
    private static double[] residual(long seed, int outputs, double tone, double frequency) {
        Random random = new Random(seed);
        double[][] spectra = new double[outputs][];
        for (int o = 0; o < outputs; o++) {
            double[] x = new double[6400];
            Arrays.setAll(x, i -> random.nextGaussian() + tone * Math.sin(2 * Math.PI * frequency * i / RATE));
            boolean[] valid = new boolean[x.length];
            Arrays.fill(valid, true);
            spectra[o] = WINDOW.spectrum(x, valid);
        }
        double[] noise = new double[outputs];
        Arrays.fill(noise, 1);
        return new Whitening(WINDOW, noise, List.of(), 0).whiten(spectra);
    }

    @Test
    void noiseHasNone() {
        for (int seed = 0; seed < 40; seed++) {
            assertFalse(SpectralLines.standOut(residual(seed, 2 + seed % 3, 0, 1), WINDOW), "seed " + seed);
        }
    }

    @Test
    void aToneIsFoundWhereItIs() {
        double[] residual = residual(3, 3, 0.3, 7.3);
        assertTrue(SpectralLines.standOut(residual, WINDOW));
        assertEquals(7.3, SpectralLines.of(residual, WINDOW)[0], WINDOW.spacing());
    }
}
