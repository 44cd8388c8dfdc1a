package wbv.identify;

import java.util.Arrays;
import org.apache.commons.math3.distribution.TDistribution;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import wbv.signal.RealDft;

/**
 * Output error over one stretch: the parameters of a {@link ModalBody} that minimise {@code Σ w e²}, {@code e = M (y - H u)},
 * by Levenberg and Marquardt with exact slopes. u is the band-limited input, so that the simulation is exact between samples; M
 * takes out what {@link CrossMotions other motions of the base} can explain.
 *
 * <p>A real sitter is no such body, so the errors are large, follow each other, and know the input. The deviations are those
 * of a misspecified model (White, Econometrica 50, 1982): {@code V = A⁻¹ B A⁻¹}, A the full second derivative of half the cost,
 * B the long-run variance of its slope, from the scatter of its sums over batches of the stretch, each several memories of
 * the body and of the excitation long (batch means; Student's quantile for their number).
 */
final class EquivalentBodyFit {

    private static final int ITERATIONS = 60;
    private static final double CONVERGED = 1e-9;
    private static final double HESSIAN_STEP = 1e-4;

    private final double rate;
    private final double[] y;
    private final double[] weight;
    private final CrossMotions.Explaining others;
    private final double[] spectrum;
    private final RealDft dft;
    private final ModalBody body;
    private final double[][] rows;

    /** Cost and its slope at one place. */
    private double cost;
    private final double[] gradient;
    private final DMatrixRMaj normal;

    /**
     * @param rate          [Hz]
     * @param dft           of the input with zeros behind it, so that the end does not run into the beginning
     * @param inputSpectrum of the input without offset and gaps. Not modified.
     * @param y             output without offset; anything where its weight is 0. Not modified.
     * @param weight        0 or 1 for each sample of y. Not modified.
     * @param others        what is taken out
     * @param body          what is fitted
     */
    EquivalentBodyFit(double rate, RealDft dft, double[] inputSpectrum, double[] y, double[] weight, CrossMotions.Explaining others,
            ModalBody body) {
        this.rate = rate;
        this.y = y;
        this.weight = weight;
        this.others = others;
        this.dft = dft;
        this.spectrum = inputSpectrum;
        this.body = body;
        this.rows = new double[1 + body.parameters()][];
        this.gradient = new double[body.parameters()];
        this.normal = new DMatrixRMaj(body.parameters(), body.parameters());
    }

    /** Simulates and fills e into rows[0] and the slopes of the simulation into the others, all weighted and projected. */
    private void look(double[] theta, boolean slopes) {
        int p = slopes ? body.parameters() : 0;
        double[][] lines = new double[1 + p][spectrum.length];
        double step = 2 * Math.PI * rate / dft.length();
        for (int k = 0; k <= dft.length() / 2; k++) {
            body.at(theta, k * step);
            double uRe = spectrum[2 * k];
            double uIm = spectrum[2 * k + 1];
            for (int i = 0; i <= p; i++) {
                double hRe = body.re()[i];
                double hIm = body.im()[i];
                lines[i][2 * k] = hRe * uRe - hIm * uIm;
                lines[i][2 * k + 1] = k == 0 || 2 * k == dft.length() ? 0 : hRe * uIm + hIm * uRe;
            }
        }
        for (int i = 0; i <= p; i++) {
            rows[i] = dft.inverse(lines[i]);
            for (int t = 0; t < y.length; t++) {
                rows[i][t] = weight[t] * (i == 0 ? y[t] - rows[i][t] : rows[i][t]);
            }
            others.takeOut(rows[i]);
        }
        cost = dot(rows[0], rows[0]);
        for (int i = 0; i < p; i++) {
            gradient[i] = -dot(rows[0], rows[1 + i]);
            for (int j = 0; j <= i; j++) {
                double sum = dot(rows[1 + i], rows[1 + j]);
                normal.set(i, j, sum);
                normal.set(j, i, sum);
            }
        }
    }

    private double dot(double[] a, double[] b) {
        double sum = 0;
        for (int t = 0; t < y.length; t++) {
            sum += a[t] * b[t];
        }
        return sum;
    }

    /** Cost of no body: what the other motions leave of the output. */
    double whole() {
        double[] left = new double[y.length];
        for (int t = 0; t < y.length; t++) {
            left[t] = weight[t] * y[t];
        }
        others.takeOut(left);
        return dot(left, left);
    }

    /** Cost at a place; infinite where no body can be. */
    double cost(double[] theta) {
        if (!body.within(theta, rate)) {
            return Double.POSITIVE_INFINITY;
        }
        look(theta, false);
        return cost;
    }

