package wbv.filter.drift;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.filter.model.Adaptation;

class EvidenceTestTest {

    private static final double RATE = 60;

    /** Log likelihood ratio of x for a mean of a against none, under none. */
    private static double gain(double x, double a) {
        return a * x - a * a / 2;
    }

    /** Once in a day at most: in fifty hours, more than eight are seen once in a thousand times. */
    @Test
    void itRingsFalselyOnceInADayAtMost() {
        int rung = 0;
        EvidenceTest test = new EvidenceTest(RATE, Adaptation.USUAL.changes());
        Random random = new Random(1);
        for (int i = 0; i < 50 * 3600 * RATE; i++) {
            if (test.hear(gain(random.nextGaussian(), 0.5))) {
                rung++;
                test.restart();
            }
        }
        assertTrue(rung <= 8, rung + " times");
    }

    /** As soon as theory says: ln of the samples of a day over the mean gain (Lorden 1971). */
    @Test
    void itHearsAChangeAsSoonAsItsEvidenceAllows() {
        Random random = new Random(2);
        double sum = 0;
        for (int run = 0; run < 200; run++) {
            EvidenceTest test = new EvidenceTest(RATE, Adaptation.USUAL.changes());
            int n = 1;
            while (!test.hear(gain(0.5 + random.nextGaussian(), 0.5))) {
                n++;
            }
            sum += n;
        }
        double bound = Math.log(86400 * RATE) / 0.125;
        assertEquals(1, sum / 200 / bound, 0.15);
    }

    @Test
    void noSingleSampleIsAChange() {
        EvidenceTest test = new EvidenceTest(RATE, Adaptation.USUAL.changes());
        assertFalse(test.hear(1e9) || test.hear(1e9) || test.hear(1e9));
    }
}
