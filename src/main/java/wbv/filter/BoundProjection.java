package wbv.filter;

import java.io.Serializable;
import java.util.Arrays;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Bounds;
import wbv.filter.model.SkyhookDegree;

/**
 * Moves an estimate to the most probable point that satisfies bounds: {@code min (ξ - ξ̂)ᵀ P⁻¹ (ξ - ξ̂)} (Simon, IET Control
 * Theory 2010; weighting W = P⁻¹). On the active rows, {@code ξ = ξ̂ - P Dᵀ (D P Dᵀ)⁻¹ (d(ξ̂) - d)} with D the derivative of
 * the bounded attributes, linearised again where they have been moved to.
 *
 * <p>Frequency, damping and the parts of the poles are bounded in their logarithms, where all but the imaginary part are
 * linear in the parameters. The active set grows by the bound violated by most standard deviations and loses bounds that push
 * the wrong way; a bound that contradicts those already active is left unsatisfied. The covariance stays as it is.
 */
final class BoundProjection implements Serializable {

    private static final long serialVersionUID = 1;
    private static final Bounds.Attribute[] ATTRIBUTES = Bounds.Attribute.values();
    private static final int MOST_ACTIVE = 2 * Bounds.MODES + 1;
    private static final int ROUNDS = 12;
    /** A bound is kept when it is missed by less (ln, or the output's own unit). */
    private static final double TOLERANCE = 1e-9;
    /** A row that others leave less than this share of its variance says nothing new. */
    private static final double DEPENDENT = 1e-9;
    /** The imaginary part has no slope at critical damping. */
    private static final double MOST_OSCILLATING = 0.999;

    private final BodyModel model;
    private final int n;
    private final int rows;
    private final double[] prior;
    private final double[] modelRow;
    private final double[][] slope;
    private final double[][] weighted;
    private final double[] value;
    private final boolean[] refused;
    /** Bounds whose logarithms were asked for last, a lower and an upper one for each row, and the logarithms: most stay for ever. */
    private final double[] asked;
    private final double[] logs;
    private final int[] active = new int[MOST_ACTIVE];
    private final boolean[] upper = new boolean[MOST_ACTIVE];
    private final double[][] gram = new double[MOST_ACTIVE][MOST_ACTIVE];
    private final double[] multiplier = new double[MOST_ACTIVE];
    private int count;

    BoundProjection(BodyModel model) {
        this.model = model;
        this.n = model.size();
        this.rows = model.modes() * ATTRIBUTES.length;
        this.prior = new double[n];
        this.modelRow = new double[model.states()];
        this.slope = new double[rows][n];
        this.weighted = new double[rows][n];
        this.value = new double[rows];
        this.refused = new boolean[rows];
        this.asked = new double[2 * rows];
        this.logs = new double[2 * rows];
        Arrays.fill(asked, Double.NaN);
    }

    /**
     * Applies bounds.
     *
     * @param bounds Not modified.
     * @param xi     Modified.
     * @param p      n by n. Not modified.
     * @return whether ξ moved
     */
    boolean apply(Bounds bounds, double[] xi, double[] p) {
        if (within(bounds, xi)) {
            return false;
        }
        System.arraycopy(xi, 0, prior, 0, n);
        Arrays.fill(refused, false);
        count = 0;
        boolean moved = false;
        boolean stale = false;
        for (int round = 0; round < ROUNDS; round++) {
            evaluate(bounds, xi, p);
            if (!stale && satisfied(bounds) && !activateWorst(bounds)) {
                return moved;
            }
            stale = false;
            if (solve(bounds, xi)) {
                moved = true;
                stale = dropWrong(bounds);
            } else {
                refused[active[--count]] = true;
                stale = true;
            }
        }
        return moved;
    }

    /** Whether no bound is missed, which is so nearly always. */
    private boolean within(Bounds bounds, double[] xi) {
        for (int row = 0; row < rows; row++) {
            if (!bounded(bounds, row)) {
                continue;
            }
            double at = evaluate(ATTRIBUTES[row % ATTRIBUTES.length], place(row, xi), xi, slope[row]);
            if (!(Math.max(at - upper(bounds, row), lower(bounds, row) - at) <= TOLERANCE)) {
                return false;
            }
        }
        return true;
    }

