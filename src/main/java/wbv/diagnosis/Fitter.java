package wbv.diagnosis;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;
import wbv.body.Assembly;
import wbv.body.Simulator;

/**
 * Least squares of the whitened residual and the priors: Levenberg (1944) and Marquardt (1963), with steps projected into the
 * bounds and the exact sensitivities of the simulation.
 */
final class Fitter {

    private static final double LONGEST = 0.7;

    private final Evidence evidence;
    private final Simulator simulator;

    Fitter(Evidence evidence) {
        this.evidence = evidence;
        this.simulator = new Simulator(evidence.excitation());
    }

    /**
     * Where a fit stands.
     *
     * @param cost     sum of squares of the whitened residual and of the priors
     * @param residual whitened residual of the data, priors not included
     * @param slopes   whitened derivative of the residual to each coordinate; empty where it was not asked for
     */
    record State(Candidate candidate, double[] x, double cost, double[] residual, double[][] slopes) {

        /** Mean square of the whitened residual: 1 where nothing is left but noise. */
        double reduced() {
            double sum = 0;
            for (double r : residual) {
                sum += r * r;
            }
            return sum / residual.length;
        }

        boolean failed() {
            return !(cost < Double.MAX_VALUE);
        }
    }

    /** The residual at x, without derivatives. */
    State look(Candidate candidate, double[] x, Whitening whitening) {
        return state(candidate, x, whitening, false);
    }

    /** The residual at x with its derivatives. */
    State lookWithSlopes(Candidate candidate, double[] x, Whitening whitening) {
        return state(candidate, x, whitening, true);
    }

    /** @param most iterations at most @param tolerance relative gain below which a fit ends */
    State fit(Candidate candidate, double[] start, Whitening whitening, int most, double tolerance) {
        double[] x = start.clone();
        State state = state(candidate, x, whitening, true);
        double damping = 1e-3;
        for (int iteration = 0; iteration < most && !state.failed(); iteration++) {
            Normal normal = new Normal(state);
            State better = state;
            for (int attempt = 0; attempt < 6 && better == state; attempt++) {
                double[] next = normal.step(damping);
                State tried = state(candidate, next, whitening, false);
                if (tried.cost() < state.cost()) {
                    better = tried;
                } else {
                    damping *= 10;
                }
            }
            if (better == state) {
                break;
            }
            double gain = state.cost() - better.cost();
            damping = Math.max(damping / 8, 1e-7);
            boolean last = gain < tolerance * state.cost() || iteration + 1 == most;
            state = last ? better : state(candidate, better.x(), whitening, true);
            if (last) {
                break;
            }
        }
        return state;
    }

    private State state(Candidate candidate, double[] x, Whitening whitening, boolean sensitivities) {
        Assembly assembly;
        try {
            assembly = candidate.at(x);
        } catch (IllegalArgumentException outside) {
            return new State(candidate, x, Double.POSITIVE_INFINITY, new double[0], new double[0][]);
        }
        Simulator.Response response = simulator.run(assembly, sensitivities);
        if (response.diverged()) {
            return new State(candidate, x, Double.POSITIVE_INFINITY, new double[0], new double[0][]);
        }
        double[] residual = evidence.residual(response.outputs(), whitening);
        double cost = 0;
        for (double r : residual) {
            cost += r * r;
        }
        for (int i = 0; i < x.length; i++) {
            double pull = x[i] / candidate.knobs().get(i).deviation();
            cost += pull * pull;
        }
        double[][] slopes = new double[sensitivities ? x.length : 0][];
        for (int i = 0; i < slopes.length; i++) {
            Knob knob = candidate.knobs().get(i);
            slopes[i] = evidence.whitened(response.slopes()[candidate.index(i)], -knob.slope(x[i]), whitening);
        }
        return new State(candidate, x, Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost, residual, slopes);
    }

    /** The normal equations at a state. */
    static final class Normal {
        private final State state;
        private final double[] gradient;
        private final double[][] curvature;

        Normal(State state) {
            this.state = state;
            int n = state.x().length;
            gradient = new double[n];
            curvature = new double[n][n];
            for (int i = 0; i < n; i++) {
                double[] a = state.slopes()[i];
                gradient[i] = dot(a, state.residual());
                for (int j = 0; j <= i; j++) {
                    curvature[i][j] = dot(a, state.slopes()[j]);
                    curvature[j][i] = curvature[i][j];
                }
                double deviation = state.candidate().knobs().get(i).deviation();
                gradient[i] += state.x()[i] / (deviation * deviation);
                curvature[i][i] += 1 / (deviation * deviation);
            }
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
            double longest = Arrays.stream(step).map(Math::abs).max().orElse(0);
            double scale = longest > LONGEST ? LONGEST / longest : 1;
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
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
