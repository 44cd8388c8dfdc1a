package wbv.learn;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import moa.classifiers.core.driftdetection.ADWIN;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.drift.Adwin;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Our window beside MOA's. */
class AdwinTest {

    private static final int INPUTS = 1_000_000;

    /** A mean that stays for some thousand values, then jumps or drifts. */
    private static double[] inputs(long seed, int most) {
        Random random = new Random(seed);
        double[] values = new double[INPUTS];
        int left = 0;
        double mean = 0.5;
        double slope = 0;
        for (int i = 0; i < INPUTS; i++) {
            if (left-- == 0) {
                left = 50 + random.nextInt(most);
                mean = random.nextDouble();
                slope = random.nextBoolean() ? 0 : (random.nextDouble() - 0.5) / left;
            }
            mean = Math.max(0, Math.min(1, mean + slope));
            values[i] = Math.max(0, Math.min(1, mean + 0.2 * random.nextGaussian()));
        }
        return values;
    }

    @ParameterizedTest
    @ValueSource(ints = {300, 30_000})
    void itIsMoasOnAMillionInputs(int most) {
        ADWIN theirs = new ADWIN(0.002);
        Adwin ours = new Adwin(0.002);
        long cuts = 0;
        for (double value : inputs(most, most)) {
            boolean cut = theirs.setInput(value);
            assertEquals(cut, ours.feed(value));
            assertEquals(theirs.getWidth(), ours.width());
            assertEquals(theirs.getEstimation(), ours.mean(), 0);
            cuts += cut ? 1 : 0;
        }
        assertTrue(cuts > 10_000 / Math.sqrt(most), cuts + " cuts");
    }

    @Test
    void theWindowOfAMillionLikeValuesIsMoas() {
        Random random = new Random(5);
        ADWIN theirs = new ADWIN(0.002);
        Adwin ours = new Adwin(0.002);
        for (int i = 0; i < INPUTS; i++) {
            double value = random.nextDouble();
            assertEquals(theirs.setInput(value), ours.feed(value));
            assertEquals(theirs.getWidth(), ours.width(), "after " + i);
            assertEquals(theirs.getEstimation(), ours.mean(), 0);
        }
        assertTrue(ours.width() > 500_000, ours.width() + " values");
    }

    @Test
    void aSavedWindowGoesOn() {
        double[] values = inputs(9, 3000);
        Adwin whole = new Adwin();
        Adwin resumed = new Adwin();
        for (int i = 0; i < 200_000; i++) {
            if (i % 777 == 0) {
                StateReader.into(resumed, "window", StateWriter.of(whole));
            }
            assertEquals(whole.feed(values[i]), resumed.feed(values[i]));
        }
        assertArrayEquals(StateWriter.of(whole), StateWriter.of(resumed));
    }
}
