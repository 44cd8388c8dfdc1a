package wbv.diagnosis;

import java.util.Arrays;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.signal.ScalarProduct;

/**
 * How the least cost rises as one number is moved away from its best value and everything else is refitted (profile likelihood:
 * Venzon and Moolgavkar 1988), and where it has risen by so much that the number can no longer be so large, or so small.
 */
final class Profile {

    private static final int STEPS = 4;
    private static final int WIDENINGS = 3;
    private static final int NARROWINGS = 2;
    /** Part of the rise by which an end may be off. */
    private static final double NEAR = 0.12;
    /** Part of the rise, either way, by which a parabola may miss it and still be one. */
    private static final double PARABOLA = 0.35;

    private final Fitter fitter;
    private final Fitter.State best;
    private final double[][] curvature;
    private final Estimand estimand;
    private final double[] direction;
    private final double at;
    private final boolean[] fixed;
    private final double rise;
    private final double half;

    /**
     * @param best   the fit, with slopes
     * @param curvature C of half its cost. Not modified.
     * @param solved C⁻¹ b with b the number's slope: how everything follows when the number moves. Not modified.
     * @param fixed  coordinates that stay where they are. Not modified.
     * @param rise   of the cost at an end of the interval
     */
    Profile(Fitter fitter, Fitter.State best, double[][] curvature, Estimand estimand, double[] solved, boolean[] fixed,
            double rise) {
        this.fitter = fitter;
        this.best = best;
        this.curvature = curvature;
        this.estimand = estimand;
        this.fixed = fixed;
        this.rise = rise;
        this.at = estimand.u(best.x());
        double variance = ScalarProduct.of(estimand.slope(best.x()), solved);
        this.direction = Arrays.stream(solved).map(x -> x / variance).toArray();
        this.half = Math.sqrt(variance * rise);
    }

    /**
     * What a side of the interval is.
     *
     * @param u infinite where nothing bounds the number
     */
    record End(double u, Interval.Source from) {}

    private record Point(double u, Fitter.State state) {}

    /** The end below ({@code side} -1) or above (1). */
    End end(int side) {
        if (!(half > 0 && half < Double.POSITIVE_INFINITY)) {   // the number does nothing
            return new End(side * Double.POSITIVE_INFINITY, Interval.Source.PROFILE);
        }
        double[] there = moved(best.x(), side * half);
        if (inside(there)) {
            double risen = fitter.look(best.candidate(), there, best.frame()).cost() - best.cost();
            if (Math.abs(risen / rise - 1) < PARABOLA) {
                return parabola(side);
            }
        }
        return search(side);
    }

    /** The end that the curvature alone has. */
    End parabola(int side) {
        return new End(at + side * half, Interval.Source.CURVATURE);
    }

    private End search(int side) {
        Point low = new Point(at, best);
        double step = half;
        Point high = low;
        for (int i = 0; i < WIDENINGS && risen(high) < rise; i++) {
            low = high;
            double bound = reach(low.state().x(), side);
            if (bound <= 1e-9 * half) {
                return new End(side * Double.POSITIVE_INFINITY, Interval.Source.PROFILE);
            }
            high = point(low, side * Math.min(step, bound));
            step *= 2;
        }
        if (risen(high) < rise) {
            return new End(side * Double.POSITIVE_INFINITY, Interval.Source.PROFILE);
        }
        for (int i = 0; i < NARROWINGS && Math.abs(risen(high) / rise - 1) > NEAR
                && Math.abs(risen(low) / rise - 1) > NEAR; i++) {
            Point middle = point(low, crossing(low, high) - low.u());
            if (risen(middle) < rise) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return new End(crossing(low, high), Interval.Source.PROFILE);
    }

    /**
     * Where the root of the rise, which is straight for a parabola, reaches that of the end; kept away from what is known
     * already.
     */
    private double crossing(Point low, Point high) {
        double a = Math.sqrt(Math.max(0, risen(low)));
        double b = high.state().failed() ? 2 * Math.sqrt(rise) + a : Math.sqrt(risen(high));
        double share = (Math.sqrt(rise) - a) / Math.max(b - a, 1e-300);
        return low.u() + Math.max(0.05, Math.min(1, share)) * (high.u() - low.u());
    }

    private double risen(Point point) {
        return point.state().cost() - best.cost();
    }

    /**
     * The least cost at a distance from a known point: Gauss-Newton steps of everything but the number, with the slopes of the
     * best fit, so that a step costs one simulation.
     */
    private Point point(Point from, double by) {
        Fitter.State state = fitter.look(best.candidate(), clamped(moved(from.state().x(), by)), best.frame());
        for (int i = 0; i < STEPS && !state.failed(); i++) {
            Fitter.State next = fitter.look(best.candidate(), refitted(state), best.frame());
            if (!(next.cost() < state.cost())) {
                break;
            }
            boolean settled = state.cost() - next.cost() < NEAR / 4 * rise;
            state = next;
            if (settled) {
                break;
            }
        }
        return new Point(from.u() + by, state);
    }

    /** One step: s = p - q (b·p) / (b·q), with C p = g and C q = b. */
    private double[] refitted(Fitter.State state) {
        double[] b = estimand.slope(state.x());
        boolean[] held = new boolean[b.length];
        double[] g = new double[b.length];
        double[] residual = state.residual();
        for (int i = 0; i < held.length; i++) {
            Knob knob = best.candidate().knobs().get(i);
            g[i] = ScalarProduct.of(best.slopes()[i], residual) + state.x()[i] / (knob.deviation() * knob.deviation());
            held[i] = state.x()[i] <= knob.low() + 1e-12 && g[i] > 0 || state.x()[i] >= knob.high() - 1e-12 && g[i] < 0;
            held[i] |= fixed[i] || estimand.isPlain() && b[i] != 0;
        }
        double[] p = DampedEquations.solve(curvature, g, held, 0);
        double[] q = DampedEquations.solve(curvature, b, held, 0);
        double bq = ScalarProduct.of(b, q);
        double share = bq > 0 ? ScalarProduct.of(b, p) / bq : 0;
        double[] next = state.x().clone();
        for (int i = 0; i < next.length; i++) {
            next[i] -= p[i] - q[i] * share;
        }
        return clamped(next);
    }

    /** Coordinates when the number moves by so much and the others follow as the curvature has it. */
    private double[] moved(double[] x, double by) {
        double[] out = x.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] += by * direction[i];
        }
        return out;
    }

    private double[] clamped(double[] x) {
        for (int i = 0; i < x.length; i++) {
            x[i] = best.candidate().knobs().get(i).within(x[i]);
        }
        return x;
    }

    private boolean inside(double[] x) {
        for (int i = 0; i < x.length; i++) {
            Knob knob = best.candidate().knobs().get(i);
            if (x[i] < knob.low() || x[i] > knob.high()) {
                return false;
            }
        }
        return true;
    }

    /** How far the number can move before one of the coordinates that it is made of stands at its bound. */
    private double reach(double[] x, int side) {
        double reach = Double.POSITIVE_INFINITY;
        for (int i : estimand.at()) {
            double slope = side * direction[i];
            Knob knob = best.candidate().knobs().get(i);
            if (slope != 0) {
                reach = Math.min(reach, ((slope > 0 ? knob.high() : knob.low()) - x[i]) / slope);
            }
        }
        return Math.max(0, reach);
    }
}
