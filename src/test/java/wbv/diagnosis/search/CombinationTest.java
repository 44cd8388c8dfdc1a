package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;
import org.junit.jupiter.api.Test;
import wbv.signal.ScalarProduct;

/** The best combination of directions is the least-squares fit of the residual by them, however they were joined. */
class CombinationTest {

    private static final int LENGTH = 40;

    private final Random random = new Random(7);

    private double[] vector() {
        return random.doubles(LENGTH, -1, 1).toArray();
    }

    private static PartialledOut.Rest rest(double[] direction, double[] residual) {
        double[] none = new double[0];
        return new PartialledOut.Rest(direction, none, none, none, none, ScalarProduct.of(direction, residual));
    }

    @Test
    void isTheLeastSquaresFitHoweverItIsJoined() {
        double[] residual = vector();
        List<double[]> directions = IntStream.range(0, 5).mapToObj(i -> vector()).toList();
        List<PartialledOut.Rest> rests = directions.stream().map(direction -> rest(direction, residual)).toList();
        OLSMultipleLinearRegression oracle = new OLSMultipleLinearRegression();
        oracle.setNoIntercept(true);
        oracle.newSampleData(residual,
                IntStream.range(0, LENGTH).mapToObj(k -> directions.stream().mapToDouble(each -> each[k]).toArray())
                        .toArray(double[][]::new));
        double gain = ScalarProduct.of(residual, residual) - oracle.calculateResidualSumOfSquares();
        double[] strengths = IntStream.of(0, 1, 2, 3, 4).mapToDouble(i -> -oracle.estimateRegressionParameters()[i]).toArray();

        Combination first = Combination.of(rests.subList(0, 2));
        Combination one = first.with(Combination.of(rests.subList(2, 3)), 0);
        Combination other = first.with(Combination.of(rests.subList(3, 5)), 0);
        for (Combination all : List.of(Combination.of(rests), one.with(other, 2))) {
            assertEquals(5, all.count());
            assertEquals(gain, all.gain(), 1e-9 * gain);
            assertArrayEquals(strengths, all.strengths(), 1e-9);
            assertEquals(3 * LENGTH, all.numbersAfter(2));
        }
    }
}
