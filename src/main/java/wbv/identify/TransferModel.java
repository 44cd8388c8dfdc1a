package wbv.identify;

import java.io.Serializable;

/**
 * A model in continuous time, {@code y = Σ B_i(s)/A(s) u_i + T(s)/A(s) δ}: common poles, one numerator for each input, and what
 * the motion before the first sample left behind, T. Arrays are not copied: treat them as read-only.
 *
 * @param a {@code A(s) = s^n + a_1 s^(n-1) + … + a_n} n long: a_1 … a_n, a_i [(rad/s)^i]
 * @param b numerators by input, that of s^m [unit_y/unit_u (rad/s)^(n-m)], highest power first; the last is of s⁰; as many in each, n + 1
 *          at most
 */
public record TransferModel(double[] a, double[][] b) implements Serializable {

    public TransferModel {
        for (double[] each : b) {
            if (each.length == 0 || each.length > a.length + 1) {
                throw new IllegalArgumentException("a numerator needs 1 to " + (a.length + 1) + " coefficients: " + each.length);
            }
        }
    }

    /** Roots of A(s), which all inputs share. */
    public PoleSet poles() {
        return PoleSet.ofContinuous(a);
    }

    /**
     * Free simulation: the output, a series in its own unit, from the inputs alone, each straight between its samples.
     *
     * @param u       by input and sample, each in its own unit. Not modified.
     * @param rate    [Hz]
     * @param initial T, highest power first, n long; coefficient j from 0 on [unit_y (rad/s)^j]. Not modified.
     */
    public double[] simulate(double[][] u, double rate, double[] initial) {
        if (u.length != b.length || initial.length != a.length) {
            throw new IllegalArgumentException("the model has " + b.length + " inputs and " + a.length
                    + " initial states: " + u.length
                    + ", " + initial.length);
        }
        int n = a.length;
        CompanionForm filter = new CompanionForm(a, 1 / rate);
        double[] y = new double[u[0].length];
        add(filter.pulse(y.length), initial, y);
        for (int i = 0; i < u.length; i++) {
            double[] weights = new double[n];
            double direct = b[i].length == n + 1 ? b[i][0] : 0;
            for (int k = 0; k < n; k++) {
                int at = k - n + b[i].length;
                weights[k] = (at >= 0 ? b[i][at] : 0) - direct * a[k];
            }
            add(filter.filter(u[i]), weights, y);
            for (int t = 0; t < y.length; t++) {
                y[t] += direct * u[i][t];
            }
        }
        return y;
    }

    /**
     * |B_i/A| at a frequency, in the output's unit over the input's.
     *
     * @param input which
     * @param f [Hz]
     */
    public double modulus(int input, double f) {
        double w = 2 * Math.PI * f;
        double[] down = new double[a.length + 1];
        down[0] = 1;
        System.arraycopy(a, 0, down, 1, a.length);
        return modulusAt(b[input], w) / modulusAt(down, w);
    }

    private static double modulusAt(double[] polynomial, double w) {
        double re = 0;
        double im = 0;
        for (double coefficient : polynomial) {
            double next = coefficient - w * im;
            im = w * re;
            re = next;
        }
        return Math.hypot(re, im);
    }

    /**
     * @param z row k is {@code s^k/A} of something
     * @param weights highest power first
     */
    private static void add(double[][] z, double[] weights, double[] y) {
        for (int k = 0; k < z.length; k++) {
            double weight = weights[z.length - 1 - k];
            for (int t = 0; t < y.length; t++) {
                y[t] += weight * z[k][t];
            }
        }
    }
}
