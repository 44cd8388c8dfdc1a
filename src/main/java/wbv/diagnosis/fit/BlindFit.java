package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.algebra.BoundedLeastSquares;
import wbv.diagnosis.algebra.Columns;
import wbv.diagnosis.algebra.SymmetricFactor;
import wbv.signal.ScalarProduct;

/**
 * Fits from one state that are blind to whatever enters at some places: the directions along which that reaches the outputs, one a line and
 * place, are taken out of all that was whitened at the state. With Z the components along them of what products G are of, the products of
 * what is left are {@code G - ZᵀZ}, and Z is as many times shorter than what was whitened as there are outputs: nothing is whitened anew,
 * and hardly a product found. Derivatives stay those of the state, so that a few steps are as good as any; what leaves little then is worth
 * a fit by {@link Evidence#ignoring}. Threads may share it.
 */
public final class BlindFit {

    private static final int ATTEMPTS = 3;
    /** Relative gain of a step below which a fit ends. */
    private static final double LEAST_GAIN = 0.01;
    /** Once takes out what rounding lets it; twice is enough (Parlett 1980). */
    private static final int ORTHOGONAL_PASSES = 2;
    /** Part of a direction's square beside others that is rounding. */
    private static final double SAME = 1e-12;

    private final Evidence evidence;
    private final Fitter fitter;
    private final Fitter.State state;
    private final Nuisances nuisances;
    private final boolean[] off;
    private final Simulator.Linearised linear;
    /** Whitened, by place. */
    private final Map<Place, double[]> ways = new ConcurrentHashMap<>();
    /** Products of the derivatives with each other, and with the sensors' errors. */
    private final double[][] gram;
    private final double[][] products;

    /**
     * From a state.
     *
     * @param fitter of the evidence
     * @param state with its derivatives
     */
    public BlindFit(Evidence evidence, Fitter fitter, Fitter.State state) {
        this.evidence = evidence;
        this.fitter = fitter;
        this.state = state;
        this.nuisances = state.frame().nuisances();
        this.off = nuisances.off(state.candidate());
        Simulator simulator = new Simulator(evidence.excitation());
        this.linear = simulator.linearised(simulator.equivalent(state.candidate().at(state.x())));
        SlopeProducts known = new SlopeProducts(state);
        this.gram = known.gram();
        this.products = known.withErrors();
    }

    /** Where all of it starts: coordinates [1], one a knob. Not a copy. */
    public double[] start() {
        return state.x();
    }

    /**
     * What is left where some places are ignored, after a few steps.
     *
     * @param steps at most
     */
    public Known.Ignoring ignoring(List<Place> places, int steps) {
        Seen seen = new Seen(places);
        Left best = seen.left(state);
        double damping = 1e-3;
        for (int step = 0; step < steps; step++) {
            Left from = best;
            for (int attempt = 0; attempt < ATTEMPTS && best == from; attempt++) {
                Left tried = seen.left(fitter.look(state.candidate(), seen.step(from, damping), state.frame()));
                best = tried.cost < from.cost ? tried : best;
                damping = tried.cost < from.cost ? Math.max(damping / 8, 1e-7) : 10 * damping;
            }
            if (!(from.cost - best.cost > LEAST_GAIN * from.cost)) {
                break;
            }
        }
        return new Known.Ignoring(places, best.at.x(), best.square / seen.degrees());
    }

    /**
     * What a state leaves beside some directions.
     *
     * @param errors the sensors' errors in standard deviations
     * @param along components of the residual, without them, along the directions
     * @param square of what is left of it
     * @param cost with the errors' and the numbers' priors
     */
    private record Left(Fitter.State at, double[] errors, double[] along, double square, double cost) {}

    /** What enters at a place, as sensors with the state's errors read it, whitened. */
    private double[] way(Place place) {
        return Entering.unit(evidence, state,
                place.direction(() -> linear, evidence.outputs().size(), evidence.excitation().omega().length));
    }

    /** All that was whitened, as it shows beside some directions. */
    private final class Seen {

        /** Orthogonal, each of unit length at every line where it shows. */
        private final List<double[]> directions = new ArrayList<>();
        private final Columns slopes;
        private final Columns errors;
        private final BoundedLeastSquares small;
        private final double[][] curvature;
        private final double[][] cross;

