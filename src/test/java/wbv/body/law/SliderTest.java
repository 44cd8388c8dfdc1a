package wbv.body.law;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class SliderTest {

    private static final double STIFFNESS = 40000;
    private static final int CYCLE = 4000;

    /** A Jenkins element takes 4 s k y (A - y) from every cycle of the amplitude A, however it is gone through. */
    @Test
    void aCycleTakesTheParallelogramOfTheLoop() {
        double share = 0.3;
        double slip = 4e-4;
        double amplitude = 1e-3;
        double[] r = IntStream.rangeClosed(0, 3 * CYCLE).mapToDouble(j -> amplitude * Math.sin(2 * Math.PI * j / CYCLE)).toArray();
        double[] force = force(new Slider(share, slip), r);
        double work = 0;
        for (int j = 2 * CYCLE + 1; j < r.length; j++) {
            work += 0.5 * (force[j] + force[j - 1]) * (r[j] - r[j - 1]);
        }
        assertEquals(4 * share * STIFFNESS * slip * (amplitude - slip), work, 1e-6 * work);
    }

    /** What has not slipped is a part of the spring, and takes nothing away. */
    @Test
    void belowItsSlipItDoesNothing() {
        double[] r = IntStream.rangeClosed(0, CYCLE).mapToDouble(j -> 3.9e-4 * Math.sin(2 * Math.PI * j / CYCLE)).toArray();
        for (double force : force(new Slider(0.3, 4e-4), r)) {
            assertEquals(0, force, 1e-9);
        }
    }

    private static double[] force(Law law, double[] r) {
        return law.series(r, new double[r.length], STIFFNESS, 0, 1e-3, new double[0]);
    }
}