    /** Where ln ω of a row's mode is. */
    private int place(int row, double[] xi) {
        int states = model.states();
        boolean swapped = model.modes() == 2 && xi[states] > xi[states + 2];
        int mode = row / ATTRIBUTES.length;
        return states + 2 * (swapped ? 1 - mode : mode);
    }

    /** Values, slopes and P Dᵀ of all rows that are bounded. Thesis: Eq. 6-6, 6-10. */
    private void evaluate(Bounds bounds, double[] xi, double[] p) {
        for (int row = 0; row < rows; row++) {
            if (!bounded(bounds, row)) {
                continue;
            }
            double[] d = slope[row];
            Arrays.fill(d, 0);
            value[row] = evaluate(ATTRIBUTES[row % ATTRIBUTES.length], place(row, xi), xi, d);
            for (int i = 0; i < n; i++) {
                double sum = 0;
                for (int j = 0; j < n; j++) {
                    sum += p[i * n + j] * d[j];
                }
                weighted[row][i] = sum;
            }
        }
    }

    private double evaluate(Bounds.Attribute attribute, int omega, double[] xi, double[] d) {
        switch (attribute) {
            case FREQUENCY -> {
                d[omega] = 1;
                return xi[omega];
            }
            case DAMPING -> {
                d[omega + 1] = 1;
                return xi[omega + 1];
            }
            case REAL -> {
                d[omega] = 1;
                d[omega + 1] = 1;
                return xi[omega] + xi[omega + 1];
            }
            case IMAGINARY -> {
                double zeta = Math.min(MOST_OSCILLATING, Math.exp(xi[omega + 1]));
                d[omega] = 1;
                d[omega + 1] = -zeta * zeta / (1 - zeta * zeta);
                return xi[omega] + 0.5 * Math.log(1 - zeta * zeta);
            }
            case BASE_SHARE -> {
                d[omega + 2] = 1;
                return xi[omega + 2];
            }
            default -> {
                model.setOutput(xi);
                model.outputRow(modelRow);
                System.arraycopy(modelRow, 0, d, 0, modelRow.length);
                for (int i = 0; i < model.parameters(); i++) {
                    d[modelRow.length + i] = model.outputSlope(i, xi);
                }
                return model.output(xi);
            }
        }
    }

    private boolean bounded(Bounds bounds, int row) {
        if (ATTRIBUTES[row % ATTRIBUTES.length] == Bounds.Attribute.BASE_SHARE
                && !(model instanceof SkyhookDegree && row < ATTRIBUTES.length)) {
            return false;
        }
        return lower(bounds, row) != Double.NEGATIVE_INFINITY || upper(bounds, row) != Double.POSITIVE_INFINITY;
    }

    /** Lower bound of a row, in the row's own scale. */
    private double lower(Bounds bounds, int row) {
        int mode = row / ATTRIBUTES.length;
        return switch (ATTRIBUTES[row % ATTRIBUTES.length]) {
            case FREQUENCY -> log(2 * row, 2 * Math.PI * bounds.lower(mode, Bounds.Attribute.FREQUENCY));
            case DAMPING -> log(2 * row, bounds.lower(mode, Bounds.Attribute.DAMPING));
            case REAL -> log(2 * row, -bounds.upper(mode, Bounds.Attribute.REAL));
            case IMAGINARY -> log(2 * row, bounds.lower(mode, Bounds.Attribute.IMAGINARY));
            case BASE_SHARE -> bounds.lower(mode, Bounds.Attribute.BASE_SHARE);
            case OUTPUT -> mode > 0 ? Double.NEGATIVE_INFINITY : bounds.lower(mode, Bounds.Attribute.OUTPUT);
        };
    }

    private double upper(Bounds bounds, int row) {
        int mode = row / ATTRIBUTES.length;
        return switch (ATTRIBUTES[row % ATTRIBUTES.length]) {
            case FREQUENCY -> log(2 * row + 1, 2 * Math.PI * bounds.upper(mode, Bounds.Attribute.FREQUENCY));
            case DAMPING -> log(2 * row + 1, bounds.upper(mode, Bounds.Attribute.DAMPING));
            case REAL -> log(2 * row + 1, -bounds.lower(mode, Bounds.Attribute.REAL));
            case IMAGINARY -> log(2 * row + 1, bounds.upper(mode, Bounds.Attribute.IMAGINARY));
            case BASE_SHARE -> bounds.upper(mode, Bounds.Attribute.BASE_SHARE);
            case OUTPUT -> mode > 0 ? Double.POSITIVE_INFINITY : bounds.upper(mode, Bounds.Attribute.OUTPUT);
        };
    }

