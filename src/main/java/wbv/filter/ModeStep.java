package wbv.filter;

import java.io.Serializable;

/**
 * One exact step in time of a mode, {@code v' = -d v - s w + u}, {@code w' = r v}, over {@code [0, T]}, and its derivatives to ln ω
 * and ln ζ, for which {@code ∂d = d, ∂s = 2 s} and {@code ∂d = d, ∂s = 0}.
 *
 * <p>The input is a polynomial in {@code t/T}, {@code u = Σ_j c_j (t/T)^j} with {@value InputWindow#POINTS} coefficients, so that
 * {@code x(T) = E x(0) + Σ_j g_j c_j} with {@code E = exp(AT)} and {@code g_j = j! T φ_{j+1}(AT) [1, 0]ᵀ} (Hochbruck and
 * Ostermann, Acta Numerica 2010, eq. 2.11). The highest φ is summed as a Taylor series, the others follow from {@code φ_{m-1} = M
 * φ_m + I/(m-1)!}. Only first columns are needed: E is a polynomial of M, {@code E = α I + β M}, so that its second column follows from
 * its first. A step with {@code |AT| >= 2} is halved first and doubled after. No case of damping is special.
 *
 * <p>Everything lies in flat arrays, which {@link #set} fills again and in which nothing is allocated.
 */
final class ModeStep implements Serializable {

    private static final long serialVersionUID = 1;
    /** Derivatives: to ln ω and to ln ζ. */
    static final int PARAMETERS = 2;
    private static final int POINTS = InputWindow.POINTS;
    private static final double NEGLIGIBLE = 1e-17;
    private static final int MOST_TERMS = 40;
    private static final double[] FACTORIAL = new double[POINTS + 1];
    private static final double[] OVER = new double[MOST_TERMS + POINTS + 1];

    static {
        FACTORIAL[0] = 1;
        for (int k = 1; k <= POINTS; k++) {
            FACTORIAL[k] = k * FACTORIAL[k - 1];
        }
        for (int k = 1; k < OVER.length; k++) {
            OVER[k] = 1.0 / k;
        }
    }

    private final double time;
    private final boolean slopes;
    private final double[] e = new double[4];
    private final double[] g = new double[2 * POINTS];
    private final double[] de;
    private final double[] dg;

    /** @param time T [s] @param slopes whether derivatives will be asked for */
    ModeStep(double time, boolean slopes) {
        this.time = time;
        this.slopes = slopes;
        this.de = new double[slopes ? 4 * PARAMETERS : 0];
        this.dg = new double[slopes ? 2 * POINTS * PARAMETERS : 0];
    }

    /** E, row by row: what is left of the state after the step. Not to be modified. */
    double[] transition() {
        return e;
    }

    /** g_j for each j in turn, 2 each: what the input's coefficient of (t/T)^j adds to the state. Not to be modified. */
    double[] gains() {
        return g;
    }

    /** Derivatives of {@link #transition}: to ln ω, then to ln ζ. Not to be modified. */
    double[] transitionSlopes() {
        return de;
    }

    /** Derivatives of {@link #gains}, likewise. Not to be modified. */
    double[] gainSlopes() {
        return dg;
    }

    /** Takes a mode. @param damper d [1/s] @param spring s [1/s] @param reference r [1/s] */
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

    /** M = [a b; c 0]. @param h length of the step [s] */
    private void sum(double a, double b, double c, double h) {
        double t0 = 1 / FACTORIAL[POINTS];
        double t1 = 0;
        double v0 = 0;
        double v1 = 0;
        double negligible = NEGLIGIBLE / FACTORIAL[POINTS];
        for (int k = POINTS + 1; k <= POINTS + MOST_TERMS; k++) {
            v0 += t0;
            v1 += t1;
            if (Math.abs(t0) + Math.abs(t1) < negligible) {
                break;
            }
            double next = OVER[k] * (a * t0 + b * t1);
            t1 = OVER[k] * c * t0;
            t0 = next;
        }
        for (int j = POINTS - 1; j >= 0; j--) {
            double factor = h * FACTORIAL[j];
            g[2 * j] = factor * v0;
            g[2 * j + 1] = factor * v1;
            double next = a * v0 + b * v1 + 1 / FACTORIAL[j];
            v1 = c * v0;
            v0 = next;
        }
        fill(a, b, v0, v1 / c, v1);
    }

