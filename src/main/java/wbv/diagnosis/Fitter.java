package wbv.diagnosis;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;
import wbv.body.Assembly;
import wbv.body.Excitation;
import wbv.body.Simulator;

/**
 * Least squares of the whitened residual and the priors: Levenberg (1944) and Marquardt (1963), with steps projected into the
 * bounds and the exact sensitivities of the simulation.
 */
final class Fitter {

    /** The farthest that a number found by factors moves in one step: the logarithm of two. */
    private static final double LONGEST = 0.7;
    /** The farthest that any other number moves, in its own units; more where it is large already. */
    private static final double LONGEST_UNITS = 3;
    /** Steps without new derivatives after each with: a free run's derivatives cost as much as four looks, others hardly more than one. */
    private static final int CHORDS = 4;
    private static final int LINEAR_CHORDS = 1;
    private static final double LEAST_CHORD = 0.2;

    private final Evidence evidence;
    private final Excitation excitation;
    private final Simulator simulator;

    /** Fits on the evidence's fit window. */
    Fitter(Evidence evidence) {
        this(evidence, evidence.excitation());
    }

    /** @param excitation all of the input that the windows to be looked at need */
    Fitter(Evidence evidence, Excitation excitation) {
        this.evidence = evidence;
        this.excitation = excitation;
        this.simulator = new Simulator(excitation);
    }

    /**
     * Where a fit stands.
     *
     * @param cost     sum of squares of the whitened residual, of the sensors' errors and of the priors
     * @param residual whitened residual of the data without what the sensors' errors explain
     * @param errors   the sensors' errors in standard deviations
     * @param slopes   whitened derivative of the residual to each coordinate; empty where it was not asked for
     * @param frame    whitening and errors that all this stands in
     */
    record State(Candidate candidate, double[] x, double cost, double[] residual, double[] errors, double[][] slopes, Frame frame) {

        /** Mean square of the whitened residual: 1 where nothing is left but noise; infinite for a fit that failed. */
        double reduced() {
            double sum = failed() ? Double.POSITIVE_INFINITY : 0;
            for (double r : residual) {
                sum += r * r;
            }
            return sum / frame.whitening().degrees();
        }

        /** Coordinates that stand at a bound, or have no room to move. */
        boolean[] held() {
            boolean[] out = new boolean[x.length];
            for (int i = 0; i < x.length; i++) {
                Knob knob = candidate.knobs().get(i);
                out[i] = x[i] <= knob.low() + 1e-9 || x[i] >= knob.high() - 1e-9 || knob.high() - knob.low() < 1e-3;
            }
            return out;
        }

        boolean failed() {
            return !(cost < Double.MAX_VALUE);
        }

        /** Another state with the derivatives of this one, corrected along the way between them by what the residual did (Broyden 1965). */
        State followed(State next) {
            double[] change = frame.nuisances().raw(next.residual, next.errors);
            double[] here = frame.nuisances().raw(residual, errors);
            double[] weighted = new double[x.length];
            double length = 0;
            for (int i = 0; i < x.length; i++) {
                double moved = next.x[i] - x[i];
                weighted[i] = moved * dot(slopes[i], slopes[i]);
                length += moved * weighted[i];
            }
            for (int k = 0; k < change.length; k++) {
                change[k] -= here[k];
                for (int i = 0; i < x.length; i++) {
                    change[k] -= slopes[i][k] * (next.x[i] - x[i]);
                }
            }
            double[][] corrected = new double[x.length][];
            for (int i = 0; i < x.length; i++) {
                corrected[i] = slopes[i].clone();
                for (int k = 0; k < change.length && length > 0; k++) {
                    corrected[i][k] += change[k] * weighted[i] / length;
                }
            }
            return new State(candidate, next.x, next.cost, next.residual, next.errors, corrected, frame);
        }
    }

    /** What a residual is seen through. */
    record Frame(Whitening whitening, Nuisances nuisances) { }

    /** The frame that belongs to a model, in a window. */
    Frame frame(Candidate candidate, double[] x, Window window) {
        Whitening whitening = evidence.whitening(excitation, candidate.at(x), window);
        return new Frame(whitening, Nuisances.of(evidence, whitening));
    }

