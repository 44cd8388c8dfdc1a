package wbv.filter.model;

import java.io.Serializable;

/**
 * One exact step in time of a mode, {@code v' = -d v - s w + u}, {@code w' = r v}, over {@code [0, T]}, and its derivatives to ln ω
 * and ln ζ, for which {@code ∂d = d, ∂s = 2 s} and {@code ∂d = d, ∂s = 0}.
 *
 * <p>The input is a polynomial in {@code t/T}, {@code u = Σ_j c_j (t/T)^j} with {@value InputWindow#POINTS} coefficients, so that
 * {@code x(T) = E x(0) + Σ_j g_j c_j} with {@code E = exp(AT)} and {@code g_j = j! T φ_{j+1}(AT) [1, 0]ᵀ} (Hochbruck and
 * Ostermann, Acta Numerica 2010, eq. 2.11). Since {@code M = AT} satisfies its own characteristic equation, {@code M² = a M + bc I}
 * for {@code M = [a b; c 0]}, every φ is {@code φ_m = α_m I + β_m M}; of {@code φ_{m-1} = M φ_m + I/(m-1)!} remains {@code β_{m-1} = 1/m!
 * + bc β_{m+1} + a β_m}, and the first column of φ_{m} is {@code [β_{m-1}, c β_m]}. The highest two β are summed as Taylor series, whose
 * terms follow from the two before in the same way. A step with {@code |AT| >= 2} is halved first and doubled after. No case of damping
 * is special.
 *
 * <p>Everything lies in flat arrays, which {@link #set} fills again and in which nothing is allocated.
 */
public final class ModeStep implements Serializable {

    private static final long serialVersionUID = 1;
    /** Derivatives: to ln ω and to ln ζ. */
    static final int PARAMETERS = 2;
    private static final int POINTS = InputWindow.POINTS;
    private static final int MOST_TERMS = 40;
    private static final double[] FACTORIAL = new double[POINTS + 2];
    private static final double[] OVER = new double[MOST_TERMS + POINTS + 2];
    /** A term of the series for β_8, which begins with 1/9!. */
    private static final double NEGLIGIBLE;

    static {
        FACTORIAL[0] = 1;
        for (int k = 1; k < FACTORIAL.length; k++) {
            FACTORIAL[k] = k * FACTORIAL[k - 1];
        }
        for (int k = 1; k < OVER.length; k++) {
            OVER[k] = 1.0 / k;
        }
        NEGLIGIBLE = 1e-17 / FACTORIAL[POINTS + 1];
    }

    private final double time;
    private final boolean slopes;
    private final double[] e = new double[4];
    private final double[] g = new double[2 * POINTS];
    private final double[] de;
    private final double[] dg;

    /**
     * @param time T [s]
     * @param slopes whether derivatives will be asked for
     */
    ModeStep(double time, boolean slopes) {
        this.time = time;
        this.slopes = slopes;
        this.de = new double[slopes ? 4 * PARAMETERS : 0];
        this.dg = new double[slopes ? 2 * POINTS * PARAMETERS : 0];
    }

    /** E, row by row [1]: what is left of the state after the step. Not to be modified. */
    public double[] transition() {
        return e;
    }

    /** g_j [s] for each j in turn, row by row: what the input's coefficient of (t/T)^j adds to the state. Not to be modified. */
    public double[] gains() {
        return g;
    }

    /** The first number of g_0. */
    public double firstGain() {
        return g[0];
    }

    /** The second number of g_0. */
    public double secondGain() {
        return g[1];
    }

    /** Derivatives of {@link #transition}: to ln ω, then to ln ζ. Not to be modified. Thesis: Eq. 4-13. */
    double[] transitionSlopes() {
        return de;
    }

    /** Derivatives of {@link #gains}, likewise. Not to be modified. */
    double[] gainSlopes() {
        return dg;
    }

    /**
     * Takes a mode. Thesis: Eq. 5-3, 6-3.
     *
     * @param damper d [1/s]
     * @param spring s [1/s]
     * @param reference r [1/s]
     */
    void set(double damper, double spring, double reference) {
        double size = Math.max(Math.abs(damper) + Math.abs(spring), Math.abs(reference)) * time;
        if (!(size < 1e6)) {
            throw new IllegalArgumentException("|A| T must be < 1e6: " + size);
        }
        int halvings = Math.max(0, Math.getExponent(size));
        double h = Math.scalb(time, -halvings);
        if (slopes) {
            sumWithSlopes(-damper * h, -spring * h, reference * h, h);
        } else {
            sum(-damper * h, -spring * h, reference * h, h);
        }
        for (int i = 0; i < halvings; i++) {
            doubleStep();
        }
    }