    private void fill(double a, double b, double v0, double beta, double v1) {
        e[0] = v0;
        e[1] = beta * b;
        e[2] = v1;
        e[3] = v0 - beta * a;
    }

    /** The same; x and y are the derivatives of v. ∂M/∂ln ω = [a 2b; 0 0], ∂M/∂ln ζ = [a 0; 0 0]. */
    private void sumWithSlopes(double a, double b, double c, double h) {
        double t0 = 1 / FACTORIAL[POINTS];
        double t1 = 0;
        double p0 = 0;
        double p1 = 0;
        double q0 = 0;
        double q1 = 0;
        double v0 = 0;
        double v1 = 0;
        double x0 = 0;
        double x1 = 0;
        double y0 = 0;
        double y1 = 0;
        double negligible = NEGLIGIBLE / FACTORIAL[POINTS];
        for (int k = POINTS + 1; k <= POINTS + MOST_TERMS; k++) {
            v0 += t0;
            v1 += t1;
            x0 += p0;
            x1 += p1;
            y0 += q0;
            y1 += q1;
            double left = Math.abs(t0) + Math.abs(t1) + Math.abs(p0) + Math.abs(p1) + Math.abs(q0) + Math.abs(q1);
            if (left < negligible) {
                break;
            }
            double over = OVER[k];
            double at = a * t0;
            double bt = b * t1;
            double nextP = over * (a * p0 + b * p1 + at + 2 * bt);
            double nextQ = over * (a * q0 + b * q1 + at);
            double step = over * c;
            p1 = step * p0;
            q1 = step * q0;
            t1 = step * t0;
            p0 = nextP;
            q0 = nextQ;
            t0 = over * (at + bt);
        }
        for (int j = POINTS - 1; j >= 0; j--) {
            double factor = h * FACTORIAL[j];
            g[2 * j] = factor * v0;
            g[2 * j + 1] = factor * v1;
            dg[2 * j] = factor * x0;
            dg[2 * j + 1] = factor * x1;
            dg[2 * POINTS + 2 * j] = factor * y0;
            dg[2 * POINTS + 2 * j + 1] = factor * y1;
            double av = a * v0;
            double bv = b * v1;
            double nextX = a * x0 + b * x1 + av + 2 * bv;
            double nextY = a * y0 + b * y1 + av;
            x1 = c * x0;
            y1 = c * y0;
            v1 = c * v0;
            x0 = nextX;
            y0 = nextY;
            v0 = av + bv + 1 / FACTORIAL[j];
        }
        double beta = v1 / c;
        fill(a, b, v0, beta, v1);
        fillSlope(0, a, b, x0, x1, x1 / c, beta, 2 * b);
        fillSlope(4, a, b, y0, y1, y1 / c, beta, 0);
    }

    /** ∂E = ∂α I + ∂β M + β ∂M. @param slope of β @param steeper ∂b */
    private void fillSlope(int at, double a, double b, double x0, double x1, double slope, double beta, double steeper) {
        de[at] = x0;
        de[at + 1] = slope * b + beta * steeper;
        de[at + 2] = x1;
        de[at + 3] = x0 - slope * a - beta * a;
    }

    /** Two equal steps as one: E' = E E, g'_j = 2^-j (E g_j + Σ_{i<=j} C(j,i) g_i). */
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

    /** Gains, or derivatives of them before the gains themselves. @param slope place of ∂E, or -1 @param d ∂E. Not modified. */
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

    /** Moves a state over the step. @param c coefficients of the input. Not modified. @param xi Modified. @param at place of v in it */
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
     * @param xi   before the step. Not modified. @param at place of v in it
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