        Seen(List<Place> places) {
            for (Place place : places) {
                for (Place single : place.each(evidence)) {
                    directions.add(unit(ways.computeIfAbsent(single, BlindFit.this::way)));
                }
            }
            slopes = new Columns(Arrays.stream(state.slopes()).map(this::along).toArray(double[][]::new));
            errors = new Columns(IntStream.range(0, nuisances.count()).mapToObj(i -> along(nuisances.columns().get(i)))
                    .toArray(double[][]::new));
            small = nuisances.squares().less(errors.gram());
            curvature = BoundedLeastSquares.difference(gram, slopes.gram());
            cross = BoundedLeastSquares.difference(products, errors.products(slopes));
        }

        private Window window() {
            return state.frame().whitening().window();
        }

        int degrees() {
            return state.frame().whitening().degrees() - 2 * window().lines() * directions.size();
        }

        /** A direction without what the others hold of it, of unit length by line; nothing where they hold all of it. */
        private double[] unit(double[] direction) {
            double[] out = direction.clone();
            double[] whole = squares(out);
            for (int pass = 0; pass < ORTHOGONAL_PASSES; pass++) {
                for (double[] other : directions) {
                    takeOut(other, out);
                }
            }
            double[] left = squares(out);
            for (int i = 0; i < out.length; i++) {
                int line = i % (2 * window().lines()) / 2;
                out[i] = left[line] > SAME * whole[line] ? out[i] / Math.sqrt(left[line]) : 0;
            }
            return out;
        }

        /** Square of a vector's length, by line. */
        private double[] squares(double[] vector) {
            double[] out = new double[window().lines()];
            for (int i = 0; i < vector.length; i++) {
                out[i % (2 * out.length) / 2] += vector[i] * vector[i];
            }
            return out;
        }

        /** @param vector Modified. */
        private void takeOut(double[] direction, double[] vector) {
            double[] along = along(direction, vector);
            for (int i = 0; i < vector.length; i += 2) {
                int k = i % along.length;
                vector[i] -= direction[i] * along[k] - direction[i + 1] * along[k + 1];
                vector[i + 1] -= direction[i] * along[k + 1] + direction[i + 1] * along[k];
            }
        }

        /** Components along all directions, by direction and line, complex. */
        private double[] along(double[] vector) {
            int stride = 2 * window().lines();
            double[] out = new double[stride * directions.size()];
            for (int d = 0; d < directions.size(); d++) {
                System.arraycopy(along(directions.get(d), vector), 0, out, d * stride, stride);
            }
            return out;
        }

        private double[] along(double[] direction, double[] vector) {
            double[] out = new double[2 * window().lines()];
            for (int from = 0; from < vector.length; from += out.length) {
                for (int k = 0; k < out.length; k += 2) {
                    int i = from + k;
                    out[k] += direction[i] * vector[i] + direction[i + 1] * vector[i + 1];
                    out[k + 1] += direction[i] * vector[i + 1] - direction[i + 1] * vector[i];
                }
            }
            return out;
        }

        Left left(Fitter.State at) {
            if (at.failed()) {
                return new Left(at, new double[0], new double[0], Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
            }
            double[] along = along(at.raw());
            double[] with = nuisances.columns().products(at.raw());
            double[] unseen = errors.products(along);
            Arrays.setAll(with, i -> with[i] - unseen[i]);
            BoundedLeastSquares.Explained explained = small.explain(with,
                    ScalarProduct.of(at.raw(), at.raw()) - ScalarProduct.of(along, along), off);
            double cost = at.candidate().withPriors(explained.square() + ScalarProduct.of(explained.errors(), explained.errors()), at.x());
            errors.subtract(explained.errors(), along);
            return new Left(at, explained.errors(), along, explained.square(), cost);
        }

        /** Where the next step leads, while errors that stand at no bound follow it. */
        double[] step(Left from, double damping) {
            int[] free = small.free(from.errors, off);
            SymmetricFactor factor = small.factor(free);
            double[] residual = nuisances.removed(from.at.raw(), from.errors);
            double[] unseen = slopes.products(from.along);
            double[][] shared = Arrays.stream(cross).map(all -> IntStream.of(free).mapToDouble(i -> all[i]).toArray())
                    .toArray(double[][]::new);
            double[] gradient = new double[curvature.length];
            for (int i = 0; i < gradient.length; i++) {
                double deviation = state.candidate().knobs().get(i).deviation();
                gradient[i] = ScalarProduct.of(state.slopes()[i], residual) - unseen[i] + from.at.x()[i] / (deviation * deviation);
            }
            double[][] followed = Normal.curvature(state.candidate(), curvature, shared, factor::solve);
            return Normal.step(state.candidate(), from.at.x(), followed, gradient, new boolean[gradient.length], damping);
        }
    }
}
