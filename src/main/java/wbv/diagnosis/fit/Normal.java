package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.Columns;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.signal.ScalarProduct;

/** The normal equations of a least-squares fit at a state, what the sensors' errors would take projected out. */
public final class Normal {

    /** The farthest that a number found by factors moves in one step: the logarithm of two. */
    private static final double LONGEST = 0.7;
    /** The farthest that any other number moves, in its own units; more where it is large already. */
    private static final double LONGEST_UNITS = 3;

    private final Fitter.State state;
    private final Projection projection;
    private final double[][] products;
    private final double[][] gram;
    private final double[] gradient;
    private final double[][] curvature;

    /**
     * The equations at a state.
     *
     * @param state with its derivatives
     */
    public Normal(Fitter.State state) {
        this(state, new Projection(state));
    }

    private Normal(Fitter.State state, Projection projection) {
        this(state, projection, new Columns(state.slopes()));
    }

    private Normal(Fitter.State state, Projection projection, Columns slopes) {
        this(state, projection, projection.products(slopes), slopes.gram());
    }

    private Normal(Fitter.State state, Projection projection, double[][] products, double[][] gram) {
        this.state = state;
        this.projection = projection;
        this.products = products;
        this.gram = gram;
        int n = products.length;
        gradient = new double[n];
        curvature = curvature(state.candidate(), gram, products, projection::errors);
        double[] residual = state.residual();
        for (int i = 0; i < n; i++) {
            double deviation = state.candidate().knobs().get(i).deviation();
            gradient[i] = ScalarProduct.of(state.slopes()[i], residual) + state.x()[i] / (deviation * deviation);
        }
    }

    /**
     * Second derivative of half a cost to the coordinates [1], n by n, priors included, where the sensors' errors follow.
     *
     * @param gram products of the slopes [1], n by n
     * @param products of each slope with the errors that follow [1], n long. Neither is modified.
     * @param follow how these errors follow such products
     */
    static double[][] curvature(Candidate candidate, double[][] gram, double[][] products, UnaryOperator<double[]> follow) {
        int n = gram.length;
        double[][] out = new double[n][n];
        for (int i = 0; i < n; i++) {
            double[] errors = follow.apply(products[i]);
            for (int j = 0; j <= i; j++) {
                out[i][j] = gram[i][j] - ScalarProduct.of(errors, products[j]);
                out[j][i] = out[i][j];
            }
            double deviation = candidate.knobs().get(i).deviation();
            out[i][i] += 1 / (deviation * deviation);
        }
        return out;
    }

    /** The same at another state, whose derivatives are these, corrected along the way by what the residual did (Broyden 1965). */
    Normal followed(Fitter.State next) {
        int n = products.length;
        double[][] slopes = state.slopes();
        double[] change = next.raw().clone();
        double[] moved = new double[n];
        double[] weight = new double[n];
        double length = 0;
        for (int i = 0; i < n; i++) {
            moved[i] = next.x()[i] - state.x()[i];
            length += moved[i] * moved[i] * gram[i][i];
        }
        for (int k = 0; k < change.length; k++) {
            change[k] -= state.raw()[k];
        }
        for (int i = 0; i < n; i++) {
            weight[i] = length > 0 ? moved[i] * gram[i][i] / length : 0;
            add(change, slopes[i], -moved[i]);
        }
        double[][] corrected = new double[n][];
        double[] along = new double[n];
        for (int i = 0; i < n; i++) {
            along[i] = ScalarProduct.of(slopes[i], change);
            corrected[i] = slopes[i].clone();
            add(corrected[i], change, weight[i]);
        }
        Fitter.State there = next.withSlopes(corrected);
        if (!projection.suits(there)) {
            return new Normal(there);
        }
        double square = ScalarProduct.of(change, change);
        double[] shared = projection.products(change);
        double[][] theirs = new double[n][];
        double[][] grown = new double[n][n];
        for (int i = 0; i < n; i++) {
            theirs[i] = products[i].clone();
            add(theirs[i], shared, weight[i]);
            for (int j = 0; j < n; j++) {
                grown[i][j] = gram[i][j] + weight[j] * along[i] + weight[i] * along[j] + weight[i] * weight[j] * square;
            }
        }
        return new Normal(there, projection, theirs, grown);
    }

    /** The same at the same place, of derivatives of which some are new: those that are other arrays than these. */
    Normal renewed(Fitter.State next) {
        int n = products.length;
        int[] fresh = IntStream.range(0, n).filter(i -> next.slopes()[i] != state.slopes()[i]).toArray();
        if (!projection.suits(next)) {
            return new Normal(next);
        }
        Columns slopes = new Columns(next.slopes());
        Columns columns = slopes.only(fresh);
        double[][] theirs = products.clone();
        double[][] all = Arrays.stream(gram).map(double[]::clone).toArray(double[][]::new);
        double[][] own = projection.products(columns);
        double[][] with = slopes.products(columns);
        for (int k = 0; k < fresh.length; k++) {
            theirs[fresh[k]] = own[k];
            for (int i = 0; i < n; i++) {
                all[fresh[k]][i] = with[k][i];
                all[i][fresh[k]] = with[k][i];
            }
        }
        return new Normal(next, projection, theirs, all);
    }

    private static void add(double[] target, double[] source, double factor) {
        for (int i = 0; i < target.length && factor != 0; i++) {
            target[i] += factor * source[i];
        }
    }

    /** Where these equations stand. */
    Fitter.State state() {
        return state;
    }

    /** What the sensors' errors take. */
    public Projection projection() {
        return projection;
    }

    /**
     * Products of the whitened slopes with the sensors' errors [1], by coordinate and error, as {@link Projection} wants them. Not a copy.
     */
    public double[][] products() {
        return products;
    }

    /** Second derivative of half the cost to the coordinates [1], n by n, priors included. Not a copy. */
    public double[][] curvature() {
        return curvature;
    }

    /** First derivative of half the cost by coordinate [1], priors included. Not a copy. */
    public double[] gradient() {
        return gradient;
    }

    /** The next x, within bounds. */
    double[] step(double damping) {
        return step(state.candidate(), state.x(), curvature, gradient, damping);
    }

    /**
     * The same of any equations.
     *
     * @param x where they stand, coordinates [1], one a knob
     * @param curvature as {@link #curvature}
     * @param gradient as {@link #gradient}. None is modified.
     */
    static double[] step(Candidate candidate, double[] x, double[][] curvature, double[] gradient, double damping) {
        int n = gradient.length;
        boolean[] held = new boolean[n];
        for (int i = 0; i < n; i++) {
            Knob knob = candidate.knobs().get(i);
            held[i] = x[i] <= knob.low() + 1e-12 && gradient[i] > 0 || x[i] >= knob.high() - 1e-12 && gradient[i] < 0;
        }
        double[] step = DampedEquations.solve(curvature, gradient, held, damping);
        double scale = 1;
        for (int i = 0; i < n; i++) {
            boolean factor = candidate.knobs().get(i).unit() == 0;
            double longest = factor ? LONGEST : Math.max(LONGEST_UNITS, LONGEST * Math.abs(x[i]));
            scale = Math.min(scale, longest / Math.max(Math.abs(step[i]), 1e-300));
        }
        double[] next = x.clone();
        for (int i = 0; i < n; i++) {
            Knob knob = candidate.knobs().get(i);
            next[i] = Math.max(knob.low(), Math.min(knob.high(), next[i] - scale * step[i]));
        }
        return next;
    }
}