    /** The same frame blind to a latent signal. @param direction spectra over all lines of the excitation, by output. Not modified. */
    Frame blind(Frame frame, double[][] direction) {
        Whitening whitening = frame.whitening().without(evidence.atLines(excitation, direction, frame.whitening().window()));
        return new Frame(whitening, Nuisances.of(evidence, whitening));
    }

    /** The residual at x, without derivatives. */
    State look(Candidate candidate, double[] x, Frame frame) {
        return state(candidate, x, frame, false);
    }

    /** The residual at x with its derivatives. */
    State lookWithSlopes(Candidate candidate, double[] x, Frame frame) {
        return state(candidate, x, frame, true);
    }

    /**
     * Fits. Derivatives cost more than looks, so each set of them serves as long as steps with it still gain well.
     *
     * @param most iterations at most @param tolerance relative gain below which a fit ends
     */
    State fit(Candidate candidate, double[] start, Frame frame, int most, double tolerance) {
        State state = state(candidate, start.clone(), frame, true);
        double damping = 1e-3;
        for (int iteration = 0; iteration < most && !state.failed(); iteration++) {
            Normal normal = new Normal(state);
            State better = state;
            for (int attempt = 0; attempt < 6 && better == state; attempt++) {
                State tried = state(candidate, normal.step(damping), frame, false);
                if (tried.cost() < state.cost()) {
                    better = tried;
                } else {
                    damping *= 10;
                }
            }
            if (better == state) {
                break;
            }
            better = farther(better, normal, damping);
            double gain = state.cost() - better.cost();
            damping = Math.max(damping / 8, 1e-7);
            if (gain < tolerance * state.cost() || iteration + 1 == most) {
                return new State(candidate, better.x(), better.cost(), better.residual(), better.errors(), new double[0][], frame);
            }
            state = state(candidate, better.x(), frame, true);
        }
        return state;
    }

    /** More steps without new derivatives, as long as each gains a good part of what the one before it did. */
    private State farther(State first, Normal earlier, double damping) {
        State best = earlier.state.followed(first);
        Normal normal = new Normal(best);
        double gain = earlier.state.cost() - first.cost();
        boolean free = best.candidate().added().stream().anyMatch(Hypothesis::runsFree);
        for (int step = 0; step < (free ? CHORDS : LINEAR_CHORDS); step++) {
            State tried = state(best.candidate(), normal.step(damping), best.frame(), false);
            double more = best.cost() - tried.cost();
            if (!(more > 0)) {
                break;
            }
            best = best.followed(tried);
            if (more < LEAST_CHORD * gain) {
                break;
            }
            normal = new Normal(best);
            gain = more;
        }
        return best;
    }

    private State state(Candidate candidate, double[] x, Frame frame, boolean sensitivities) {
        Assembly assembly;
        try {
            assembly = candidate.at(x);
        } catch (IllegalArgumentException outside) {
            return new State(candidate, x, Double.POSITIVE_INFINITY, new double[0], new double[0], new double[0][], frame);
        }
        Simulator.Response response = simulator.run(assembly, sensitivities);
        if (response.diverged()) {
            return new State(candidate, x, Double.POSITIVE_INFINITY, new double[0], new double[0], new double[0][], frame);
        }
        double[] raw = evidence.residual(excitation, response.outputs(), frame.whitening());
        double[] errors = frame.nuisances().best(raw, frame.nuisances().off(candidate));
        double[] residual = frame.nuisances().removed(raw, errors);
        double cost = dot(residual, residual) + dot(errors, errors);
        for (int i = 0; i < x.length; i++) {
            double pull = x[i] / candidate.knobs().get(i).deviation();
            cost += pull * pull;
        }
        double[][] slopes = new double[sensitivities ? x.length : 0][];
        for (int i = 0; i < slopes.length; i++) {
            slopes[i] = evidence.whitened(excitation, response.slopes()[candidate.index(i)], -candidate.knobs().get(i).slope(x[i]),
                    frame.whitening());
        }
        return new State(candidate, x, Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost, residual, errors, slopes, frame);
    }

    /** The normal equations at a state. */
    static final class Normal {
        private final State state;
        private final Projection projection;
        private final double[][] products;
        private final double[] gradient;
        private final double[][] curvature;

