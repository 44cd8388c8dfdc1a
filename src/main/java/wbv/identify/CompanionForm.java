package wbv.identify;

import java.io.Serializable;
import org.ejml.data.DMatrixRMaj;
import wbv.signal.MatrixExponential;

/**
 * The filter {@code 1/A(s)} for a signal that is straight between samples: its states are the filtered signal and its
 * derivatives, {@code s^k/A u} for k = 0 … n-1. Exact (first-order hold by one matrix exponential; Van Loan 1978).
 */
final class CompanionForm implements Serializable {

    private static final long serialVersionUID = 1;

    private final int n;
    private final double[] phi;
    private final double[] first;
    private final double[] second;

    /**
     * @param p A(s) = s^n + p_1 s^(n-1) + … + p_n. Not modified.
     * @param step between samples, in the unit of 1/s
     */
    CompanionForm(double[] p, double step) {
        n = p.length;
        DMatrixRMaj m = new DMatrixRMaj(n + 2, n + 2);
        for (int i = 0; i < n; i++) {
            if (i + 1 < n) {
                m.set(i, i + 1, step);
            }
            m.set(n - 1, i, -p[n - 1 - i] * step);
        }
        m.set(n - 1, n, step);
        m.set(n, n + 1, 1);
        DMatrixRMaj e = MatrixExponential.of(m);
        phi = new double[n * n];
        first = new double[n];
        second = new double[n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                phi[i * n + j] = e.get(i, j);
            }
            second[i] = e.get(i, n + 1);
            first[i] = e.get(i, n) - second[i];
        }
    }

    /**
     * States at all samples, n by length: row k is {@code s^k/A u}; at rest before the first sample.
     *
     * @param u Not modified.
     */
    double[][] filter(double[] u) {
        double[][] z = new double[n][u.length];
        double[] x = new double[n];
        double[] next = new double[n];
        for (int t = 1; t < u.length; t++) {
            advance(x, u[t - 1], u[t], next);
            System.arraycopy(next, 0, x, 0, n);
            put(x, z, t);
        }
        return z;
    }

    /** Answer to a pulse at the first sample, n by length: row k is {@code s^k/A δ}. */
    double[][] pulse(int length) {
        double[][] z = new double[n][length];
        double[] x = new double[n];
        x[n - 1] = 1;
        double[] next = new double[n];
        put(x, z, 0);
        for (int t = 1; t < length; t++) {
            advance(x, 0, 0, next);
            System.arraycopy(next, 0, x, 0, n);
            put(x, z, t);
        }
        return z;
    }

    /**
     * States one sample on.
     *
     * @param x states before. Not modified.
     * @param next states after. Modified.
     */
    void advance(double[] x, double before, double now, double[] next) {
        for (int i = 0; i < n; i++) {
            double sum = first[i] * before + second[i] * now;
            for (int j = 0; j < n; j++) {
                sum += phi[i * n + j] * x[j];
            }
            next[i] = sum;
        }
    }

    private static void put(double[] x, double[][] z, int t) {
        for (int i = 0; i < x.length; i++) {
            z[i][t] = x[i];
        }
    }

    /** e^M by Taylor's series of M/2^k, squared k times. */
}
