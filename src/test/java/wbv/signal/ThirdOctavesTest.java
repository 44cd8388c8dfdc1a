package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ThirdOctavesTest {

    /** A flat density D has √(D · 0.2308 f) in the band about f (10^0.05 - 10^-0.05 = 0.23077). */
    @Test
    void aFlatDensityRisesByTheWidthOfTheBands() {
        double[] density = new double[2001];
        Arrays.fill(density, 0.5);
        ThirdOctaves bands = ThirdOctaves.of(density, 0.02, 0.5, 25, f -> 1);
        assertEquals(-3, bands.first());
        assertEquals(18, bands.rms().length);
        for (int band = 0; band < bands.rms().length; band++) {
            assertEquals(Math.sqrt(0.5 * 0.230768 * bands.centre(band)), bands.rms()[band], 1e-4);
        }
        assertEquals(Math.sqrt(0.5 * (Math.pow(10, 1.45) - Math.pow(10, -0.35))), bands.total(), 1e-6);
    }

    @Test
    void bandsAreCalledByTheirNominalFrequencies() {
        double[] density = new double[1001];
        ThirdOctaves bands = ThirdOctaves.of(density, 0.1, 0.5, 40, f -> 1);
        double[] names = new double[bands.rms().length];
        Arrays.setAll(names, bands::nominal);
        assertArrayEquals(new double[] {1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8, 10, 12.5, 16, 20, 25, 31.5, 40}, names, 1e-12);
    }

    /** A tone of r.m.s. 0.7 at 4.1 Hz is all in the band of 4 Hz, weighted by what is said of 4.1 Hz. */
    @Test
    void aToneIsInItsBand() {
        PowerSpectrum spectrum = new PowerSpectrum(new Segmentation(60, 2048, 0.5), Detrend.MEAN);
        for (int i = 0; i < 20000; i++) {
            spectrum.accept(0.7 * Math.sqrt(2) * Math.sin(2 * Math.PI * 4.1 * i / 60));
        }
        ThirdOctaves bands = ThirdOctaves.of(spectrum.density(), 60 / 2048.0, 0.5, 23.4, f -> f < 4.5 ? 2 : 0);
        assertEquals(1.4, bands.rms()[6 - bands.first()], 1e-3);
        assertEquals(1.4, bands.total(), 1e-3);
    }
}