    /**
     * M = [a b; c 0].
     *
     * @param h length of the step [s]
     */
    private void sum(double a, double b, double c, double h) {
        double d = b * c;
        double u = 1 / FACTORIAL[POINTS + 1];
        double before = 0;
        double above = 0;
        double beta = 0;
        for (int k = POINTS + 1; k <= POINTS + MOST_TERMS; k++) {
            beta += u;
            above += OVER[k + 1] * u;
            if (Math.abs(u) + Math.abs(before) < NEGLIGIBLE) {
                break;
            }
            double next = OVER[k + 1] * (a * u + OVER[k] * d * before);
            before = u;
            u = next;
        }
        for (int j = POINTS - 1; j >= 0; j--) {
            double factor = h * FACTORIAL[j];
            double next = 1 / FACTORIAL[j + 1] + d * above + a * beta;
            g[2 * j] = factor * next;
            g[2 * j + 1] = factor * c * beta;
            above = beta;
            beta = next;
        }
        fill(a, b, c, 1 + d * above + a * beta, beta);
    }

    private void fill(double a, double b, double c, double first, double beta) {
        e[0] = first;
        e[1] = b * beta;
        e[2] = c * beta;
        e[3] = first - a * beta;
    }

    /** The same; x and y are derivatives to ln ω and ln ζ, for which ∂a = a and ∂bc = 2bc, and ∂a = a and ∂bc = 0. */
    private void sumWithSlopes(double a, double b, double c, double h) {
        double d = b * c;
        double u = 1 / FACTORIAL[POINTS + 1];
        double before = 0;
        double above = 0;
        double beta = 0;
        double x = 0;
        double xBefore = 0;
        double xAbove = 0;
        double xBeta = 0;
        double y = 0;
        double yBefore = 0;
        double yAbove = 0;
        double yBeta = 0;
        for (int k = POINTS + 1; k <= POINTS + MOST_TERMS; k++) {
            double over = OVER[k + 1];
            beta += u;
            xBeta += x;
            yBeta += y;
            above += over * u;
            xAbove += over * x;
            yAbove += over * y;
            if (Math.abs(u) + Math.abs(before) + (Math.abs(x) + Math.abs(xBefore)) + (Math.abs(y) + Math.abs(yBefore)) < NEGLIGIBLE) {
                break;
            }
            double first = over * a;
            double second = over * OVER[k] * d;
            double au = first * u;
            double du = second * before;
            double nextX = first * x + second * xBefore + (au + 2 * du);
            double nextY = first * y + second * yBefore + au;
            before = u;
            xBefore = x;
            yBefore = y;
            u = au + du;
            x = nextX;
            y = nextY;
        }
        for (int j = POINTS - 1; j >= 0; j--) {
            double factor = h * FACTORIAL[j];
            double turned = factor * c;
            double au = a * beta;
            double du = d * above;
            double next = 1 / FACTORIAL[j + 1] + du + au;
            double nextX = d * xAbove + a * xBeta + (au + 2 * du);
            double nextY = d * yAbove + a * yBeta + au;
            g[2 * j] = factor * next;
            g[2 * j + 1] = turned * beta;
            dg[2 * j] = factor * nextX;
            dg[2 * j + 1] = turned * xBeta;
            dg[2 * POINTS + 2 * j] = factor * nextY;
            dg[2 * POINTS + 2 * j + 1] = turned * yBeta;
            above = beta;
            xAbove = xBeta;
            yAbove = yBeta;
            beta = next;
            xBeta = nextX;
            yBeta = nextY;
        }
        double au = a * beta;
        double du = d * above;
        fill(a, b, c, 1 + du + au, beta);
        fillSlope(0, a, b, c, d * xAbove + a * xBeta + (au + 2 * du), xBeta, beta, 2 * b);
        fillSlope(4, a, b, c, d * yAbove + a * yBeta + au, yBeta, beta, 0);
    }

