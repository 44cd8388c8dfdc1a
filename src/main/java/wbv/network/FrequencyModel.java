package wbv.network;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;
import wbv.signal.RealDft;

/**
 * A window in frequency beside what a linear body of given modes makes of its excitation: {@code Y = N/D U + T/D}.
 *
 * <p>D is of the modes; T, a polynomial, is what the body was doing when the window began and ended (Pintelon and Schoukens,
 * System Identification, 2012, chapter 6). Of one mode driven by its base N is known, {@code 2ζωs + ω²}; of more only
 * N(0) = D(0) is. Other motions of the base add N_i/D U_i, of which nothing is known but that D is the same and N_i is of its
 * order. What is free in N, N_i and T is fitted by least squares, every line weighted by the noise that reaches it from both
 * sensors, {@code 1 / (1 + |N/D|²)} (errors in variables). Not for several threads.
 */
final class FrequencyModel {

    /** Samples looked at, the last of a window. */
    private static final int LENGTH = RealDft.fitting(Imaging.SAMPLES);
    private static final double STEP = Imaging.RATE / LENGTH;
    /** To here all the shaking reaches that networks are trained on [lines of {@link #STEP} Hz]: 13 Hz. */
    private static final int SHAKEN = (int) (13 / STEP);
    /** Lines fitted: to where shaking ends, above 16 Hz it is quiet. */
    private static final int FITTED = (int) (17 / STEP);
    private static final int QUIET = (int) (16 / STEP);
    /** Above, sensors' filters and what lies between samples count: 25 Hz. */
    private static final int LINES = (int) (25 / STEP);
    private static final double MOST_GAIN = 1e4;
    private static final double RIDGE = 1e-13;

    private final int modes;
    private final int free;
    private final int others;
    /** Columns of N and T; those of the others follow. */
    private final int own;
    private final int columns;
    private final RealDft dft = new RealDft(LENGTH);
    private final double[] rest = new double[2 * FITTED];
    private final double[] weight = new double[LINES];
    private final double[] one = new double[2 * LINES];
    private final double[] wanted = new double[2 * LINES];
    private final double[] design;
    private final DMatrixRMaj normal;
    private final DMatrixRMaj right;
    private final DMatrixRMaj solution;
    private final LinearSolverDense<DMatrixRMaj> solver;
    private double[] u = {};
    private double[] y = {};
    private double[][] other = {};
    private double unit;
    private double still;
    private double known;

    FrequencyModel(int modes, int others) {
        this.modes = modes;
        this.others = others;
        free = modes == 1 ? 0 : 2 * modes - 1;
        own = free + 2 * modes + 1;
        columns = own + others * (2 * modes + 1);
        design = new double[2 * LINES * columns];
        normal = new DMatrixRMaj(columns, columns);
        right = new DMatrixRMaj(columns, 1);
        solution = new DMatrixRMaj(columns, 1);
        solver = LinearSolverFactory_DDRM.symmPosDef(columns);
    }

    /** Equations less what is fitted in them linearly. */
    int equations() {
        return 2 * FITTED - columns;
    }

    /**
     * Turns to a window.
     *
     * @param motion excitation, answer, others. Not modified.
     */
    void look(double[][] motion) {
        u = spectrum(motion[0]);
        y = spectrum(motion[1]);
        other = new double[others][];
        Arrays.setAll(other, i -> spectrum(motion[2 + i]));
        Arrays.fill(weight, 1);
    }

    /**
     * Weighs lines by the gain of a body.
     *
     * @param at logarithms of damping ratio and pulsation of each mode. Not modified.
     */
    void weigh(double[] at) {
        explain(at);
        for (int k = 0; k < LINES; k++) {
            weight[k] = 1 / Math.sqrt(1 + Math.min(MOST_GAIN, gain(k)));
        }
    }

    /** What the last {@link #explain} left, weighted: real and imaginary part of each line in turn. */
    double[] rest() {
        return rest;
    }

    /**
     * Fits what is linear.
     *
     * @param at logarithms, as of {@link #weigh}. Not modified.
     * @return squares left, weighted
     */
    double explain(double[] at) {
        unit = 0;
        for (int m = 0; m < modes; m++) {
            unit = Math.max(unit, Math.exp(at[2 * m + 1]));
        }
        still = 1;
        for (int m = 0; m < modes; m++) {
            still *= Math.exp(2 * at[2 * m + 1]) / (unit * unit);
        }
        known = modes == 1 ? 2 * Math.exp(at[0]) : 0;
        for (int k = 0; k < LINES; k++) {
            line(at, k);
        }
        solve();
        double squares = 0;
        for (int i = 0; i < rest.length; i++) {
            rest[i] = left(i) * weight[i / 2];
            squares += rest[i] * rest[i];
        }
        return squares;
    }

