package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.Columns;
import wbv.diagnosis.algebra.CorrectedColumns;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.signal.ScalarProduct;

/** The normal equations of a least-squares fit at a state, what the sensors' errors would take projected out. */
public final class Normal {

    /** The farthest that a number found by factors moves in one step: the logarithm of two. */
    private static final double LONGEST = 0.7;
    /** The farthest that any other number moves, in its own units; more where it is large already. */
    private static final double LONGEST_UNITS = 3;

    private final Fitter.State state;
    /** Derivatives, which are the state's but for what was added to them since. */
    private final CorrectedColumns slopes;
    private final Projection projection;
    /** Products of the slopes with all errors, free or not [1]: as a fit goes on some come to stand at a bound and others leave it. */
    private final double[][] withErrors;
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
        this(state, new Projection(state), new SlopeProducts(state));
    }

    private Normal(Fitter.State state, Projection projection, SlopeProducts known) {
        this(state, new CorrectedColumns(new Columns(state.slopes())), projection, known.withErrors(), known.gram());
    }

    private Normal(Fitter.State state, CorrectedColumns slopes, Projection projection, double[][] withErrors, double[][] gram) {
        this.state = state;
        this.slopes = slopes;
        this.projection = projection;
        this.withErrors = withErrors;
        this.gram = gram;
        products = Arrays.stream(withErrors).map(projection::ofFree).toArray(double[][]::new);
        curvature = curvature(state.candidate(), gram, products, projection::errors);
        gradient = slopes.products(state.residual());
        for (int i = 0; i < gradient.length; i++) {
            double deviation = state.candidate().knobs().get(i).deviation();
            gradient[i] += state.x()[i] / (deviation * deviation);
        }
    }

    /**
     * The same where most derivatives are those of another state of the same frame, whose products are known.
     *
     * @param known of the first of the coordinates
     */
    static Normal of(Fitter.State state, SlopeProducts known) {
        int n = state.slopes().length;
        double[][] all = new double[n][];
        double[][] gram = new double[n][n];
        for (int i = 0; i < known.count(); i++) {
            all[i] = known.withErrors()[i];
            System.arraycopy(known.gram()[i], 0, gram[i], 0, known.count());
        }
        return renewed(state, new Projection(state), all, gram,
                IntStream.range(0, n).filter(i -> i >= known.count() || state.slopes()[i] != known.slope(i)).toArray());
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
        double[] change = next.raw().clone();
        double[] moved = new double[n];
        double[] weight = new double[n];
        double length = 0;
        for (int i = 0; i < n; i++) {
            moved[i] = next.x()[i] - state.x()[i];
            length += moved[i] * moved[i] * gram[i][i];
        }
        for (int i = 0; i < n; i++) {
            weight[i] = length > 0 ? moved[i] * gram[i][i] / length : 0;
        }
        for (int k = 0; k < change.length; k++) {
            change[k] -= state.raw()[k];
        }
        slopes.subtract(moved, change);
        double[] along = slopes.products(change);
        double square = ScalarProduct.of(change, change);
        double[] shared = state.frame().nuisances().columns().products(change);
        double[][] errors = new double[n][shared.length];
        double[][] all = new double[n][n];
        for (int i = 0; i < n; i++) {
            for (int e = 0; e < shared.length; e++) {
                errors[i][e] = withErrors[i][e] + weight[i] * shared[e];
            }
            for (int j = 0; j < n; j++) {
                all[i][j] = gram[i][j] + weight[j] * along[i] + weight[i] * along[j] + weight[i] * weight[j] * square;
            }
        }
        return new Normal(next.withSlopes(state.slopes()), slopes.plus(change, weight), projection(next), errors, all);
    }

    /** What the sensors' errors take at another state of the same frame. */
    private Projection projection(Fitter.State next) {
        return projection.suits(next) ? projection : new Projection(next);
    }

    /** The same with the derivatives of their state as they have been corrected, which takes as long as a step. */
    Normal settled() {
        if (slopes.isPlain()) {
            return this;
        }
        double[][] sums = slopes.sums();
        return new Normal(state.withSlopes(sums), new CorrectedColumns(new Columns(sums)), projection, withErrors, gram);
    }

    /**
     * The same at the same place, of derivatives of which some are new: those that are other arrays than these.
     *
     * @param next of equations that are {@link #settled}
     */
    Normal renewed(Fitter.State next) {
        return renewed(next, projection(next), withErrors.clone(), Arrays.stream(gram).map(double[]::clone).toArray(double[][]::new),
                IntStream.range(0, gram.length).filter(i -> next.slopes()[i] != state.slopes()[i]).toArray());
    }

    /**
     * With some products found.
     *
     * @param withErrors those that are known, filled in
     * @param gram       likewise
     * @param fresh      of which derivatives none is known
     */
    private static Normal renewed(Fitter.State state, Projection projection, double[][] withErrors, double[][] gram, int[] fresh) {
        Columns slopes = new Columns(state.slopes());
        Columns columns = slopes.only(fresh);
        double[][] own = state.frame().nuisances().columns().products(columns);
        double[][] with = slopes.products(columns);
        for (int k = 0; k < fresh.length; k++) {
            withErrors[fresh[k]] = own[k];
            for (int i = 0; i < gram.length; i++) {
                gram[fresh[k]][i] = with[k][i];
                gram[i][fresh[k]] = with[k][i];
            }
        }
        return new Normal(state, new CorrectedColumns(slopes), projection, withErrors, gram);
    }

    /** Where these equations stand; its derivatives are theirs once they are {@link #settled}. */
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

    /**
     * The next x, within bounds.
     *
     * @param still whether moments stay where they are
     */
    double[] step(double damping, boolean still) {
        boolean[] held = new boolean[gradient.length];
        for (int i = 0; i < held.length; i++) {
            held[i] = still && state.candidate().knobs().get(i).isMoment();
        }
        return step(state.candidate(), state.x(), curvature, gradient, held, damping);
    }

    /**
     * The same of any equations.
     *
     * @param x where they stand, coordinates [1], one a knob
     * @param curvature as {@link #curvature}
     * @param gradient as {@link #gradient}
     * @param still coordinates that do not move. None is modified.
     */
    static double[] step(Candidate candidate, double[] x, double[][] curvature, double[] gradient, boolean[] still, double damping) {
        int n = gradient.length;
        boolean[] held = new boolean[n];
        for (int i = 0; i < n; i++) {
            Knob knob = candidate.knobs().get(i);
            held[i] = still[i] || x[i] <= knob.low() + 1e-12 && gradient[i] > 0 || x[i] >= knob.high() - 1e-12 && gradient[i] < 0;
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
            next[i] = candidate.knobs().get(i).within(next[i] - scale * step[i]);
        }
        return next;
    }
}
