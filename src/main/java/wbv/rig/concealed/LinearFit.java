package wbv.rig.concealed;

import java.util.Arrays;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;

/**
 * How much of an effect a linear chain can take up: masses, stiffness and damping fitted to what perfect sensors would show, at
 * every third line of a band, of a sitter from {@value #LOW} to {@value #HIGH} Hz, by Levenberg-Marquardt with differences.
 */
final class LinearFit {

    static final double LOW = 0.5;
    static final double HIGH = 15;
    private static final double STEP = 1e-4;
    private static final double MASS_SPREAD = 0.15;
    private static final int ROUNDS = 8;
    private static final int EVERY = 3;

    /**
     * What moves the chain: the platform's acceleration, or a force on a body of it.
     *
     * @param body on which it acts, -1 for the platform
     * @param order of each output's derivative: 2 acceleration, 1 speed, 0 position
     */
    record Drive(int body, int[] order) {

        static Drive platform(int outputs) {
            int[] order = new int[outputs];
            Arrays.fill(order, 2);
            return new Drive(-1, order);
        }
    }

    private final int[] body;
    private final Drive drive;
    private final double[] omega;
    private final double[][] base;
    private final double[][][] shown;
    private final double[] power;

    /**
     * @param body measured, by output
     * @param platform rows [m/s²]
     * @param outputs rows by output [m/s²]. Not modified.
     */
    LinearFit(int[] body, double[] platform, double[][] outputs) {
        this(body, Drive.platform(outputs.length), platform, outputs, Imus.RATE, LOW, HIGH);
    }

    /**
     * @param platform rows of what drives it
     * @param rate of the rows [Hz]
     * @param low
     * @param high edges of the band [Hz]
     */
    LinearFit(int[] body, Drive drive, double[] platform, double[][] outputs, double rate, double low, double high) {
        this.body = body;
        this.drive = drive;
        int size = Integer.highestOneBit(platform.length - 1) * 2;
        int first = (int) Math.ceil(low * size / rate);
        int last = (int) (high * size / rate);
        omega = new double[(last - first) / EVERY];
        for (int i = 0; i < omega.length; i++) {
            omega[i] = 2 * Math.PI * (first + EVERY * i) * rate / size;
        }
        base = spectrum(platform, size, first);
        shown = new double[outputs.length][][];
        power = new double[outputs.length];
        for (int o = 0; o < outputs.length; o++) {
            shown[o] = spectrum(outputs[o], size, first);
            power[o] = energy(shown[o]);
        }
    }

    /**
     * Part of each output's variance that the best linear chain leaves.
     *
     * @param start where to begin
     */
    double[] left(Chain start) {
        int n = start.size();
        double[] x = new double[3 * n];
        double[] residual = residual(start, x);
        double cost = cost(residual, x, n);
        double damping = 1e-3;
        for (int round = 0; round < ROUNDS; round++) {
            double[][] slopes = new double[3 * n][];
            for (int j = 0; j < 3 * n; j++) {
                double[] moved = x.clone();
                moved[j] += STEP;
                slopes[j] = residual(start, moved);
                for (int i = 0; i < slopes[j].length; i++) {
                    slopes[j][i] = (slopes[j][i] - residual[i]) / STEP;
                }
            }
            RealMatrix normal = new Array2DRowRealMatrix(3 * n, 3 * n);
            double[] gradient = new double[3 * n];
            for (int j = 0; j < 3 * n; j++) {
                for (int l = 0; l <= j; l++) {
                    double sum = dot(slopes[j], slopes[l]);
                    normal.setEntry(j, l, sum);
                    normal.setEntry(l, j, sum);
                }
                gradient[j] = dot(slopes[j], residual);
                double prior = j >= 2 * n ? ridge() / (MASS_SPREAD * MASS_SPREAD) : ridge();
                normal.addToEntry(j, j, prior);
                gradient[j] += prior * x[j];
            }
            boolean better = false;
            for (int attempt = 0; attempt < 6 && !better; attempt++) {
                RealMatrix damped = normal.copy();
                for (int j = 0; j < 3 * n; j++) {
                    damped.multiplyEntry(j, j, 1 + damping);
                }
                double[] step = new LUDecomposition(damped).getSolver().solve(new ArrayRealVector(gradient)).toArray();
                double[] moved = new double[3 * n];
                for (int j = 0; j < 3 * n; j++) {
                    moved[j] = Math.max(-3, Math.min(3, x[j] - step[j]));
                }
                double[] trial = residual(start, moved);
                double trialCost = cost(trial, moved, n);
                better = trialCost < cost;
                damping *= better ? 0.2 : 8;
                if (better) {
                    x = moved;
                    residual = trial;
                    cost = trialCost;
                }
            }
        }
        double[] share = new double[shown.length];
        int lines = omega.length;
        for (int o = 0; o < share.length; o++) {
            share[o] = dot(Arrays.copyOfRange(residual, 2 * lines * o, 2 * lines * (o + 1)),
                    Arrays.copyOfRange(residual, 2 * lines * o, 2 * lines * (o + 1)));
        }
        return share;
    }

