package wbv.diagnosis.mechanism;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import wbv.body.law.Law;

class HysteresisTest {

    private static final double STIFFNESS = 40000;
    private static final double GREATEST = 2e-3;
    private static final int STEPS = 1000;
    private static final double SHARE = 0.6;
    private static final double YIELD = 5e-4;

    private final Hypothesis gradual = new Hysteresis().gradual(0, "seat-pelvis", SHARE, YIELD);

    /**
     * A branch after a turn is the first one, twice as large (Masing 1926): so yields what is made of sliders, and one stage of Bouc and
     * Wen does not.
     */
    @Test
    void aBranchAfterATurnIsTheFirstTwiceAsLarge() {
        double[] there = IntStream.rangeClosed(0, STEPS).mapToDouble(j -> GREATEST * j / STEPS).toArray();
        double[] back = IntStream.rangeClosed(1, STEPS).mapToDouble(j -> GREATEST * (1 - 2.0 * j / STEPS)).toArray();
        double[] both = java.util.stream.DoubleStream.concat(Arrays.stream(there), Arrays.stream(back)).toArray();
        double[] force = force(both);
        for (int j = 0; j <= STEPS; j += 50) {
            assertEquals(force[STEPS] - 2 * force[j], force[STEPS + j], 1e-9 * STIFFNESS * GREATEST);
        }
    }

    /** All yields far beyond, and half of it at the yield that is told: as much slides below it as above. */
    @Test
    void whatIsToldIsTheShareThatYieldsAndWhereHalfDoes() {
        double[] far = IntStream.rangeClosed(0, STEPS).mapToDouble(j -> 40 * YIELD * j / STEPS).toArray();
        double[] force = force(far);
        double slope = (force[STEPS] - force[STEPS - 1]) / (far[STEPS] - far[STEPS - 1]);
        assertEquals(-SHARE * STIFFNESS, slope, 1e-6 * STIFFNESS);
        double[] half = IntStream.rangeClosed(0, STEPS).mapToDouble(j -> YIELD * j / STEPS).toArray();
        double[] until = force(half);
        assertEquals(-SHARE / 2 * STIFFNESS, (until[STEPS] - until[STEPS - 1]) / (half[STEPS] - half[STEPS - 1]), 1e-6 * STIFFNESS);
        assertEquals(List.of("share", "yield_m"), gradual.kind().told(gradual).stream().map(Told::key).toList());
    }

    /** What slides beside a spring is a part of the spring that is as much stiffer. */
    @Test
    void besideASpringIsAPartOfAStifferOne() {
        double sticking = 3 * STIFFNESS;
        Hypothesis beside = new Hysteresis().beside(0, "seat-pelvis", STIFFNESS, sticking, YIELD);
        Hypothesis part = new Hysteresis().gradual(0, "seat-pelvis", sticking / (STIFFNESS + sticking), YIELD);
        double[] r = IntStream.rangeClosed(0, 4 * STEPS).mapToDouble(j -> GREATEST * Math.sin(0.01 * j) * Math.cos(0.003 * j)).toArray();
        double[] one = force(beside, STIFFNESS, r);
        double[] other = force(part, STIFFNESS + sticking, r);
        for (int j = 0; j < r.length; j++) {
            assertEquals((STIFFNESS + sticking) * r[j] + other[j], STIFFNESS * r[j] + one[j], 1e-9 * STIFFNESS * GREATEST);
        }
        assertEquals(List.of("sticking_N_per_m", "yield_m"), beside.kind().told(beside).stream().map(Told::key).toList());
    }

    private double[] force(double[] r) {
        return force(gradual, STIFFNESS, r);
    }

    private static double[] force(Hypothesis hysteresis, double stiffness, double[] r) {
        double[] sum = new double[r.length];
        for (Law law : hysteresis.laws(hysteresis.starts().get(0).values())) {
            double[] own = law.series(r, new double[r.length], stiffness, 0, 1e-3, new double[0]);
            Arrays.setAll(sum, j -> sum[j] + own[j]);
        }
        return sum;
    }
}
