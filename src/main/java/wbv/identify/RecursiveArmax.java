package wbv.identify;

import java.io.Serializable;
import java.util.Arrays;

/**
 * ARMAX sample by sample, with forgetting. Allocates nothing per sample.
 *
 * <p>{@link Kind#EXTENDED_LEAST_SQUARES} regresses on past outputs, inputs and a-posteriori errors; it converges where
 * {@code 1/C - 1/2} is positive real (Ljung and Söderström, Theory and Practice of Recursive Identification, 1983, 4.3).
 * {@link Kind#MAXIMUM_LIKELIHOOD} filters the regressors by 1/C and converges to a local maximum of the likelihood whatever
 * C is. C keeps its roots inside the unit circle, and the covariance its trace below a cap, so that nothing winds up where the
 * input tells nothing.
 */
public final class RecursiveArmax implements Serializable {

    /** How the regressors are treated. */
    public enum Kind { EXTENDED_LEAST_SQUARES, MAXIMUM_LIKELIHOOD }

    private static final long serialVersionUID = 1;
    private static final double START = 1e4;
    private static final double EDGE = 0.995;
    /**
     * Early samples, whose errors come from a wrong C, are forgotten faster: 1 - λ begins at the first and falls by the second.
     */
    private static final double EARLY = 0.05;
    private static final double EARLY_FALL = 0.99;

    private final Kind kind;
    private final Orders orders;
    private final int inputs;
    private final double rate;
    private final double forgetting;
    private final int n;
    private final double[] theta;
    private final double[] p;
    private final double[] phi;
    private final double[] psi;
    private final double[][] filtered;
    private final double[] gain;
    private final double[] trialC;
    private final double[] work;
    private final double[][] recentU;
    private long samples;
    private double early;
    private double power;
    private double weight;

    /**
     * Begins with all coefficients 0 and little trust in them.
     *
     * @param inputs     number of inputs, &gt;= 1
     * @param rate       [Hz]
     * @param forgetting λ, weight of a sample over that of the next, &gt; 0 to 1; memory is 1/(1-λ) samples
     */
    public RecursiveArmax(Kind kind, Orders orders, int inputs, double rate, double forgetting) {
        if (inputs < 1 || !(rate > 0)) {
            throw new IllegalArgumentException("needs at least one input and a rate > 0 Hz: " + inputs + ", " + rate);
        }
        if (!(forgetting > 0 && forgetting <= 1)) {
            throw new IllegalArgumentException("forgetting must be > 0 to 1: " + forgetting);
        }
        this.kind = kind;
        this.orders = orders;
        this.inputs = inputs;
        this.rate = rate;
        this.forgetting = forgetting;
        this.n = orders.coefficients(inputs);
        this.theta = new double[n];
        this.p = new double[n * n];
        this.phi = new double[n];
        this.psi = new double[n];
        this.filtered = new double[Math.max(1, orders.nc())][n];
        this.gain = new double[n];
        this.trialC = new double[orders.nc()];
        this.work = new double[orders.nc()];
        this.recentU = new double[inputs][orders.nb() + orders.delay()];
        reset();
    }

    /** As before the first sample. */
    public void reset() {
        Arrays.fill(theta, 0);
        Arrays.fill(p, 0);
        for (int i = 0; i < n; i++) {
            p[i * n + i] = START;
        }
        Arrays.fill(phi, 0);
        for (double[] each : filtered) {
            Arrays.fill(each, 0);
        }
        for (double[] each : recentU) {
            Arrays.fill(each, 0);
        }
        samples = 0;
        early = EARLY;
        power = 0;
        weight = 0;
    }

    /**
     * Takes the next sample; one with a missing number is passed over.
     *
     * @param u one an input, in its own unit. Not modified.
     * @param y output, in its own unit
     * @return the output as predicted before it was seen, in its unit; NaN if the sample was passed over
     */
    public double step(double[] u, double y) {
        boolean whole = Double.isFinite(y);
        for (double value : u) {
            whole &= Double.isFinite(value);
        }
        if (!whole) {
            return Double.NaN;
        }
        int na = orders.na();
        for (int i = 0; i < inputs; i++) {
            double[] recent = recentU[i];
            System.arraycopy(recent, 0, recent, 1, recent.length - 1);
            recent[0] = u[i];
            System.arraycopy(recent, orders.delay(), phi, na + i * orders.nb(), orders.nb());
        }
        direction();
        double predicted = dot(theta, phi);
        double error = y - predicted;
        update(error);
        double after = y - dot(theta, phi);
        power = forgetting * power + error * after;
        weight = forgetting * weight + 1;
        shift(phi, 0, na, -y);
        shift(phi, na + inputs * orders.nb(), orders.nc(), after);
        samples++;
        return predicted;
    }

