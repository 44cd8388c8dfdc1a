package wbv.identify;

import java.io.Serializable;
import java.util.Locale;

/**
 * An ARMAX model {@code y_k = -Σ a_i y_(k-i) + Σ b_ij u_i,(k-d-j) + e_k + Σ c_i e_(k-i)} (Ljung, System Identification, 1999,
 * 4.14).
 *
 * <p>Its state is that of the observer form, {@code y_k = x_1 + b_0 u_k + e_k},
 * {@code x_i ← x_(i+1) - a_i y_k + b_i u_k + c_i e_k}, {@link Orders#memory} numbers in the unit of the output.
 * Arrays are not copied: treat them as read-only.
 *
 * @param rate     [Hz]
 * @param a        a_1 … a_na [1], na long
 * @param b        by input, nb coefficients each, in the output's unit over the input's, the first at {@code delay}
 * @param delay    samples before an input acts
 * @param c        c_1 … c_nc [1], nc long
 * @param variance of e, in the output's unit squared, &gt;= 0
 */
public record Armax(double rate, double[] a, double[][] b, int delay, double[] c, double variance) implements Serializable {

    /** na, nb, nc and the delay of these coefficients. */
    public Orders orders() {
        return new Orders(a.length, b[0].length, c.length, delay);
    }

    /** Poles in the s-plane. */
    public PoleSet poles() {
        return PoleSet.ofDiscrete(a, rate);
    }

    /**
     * One-step-ahead prediction, a series in the output's unit: each sample of the output from the inputs up to it and the measured output
     * before it.
     *
     * @param initial state at the first sample, in the output's unit, {@link Orders#memory} long. Not modified.
     */
    public double[] predict(Samples samples, double[] initial) {
        return run(samples.u(), samples.y(), initial);
    }

    /**
     * Free simulation: the output, a series in its own unit, from the inputs alone.
     *
     * @param u       by input and sample, each in its own unit. Not modified.
     * @param initial state at the first sample, in the output's unit, {@link Orders#memory} long. Not modified.
     */
    public double[] simulate(double[][] u, double[] initial) {
        return run(u, new double[0], initial);
    }

    private double[] run(double[][] u, double[] measured, double[] initial) {
        if (u.length != b.length || initial.length != orders().memory()) {
            throw new IllegalArgumentException("the model has " + b.length + " inputs and a state of " + orders().memory() + ": "
                    + u.length + ", " + initial.length);
        }
        double[] x = initial.clone();
        double[] out = new double[u[0].length];
        for (int k = 0; k < out.length; k++) {
            double foreseen = x.length == 0 ? 0 : x[0];
            for (int i = 0; i < b.length && delay == 0; i++) {
                foreseen += b[i][0] * u[i][k];
            }
            out[k] = foreseen;
            double y = measured.length == 0 ? foreseen : measured[k];
            for (int i = 0; i < x.length; i++) {
                double next = i + 1 < x.length ? x[i + 1] : 0;
                next += i < a.length ? -a[i] * y : 0;
                next += i < c.length ? c[i] * (y - foreseen) : 0;
                int lag = i + 1 - delay;
                for (int j = 0; j < b.length && lag >= 0 && lag < b[j].length; j++) {
                    next += b[j][lag] * u[j][k];
                }
                x[i] = next;
            }
        }
        return out;
    }

    /**
     * |B_i/A| at a frequency, in the output's unit over the input's.
     *
     * @param input which
     * @param f [Hz], up to half the rate
     */
    public double modulus(int input, double f) {
        double w = 2 * Math.PI * f / rate;
        double re = 0;
        double im = 0;
        for (int j = 0; j < b[input].length; j++) {
            re += b[input][j] * Math.cos(w * (j + delay));
            im -= b[input][j] * Math.sin(w * (j + delay));
        }
        double downRe = 1;
        double downIm = 0;
        for (int i = 0; i < a.length; i++) {
            downRe += a[i] * Math.cos(w * (i + 1));
            downIm -= a[i] * Math.sin(w * (i + 1));
        }
        return Math.hypot(re, im) / Math.hypot(downRe, downIm);
    }

    /** The difference equation in words of mathematics. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("y[k] =");
        for (int i = 0; i < a.length; i++) {
            term(text, -a[i], "y[k-" + (i + 1) + "]");
        }
        for (int i = 0; i < b.length; i++) {
            String name = b.length == 1 ? "u" : "u" + (i + 1);
            for (int j = 0; j < b[i].length; j++) {
                term(text, b[i][j], name + (j + delay == 0 ? "[k]" : "[k-" + (j + delay) + "]"));
            }
        }
        text.append(" + e[k]");
        for (int i = 0; i < c.length; i++) {
            term(text, c[i], "e[k-" + (i + 1) + "]");
        }
        return text.append(String.format(Locale.ROOT, ", sd(e) = %.4g, %.6g Hz", Math.sqrt(variance), rate)).toString();
    }

    private static void term(StringBuilder text, double value, String signal) {
        text.append(value < 0 ? " - " : " + ").append(String.format(Locale.ROOT, "%.6g ", Math.abs(value))).append(signal);
    }
}
