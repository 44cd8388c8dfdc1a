package wbv.diagnosis.algebra;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import wbv.signal.ScalarProduct;

class DirectionProductsTest {

    private static final int LENGTH = 40;

    /** Vectors of which the last are numbers known to one unit, that may be so large. */
    private static DirectionProducts products(double[][] vectors, double[] residual, double... most) {
        Columns columns = new Columns(vectors);
        double[][] each = columns.gram();
        for (int i = each.length - most.length; i < each.length; i++) {
            each[i][i]++;
        }
        return new DirectionProducts(each, columns.products(residual), most);
    }

    private static double[][] random(int count, Random random) {
        return Stream.generate(() -> random.doubles(LENGTH, -1, 1).toArray()).limit(count).toArray(double[][]::new);
    }

    /** At the least no direction is of use any more: the residual with all of them is orthogonal to each. */
    @Test
    void whatIsLeftIsOrthogonal() {
        double[][] vectors = random(3, new Random(1));
        double[] residual = random(1, new Random(2))[0];
        JointStrengths joint = products(vectors, residual).together(new int[] {0, 1, 2}, new boolean[3]).joint();
        double[] left = residual.clone();
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < LENGTH; i++) {
                left[i] += joint.strengths()[k] * vectors[k][i];
            }
        }
        for (double[] vector : vectors) {
            assertEquals(0, ScalarProduct.of(vector, left), 1e-12);
        }
        assertEquals(ScalarProduct.of(residual, residual) - ScalarProduct.of(left, left), joint.gain(), 1e-12);
    }

    /** A number that would be -27 where 3 is the most stays at -3, and the direction does what is left, by hand. */
    @Test
    void aNumberStaysWithinItsBound() {
        double[][] vectors = {{1, 1, 0}, {0, 2, 0}};
        double[] residual = {0, 54.5, 0};
        DirectionProducts products = products(vectors, residual, 3);
        DirectionProducts.Together alone = products.together(new int[0], new boolean[0]);
        assertArrayEquals(new double[] {-3}, alone.joint().strengths(), 0);
        DirectionProducts.Together both = products.together(new int[] {0}, new boolean[1]);
        assertArrayEquals(new int[] {0, 1}, both.which());
        // Least of s² + (54.5 - 6 + s)²
        assertArrayEquals(new double[] {-24.25, -3}, both.joint().strengths(), 1e-12);
        assertEquals(54.5 * 54.5 - 2 * 24.25 * 24.25 - 9, both.joint().gain(), 1e-9);
    }

    /** A second direction that is nearly the first has no strength of its own, one that is left out none at all. */
    @Test
    void whatIsOldOrLeftOutHasNoStrength() {
        double[][] vectors = {{1, 1, 0}, {1, 1, 1e-3}, {0, 0, 2}};
        DirectionProducts products = products(vectors, new double[] {2, 2, 6});
        assertArrayEquals(new double[] {-2, 0, -3},
                products.together(new int[] {0, 1, 2}, new boolean[3]).joint().strengths(), 1e-12);
        assertArrayEquals(new double[] {0, -3},
                products.together(new int[] {0, 2}, new boolean[] {true, false}).joint().strengths(), 1e-12);
    }

    /** Within bounds no less is left than without any, and no more than where the numbers stay what they were. */
    @Test
    void boundedNumbersLeaveWhatLiesBetween() {
        for (int seed = 0; seed < 50; seed++) {
            Random random = new Random(seed);
            double[][] vectors = random(6, random);
            double[] residual = Arrays.stream(random(1, random)[0]).map(x -> 5 * x).toArray();
            DirectionProducts products = products(vectors, residual, 0.2, 0.2, 0.2);
            double before = products.together(new int[0], new boolean[0]).joint().gain();
            double gain = products.together(new int[] {0, 2}, new boolean[2]).joint().gain();
            double most = products.free().together(new int[] {0, 2}, new boolean[2]).joint().gain()
                    + products(Arrays.copyOfRange(vectors, 3, 6), residual, 1e9, 1e9, 1e9).together(new int[0], new boolean[0]).joint()
                            .gain();
            double least = products.resting().together(new int[] {0, 2}, new boolean[2]).joint().gain() + before;
            assertTrue(gain <= most + 1e-9, gain + " of " + most);
            assertTrue(gain >= least - 1e-9, gain + " for " + least);
        }
    }

    /** Within groups and after them as all together, no numbers across. */
    @Test
    void productsWithinGroupsAreThoseOfAll() {
        Columns columns = new Columns(random(5, new Random(3)));
        double[][] all = columns.gram();
        double[][] within = DirectionProducts.within(columns, new int[] {1, 2});
        for (int i = 0; i < 5; i++) {
            for (int j = 0; j < 5; j++) {
                boolean across = Math.max(i, j) < 3 && (i == 0) != (j == 0);
                assertEquals(across ? Double.NaN : all[i][j], within[i][j], 1e-12);
            }
        }
    }
}
