package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;

/** The likelihood held to dense matrices: all numbers of all lines in one covariance, small errors and processes in it. */
class LogLikelihoodTest {

    private static final int OUTPUTS = 3;
    private static final int LINES = 4;
    private static final int SIZE = 2 * OUTPUTS * LINES;

    private static double[] random(Random random, double size) {
        return IntStream.range(0, SIZE).mapToDouble(i -> size * random.nextGaussian()).toArray();
    }

    /** -½ rᵀ C⁻¹ r - ½ log det C. */
    private static double dense(double[] r, RealMatrix c) {
        LUDecomposition lu = new LUDecomposition(c);
        double logDeterminant = 0;
        for (int i = 0; i < r.length; i++) {
            logDeterminant += Math.log(Math.abs(lu.getU().getEntry(i, i)));
        }
        return -0.5 * MatrixUtils.createRealVector(r).dotProduct(lu.getSolver().solve(MatrixUtils.createRealVector(r))) - 0.5 * logDeterminant;
    }

    private static RealMatrix unit() {
        return MatrixUtils.createRealIdentityMatrix(SIZE);
    }

    /** One standard deviation of an error, as a covariance. */
    private static RealMatrix of(double[] column) {
        RealMatrix v = new Array2DRowRealMatrix(column);
        return v.multiply(v.transpose());
    }

    /** A process at each line: u times a complex number of independent parts. */
    private static RealMatrix of(double[] way, double[] power) {
        RealMatrix out = new Array2DRowRealMatrix(SIZE, SIZE);
        for (int line = 0; line < LINES; line++) {
            double[] re = new double[SIZE];
            double[] im = new double[SIZE];
            for (int i = 2 * OUTPUTS * line; i < 2 * OUTPUTS * (line + 1); i += 2) {
                re[i] = way[i];
                re[i + 1] = way[i + 1];
                im[i] = -way[i + 1];
                im[i + 1] = way[i];
            }
            out = out.add(of(re).add(of(im)).scalarMultiply(power[line]));
        }
        return out;
    }

    @Test
    void smallErrorsAndProcessesAreIntegratedOutExactly() {
        Random random = new Random(1);
        double[] r = random(random, 2);
        double[][] errors = {random(random, 1), random(random, 0.1), random(random, 5)};
        double[] first = random(random, 1);
        double[] second = random(random, 1);
        double[] power = {0.3, 0, 20, 1000};
        double[] other = {2, 0.01, 5, 0};
        LogLikelihood likelihood = new LogLikelihood(r, errors, 3.25, OUTPUTS);
        RealMatrix c = unit().add(of(errors[0])).add(of(errors[1])).add(of(errors[2]));
        assertEquals(dense(r, c) - 3.25, likelihood.value(), 1e-10);
        RealMatrix one = c.add(of(first, power));
        RankOne process = new RankOne(first, power, OUTPUTS);
        assertEquals(dense(r, one) - 3.25, likelihood.with(process).value(), 1e-9);
        assertEquals(dense(r, one) - 3.25, likelihood.held(first, power).value(power), 1e-9);
        RealMatrix two = one.add(of(second, other));
        double[] seen = process.of(second);
        assertEquals(dense(r, two) - 3.25, likelihood.with(process).with(new RankOne(seen, other, OUTPUTS)).value(), 1e-9);
        assertEquals(dense(r, two) - 3.25, likelihood.with(process).held(seen, other).value(other), 1e-9);
    }

    @Test
    void withoutErrorsItIsThatOfTheResidual() {
        double[] r = random(new Random(2), 1);
        assertEquals(-0.5 * Fitter.dot(r, r), new LogLikelihood(r, new double[0][], 0, OUTPUTS).value(), 1e-12);
    }

    /** Near the power at which errors are held their following hardly counts. */
    @Test
    void heldErrorsHardlyCount() {
        Random random = new Random(4);
        double[] r = random(random, 2);
        double[] way = random(random, 1);
        double[] near = {1, 1, 1, 1};
        double[] other = {1.5, 1.5, 1.5, 1.5};
        LogLikelihood likelihood = new LogLikelihood(r, new double[][] {random(random, 0.3), random(random, 0.3)}, 0, OUTPUTS);
        double exact = likelihood.with(new RankOne(way, other, OUTPUTS)).value();
        assertEquals(exact, likelihood.held(way, near).value(other), 0.05);
    }

    @Test
    void sumsOfLogarithms() {
        assertEquals(Math.log(6), LogSum.of(Math.log(1), Math.log(2), Math.log(3)), 1e-14);
        assertEquals(-2000 + Math.log(2), LogSum.of(-2000, -2000), 1e-12);
        assertEquals(Double.NEGATIVE_INFINITY, LogSum.of());
        assertEquals(2, LogSum.greatest(new double[] {1, -3, 5, 5}));
    }
}
