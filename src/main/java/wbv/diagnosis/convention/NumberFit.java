package wbv.diagnosis.convention;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.search.Calibration;
import wbv.signal.ScalarProduct;

/**
 * How well a model agrees with what was measured, with its numbers as they may be. What is left of an output is the model's form, of a size
 * that nobody knows before: its evidence goes as a power of what is left (as in {@link Calibration#evidence}), so that an output that
 * nothing explains counts for little in the others' numbers. The numbers' logarithms have a normal error.
 */
final class NumberFit {

    private static final int MOST_STEPS = 10;
    /** Gain that is worth no further step [nat]. */
    private static final double LITTLE = 0.3;
    /** The farthest that a number moves in one step, in the logarithm. */
    private static final double STRIDE = 0.7;
    private static final double DAMPED = 4;
    /** Part of an output's power that its sensor's small error leaves beside the best of models [1]. */
    private static final double FLOOR = Math.pow(SmallError.Kind.GAIN.deviation(), 2);

    private final ModelRuns runs;
    private final double[][] measured;
    private final double[] size;
    private final double[] parts;

    /** @param measured spectra by output. Not modified. */
    NumberFit(ModelRuns runs, double[][] measured) {
        this.runs = runs;
        this.measured = measured;
        this.size = Arrays.stream(measured).mapToDouble(y -> ScalarProduct.of(y, y)).toArray();
        double forms = Calibration.standard().forms();
        this.parts = Arrays.stream(measured).mapToDouble(y -> Math.min(forms, Stretch.parts(y))).toArray();
    }

    /**
     * Where a fit stands.
     *
     * @param x    logarithm of each number over what was given
     * @param left part of the power of each output that is left [1]
     * @param cost minus the logarithm of the evidence [nat]
     */
    record Fit(double[] x, double[] left, double cost) {}

    /** What the best evidence is that any fit could have [nat], as a cost. */
    double least() {
        return IntStream.range(0, size.length).mapToDouble(o -> cost(o, 0)).sum();
    }

    /** The best fit of the model as it is linear about some starts: a look that takes no further run. */
    double glimpse(List<double[]> starts) {
        return starts.stream().mapToDouble(start -> runs.begun(start).map(run -> {
            double[] d = new double[start.length];
            Products products = new Products(run);
            for (int step = 0; step < MOST_STEPS; step++) {
                d = products.step(d, start, 0);
            }
            double[] way = d;
            return cost(products.left(way), IntStream.range(0, start.length).mapToDouble(i -> start[i] + way[i]).toArray());
        }).orElse(Double.POSITIVE_INFINITY)).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** The best fit from several starts; empty where the model leaves all bounds from all of them. */
    Optional<Fit> best(List<double[]> starts) {
        Optional<Fit> best = Optional.empty();
        for (double[] start : starts) {
            Optional<Fit> fit = from(start);
            if (fit.isPresent() && (best.isEmpty() || fit.get().cost() < best.get().cost())) {
                best = fit;
            }
        }
        return best;
    }

    private Optional<Fit> from(double[] start) {
        Optional<ModelRuns.Run> begun = runs.begun(start);
        if (begun.isEmpty()) {
            return Optional.empty();
        }
        double[] x = start;
        Products here = new Products(begun.get());
        double[] nothing = new double[x.length];
        double cost = cost(here.left(nothing), x);
        double damping = 0.01;
        for (int step = 0; step < MOST_STEPS && damping < 1e4; step++) {
            double[] next = bounded(x, here.step(nothing, x, damping));
            Optional<Products> there = runs.at(next).map(Products::new);
            double other = there.map(products -> cost(products.left(nothing), next)).orElse(Double.POSITIVE_INFINITY);
            double gain = cost - other;
            if (gain > 0) {
                x = next;
                here = there.orElseThrow();
                cost = other;
                damping /= DAMPED;
                if (gain < LITTLE) {
                    break;
                }
            } else {
                damping *= DAMPED * DAMPED;
            }
        }
        double[] left = here.left(nothing);
        double[] capped = Arrays.stream(left).map(part -> Math.min(1, part)).toArray();
        return Optional.of(new Fit(x, left, cost(capped, x)));
    }

    /** @param step from x. Neither is modified. */
    private static double[] bounded(double[] x, double[] step) {
        double longest = Arrays.stream(step).map(Math::abs).max().orElse(0);
        double part = longest > STRIDE ? STRIDE / longest : 1;
        return IntStream.range(0, x.length).mapToDouble(i -> x[i] + part * step[i]).toArray();
    }

    private double cost(double[] left, double[] x) {
        double sum = 0;
        for (int o = 0; o < left.length; o++) {
            sum += cost(o, left[o]);
        }
        for (int i = 0; i < x.length; i++) {
            sum += Math.pow(x[i] / runs.deviation()[i], 2) / 2;
        }
        return sum;
    }

    private double cost(int output, double left) {
        return parts[output] / 2 * Math.log(left + FLOOR);
    }

    /** Products of what is left where the model was run and its derivatives there, by output. */
    private final class Products {
        private final double[] square;
        private final double[][] slopes;
        private final double[][][] curvature;

        Products(ModelRuns.Run run) {
            int outputs = measured.length;
            int n = run.slopes().length;
            square = new double[outputs];
            slopes = new double[outputs][n];
            curvature = run.curvature();
            for (int o = 0; o < outputs; o++) {
                double[] left = measured[o].clone();
                for (int k = 0; k < left.length; k++) {
                    left[k] -= run.outputs()[o][k];
                }
                square[o] = ScalarProduct.of(left, left);
                for (int i = 0; i < n; i++) {
                    slopes[o][i] = ScalarProduct.of(run.slopes()[i][o], left);
                }
            }
        }

        /** Part of each output that is left some way from the run, as far as it is linear. */
        private double[] left(double[] d) {
            return IntStream.range(0, square.length).mapToDouble(o -> {
                double sum = square[o];
                for (int i = 0; i < d.length; i++) {
                    sum -= 2 * d[i] * slopes[o][i];
                    for (int j = 0; j < d.length; j++) {
                        sum += d[i] * d[j] * curvature[o][i][j];
                    }
                }
                return Math.max(0, sum) / size[o];
            }).toArray();
        }

        /**
         * The way from the run to the best numbers, outputs weighed by what is left of them some way from it.
         *
         * @param d that way. Not modified.
         * @param x where the run is. Not modified.
         */
        private double[] step(double[] d, double[] x, double damping) {
            int n = d.length;
            double[][] a = new double[n][n];
            double[] b = new double[n];
            double[] left = left(d);
            for (int o = 0; o < left.length; o++) {
                double weight = parts[o] / (left[o] + FLOOR) / size[o];
                for (int i = 0; i < n; i++) {
                    b[i] += weight * slopes[o][i];
                    for (int j = 0; j < n; j++) {
                        a[i][j] += weight * curvature[o][i][j];
                    }
                }
            }
            for (int i = 0; i < n; i++) {
                double precision = 1 / (runs.deviation()[i] * runs.deviation()[i]);
                a[i][i] += precision;
                b[i] -= precision * x[i];
            }
            return DampedEquations.solve(a, b, new boolean[n], damping);
        }
    }
}
