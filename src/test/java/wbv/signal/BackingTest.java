package wbv.signal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.signal.FrequencyResponse.Excited;

class BackingTest {

    private static final double RATE = 100;
    private static final int SEGMENT = 256;

    /** The input moves from 1 to 20 Hz, the output follows it up to 8 Hz and another motion above. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void whatIsNotExcitedIsToldFromWhatIsNotCaused(long seed) {
        Random random = new Random(seed);
        double[] exciting = KnownBodies.spectrum(1 << 14, RATE, 1, 20, random);
        double[] unrelated = KnownBodies.spectrum(1 << 14, RATE, 8, 20, random);
        double[] acting = KnownBodies.spectrum(1 << 14, RATE, 8, 20, random);
        double[] answer = new double[exciting.length];
        KnownBodies.pass(exciting, f -> new double[] {f < 8 ? 1.5 : 0, 0}, RATE, answer);
        KnownBodies.pass(acting, f -> new double[] {0.7, 0}, RATE, answer);
        double[] x = KnownBodies.record(exciting, 0.35, random);   // 26 dB down: above 20 Hz the sensor's own noise is all there is
        double[] low = KnownBodies.record(unrelated, 0.01, random);
        double[] other = KnownBodies.record(acting, 0.01, random);
        double[] y = KnownBodies.record(answer, 0.01, random);
        SpectralMatrix spectra = KnownBodies.spectra(RATE, SEGMENT, x, low, other, y);
        Backing[] backing = ResponseMatrix.of(spectra.only(0, 3), 1, Excited.USUAL).backing(0, 0);
        Backing[] alone = pair(x, y).backing();
        assertArrayEquals(backing, alone);
        assertEquals(1, share(backing, 2, 7, Backing.USABLE), 0.1);
        assertEquals(1, share(backing, 9, 19, Backing.NOT_CAUSED), 0.02);
        assertTrue(share(backing, 22, 49, Backing.NOT_EXCITED) > 0.95);
        assertEquals(0, share(backing, 2, 7, Backing.NOT_CAUSED), 0.02);

        OtherCauses causes = OtherCauses.of(spectra, 1, backing);
        OtherCauses.Likeliest found = causes.likeliest().orElseThrow();
        assertEquals(1, found.candidate());
        assertTrue(found.partial() > 0.9 && found.bins() > 20, found.toString());
    }

    /**
     * The input moves from 1 to 30 Hz, the output follows it through a low-pass and sinks in its sensor's noise: nothing else causes it.
     * Another motion as large as three times that noise does.
     */
    @Test
    void whatTheSensorsNoiseHidesHasNoOtherCause() {
        int told = 0;
        int another = 0;
        int hidden = 0;
        int runs = 20;
        for (int seed = 1; seed <= runs; seed++) {
            Random random = new Random(seed);
            double[] exciting = KnownBodies.spectrum(1 << 13, RATE, 1, 30, random);
            double[] acting = KnownBodies.spectrum(1 << 13, RATE, 1, 30, random);
            double[] answer = new double[exciting.length];
            KnownBodies.pass(exciting, f -> new double[] {Math.exp(-f / 2), 0}, RATE, answer);
            double[] x = KnownBodies.record(exciting, 0.001, random);
            double[] alone = KnownBodies.record(answer, 0.05, random);
            double[] both = answer.clone();
            KnownBodies.pass(acting, f -> new double[] {0.021, 0}, RATE, both);
            Backing[] quiet = pair(x, alone).backing();
            told += Backing.isBeyondChance(Arrays.stream(quiet).filter(Backing.NOT_CAUSED::equals).count(), 74) ? 1 : 0;
            hidden += share(quiet, 20, 29, Backing.BELOW_NOISE) > 0.7 ? 1 : 0;
            another += share(pair(x, KnownBodies.record(both, 0.05, random)).backing(), 20, 29, Backing.NOT_CAUSED) > 0.7 ? 1 : 0;
        }
        assertTrue(told <= 2, "another cause told in " + told + " of " + runs);
        assertEquals(runs, hidden);
        assertEquals(runs, another);
    }

    /** An input of even density has no floor: where nothing answers it, the answer is missing, not the excitation. */
    @Test
    void anEvenInputIsExcitedEverywhere() {
        Random random = new Random(5);
        double[] x = random.doubles(1 << 14).map(u -> u - 0.5).toArray();
        double[] y = random.doubles(1 << 14).map(u -> u - 0.5).toArray();
        assertEquals(1, share(pair(x, y).backing(), 1, 50, Backing.NOT_CAUSED), 1e-9);
    }

    /** Unrelated motions are not named as causes more often than chance allows. */
    @Tag("slow")
    @Test
    void noCauseIsNamedAmongUnrelatedMotions() {
        int named = 0;
        for (int seed = 0; seed < 30; seed++) {
            Random random = new Random(100 + seed);
            double[][] all = new double[6][1000];
            for (double[] series : all) {
                Arrays.setAll(series, n -> random.nextGaussian());
            }
            SpectralMatrix spectra = KnownBodies.spectra(RATE, 64, all);
            Backing[] backing = ResponseMatrix.of(spectra.only(0, 5), 1, Excited.USUAL).backing(0, 0);
            named += OtherCauses.of(spectra, 1, backing).likeliest().isPresent() ? 1 : 0;
        }
        assertTrue(named <= 2, named + " of 30");   // 1 %: at most 2 in 99.7 % of cases
    }

    /** From few averages a coherence in between is neither believed nor called low. */
    @Test
    void fewAveragesLeaveDoubt() {
        double critical = Excited.USUAL.leastCoherence(7, 1);
        double[] coherence = {0, 0, 0.2, 0.7, critical - 1e-6, critical + 1e-6};
        double[] even = {1, 1, 1, 1, 1, 1};
        assertTrue(critical > 0.8, "critical " + critical);
        assertArrayEquals(new Backing[] {Backing.NOT_EXCITED, Backing.NOT_CAUSED, Backing.NOT_CAUSED, Backing.IN_DOUBT, Backing.IN_DOUBT,
            Backing.USABLE}, new Judge(7, 1, 1, Excited.USUAL).of(even, even, 0, coherence, even, 0));
    }

    private static FrequencyResponse pair(double[] x, double[] y) {
        CrossSpectrum spectrum = new CrossSpectrum(new Segmentation(RATE, SEGMENT, 0.5), Detrend.MEAN, 1);
        for (int n = 0; n < x.length; n++) {
            spectrum.accept(x[n], y[n]);
        }
        return spectrum.response(0, Excited.USUAL);
    }

    private static double share(Backing[] backing, double from, double to, Backing what) {
        double resolution = RATE / SEGMENT;
        int first = (int) Math.ceil(from / resolution);
        int last = (int) Math.floor(to / resolution);
        return Arrays.stream(backing, first, last + 1).filter(what::equals).count() / (double) (last + 1 - first);
    }
}
