package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** What a recording tells of, and how fast it need be. */
class ExcitedBandTest {

    /** A spring and a dashpot have no mode: force of a motion that ends at 25 Hz, at 1 kHz. */
    @Test
    void polesOfWhatIsNotExcitedAreNoModes() {
        Samples bench = ChainData.springAndDashpot(10, 1000, 1);
        ExcitedBand band = ExcitedBand.of(bench);
        assertEquals(25, band.to(), 1);
        assertTrue(band.holds(12, 0.1));
        assertFalse(band.holds(42, 0.06));
        assertFalse(band.holds(438, 0.3));
        assertTrue(band.holds(26.5, 0.4), "its flank is seen");
    }

    @Test
    void whatEndsFarBelowHalfTheRateIsUsedSlower() {
        Samples bench = ChainData.springAndDashpot(10, 1000, 2);
        Samples slower = Slower.of(bench, 25, 300);
        assertEquals(100, slower.rate());
        int end = (bench.length() / 10 - slower.length()) / 2;
        double[] kept = new double[slower.length()];
        double power = 0;
        double off = 0;
        for (int k = 0; k < kept.length; k++) {
            kept[k] = bench.u()[0][(k + end) * 10];
            power += kept[k] * kept[k];
            off += Math.pow(kept[k] - slower.u()[0][k], 2);
        }
        assertEquals(0, Math.sqrt(off / power), 1e-3, "what is excited passes");
        assertSame(bench, Slower.of(bench, 200, 300), "nothing to gain");
        assertSame(bench, Slower.of(bench, 25, bench.length()), "too few would be left");
    }
}