    /** Moves theta to a minimum; returns the cost there. */
    double minimise(double[] theta) {
        int p = body.parameters();
        double lambda = 1e-3;
        DMatrixRMaj damped = new DMatrixRMaj(p, p);
        DMatrixRMaj step = new DMatrixRMaj(p, 1);
        look(theta, true);
        double best = cost;
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            DMatrixRMaj here = normal.copy();
            double[] slope = gradient.clone();
            boolean better = false;
            double gain = 0;
            for (int attempt = 0; attempt < 12 && !better; attempt++) {
                damped.setTo(here);
                for (int i = 0; i < p; i++) {
                    damped.add(i, i, lambda * Math.max(here.get(i, i), 1e-12 * best));
                }
                DMatrixRMaj right = new DMatrixRMaj(p, 1);
                for (int i = 0; i < p; i++) {
                    right.set(i, 0, -slope[i]);
                }
                if (!CommonOps_DDRM.solve(damped, right, step)) {
                    lambda *= 10;
                    continue;
                }
                double[] next = theta.clone();
                for (int i = 0; i < p; i++) {
                    next[i] += Math.max(-0.5, Math.min(0.5, step.get(i, 0)));
                }
                double there = cost(next);
                better = there < best;
                if (better) {
                    gain = (best - there) / best;
                    best = there;
                    System.arraycopy(next, 0, theta, 0, p);
                    lambda = Math.max(1e-9, lambda / 10);
                } else {
                    lambda *= 10;
                }
            }
            if (!better || gain < CONVERGED) {
                break;
            }
            look(theta, true);
        }
        return best;
    }

    /**
     * Half of the intervals that hold each parameter with 95 %; empty array if the cost has no bottom there.
     *
     * @param theta at a minimum
     * @param batch samples of one batch
     */
    double[] deviations(double[] theta, int batch) {
        int p = body.parameters();
        DMatrixRMaj curvature = new DMatrixRMaj(p, p);
        for (int i = 0; i < p; i++) {
            double[] there = theta.clone();
            there[i] += HESSIAN_STEP;
            look(there, true);
            double[] up = gradient.clone();
            there[i] -= 2 * HESSIAN_STEP;
            look(there, true);
            for (int j = 0; j < p; j++) {
                curvature.set(i, j, (up[j] - gradient[j]) / (2 * HESSIAN_STEP));
            }
        }
        for (int i = 0; i < p; i++) {
            for (int j = 0; j < i; j++) {
                double mean = (curvature.get(i, j) + curvature.get(j, i)) / 2;
                curvature.set(i, j, mean);
                curvature.set(j, i, mean);
            }
        }
        look(theta, true);
        int batches = 0;
        DMatrixRMaj scatter = new DMatrixRMaj(p, p);
        double[] sum = new double[p];
        for (int from = 0; from + batch <= y.length; from += batch) {
            Arrays.fill(sum, 0);
            int counted = 0;
            for (int t = from; t < from + batch; t++) {
                counted += weight[t] > 0 ? 1 : 0;
                for (int i = 0; i < p; i++) {
                    sum[i] += rows[0][t] * rows[1 + i][t];
                }
            }
            if (counted < batch / 2) {
                continue;
            }
            batches++;
            for (int i = 0; i < p; i++) {
                for (int j = 0; j < p; j++) {
                    scatter.add(i, j, sum[i] * sum[j]);
                }
            }
        }
        DMatrixRMaj inverse = new DMatrixRMaj(p, p);
        if (batches <= p + 1 || !CommonOps_DDRM.invert(curvature, inverse)) {
            return new double[0];
        }
        // the sums add up to nothing at the minimum: one of each p is not free
        CommonOps_DDRM.scale(batches / (double) (batches - p), scatter);
        DMatrixRMaj half = new DMatrixRMaj(p, p);
        DMatrixRMaj covariance = new DMatrixRMaj(p, p);
        CommonOps_DDRM.mult(inverse, scatter, half);
        CommonOps_DDRM.mult(half, inverse, covariance);
        double quantile = new TDistribution(batches - p).inverseCumulativeProbability(0.975);
        double[] deviation = new double[p];
        for (int i = 0; i < p; i++) {
            deviation[i] = quantile * Math.sqrt(covariance.get(i, i));
            if (!(inverse.get(i, i) > 0) || !Double.isFinite(deviation[i])) {
                return new double[0];
            }
        }
        return deviation;
    }

    /** Errors after {@link #look}, weighted and projected. */
    double[] errors(double[] theta) {
        look(theta, false);
        return rows[0];
    }
}