    /** Mean of |output over platform|² of a chain over the lines, by output. */
    double[] gain(Chain chain) {
        double[] sum = new double[body.length];
        for (int i = 0; i < omega.length; i++) {
            Complex[] q = response(chain, drive.body(), omega[i]);
            for (int o = 0; o < body.length; o++) {
                sum[o] += Math.pow(q[body[o]].abs(), 2) / omega.length;
            }
        }
        return sum;
    }

    private double ridge() {
        return 1e-6 * shown.length;
    }

    private double cost(double[] residual, double[] x, int n) {
        double sum = dot(residual, residual);
        for (int j = 0; j < x.length; j++) {
            sum += x[j] * x[j] * (j >= 2 * n ? ridge() / (MASS_SPREAD * MASS_SPREAD) : ridge());
        }
        return sum;
    }

    /** Model less shown, real and imaginary, over the root of the output's power. */
    private double[] residual(Chain start, double[] x) {
        int n = start.size();
        double[] k = new double[n];
        double[] c = new double[n];
        double[] m = new double[n];
        for (int i = 0; i < n; i++) {
            k[i] = start.stiffness()[i] * Math.exp(x[i]);
            c[i] = start.damping()[i] * Math.exp(x[n + i]);
            m[i] = start.mass()[i] * Math.exp(x[2 * n + i]);
        }
        Chain chain = new Chain(start.names(), start.parent(), m, k, c);
        int lines = omega.length;
        double[] out = new double[2 * lines * body.length];
        for (int i = 0; i < lines; i++) {
            Complex[] h = response(chain, drive.body(), omega[i]);
            for (int o = 0; o < body.length; o++) {
                double scale = 1 / Math.sqrt(power[o]);
                Complex g = drive.body() < 0 ? h[body[o]] : h[body[o]].multiply(derivative(drive.order()[o], omega[i]));
                out[2 * (lines * o + i)] = (g.getReal() * base[0][i] - g.getImaginary() * base[1][i] - shown[o][0][i]) * scale;
                out[2 * (lines * o + i) + 1] = (g.getReal() * base[1][i]
                        + g.getImaginary() * base[0][i] - shown[o][1][i]) * scale;
            }
        }
        return out;
    }

    private static Complex derivative(int order, double omega) {
        return order == 0 ? Complex.ONE : order == 1 ? new Complex(0, omega) : new Complex(-omega * omega);
    }

    /** Motion of every body over that of the platform, or over a force on a body [m/N]; the tree is eliminated from its tops down. */
    private static Complex[] response(Chain chain, int driven, double omega) {
        int n = chain.size();
        Complex[] diagonal = new Complex[n];
        Complex[] link = new Complex[n];
        Complex[] load = new Complex[n];
        for (int i = 0; i < n; i++) {
            link[i] = new Complex(chain.stiffness()[i], omega * chain.damping()[i]);
            diagonal[i] = link[i].subtract(omega * omega * chain.mass()[i]);
            load[i] = i == driven ? Complex.ONE : Complex.ZERO;
        }
        for (int i = n - 1; i >= 0; i--) {
            int p = chain.parent()[i];
            if (p >= 0) {
                diagonal[p] = diagonal[p].add(link[i]).subtract(link[i].multiply(link[i]).divide(diagonal[i]));
                load[p] = load[p].add(link[i].multiply(load[i]).divide(diagonal[i]));
            }
        }
        Complex[] h = new Complex[n];
        for (int i = 0; i < n; i++) {
            Complex below = chain.parent()[i] >= 0 ? h[chain.parent()[i]] : driven < 0 ? Complex.ONE : Complex.ZERO;
            h[i] = below.multiply(link[i]).add(load[i]).divide(diagonal[i]);
        }
        return h;
    }

    private double[][] spectrum(double[] rows, int size, int first) {
        Complex[] lines = new FastFourierTransformer(DftNormalization.STANDARD).transform(Arrays.copyOf(rows, size),
                TransformType.FORWARD);
        double[][] out = new double[2][omega.length];
        for (int i = 0; i < omega.length; i++) {
            out[0][i] = lines[first + EVERY * i].getReal();
            out[1][i] = lines[first + EVERY * i].getImaginary();
        }
        return out;
    }

    private static double energy(double[][] spectrum) {
        return dot(spectrum[0], spectrum[0]) + dot(spectrum[1], spectrum[1]);
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