    private void line(double[] at, int k) {
        double omega = omega(k);
        double re = 1;
        double im = 0;
        for (int m = 0; m < modes; m++) {
            double w = Math.exp(at[2 * m + 1]) / unit;
            double real = w * w - omega * omega;
            double imaginary = 2 * Math.exp(at[2 * m]) * w * omega;
            double next = re * real - im * imaginary;
            im = re * imaginary + im * real;
            re = next;
        }
        double size = re * re + im * im;
        double tRe = re / size; // 1/D
        double tIm = -im / size;
        one[2 * k] = tRe;
        one[2 * k + 1] = tIm;
        double xRe = u[2 * k + 2] * tRe - u[2 * k + 3] * tIm; // U/D
        double xIm = u[2 * k + 2] * tIm + u[2 * k + 3] * tRe;
        wanted[2 * k] = y[2 * k + 2] - still * xRe + known * omega * xIm;
        wanted[2 * k + 1] = y[2 * k + 3] - still * xIm - known * omega * xRe;
        powers(k, 0, free, -omega * xIm, omega * xRe);
        powers(k, free, own, tRe, tIm);
        for (int i = 0; i < others; i++) {
            int from = own + i * (2 * modes + 1);
            double oRe = other[i][2 * k + 2];
            double oIm = other[i][2 * k + 3];
            powers(k, from, from + 2 * modes + 1, oRe * tRe - oIm * tIm, oRe * tIm + oIm * tRe);
        }
    }

    /** Columns of a value times 1, jω, (jω)² and so on. */
    private void powers(int k, int from, int to, double re, double im) {
        double omega = omega(k);
        double r = re;
        double i = im;
        for (int j = from; j < to; j++) {
            design[2 * k * columns + j] = r;
            design[(2 * k + 1) * columns + j] = i;
            double turned = -i * omega;
            i = r * omega;
            r = turned;
        }
    }

    private void solve() {
        normal.zero();
        right.zero();
        for (int i = 0; i < rest.length; i++) {
            double square = weight[i / 2] * weight[i / 2];
            for (int a = 0; a < columns; a++) {
                double value = square * design[i * columns + a];
                right.data[a] += value * wanted[i];
                for (int b = 0; b <= a; b++) {
                    normal.data[a * columns + b] += value * design[i * columns + b];
                }
            }
        }
        for (int a = 0; a < columns; a++) {
            normal.add(a, a, RIDGE * normal.get(a, a) + Double.MIN_NORMAL); // what tells nothing stays at rest
            for (int b = 0; b < a; b++) {
                normal.set(b, a, normal.get(a, b));
            }
        }
        solution.zero();
        if (solver.setA(normal)) {
            solver.solve(right, solution);
        }
    }

    /** What is left of a line's real (even) or imaginary (odd) part, not weighted. */
    private double left(int i) {
        double value = wanted[i];
        for (int j = 0; j < columns; j++) {
            value -= design[i * columns + j] * solution.data[j];
        }
        return value;
    }

    /** Noise of both sensors that would leave what is left where there is shaking: root mean square to 25 Hz [m/s²]. */
    double leftWhereShaken() {
        return noise(0, SHAKEN);
    }

    /** The same where there is none. */
    double leftWhereQuiet() {
        return noise(QUIET, LINES);
    }

    private double noise(int from, int to) {
        double sum = 0;
        for (int k = from; k < to; k++) {
            sum += (left(2 * k) * left(2 * k) + left(2 * k + 1) * left(2 * k + 1)) / (1 + gain(k));
        }
        return Math.sqrt(2.0 * LINES * sum / (to - from)) / LENGTH;
    }

    /** |N/D|² at a line. */
    private double gain(int k) {
        double omega = omega(k);
        double nRe = still;
        double nIm = known * omega;
        double pRe = 0;
        double pIm = omega;
        for (int j = 0; j < free; j++) {
            nRe += solution.data[j] * pRe;
            nIm += solution.data[j] * pIm;
            double turned = -pIm * omega;
            pIm = pRe * omega;
            pRe = turned;
        }
        return (nRe * nRe + nIm * nIm) * (one[2 * k] * one[2 * k] + one[2 * k + 1] * one[2 * k + 1]);
    }

    private double omega(int k) {
        return 2 * Math.PI * (k + 1) * STEP / unit;
    }

    private double[] spectrum(double[] samples) {
        return dft.forward(Arrays.copyOfRange(samples, samples.length - LENGTH, samples.length));
    }
}