        Normal(State state) {
            this.state = state;
            this.projection = new Projection(state);
            int n = state.x().length;
            gradient = new double[n];
            curvature = new double[n][];
            double[][] slopes = state.slopes();
            products = new double[n][];
            for (int i = 0; i < n; i++) {
                curvature[i] = new double[n];
                gradient[i] = dot(slopes[i], state.residual());
                products[i] = projection.products(slopes[i]);
                double[] follow = projection.errors(products[i]);
                for (int j = 0; j <= i; j++) {
                    curvature[i][j] = dot(slopes[i], slopes[j]) - dot(follow, products[j]);
                    curvature[j][i] = curvature[i][j];
                }
                double deviation = state.candidate().knobs().get(i).deviation();
                gradient[i] += state.x()[i] / (deviation * deviation);
                curvature[i][i] += 1 / (deviation * deviation);
            }
        }

        Projection projection() {
            return projection;
        }

        /** Products of the slopes with the sensors' errors, as {@link Projection} wants them. Not a copy. */
        double[][] products() {
            return products;
        }

        /** Second derivative of half the cost, priors included. Not a copy. */
        double[][] curvature() {
            return curvature;
        }

        double[] gradient() {
            return gradient;
        }

        /** The next x, within bounds. */
        double[] step(double damping) {
            int n = gradient.length;
            boolean[] held = new boolean[n];
            for (int i = 0; i < n; i++) {
                Knob knob = state.candidate().knobs().get(i);
                held[i] = state.x()[i] <= knob.low() + 1e-12 && gradient[i] > 0 || state.x()[i] >= knob.high() - 1e-12 && gradient[i] < 0;
            }
            double[] step = solve(curvature, gradient, held, damping);
            double scale = 1;
            for (int i = 0; i < n; i++) {
                boolean factor = state.candidate().knobs().get(i).unit() == 0;
                double longest = factor ? LONGEST : Math.max(LONGEST_UNITS, LONGEST * Math.abs(state.x()[i]));
                scale = Math.min(scale, longest / Math.max(Math.abs(step[i]), 1e-300));
            }
            double[] next = state.x().clone();
            for (int i = 0; i < n; i++) {
                Knob knob = state.candidate().knobs().get(i);
                next[i] = Math.max(knob.low(), Math.min(knob.high(), next[i] - scale * step[i]));
            }
            return next;
        }
    }

    /** (C + damping diag C) s = g over the coordinates that are not held; 0 for those that are. */
    static double[] solve(double[][] c, double[] g, boolean[] held, double damping) {
        int n = g.length;
        int[] free = java.util.stream.IntStream.range(0, n).filter(i -> !held[i]).toArray();
        double[] out = new double[n];
        if (free.length == 0) {
            return out;
        }
        // Scaled to a unit diagonal, so that knobs of any unit are solved with the same care.
        double[] size = new double[free.length];
        DMatrixRMaj a = new DMatrixRMaj(free.length, free.length);
        DMatrixRMaj b = new DMatrixRMaj(free.length, 1);
        for (int i = 0; i < free.length; i++) {
            size[i] = Math.sqrt(Math.max(c[free[i]][free[i]], 1e-300));
        }
        for (int i = 0; i < free.length; i++) {
            for (int j = 0; j < free.length; j++) {
                a.set(i, j, c[free[i]][free[j]] / size[i] / size[j] + (i == j ? damping + 1e-12 : 0));
            }
            b.set(i, g[free[i]] / size[i]);
        }
        LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(free.length);
        if (!solver.setA(a)) {
            solver = LinearSolverFactory_DDRM.pseudoInverse(true);
            solver.setA(a);
        }
        DMatrixRMaj x = new DMatrixRMaj(free.length, 1);
        solver.solve(b, x);
        for (int i = 0; i < free.length; i++) {
            out[free[i]] = x.get(i) / size[i];
        }
        return out;
    }

    static double dot(double[] a, double[] b) {
        double s0 = 0;
        double s1 = 0;
        double s2 = 0;
        double s3 = 0;
        int i = 0;
        for (; i + 3 < a.length; i += 4) {
            s0 += a[i] * b[i];
            s1 += a[i + 1] * b[i + 1];
            s2 += a[i + 2] * b[i + 2];
            s3 += a[i + 3] * b[i + 3];
        }
        for (; i < a.length; i++) {
            s0 += a[i] * b[i];
        }
        return s0 + s1 + s2 + s3;
    }
}