    /**
     * The output, in its unit, that goes with the next sample of the inputs, from everything before it. Changes nothing.
     *
     * @param u one an input, in its own unit. Not modified.
     */
    public double foresee(double[] u) {
        int na = orders.na();
        int nb = orders.nb();
        double sum = 0;
        for (int i = 0; i < na; i++) {
            sum += theta[i] * phi[i];
        }
        for (int i = 0; i < inputs; i++) {
            for (int j = 0; j < nb; j++) {
                int lag = j + orders.delay();
                sum += theta[na + i * nb + j] * (lag == 0 ? u[i] : recentU[i][lag - 1]);
            }
        }
        for (int i = n - orders.nc(); i < n; i++) {
            sum += theta[i] * phi[i];
        }
        return sum;
    }

    /** The model as now known; its variance is that of the recent errors. */
    public Armax model() {
        double[][] b = new double[inputs][];
        for (int i = 0; i < inputs; i++) {
            int from = orders.na() + i * orders.nb();
            b[i] = Arrays.copyOfRange(theta, from, from + orders.nb());
        }
        return new Armax(rate, Arrays.copyOf(theta, orders.na()), b, orders.delay(),
                Arrays.copyOfRange(theta, n - orders.nc(), n), weight > 0 ? Math.max(0, power / weight) : 0);
    }

    /** Samples taken. */
    public long samples() {
        return samples;
    }

    /** ψ: the regressors, filtered by 1/C for maximum likelihood. */
    private void direction() {
        System.arraycopy(phi, 0, psi, 0, n);
        int nc = orders.nc();
        if (kind == Kind.EXTENDED_LEAST_SQUARES || nc == 0) {
            return;
        }
        for (int i = 0; i < nc; i++) {
            double c = theta[n - nc + i];
            double[] before = filtered[(int) Math.floorMod(samples - 1 - i, (long) nc)];
            for (int j = 0; j < n; j++) {
                psi[j] -= c * before[j];
            }
        }
        System.arraycopy(psi, 0, filtered[(int) (samples % nc)], 0, n);
    }

    private void update(double error) {
        double lambda = Math.min(forgetting, 1 - early);
        early *= EARLY_FALL;
        double s = lambda;
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int j = 0; j < n; j++) {
                sum += p[i * n + j] * psi[j];
            }
            gain[i] = sum;
        }
        s += dot(gain, psi);
        // P = (P - K ψᵀP)/λ with K = Pψ/s, kept symmetric; not forgotten where the trace is at its cap
        double trace = 0;
        for (int i = 0; i < n; i++) {
            trace += p[i * n + i] - gain[i] * gain[i] / s;
        }
        double forget = trace / lambda > START * n ? 1 : lambda;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                double value = (p[i * n + j] - gain[i] * gain[j] / s) / forget;
                p[i * n + j] = value;
                p[j * n + i] = value;
            }
        }
        double share = largestStableStep(error / s);
        for (int i = 0; i < n; i++) {
            theta[i] += share * gain[i] * error / s;
        }
    }

    /** Halves the step until C stays inside the unit circle. */
    private double largestStableStep(double factor) {
        int nc = orders.nc();
        for (double share = 1; share > 1e-3; share /= 2) {
            for (int i = 0; i < nc; i++) {
                trialC[i] = theta[n - nc + i] + share * gain[n - nc + i] * factor;
            }
            if (Polynomial.inside(trialC, EDGE, work)) {
                return share;
            }
        }
        return 0;
    }

    private static void shift(double[] values, int from, int count, double first) {
        if (count > 0) {
            System.arraycopy(values, from, values, from + 1, count - 1);
            values[from] = first;
        }
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
