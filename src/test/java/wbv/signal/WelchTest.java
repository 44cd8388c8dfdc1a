package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.DataFault;

/** Averaged spectra: {@link PowerSpectrum}, {@link CrossSpectrum}, {@link Detrend}, {@link Taper}, {@link Segmentation}. */
class WelchTest {

    /**
     * scipy 1.17.1, {@code welch, csd, coherence(x, y, fs=60, window='hann', nperseg=32, noverlap=16, detrend=…)} of
     * {@code x = sin(0.01 n²) + 0.1 (n mod 7) + 3}, {@code y = cos(0.013 n²) + 0.05 (n mod 5) + 0.5 x}, n = 0…199.
     */
    @ParameterizedTest
    @CsvSource({
        "MEAN, 0, 0.0002897096157015293, 0.0023082535794669134, -7.93733778655256e-05, 0, 0.009421136536833581",
        "MEAN, 1, 0.009666338742014157, 0.007785563255826758, 0.0033753443688468534, 0.007806312482467464, 0.9611146754344968",
        "MEAN, 11, 0.014789377005801378, 0.027527707567535885, 0.005697325635066823, -0.000989668371215889, 0.08213587217657517",
        "MEAN, 16, 0.024606443857426122, 0.02039079839881156, 0.012292278037530158, 0, 0.3011491664252384",
        "LINEAR, 0, 0.0002720259087963124, 0.002019034779740907, -0.00011618000217248537, 0, 0.02457585808558742",
        "LINEAR, 1, 0.00886708930370187, 0.006184453274245824, 0.00036270567854507864, 0.006709866490980226, 0.8234031479284187",
        "LINEAR, 5, 0.020591798583221292, 0.014851689050238244, 0.010206942393816778, 0.006616716342516234, 0.4838178071866117",
        "NONE, 0, 3.9267011569493118, 1.0958609915229767, 2.0742181248770875, 0, 0.9998285444197883",
        "NONE, 1, 1.984420564125314, 0.5295020798462287, 1.022065121960133, 0.0004058546114452298, 0.9941589249411844"})
    void densitiesAreThoseOfScipy(Detrend detrend, int bin, double xx, double yy, double yxRe, double yxIm, double coherence) {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(60, 32, 0.5), detrend, 1);
        PowerSpectrum power = new PowerSpectrum(new Segmentation(60, 32, 0.5), detrend);
        for (int n = 0; n < 200; n++) {
            double x = Math.sin(0.01 * n * n) + 0.1 * (n % 7) + 3;
            spectrum.accept(x, Math.cos(0.013 * n * n) + 0.05 * (n % 5) + 0.5 * x);
            power.accept(x);
        }
        assertEquals(11, spectrum.averaged(0));
        assertEquals(xx, spectrum.inputDensity(0)[bin], 1e-11);
        assertEquals(xx, power.density()[bin], 1e-11);
        assertEquals(yy, spectrum.outputDensity(0)[bin], 1e-11);
        assertEquals(yxRe, spectrum.crossDensity(0).re()[bin], 1e-11);
        assertEquals(yxIm, spectrum.crossDensity(0).im()[bin], 1e-11);
        assertEquals(coherence, spectrum.response(0, FrequencyResponse.Excited.USUAL).coherence()[bin], 1e-9);
    }

    @Test
    void densityOverAllFrequenciesIsTheMeanSquare() {
        Random random = new Random(1);
        PowerSpectrum spectrum = new PowerSpectrum(new Segmentation(100, 256, 0.5), Detrend.NONE);
        double squares = 0;
        int samples = 200_000;
        for (int n = 0; n < samples; n++) {
            double value = random.nextGaussian() + 3 * Math.sin(2 * Math.PI * 7.3 * n / 100);
            squares += value * value;
            spectrum.accept(value);
        }
        double integral = DoubleStream.of(spectrum.density()).sum() * 100 / 256;
        assertEquals(squares / samples, integral, 0.005 * integral);
    }

    @Test
    void outputsFedTogetherEqualOutputsFedAlone() {
        Random random = new Random(2);
        Segmentation segmentation = new Segmentation(60, 64, 0.75);
        CrossSpectrum together = new CrossSpectrum(segmentation, Detrend.MEAN, 3);
        CrossSpectrum alone = new CrossSpectrum(segmentation, Detrend.MEAN, 1);
        double[] y = new double[3];
        for (int n = 0; n < 1000; n++) {
            double x = random.nextGaussian();
            for (int i = 0; i < 3; i++) {
                y[i] = i * x + random.nextGaussian();
            }
            together.accept(x, y);
            alone.accept(x, y[2]);
        }
        assertArrayEquals(alone.crossDensity(0).im(), together.crossDensity(2).im());
        assertArrayEquals(alone.outputDensity(0), together.outputDensity(2));
    }

    @Test
    void missingSamplesCostOnlyTheSegmentsAndOutputsTheyTouch() {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(1, 8, 0.5), Detrend.NONE, 2);
        for (int n = 0; n < 32; n++) { // segments begin at 0, 4, …, 24
            spectrum.accept(n == 5 ? Double.NaN : Math.sin(n), new double[] {Math.cos(n), n == 20 ? Double.NaN : n});
        }
        assertEquals(2, spectrum.skipped(0)); // those at 0 and 4
        assertEquals(5, spectrum.averaged(0));
        assertEquals(4, spectrum.skipped(1)); // and those at 16 and 20
        assertEquals(3, spectrum.averaged(1));
        for (double density : spectrum.outputDensity(1)) {
            assertTrue(Double.isFinite(density));
        }
    }

    @Test
    void aRecordWithoutAWholeSegmentIsRefusedInWords() {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(60, 64, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < 63; n++) {
            spectrum.accept(n, n);
        }
        assertThrows(DataFault.class, () -> spectrum.response(0, FrequencyResponse.Excited.USUAL));
    }

    /** Heinzel, Rüdiger and Schilling (2002), Spectrum and spectral density estimation, section 3 and table of windows: Hann. */
    @Test
    void hannWindowHasItsPublishedBandwidthAndOverlapCorrelations() {
        Taper window = Taper.hann(1024);
        assertEquals(1.5, window.noiseBandwidth(), 1e-12);
        assertEquals(3 * 1024 / 8.0, window.power(), 1e-9);
        assertEquals(0.167, window.correlation(512), 5e-4);
        assertEquals(0.659, window.correlation(256), 5e-4);
        assertEquals(0, window.correlation(1024));
    }

    @Test
    void overlappingSegmentsCountForLessThanTheirNumber() {
        assertEquals(100, new Segmentation(60, 256, 0).independent(100), 1e-12);
        // Halves of Hann segments correlate 1/6: K / (1 + 2 (1 - 1/K) / 36)
        assertEquals(100 / (1 + 2 * 0.99 / 36), new Segmentation(60, 256, 0.5).independent(100), 1e-3);
        assertEquals(1, new Segmentation(60, 256, 0.5).independent(1));
    }

    /** Against the transform of the oscillator's impulse response times the window's autocorrelation, which is exact. */
    @ParameterizedTest
    @CsvSource({"0.1, 512", "0.1, 1024", "0.2, 512", "0.3, 256"})
    void peakBiasIsThatOfTheSmoothedResponse(double damping, int length) {
        Segmentation segmentation = new Segmentation(60, length, 0.5);
        Taper window = Taper.hann(length);
        double omega = 2 * Math.PI * 5;
        double damped = omega * Math.sqrt(1 - damping * damping);
        double[] sums = new double[4];
        for (int n = 0; n < length; n++) {
            double t = n / 60.0;
            double response = Math.exp(-damping * omega * t);
            // The resonant pole alone, seen from its own frequency: exp(-ζωt), and the conjugate pole twice the frequency away.
            double re = response * (1 - Math.cos(2 * damped * t)) * (n == 0 ? 0.5 : 1);
            double im = response * Math.sin(2 * damped * t);
            sums[0] += re;
            sums[1] += im;
            sums[2] += re * window.correlation(n);
            sums[3] += im * window.correlation(n);
        }
        double bias = Math.hypot(sums[2], sums[3]) / Math.hypot(sums[0], sums[1]) - 1;
        assertEquals(bias, segmentation.peakBias(5, damping), 0.15 * Math.abs(bias));
    }

    @Test
    void resolvingSegmentationKeepsThePromisedPeak() {
        Segmentation chosen = Segmentation.resolving(60, 5, 0.2, 0.01);
        assertEquals(512, chosen.length()); // 1/(3 (0.2·5·8.53)²) = 0.0046; half of it would lose 0.018
    }
}
