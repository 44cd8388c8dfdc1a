package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Bounds;
import wbv.filter.model.OneDegree;
import wbv.filter.model.Spec;

class BoundProjectionTest {

    private static final int N = 5;
    private static final int OMEGA = 2;
    private static final int ZETA = 3;

    private static final BodyModel MODEL = new OneDegree(Spec.at(60), true);

    private static DMatrixRMaj covariance(Random random) {
        DMatrixRMaj root = new DMatrixRMaj(N, N);
        for (int i = 0; i < N * N; i++) {
            root.data[i] = 0.2 * random.nextGaussian();
        }
        DMatrixRMaj p = new DMatrixRMaj(N, N);
        CommonOps_DDRM.multTransB(root, root, p);
        for (int i = 0; i < N; i++) {
            p.add(i, i, 0.01);
        }
        return p;
    }

    private static double[] estimate(double frequency, double damping) {
        return new double[] {0.01, -0.02, Math.log(2 * Math.PI * frequency), Math.log(damping), 0.1};
    }

    private static double distance(double[] xi, double[] from, DMatrixRMaj inverse) {
        double sum = 0;
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                sum += (xi[i] - from[i]) * inverse.get(i, j) * (xi[j] - from[j]);
            }
        }
        return sum;
    }

    private static DMatrixRMaj inverse(DMatrixRMaj p) {
        DMatrixRMaj inverse = new DMatrixRMaj(N, N);
        assertTrue(CommonOps_DDRM.invert(p, inverse));
        return inverse;
    }

    /** On one bound: the other numbers move by their regression on the bounded one. */
    @Test
    void oneBoundMovesTheOthersByTheirRegression() {
        DMatrixRMaj p = covariance(new Random(3));
        double[] xi = estimate(5, 0.3);
        double[] before = xi.clone();
        Bounds bounds = new Bounds();
        bounds.set(Bounds.Attribute.FREQUENCY, 6, Double.POSITIVE_INFINITY);
        assertTrue(new BoundProjection(MODEL).apply(bounds, xi, p.data));
        assertEquals(6, Math.exp(xi[OMEGA]) / (2 * Math.PI), 1e-9);
        for (int i = 0; i < N; i++) {
            assertEquals(before[i] + p.get(i, OMEGA) / p.get(OMEGA, OMEGA) * Math.log(6.0 / 5), xi[i], 1e-9);
        }
    }

    @Test
    void whatSatisfiesItsBoundsDoesNotMove() {
        double[] xi = estimate(5, 0.3);
        double[] before = xi.clone();
        Bounds bounds = new Bounds();
        bounds.set(Bounds.Attribute.FREQUENCY, 4, 6);
        bounds.set(Bounds.Attribute.DAMPING, 0.1, Double.POSITIVE_INFINITY);
        bounds.set(Bounds.Attribute.IMAGINARY, 0, 200);
        assertFalse(new BoundProjection(MODEL).apply(bounds, xi, covariance(new Random(1)).data));
        assertArrayEquals(before, xi, 0);
    }

    /**
     * Among all points of a fine grid that satisfy the bounds, none is more probable; the other numbers take their best
     * values.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void noPointWithinBoundsIsMoreProbable(long seed) {
        Random random = new Random(seed);
        DMatrixRMaj p = covariance(random);
        double[] prior = estimate(3 + 4 * random.nextDouble(), 0.1 + 0.5 * random.nextDouble());
        Bounds bounds = new Bounds();
        double f = 3 + 4 * random.nextDouble();
        bounds.set(Bounds.Attribute.FREQUENCY, f, f + 0.6);
        double re = 5 + 8 * random.nextDouble();
        bounds.set(Bounds.Attribute.REAL, -re - 2, -re);
        double[] xi = prior.clone();
        new BoundProjection(MODEL).apply(bounds, xi, p.data);
        double omega = Math.exp(xi[OMEGA]);
        double zeta = Math.exp(xi[ZETA]);
        assertTrue(omega >= 2 * Math.PI * f * (1 - 1e-6) && omega <= 2 * Math.PI * (f + 0.6) * (1 + 1e-6));
        assertTrue(zeta * omega >= re * (1 - 1e-6) && zeta * omega <= (re + 2) * (1 + 1e-6));

        // the marginal of the two parameters decides; what is left follows by regression
        double found = distance(xi, prior, inverse(p));
        double a = p.get(OMEGA, OMEGA);
        double b = p.get(OMEGA, ZETA);
        double c = p.get(ZETA, ZETA);
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i <= 600; i++) {
            double lo = Math.log(2 * Math.PI * f);
            double w = lo + i / 600.0 * Math.log((f + 0.6) / f);
            for (int k = 0; k <= 600; k++) {
                double z = Math.log(re) + k / 600.0 * Math.log((re + 2) / re) - w;
                double dw = w - prior[OMEGA];
                double dz = z - prior[ZETA];
                least = Math.min(least, (c * dw * dw - 2 * b * dw * dz + a * dz * dz) / (a * c - b * b));
            }
        }
        assertEquals(least, found, 1e-3 * (1 + least));
        assertTrue(found <= least + 1e-9);
    }

    @Test
    void theImaginaryPartIsReachedThoughItIsNotLinear() {
        double[] xi = estimate(5, 0.6);
        Bounds bounds = new Bounds();
        bounds.set(Bounds.Attribute.IMAGINARY, 30, 30);
        new BoundProjection(MODEL).apply(bounds, xi, covariance(new Random(2)).data);
        double zeta = Math.exp(xi[ZETA]);
        assertEquals(30, Math.exp(xi[OMEGA]) * Math.sqrt(1 - zeta * zeta), 1e-6);
    }

    @Test
    void aBoundOnTheOutputMovesTheMotion() {
        double[] xi = estimate(5, 0.3);
        Bounds bounds = new Bounds();
        bounds.set(Bounds.Attribute.OUTPUT, -0.05, 0.05);
        new BoundProjection(MODEL).apply(bounds, xi, covariance(new Random(4)).data);
        MODEL.setOutput(xi);
        assertTrue(Math.abs(MODEL.output(xi)) <= 0.05 + 1e-6, "output " + MODEL.output(xi));
    }

    /** Frequency and both parts of the poles cannot be met at once: what is met is met, and nothing breaks. */
    @Test
    void boundsThatContradictEachOtherLeaveANumber() {
        double[] xi = estimate(5, 0.3);
        Bounds bounds = new Bounds();
        bounds.set(Bounds.Attribute.FREQUENCY, 5, 5);
        bounds.set(Bounds.Attribute.DAMPING, 0.5, 0.5);
        bounds.set(Bounds.Attribute.REAL, -2, -1);
        new BoundProjection(MODEL).apply(bounds, xi, covariance(new Random(5)).data);
        for (double value : xi) {
            assertTrue(Double.isFinite(value));
        }
    }
}
