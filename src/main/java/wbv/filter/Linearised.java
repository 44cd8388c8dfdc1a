package wbv.filter;

import wbv.filter.model.BodyModel;
import wbv.filter.model.OneDegree;

/**
 * Moments of the extended Kalman filter: exact derivatives at the mean. Products are written out for what F is, the rows of each
 * mode's motion beside rows of the identity, and for what KH is, of rank one.
 */
final class Linearised implements Moments {

    private static final long serialVersionUID = 1;

    private final BodyModel model;
    private final double decay;
    private final int n;
    private final int states;
    private final int offset;
    private final double[] row;
    private final double[] h;
    private final double[] crossed;
    private final double[] work;
    private double variance;

    /**
     * @param model the filter's own, with slopes, set at the mean when called
     * @param decay of the offset over one sample
     */
    Linearised(BodyModel model, double decay) {
        this.model = model;
        this.decay = decay;
        this.n = model.size();
        this.states = model.states();
        this.offset = model.offset();
        this.row = new double[states];
        this.h = new double[n];
        this.crossed = new double[n];
        this.work = new double[n * n];
    }

    /**
     * Those of a model, written out where it has one degree of freedom.
     *
     * @param model as the constructor has it
     * @param decay likewise
     */
    static Moments of(BodyModel model, double decay) {
        return model instanceof OneDegree one ? new LinearisedOne(one, decay) : new Linearised(model, decay);
    }

    /** P = F P Fᵀ, F = ∂g/∂ξ before ξ moves. Thesis: Eq. 4-8, 4-11. */
    @Override
    public void advance(double[] c, double[] forced, double[] xi, double[] p) {
        model.advance(c, c.length, xi);
        xi[offset] *= decay;
        for (int i = 0; i < states; i++) {
            timesRow(i, forced, p);
        }
        for (int i = 0; i < states; i++) {
            timesColumn(i, forced, p);
        }
        for (int i = states; i < offset; i++) {
            double value = decay * p[i * n + offset];
            p[i * n + offset] = value;
            p[offset * n + i] = value;
        }
        p[offset * n + offset] *= decay * decay;
    }

    /** Row i of F P, of the motion. */
    private void timesRow(int i, double[] forced, double[] p) {
        double[] e = model.step(i / 2).transition();
        int r = i % 2;
        int first = i - r;
        int at = first * n;
        int parameter = (states + first) * n;
        double e0 = e[2 * r];
        double e1 = e[2 * r + 1];
        double s0 = forced[2 * i];
        double s1 = forced[2 * i + 1];
        for (int j = 0; j < n; j++) {
            work[i * n + j] = e0 * p[at + j] + e1 * p[at + n + j] + s0 * p[parameter + j] + s1 * p[parameter + n + j];
        }
    }

    /** Row i of (F P) Fᵀ, of the motion, and the column like it. */
    private void timesColumn(int i, double[] forced, double[] p) {
        int at = i * n;
        for (int k = 0; k <= i; k++) {
            double[] e = model.step(k / 2).transition();
            int r = k % 2;
            int first = at + k - r;
            double value = work[first] * e[2 * r] + work[first + 1] * e[2 * r + 1] + work[first + states] * forced[2 * k]
                    + work[first + states + 1] * forced[2 * k + 1];
            p[at + k] = value;
            p[k * n + i] = value;
        }
        for (int j = states; j < n; j++) {
            double value = j == offset ? decay * work[at + j] : work[at + j];
            p[at + j] = value;
            p[j * n + i] = value;
        }
    }

    /** Variance of the innovation: H P Hᵀ + R. Thesis: Eq. 4-14. */
    @Override
    public double measure(double[] xi, double[] p, double[] cross) {
        model.outputRow(row);
        System.arraycopy(row, 0, h, 0, states);
        for (int i = states; i < offset; i++) {
            h[i] = model.outputSlope(i - states, xi);
        }
        h[offset] = 1;
        double all = 0;
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int j = 0; j < n; j++) {
                sum += p[i * n + j] * h[j];
            }
            cross[i] = sum;
            crossed[i] = sum;
            all += h[i] * sum;
        }
        variance = Math.max(0, all);
        return model.output(xi) + xi[offset];
    }

    @Override
    public double variance() {
        return variance;
    }

    /**
     * P = (I - KH) P (I - KH)ᵀ + K R Kᵀ (Joseph), by {@code A = P - K (P Hᵀ)ᵀ} and {@code P = A - (A Hᵀ) Kᵀ + K R Kᵀ}. Thesis: Eq. 4-17.
     */
    @Override
    public void reduce(double[] gain, double r, double[] p) {
        for (int i = 0; i < n; i++) {
            double k = gain[i];
            double sum = 0;
            for (int j = 0; j < n; j++) {
                double value = p[i * n + j] - k * crossed[j];
                work[i * n + j] = value;
                sum += value * h[j];
            }
            double left = r * k - sum;
            for (int j = 0; j <= i; j++) {
                double value = work[i * n + j] + left * gain[j];
                p[i * n + j] = value;
            }
        }
        mirror(p, n);
    }

    /**
     * The upper half becomes what the lower is.
     *
     * @param p n by n. Modified.
     */
    static void mirror(double[] p, int n) {
        for (int i = 1; i < n; i++) {
            for (int j = 0; j < i; j++) {
                p[j * n + i] = p[i * n + j];
            }
        }
    }
}
