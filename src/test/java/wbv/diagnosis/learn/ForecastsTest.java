package wbv.diagnosis.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ForecastsTest {

    private static final int LENGTH = 480;

    /**
     * Of two forecasts that are as good as each other less than one in a thousand is held better, however what they leave is distributed:
     * of the 4096 signs that twelve stretches may have, each as likely, those whose negative ranks add up to 2 at most.
     */
    @Test
    void chanceIsHeldBetterLessThanOnceInAThousandTimes() {
        int better = 0;
        for (int signs = 0; signs < 4096; signs++) {
            double[] less = new double[12];
            for (int i = 0; i < less.length; i++) {
                less[i] = (signs >> i & 1) == 0 ? Math.exp(i) : -Math.exp(i);
            }
            better += new Forecasts(less).isBetter() ? 1 : 0;
        }
        assertEquals(3, better);
    }

    /** A tenth less is seen, if it is less everywhere, and not if half of the recording has it and the rest the contrary. */
    @Test
    void whatIsLessEverywhereIsBetter() {
        double[] other = new double[LENGTH];
        Arrays.setAll(other, i -> 1 + 0.5 * Math.sin(2 * Math.PI * i / 37.0));
        double[] less = Arrays.stream(other).map(square -> 0.9 * square).toArray();
        assertTrue(Forecasts.of(less, other).isBetter());
        assertFalse(Forecasts.of(other, less).isBetter());
        double[] here = less.clone();
        Arrays.setAll(here, i -> i < LENGTH / 2 ? 0.9 * other[i] : 1.05 * other[i]);
        assertFalse(Forecasts.of(here, other).isBetter());
    }
}
