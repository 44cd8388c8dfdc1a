package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.List;

/**
 * Turns residual spectra of all outputs into independent numbers of unit variance: W r with Wᴴ W = S⁻¹, where
 * {@code S = diag(σ²) + Σ P g gᴴ} holds the noise of the outputs' sensors and that which reaches all outputs through the model: the
 * input sensor's, and what a person does on a seat.
 */
public final class Whitening {

    /** Power over noise of what is not to be seen. */
    private static final double DEAFENING = 1e8;

    private final Window window;
    private final int outputs;
    /** Lower triangular W, entry (i, j) at i m + j, complex by line; empty where it is zero at every line. */
    private final double[][] factor;
    private final int blind;

    /**
     * @param noise     standard deviation of a sample, by output
     * @param sources   noise that reaches all outputs together: that of the input, a body's own force
     * @param blind     how many of the sources are so strong that nothing is seen along their way
     */
    Whitening(Window window, double[] noise, List<Source> sources, int blind) {
        this.window = window;
        this.outputs = noise.length;
        this.blind = blind;
        int m = outputs;
        double[][] entries = new double[m * m][2 * window.lines()];
        double[] s = new double[2 * m * m];
        double[] w = new double[2 * m * m];
        for (int line = 0; line < window.lines(); line++) {
            Arrays.fill(s, 0);
            for (int i = 0; i < m; i++) {
                s[2 * (i * m + i)] = noise[i] * noise[i];
            }
            for (Source source : sources) {
                source.add(s, line, m);
            }
            cholesky(s, m);
            invertTriangle(s, w, m);
            for (int e = 0; e < m * m; e++) {
                entries[e][2 * line] = w[2 * e];
                entries[e][2 * line + 1] = w[2 * e + 1];
            }
        }
        factor = Arrays.stream(entries).map(entry -> Arrays.stream(entry).allMatch(part -> part == 0) ? new double[0] : entry)
                .toArray(double[][]::new);
    }

    /**
     * Noise from one source that reaches all outputs.
     *
     * @param power    variance of each part of a line, by line. Not modified.
     * @param transfer its way to each output at the window's lines, by output. Not modified.
     */
    record Source(double[] power, double[][] transfer) {

        /**
         * One so strong at every line that nothing is seen along its way.
         *
         * @param noise standard deviation of a sample, by output
         */
        static Source deafening(double[] noise, double[][] transfer) {
            double[] power = new double[transfer[0].length / 2];
            for (int line = 0; line < power.length; line++) {
                double size = 0;
                for (int o = 0; o < noise.length; o++) {
                    double re = transfer[o][2 * line] / noise[o];
                    double im = transfer[o][2 * line + 1] / noise[o];
                    size += re * re + im * im;
                }
                power[line] = size > 0 ? DEAFENING / size : 0;
            }
            return new Source(power, transfer);
        }

        private void add(double[] s, int line, int m) {
            for (int i = 0; i < m; i++) {
                double gr = transfer[i][2 * line];
                double gi = transfer[i][2 * line + 1];
                for (int j = 0; j < m; j++) {
                    double hr = transfer[j][2 * line];
                    double hi = transfer[j][2 * line + 1];
                    s[2 * (i * m + j)] += power[line] * (gr * hr + gi * hi);
                    s[2 * (i * m + j) + 1] += power[line] * (gi * hr - gr * hi);
                }
            }
        }
    }

    /** Independent numbers that show something. */
    public int degrees() {
        return size() - 2 * window.lines() * blind;
    }

    /** Whose lines it whitens. */
    public Window window() {
        return window;
    }

    /** Number of independent numbers: two for every line and output. */
    public int size() {
        return 2 * outputs * window.lines();
    }

    /** Position of an output's line in {@link #whiten}'s answer. */
    int index(int line, int output) {
        return 2 * (output * window.lines() + line);
    }

    /**
     * Whitens.
     *
     * @param spectra by output, as {@link Window#spectrum} gives them; an empty array stands for zero. Not modified.
     */
    double[] whiten(double[][] spectra) {
        double[] out = new double[size()];
        for (int i = 0; i < outputs; i++) {
            for (int j = 0; j <= i; j++) {
                addProduct(factor[i * outputs + j], spectra[j], index(0, i), out);
            }
        }
        return out;
    }

    /**
     * @param a complex
     * @param b complex; nothing where one of both is empty
     * @param at where the products are added. Modified.
     */
    private static void addProduct(double[] a, double[] b, int at, double[] out) {
        for (int k = 0; k < Math.min(a.length, b.length); k += 2) {
            out[at + k] += a[k] * b[k] - a[k + 1] * b[k + 1];
            out[at + k + 1] += a[k] * b[k + 1] + a[k + 1] * b[k];
        }
    }

    /** S = L Lᴴ, L in the lower triangle of s. */
    private static void cholesky(double[] s, int m) {
        for (int j = 0; j < m; j++) {
            for (int i = j; i < m; i++) {
                double re = s[2 * (i * m + j)];
                double im = s[2 * (i * m + j) + 1];
                for (int k = 0; k < j; k++) {
                    double ar = s[2 * (i * m + k)];
                    double ai = s[2 * (i * m + k) + 1];
                    double br = s[2 * (j * m + k)];
                    double bi = s[2 * (j * m + k) + 1];
                    re -= ar * br + ai * bi;
                    im -= ai * br - ar * bi;
                }
                if (i == j) {
                    s[2 * (j * m + j)] = Math.sqrt(re);
                    s[2 * (j * m + j) + 1] = 0;
                } else {
                    s[2 * (i * m + j)] = re / s[2 * (j * m + j)];
                    s[2 * (i * m + j) + 1] = im / s[2 * (j * m + j)];
                }
            }
        }
    }

    private static void invertTriangle(double[] l, double[] out, int m) {
        for (int j = 0; j < m; j++) {
            out[2 * (j * m + j)] = 1 / l[2 * (j * m + j)];
            for (int i = j + 1; i < m; i++) {
                double re = 0;
                double im = 0;
                for (int k = j; k < i; k++) {
                    double ar = l[2 * (i * m + k)];
                    double ai = l[2 * (i * m + k) + 1];
                    double br = out[2 * (k * m + j)];
                    double bi = out[2 * (k * m + j) + 1];
                    re += ar * br - ai * bi;
                    im += ar * bi + ai * br;
                }
                out[2 * (i * m + j)] = -re / l[2 * (i * m + i)];
                out[2 * (i * m + j) + 1] = -im / l[2 * (i * m + i)];
            }
        }
    }
}