    /** Logarithm of a bound; what nothing can be below, or above, is none. */
    private double log(int place, double bound) {
        if (asked[place] != bound) {
            asked[place] = bound;
            logs[place] = bound > 0 ? Math.log(bound) : Double.NEGATIVE_INFINITY;
        }
        return logs[place];
    }

    /** Takes the bound that is missed by most standard deviations into the active set. Thesis: Eq. 6-8. */
    private boolean activateWorst(Bounds bounds) {
        int worst = -1;
        double most = 0;
        for (int row = 0; row < rows; row++) {
            if (!bounded(bounds, row) || refused[row] || isActive(row)) {
                continue;
            }
            double missed = Math.max(value[row] - upper(bounds, row), lower(bounds, row) - value[row]);
            double deviation = Math.sqrt(product(row, row));
            if (missed > TOLERANCE && missed < Double.POSITIVE_INFINITY && deviation > 0 && missed / deviation > most) {
                worst = row;
                most = missed / deviation;
            }
        }
        if (worst < 0 || count == MOST_ACTIVE) {
            return false;
        }
        active[count] = worst;
        upper[count] = value[worst] > upper(bounds, worst);
        count++;
        return true;
    }

    private boolean isActive(int row) {
        for (int i = 0; i < count; i++) {
            if (active[i] == row) {
                return true;
            }
        }
        return false;
    }

    private boolean satisfied(Bounds bounds) {
        for (int i = 0; i < count; i++) {
            if (Math.abs(value[active[i]] - target(bounds, i)) > TOLERANCE) {
                return false;
            }
        }
        return true;
    }

    private double target(Bounds bounds, int i) {
        return upper[i] ? upper(bounds, active[i]) : lower(bounds, active[i]);
    }

    /** D_i P D_jᵀ. */
    private double product(int i, int j) {
        double sum = 0;
        for (int k = 0; k < n; k++) {
            sum += slope[i][k] * weighted[j][k];
        }
        return sum;
    }

    /** ξ = ξ̂ - P Dᵀ (D P Dᵀ)⁻¹ (d(ξ) + D (ξ̂ - ξ) - d); false if the newest row depends on the others. Thesis: Eq. 6-9. */
    private boolean solve(Bounds bounds, double[] xi) {
        for (int i = 0; i < count; i++) {
            double residual = value[active[i]] - target(bounds, i);
            for (int k = 0; k < n; k++) {
                residual += slope[active[i]][k] * (prior[k] - xi[k]);
            }
            multiplier[i] = residual;
            for (int j = 0; j <= i; j++) {
                double sum = product(active[i], active[j]);
                double whole = sum;
                for (int k = 0; k < j; k++) {
                    sum -= gram[i][k] * gram[j][k];
                }
                if (i == j && !(sum > DEPENDENT * whole)) {
                    return false;
                }
                gram[i][j] = i == j ? Math.sqrt(sum) : sum / gram[j][j];
            }
        }
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < i; k++) {
                multiplier[i] -= gram[i][k] * multiplier[k];
            }
            multiplier[i] /= gram[i][i];
        }
        for (int i = count - 1; i >= 0; i--) {
            for (int k = i + 1; k < count; k++) {
                multiplier[i] -= gram[k][i] * multiplier[k];
            }
            multiplier[i] /= gram[i][i];
        }
        System.arraycopy(prior, 0, xi, 0, n);
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < n; k++) {
                xi[k] -= weighted[active[i]][k] * multiplier[i];
            }
        }
        return true;
    }

    /** An upper bound can only push down, and a lower one up: one that does not is not needed. */
    private boolean dropWrong(Bounds bounds) {
        boolean dropped = false;
        for (int i = count - 1; i >= 0; i--) {
            boolean known = lower(bounds, active[i]) == upper(bounds, active[i]);
            if (!known && (upper[i] ? multiplier[i] < 0 : multiplier[i] > 0)) {
                System.arraycopy(active, i + 1, active, i, count - i - 1);
                System.arraycopy(upper, i + 1, upper, i, count - i - 1);
                count--;
                dropped = true;
            }
        }
        return dropped;
    }
}
