package wbv.signal;

import java.util.Random;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealVector;

/**
 * Records of bodies whose responses are known in closed form, made in the frequency domain, so that they are exact between the
 * samples too, and the dynamic-stiffness solution of chains of masses. Shares no code with what is tested but the transform.
 */
final class KnownBodies {

    /** Allen 1978, a torso and a head in series [kg, N/m, N·s/m]; |head/seat| is 1.129444, 1.458062, 1.279637 at 2, 5, 10 Hz. */
    static final double[][] ALLEN = {{50.2, 74_300, 2807}, {5.5, 41_000, 318}};
    /** Boileau and Rakheja 1998, four masses in series. */
    static final double[][] BOILEAU = {{12.78, 90_000, 2064}, {8.62, 162_800, 4585}, {28.49, 183_000, 4750}, {5.31, 310_000,
        400}};

    private KnownBodies() {}

    /** A response: real and imaginary part at a frequency [Hz]. */
    interface Response {
        double[] at(double frequency);
    }

    /** {@code (2ζωs + ω²)/(s² + 2ζωs + ω²)}. */
    static Response oneDegree(double natural, double damping) {
        return f -> {
            double r = f / natural;
            double[] above = {1, 2 * damping * r};
            double[] below = {1 - r * r, 2 * damping * r};
            return divide(above, below);
        };
    }

    /** Acceleration of every mass of a chain over that of its base. @param chain mass, stiffness and damping below, upwards */
    static double[][] motions(double[][] chain, double f) {
        int n = chain.length;
        double w = 2 * Math.PI * f;
        Array2DRowRealMatrix z = new Array2DRowRealMatrix(2 * n, 2 * n);
        RealVector right = new ArrayRealVector(2 * n);
        for (int i = 0; i < n; i++) {
            add(z, n, i, i, -w * w * chain[i][0], 0);
            for (int end : new int[] {i, i - 1}) {
                if (end >= 0) {
                    add(z, n, end, end, chain[i][1], w * chain[i][2]);
                }
            }
            if (i > 0) {
                add(z, n, i, i - 1, -chain[i][1], -w * chain[i][2]);
                add(z, n, i - 1, i, -chain[i][1], -w * chain[i][2]);
            }
        }
        right.setEntry(0, chain[0][1]);
        right.setEntry(n, w * chain[0][2]);
        RealVector x = new LUDecomposition(z).getSolver().solve(right);
        double[][] ratio = new double[n][];
        for (int i = 0; i < n; i++) {
            ratio[i] = new double[] {x.getEntry(i), x.getEntry(n + i)};
        }
        return ratio;
    }

    private static void add(Array2DRowRealMatrix z, int n, int i, int j, double re, double im) {
        z.addToEntry(i, j, re);
        z.addToEntry(n + i, n + j, re);
        z.addToEntry(i, n + j, -im);
        z.addToEntry(n + i, j, im);
    }

    static Response chain(double[][] chain, int mass) {
        return f -> motions(chain, f)[mass];
    }

    /** {@code m0 + Σ m A/A_base} [kg]. */
    static Response apparentMass(double[][] chain, double rigid) {
        return f -> {
            double[] sum = {rigid, 0};
            double[][] ratio = motions(chain, f);
            for (int i = 0; i < chain.length; i++) {
                sum[0] += chain[i][0] * ratio[i][0];
                sum[1] += chain[i][0] * ratio[i][1];
            }
            return sum;
        };
    }

    static double[] divide(double[] a, double[] b) {
        double square = b[0] * b[0] + b[1] * b[1];
        return new double[] {(a[0] * b[0] + a[1] * b[1]) / square, (a[1] * b[0] - a[0] * b[1]) / square};
    }

    /** A random spectrum, flat from one frequency to another, of a periodic record of unit density. */
    static double[] spectrum(int length, double rate, double from, double to, Random random) {
        double[] packed = new double[length];
        for (int k = 1; k < length / 2; k++) {
            double f = k * rate / length;
            if (f >= from && f <= to) {
                double scale = Math.sqrt(length * rate / 4);
                packed[2 * k] = scale * random.nextGaussian();
                packed[2 * k + 1] = scale * random.nextGaussian();
            }
        }
        return packed;
    }

    /** Adds to a spectrum what a response makes of another. @param x Not modified. @param y Modified. */
    static void pass(double[] x, Response response, double rate, double[] y) {
        for (int k = 1; k < x.length / 2; k++) {
            if (x[2 * k] != 0 || x[2 * k + 1] != 0) {
                double[] h = response.at(k * rate / x.length);
                y[2 * k] += h[0] * x[2 * k] - h[1] * x[2 * k + 1];
                y[2 * k + 1] += h[0] * x[2 * k + 1] + h[1] * x[2 * k];
            }
        }
    }

    /** The record of a spectrum, a new array. @param noise standard deviation of white noise on it */
    static double[] record(double[] spectrum, double noise, Random random) {
        double[] series = spectrum.clone();
        new Fft(series.length).inverse(series);
        for (int n = 0; n < series.length; n++) {
            series[n] += noise * random.nextGaussian();
        }
        return series;
    }

    /** Spectra of records, all of one length. */
    static SpectralMatrix spectra(double rate, int segment, double[]... records) {
        SpectralMatrix spectra = new SpectralMatrix(new Segmentation(rate, segment, 0.5), Detrend.MEAN, records.length);
        double[] row = new double[records.length];
        for (int n = 0; n < records[0].length; n++) {
            for (int i = 0; i < row.length; i++) {
                row[i] = records[i][n];
            }
            spectra.accept(row);
        }
        return spectra;
    }
}