    /**
     * ∂E = ∂α I + ∂β M + β ∂M.
     *
     * @param first ∂ of E's first number
     * @param slope of β
     * @param steeper ∂b
     */
    private void fillSlope(int at, double a, double b, double c, double first, double slope, double beta, double steeper) {
        de[at] = first;
        de[at + 1] = slope * b + beta * steeper;
        de[at + 2] = c * slope;
        de[at + 3] = first - slope * a - beta * a;
    }

    /** Two equal steps as one: E' = E E, g'_j = 2^-j (E g_j + Σ_{i ≤ j} C(j,i) g_i). */
    private void doubleStep() {
        for (int i = 0; i < de.length / 4; i++) {
            doubleGains(dg, 2 * POINTS * i, de, 4 * i);
        }
        doubleGains(g, 0, de, -1);
        for (int i = 0; i < de.length / 4; i++) {
            int at = 4 * i;
            double d0 = de[at];
            double d1 = de[at + 1];
            double d2 = de[at + 2];
            double d3 = de[at + 3];
            de[at] = d0 * e[0] + d1 * e[2] + e[0] * d0 + e[1] * d2;
            de[at + 1] = d0 * e[1] + d1 * e[3] + e[0] * d1 + e[1] * d3;
            de[at + 2] = d2 * e[0] + d3 * e[2] + e[2] * d0 + e[3] * d2;
            de[at + 3] = d2 * e[1] + d3 * e[3] + e[2] * d1 + e[3] * d3;
        }
        double e0 = e[0];
        double e1 = e[1];
        double e2 = e[2];
        double e3 = e[3];
        e[0] = e0 * e0 + e1 * e2;
        e[1] = e0 * e1 + e1 * e3;
        e[2] = e2 * e0 + e3 * e2;
        e[3] = e2 * e1 + e3 * e3;
    }

    /**
     * Gains, or derivatives of them before the gains themselves.
     *
     * @param slope place of ∂E, or -1
     * @param d ∂E. Not modified.
     */
    private void doubleGains(double[] gains, int from, double[] d, int slope) {
        for (int j = POINTS - 1; j >= 0; j--) {
            int at = from + 2 * j;
            double first = e[0] * gains[at] + e[1] * gains[at + 1];
            double second = e[2] * gains[at] + e[3] * gains[at + 1];
            if (slope >= 0) {
                first += d[slope] * g[2 * j] + d[slope + 1] * g[2 * j + 1];
                second += d[slope + 2] * g[2 * j] + d[slope + 3] * g[2 * j + 1];
            }
            double choose = 1;
            for (int k = 0; k <= j; k++) {
                first += choose * gains[from + 2 * k];
                second += choose * gains[from + 2 * k + 1];
                choose = choose * (j - k) / (k + 1);
            }
            gains[at] = Math.scalb(first, -j);
            gains[at + 1] = Math.scalb(second, -j);
        }
    }

    /**
     * Moves a state over the step. Thesis: Eq. 5-2, 6-2.
     *
     * @param c coefficients of the input. Not modified.
     * @param xi Modified.
     * @param at place of v in it
     */
    void move(double[] c, int points, double[] xi, int at) {
        double v = e[0] * xi[at] + e[1] * xi[at + 1];
        double w = e[2] * xi[at] + e[3] * xi[at + 1];
        for (int j = 0; j < points; j++) {
            v += g[2 * j] * c[j];
            w += g[2 * j + 1] * c[j];
        }
        xi[at] = v;
        xi[at + 1] = w;
    }

    /**
     * Derivatives of the state after the step, the state before held.
     *
     * @param c    coefficients of the input. Not modified.
     * @param xi   before the step. Not modified.
     * @param at place of v in it
     * @param into [∂v/∂ln ω, ∂v/∂ln ζ; ∂w/∂ln ω, ∂w/∂ln ζ] from a place. Modified.
     */
    void forced(double[] c, double[] xi, int at, double[] into, int place) {
        double v = xi[at];
        double w = xi[at + 1];
        double a = de[0] * v + de[1] * w;
        double b = de[4] * v + de[5] * w;
        double f = de[2] * v + de[3] * w;
        double k = de[6] * v + de[7] * w;
        for (int j = 0; j < POINTS; j++) {
            double u = c[j];
            a += dg[2 * j] * u;
            f += dg[2 * j + 1] * u;
            b += dg[2 * POINTS + 2 * j] * u;
            k += dg[2 * POINTS + 2 * j + 1] * u;
        }
        into[place] = a;
        into[place + 1] = b;
        into[place + 2] = f;
        into[place + 3] = k;
    }
}
