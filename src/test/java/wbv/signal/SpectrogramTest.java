package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SpectrogramTest {

    private static final Segmentation SEGMENTS = new Segmentation(60, 64, 0.5);

    @Test
    void everyColumnOfASweepPeaksAtItsOwnFrequency() {
        Spectrogram spectrogram = new Spectrogram(SEGMENTS, Detrend.MEAN, 100);
        // 2 to 14 Hz in 200 s: f(t) = 2 + 0.06 t
        for (int n = 0; n < 12_000; n++) {
            double t = n / 60.0;
            spectrogram.accept(Math.sin(2 * Math.PI * (2 * t + 0.03 * t * t)));
        }
        assertTrue(spectrogram.columns() <= 100 && spectrogram.columns() > 50);
        for (int c = 0; c < spectrogram.columns(); c++) {
            double[] column = spectrogram.decibels(c);
            int peak = 0;
            for (int k = 1; k < column.length; k++) {
                peak = column[k] > column[peak] ? k : peak;
            }
            assertEquals(2 + 0.06 * spectrogram.time(c), SEGMENTS.frequency(peak), 1.0, "column " + c);
        }
    }

    @Test
    void levelIsThatOfTheSine() {
        Spectrogram spectrogram = new Spectrogram(SEGMENTS, Detrend.MEAN, 8);
        for (int n = 0; n < 640; n++) {
            spectrogram.accept(2 * Math.sin(2 * Math.PI * 7.5 * n / 60)); // bin 8 exactly
        }
        // Mean square 2 over the noise bandwidth of 1.5 bins
        assertEquals(10 * Math.log10(2 / SEGMENTS.resolution()), spectrogram.decibels(0)[8], 1e-9);
    }

    @Test
    void mergedColumnsHoldTheMeanPowerOfTheirSegments() {
        Spectrogram few = new Spectrogram(SEGMENTS, Detrend.MEAN, 4);
        Spectrogram many = new Spectrogram(SEGMENTS, Detrend.MEAN, 64);
        Random random = new Random(1);
        for (int n = 0; n < 32 * 17; n++) { // 16 segments: four to a column
            double value = random.nextGaussian() * (1 + n / 100);
            few.accept(value);
            many.accept(value);
        }
        assertEquals(4, few.columns());
        assertEquals(16, many.columns());
        for (int c = 0; c < 4; c++) {
            double power = 0;
            double time = 0;
            for (int i = 0; i < 4; i++) {
                power += Math.pow(10, many.decibels(4 * c + i)[5] / 10) / 4;
                time += many.time(4 * c + i) / 4;
            }
            assertEquals(10 * Math.log10(power), few.decibels(c)[5], 1e-9);
            assertEquals(time, few.time(c), 1e-9);
        }
        assertEquals(32 / 60.0, many.time(0), 1e-12); // centre of the first segment
    }

    @Test
    void segmentsWithMissingSamplesAreHoles() {
        Spectrogram spectrogram = new Spectrogram(SEGMENTS, Detrend.MEAN, 16);
        for (int n = 0; n < 320; n++) {
            spectrogram.accept(n == 40 ? Double.NaN : Math.sin(n));
        }
        double[] hole = new double[33];
        Arrays.fill(hole, Double.NaN);
        assertArrayEquals(hole, spectrogram.decibels(0));
        assertArrayEquals(hole, spectrogram.decibels(1));
        assertTrue(Double.isFinite(spectrogram.decibels(2)[3]));
    }
}
