package wbv.filter;

import java.io.Serializable;
import java.util.Arrays;

/**
 * One exact step in time of {@code dx/dt = A x + B u} over {@code [0, T]}, and its derivatives to the parameters of A.
 *
 * <p>The scalar input is a polynomial in {@code s = t/T}, {@code u = Σ_j c_j s^j}, so that
 * {@code x(T) = E x(0) + Σ_j g_j c_j} with {@code E = exp(AT)} and {@code g_j = j! T φ_{j+1}(AT) B}, where
 * {@code φ_m(M) = Σ_k M^k / (k+m)!} (Hochbruck and Ostermann, Acta Numerica 2010, eq. 2.11). The highest φ is summed as a
 * Taylor series, the others follow from {@code φ_{m-1} = M φ_m + I/(m-1)!}; a step with {@code |AT| >= 2} is halved first
 * and doubled after. No case of damping is special. B must not depend on the parameters.
 *
 * <p>Matrices are row-major arrays. A step is a workspace: {@link #set} allocates nothing, and after it the accessors are
 * to be asked again.
 */
public final class ExactStep implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double NEGLIGIBLE = 1e-17;
    private static final int MOST_TERMS = 40;

    private final int n;
    private final int parameters;
    private final int degree;
    /** Index 0 is the quantity, index 1 + i its derivative to parameter i. */
    private final double[][] m;
    private double[][] term;
    private double[][] phi;
    private double[][] work;
    private final double[][][] gain;
    private final double[][] halfGain;

    /**
     * @param n          order of the model, &gt;= 1
     * @param parameters number of parameters of A, &gt;= 0
     * @param degree     of the input's polynomial, &gt;= 0: 0 holds, 1 joins samples by straight lines
     */
    public ExactStep(int n, int parameters, int degree) {
        if (n < 1 || parameters < 0 || degree < 0) {
            throw new IllegalArgumentException("order must be >= 1, parameters and degree >= 0: "
                    + n + ", " + parameters + ", " + degree);
        }
        this.n = n;
        this.parameters = parameters;
        this.degree = degree;
        this.m = new double[1 + parameters][n * n];
        this.term = new double[1 + parameters][n * n];
        this.phi = new double[1 + parameters][n * n];
        this.work = new double[1 + parameters][n * n];
        this.gain = new double[1 + parameters][degree + 1][n];
        this.halfGain = new double[degree + 1][n];
    }

    /** E, n by n: what is left of the state after the step. */
    public double[] transition() {
        return phi[0];
    }

    /** Derivative of {@link #transition} to a parameter, n by n. */
    public double[] transitionSlope(int parameter) {
        return phi[1 + parameter];
    }

    /** g_j, n long: what the input's coefficient of s^j adds to the state. */
    public double[] gain(int j) {
        return gain[0][j];
    }

    /** Derivative of {@link #gain} to a parameter, n long. */
    public double[] gainSlope(int parameter, int j) {
        return gain[1 + parameter][j];
    }

    /**
     * Computes the step.
     *
     * @param a      A, n by n. Not modified.
     * @param slopes derivative of A to each parameter, each n by n. Not modified.
     * @param b      B, n long. Not modified.
     * @param time   T [s], &gt; 0
     */
    public void set(double[] a, double[][] slopes, double[] b, double time) {
        double size = norm(a) * time;
        if (!(size < 1e6)) {
            throw new IllegalArgumentException("|A| T must be < 1e6: " + size);
        }
        int halvings = Math.max(0, Math.getExponent(size));
        double h = Math.scalb(time, -halvings);
        scale(a, h, m[0]);
        for (int i = 1; i <= parameters; i++) {
            scale(slopes[i - 1], h, m[i]);
        }
        sumHighestPhi();
        for (int order = degree + 1; order >= 1; order--) {
            takeGain(order, b, h);
            // φ_{m-1} = M φ_m + I/(m-1)!
            multiplyByM(phi, 1, work);
            addIdentity(work[0], 1 / factorial(order - 1));
            double[][] next = work;
            work = phi;
            phi = next;
        }
        for (int i = 0; i < halvings; i++) {
            doubleStep();
        }
    }

    private void sumHighestPhi() {
        for (int i = 0; i <= parameters; i++) {
            Arrays.fill(phi[i], 0);
            Arrays.fill(term[i], 0);
        }
        addIdentity(term[0], 1 / factorial(degree + 1));
        double negligible = NEGLIGIBLE / factorial(degree + 1);
        for (int k = 1; k <= MOST_TERMS; k++) {
            double largest = 0;
            for (int i = 0; i <= parameters; i++) {
                for (int e = 0; e < n * n; e++) {
                    phi[i][e] += term[i][e];
                    largest = Math.max(largest, Math.abs(term[i][e]));
                }
            }
            if (largest < negligible) {
                return;
            }
            multiplyByM(term, 1.0 / (k + degree + 1), work);
            double[][] next = work;
            work = term;
            term = next;
        }
    }

    /** g_{m-1} = (m-1)! h φ_m B. */
    private void takeGain(int order, double[] b, double h) {
        double factor = h * factorial(order - 1);
        for (int i = 0; i <= parameters; i++) {
            double[] g = gain[i][order - 1];
            for (int r = 0; r < n; r++) {
                double sum = 0;
                for (int c = 0; c < n; c++) {
                    sum += phi[i][r * n + c] * b[c];
                }
                g[r] = factor * sum;
            }
        }
    }

    /** Two equal steps as one: E' = E E, g'_j = 2^-j (E g_j + Σ_{i<=j} C(j,i) g_i). */
    private void doubleStep() {
        for (int i = parameters; i >= 0; i--) {
            for (int j = 0; j <= degree; j++) {
                doubledGain(i, j, halfGain[j]);
            }
            for (int j = 0; j <= degree; j++) {
                System.arraycopy(halfGain[j], 0, gain[i][j], 0, n);
            }
        }
        for (int i = 0; i <= parameters; i++) {
            product(phi, phi, i, 1, work[i]);
        }
        double[][] doubled = work;
        work = phi;
        phi = doubled;
    }

    private void doubledGain(int i, int j, double[] out) {
        for (int r = 0; r < n; r++) {
            double sum = 0;
            for (int c = 0; c < n; c++) {
                sum += phi[0][r * n + c] * gain[i][j][c];
                if (i > 0) {
                    sum += phi[i][r * n + c] * gain[0][j][c];
                }
            }
            double choose = 1;
            for (int k = 0; k <= j; k++) {
                sum += choose * gain[i][k][r];
                choose = choose * (j - k) / (k + 1);
            }
            out[r] = Math.scalb(sum, -j);
        }
    }

    /** to = factor M from, with derivatives. */
    private void multiplyByM(double[][] from, double factor, double[][] to) {
        for (int i = 0; i <= parameters; i++) {
            product(m, from, i, factor, to[i]);
        }
    }

    /** Element i, quantity or derivative, of factor times left times right. */
    private void product(double[][] left, double[][] right, int i, double factor, double[] out) {
        double[] l = left[0];
        double[] dr = right[i];
        double[] dl = left[i];
        double[] r = right[0];
        for (int row = 0; row < n; row++) {
            for (int c = 0; c < n; c++) {
                double sum = 0;
                for (int k = 0; k < n; k++) {
                    sum += l[row * n + k] * dr[k * n + c];
                    if (i > 0) {
                        sum += dl[row * n + k] * r[k * n + c];
                    }
                }
                out[row * n + c] = factor * sum;
            }
        }
    }

    private double norm(double[] matrix) {
        double largest = 0;
        for (int r = 0; r < n; r++) {
            double sum = 0;
            for (int c = 0; c < n; c++) {
                sum += Math.abs(matrix[r * n + c]);
            }
            largest = Math.max(largest, sum);
        }
        return largest;
    }

    private void addIdentity(double[] matrix, double factor) {
        for (int i = 0; i < n; i++) {
            matrix[i * n + i] += factor;
        }
    }

    private static void scale(double[] from, double factor, double[] to) {
        for (int e = 0; e < from.length; e++) {
            to[e] = factor * from[e];
        }
    }

    private static double factorial(int k) {
        double product = 1;
        for (int i = 2; i <= k; i++) {
            product *= i;
        }
        return product;
    }
}
