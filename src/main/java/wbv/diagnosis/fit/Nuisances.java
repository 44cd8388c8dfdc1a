package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import wbv.body.Drive;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.signal.ScalarProduct;

/**
 * The small errors that every sensor has (gain, clock, tilt, place), each with what is known of it beforehand. Being small they act
 * linearly, and what they act on was measured, so they are not simulated: for any residual their best values follow from a small
 * quadratic problem, within three standard deviations. What is larger has to be named. Delays alone are not linear up to the highest
 * line that counts; they are exact about where a fit has them, see {@link #around}.
 */
public final class Nuisances {

    private static final int ROUNDS = 25;
    private static final int HALVINGS = 20;

    private final Window window;
    private final double sample;
    private final List<SmallError> errors;
    /** What one standard deviation of each error adds to the whitened residual. */
    private final Columns columns;
    private final double[][] gram;
    /** Delays that are exact, in standard deviations; 0 for all other errors. */
    private final double[] delays;
    /** What errors of ways are scaled by, see {@link #bounded}. */
    private final double way;
    /** Where looks for the errors begin, in standard deviations: at their bounds those that stood there, 0 for all others. */
    private final double[] begun;
    /** Factors by the errors that are asked, since looks in one frame ask for the same few again and again. */
    private final Map<BitSet, SymmetricFactor> factors = new ConcurrentHashMap<>();

    /**
     * The errors of all acceleration sensors of the outputs, as a whitening sees them; none of what was computed.
     *
     * @param ways those of ways, as series
     */
    public static Nuisances of(Evidence evidence, Whitening whitening, ErrorShapes ways) {
        ErrorShapes shapes = evidence.shapes(whitening.window()).and(ways.in(evidence, whitening.window()));
        Columns all = new Columns(shapes.shapes().stream().map(whitening::whiten).toArray(double[][]::new));
        return new Nuisances(whitening.window(), evidence.measured().sample(), shapes.errors(), all, all.gram(), new double[all.count()], 1,
                new double[all.count()]);
    }

    /**
     * The same, where delays of these sizes are exact and only what they are more or less counts to first order.
     *
     * @param sizes in standard deviations
     */
    Nuisances around(double[] sizes) {
        double[] delays = new double[sizes.length];
        for (int i = 0; i < delays.length; i++) {
            delays[i] = errors.get(i).isDelay() ? sizes[i] : 0;
        }
        double[] bounds = new double[sizes.length];
        Arrays.setAll(bounds, i -> isHeld(i, sizes[i]) ? Math.copySign(errors.get(i).most(), sizes[i]) : 0);
        return new Nuisances(window, sample, errors, columns, gram, delays, way, bounds);
    }

    /**
     * The same, with errors of ways that together are no larger than what is known of them: a way that has to be another altogether is not
     * this law's.
     *
     * @param residual that they are to explain. Not modified.
     * @param off errors that are not asked, see {@link #off}
     */
    Nuisances bounded(double[] residual, boolean[] off) {
        long ways = errors.stream().filter(error -> error.kind() == SmallError.Kind.WAY).count();
        Nuisances out = this;
        for (int round = 0; round < HALVINGS && ways > 0 && out.size(out.explain(residual, off).errors()) > ways; round++) {
            out = out.scaled(Math.sqrt(0.5));
        }
        return out;
    }

    /** Sum of the squares of all errors of ways, in what is known of them. */
    private double size(double[] sizes) {
        return IntStream.range(0, sizes.length).filter(i -> errors.get(i).kind() == SmallError.Kind.WAY)
                .mapToDouble(i -> Math.pow(way * sizes[i], 2)).sum();
    }

    private Nuisances scaled(double factor) {
        double[][] all = new double[columns.count()][];
        double[][] products = new double[all.length][all.length];
        double[] by = new double[all.length];
        for (int i = 0; i < all.length; i++) {
            boolean own = errors.get(i).kind() == SmallError.Kind.WAY;
            by[i] = own ? factor : 1;
            all[i] = own ? Arrays.stream(columns.get(i)).map(value -> factor * value).toArray() : columns.get(i);
        }
        for (int i = 0; i < all.length; i++) {
            for (int j = 0; j < all.length; j++) {
                products[i][j] = by[i] * by[j] * gram[i][j];
            }
        }
        return new Nuisances(window, sample, errors, new Columns(all), products, delays, factor * way, begun);
    }

    /**
     * The same errors as they show where a part of everything is not seen; their columns stay whole.
     *
     * @param unseen products of that part of the columns, by column and column. Not modified.
     */
    Nuisances less(double[][] unseen) {
        return new Nuisances(window, sample, errors, columns, less(gram, unseen), delays, way, begun);
    }

    /** A difference, entry by entry, in their unit. None is modified. */
    static double[][] less(double[][] all, double[][] some) {
        double[][] out = new double[all.length][];
        for (int i = 0; i < out.length; i++) {
            out[i] = all[i].clone();
            for (int j = 0; j < out[i].length; j++) {
                out[i][j] -= some[i][j];
            }
        }
        return out;
    }

    /** What an error of so many standard deviations is of what is known of it. */
    double scale(int i) {
        return errors.get(i).kind() == SmallError.Kind.WAY ? way : 1;
    }

    private Nuisances(Window window, double sample, List<SmallError> errors, Columns columns, double[][] gram, double[] delays,
            double way, double[] begun) {
        this.window = window;
        this.sample = sample;
        this.errors = errors;
        this.columns = columns;
        this.gram = gram;
        this.delays = delays;
        this.way = way;
        this.begun = begun;
    }

    /**
     * The same delays of sensors against the input's, its own being what is likeliest beside them. Beside a sensor whose delay is at fault,
     * which takes any share of what all have in common, nothing but this tells how late the input is.
     *
     * @param sizes in standard deviations. Not modified.
     * @param off errors that are not asked, see {@link #off}
     */
    double[] likeliest(double[] sizes, boolean[] off) {
        int[] delayed = IntStream.range(0, sizes.length).filter(i -> errors.get(i).isDelay() && !errors.get(i).isInput()).toArray();
        double[] out = sizes.clone();
        if (IntStream.range(0, sizes.length).anyMatch(i -> off[i] && errors.get(i).isInput())) {
            // All that the outputs have in common is the input's.
            double common = IntStream.of(delayed).mapToDouble(i -> sizes[i]).average().orElse(0);
            IntStream.of(delayed).forEach(i -> out[i] -= common);
            return out;
        }
        if (IntStream.of(delayed).noneMatch(i -> off[i])) {
            return out;
        }
        int input = IntStream.range(0, sizes.length).filter(i -> errors.get(i).isInput()).findFirst().orElseThrow();
        int[] own = IntStream.of(delayed).filter(i -> !off[i]).toArray();
        // Least Σ (d + input)² + input² over the others' delays d against the input's.
        out[input] = -IntStream.of(own).mapToDouble(i -> sizes[i] - sizes[input]).sum() / (own.length + 1);
        for (int i : own) {
            out[i] = sizes[i] - sizes[input] + out[input];
        }
        return out;
    }

    /**
     * How late the sensors are for whose delays the errors are exact.
     *
     * @param omega by line of what is simulated [rad/s]
     * @param off errors that are not asked, see {@link #off}. Neither is modified.
     */
    public Lateness lateness(double[] omega, boolean[] off, int outputs) {
        double[] delay = new double[outputs];
        for (int i = 0; i < delays.length; i++) {
            double own = off[i] || delays[i] == 0 ? 0 : errors.get(i).deviation(sample) * delays[i];
            for (int o = 0; o < outputs; o++) {
                delay[o] += errors.get(i).isInput() ? -own : errors.get(i).owner() == o ? own : 0;
            }
        }
        double[][] factors = new double[outputs][0];
        for (int o = 0; o < outputs; o++) {
            double late = delay[o];
            factors[o] = late == 0 ? factors[o] : factor(omega.length, k -> omega[k], 1, late);
        }
        return new Lateness(factors);
    }

    /**
     * What delays make of spectra.
     *
     * @param factors by output, complex; empty for one that is not late
     */
    public record Lateness(double[][] factors) {

        /** The outputs of a run, spectra by output in its unit: what a sensor's other channels make of it was recorded late already. */
        public double[][] of(Simulator.Response response) {
            double[][] out = of(response.outputs());
            for (int o = 0; o < out.length; o++) {
                double[] recorded = response.recorded()[o];
                double[] twice = recorded.length == 0 || factors[o].length == 0 ? new double[0] : product(recorded, factors[o]);
                for (int k = 0; k < twice.length; k++) {
                    out[o][k] += recorded[k] - twice[k];
                }
            }
            return out;
        }

        /**
         * What late sensors read of it, spectra by output in its unit.
         *
         * @param simulated spectra by output in its unit. Not modified.
         */
        public double[][] of(double[][] simulated) {
            double[][] out = simulated.clone();
            for (int o = 0; o < out.length; o++) {
                out[o] = factors[o].length == 0 ? out[o] : product(out[o], factors[o]);
            }
            return out;
        }
    }

    /**
     * Adds to a residual what {@link #lateness} took out of it to first order, so that errors count from nothing.
     *
     * @param residual Modified.
     */
    void restore(double[] residual, boolean[] off) {
        double[] taken = new double[delays.length];
        Arrays.setAll(taken, i -> off[i] ? 0 : -delays[i]);
        columns.subtract(taken, residual);
    }

    /** What a gain and a delay [s] make of each line. */
    private static double[] factor(int lines, IntToDoubleFunction omega, double gain, double delay) {
        double[] out = new double[2 * lines];
        for (int k = 0; k < lines; k++) {
            out[2 * k] = gain * Math.cos(omega.applyAsDouble(k) * delay);
            out[2 * k + 1] = -gain * Math.sin(omega.applyAsDouble(k) * delay);
        }
        return out;
    }

    private static double[] product(double[] x, double[] y) {
        double[] out = new double[x.length];
        Remainder.add(out, x, y);
        return out;
    }

    /** The errors of sensors that a candidate holds at fault in the same way: there the fault says it all. */
    public boolean[] off(Candidate candidate) {
        boolean[] out = new boolean[columns.count()];
        for (Hypothesis hypothesis : candidate.added()) {
            for (Hypothesis.Addition addition : hypothesis.additions()) {
                for (int i = 0; i < out.length && isLate(addition); i++) {
                    out[i] |= errors.get(i).isInput();
                }
                for (int i = 0; i < out.length && addition instanceof Hypothesis.Addition.OfSensor; i++) {
                    Hypothesis.Addition.OfSensor at = (Hypothesis.Addition.OfSensor) addition;
                    out[i] |= at.output() == errors.get(i).owner() && errors.get(i).isLike(at.fault());
                }
            }
        }
        return out;
    }

    /** Whether it is the input's own channel that is late. */
    private static boolean isLate(Hypothesis.Addition addition) {
        return addition instanceof Hypothesis.Addition.Driven driven && driven.drive() instanceof Drive.Late;
    }

    /**
     * What sensors with these errors read of something that reaches the outputs: gain and delay change its way too.
     *
     * @param way spectra at the window's lines, by output. Not modified.
     * @param sizes of the errors in standard deviations
     */
    double[][] seen(double[][] way, double[] sizes) {
        double[][] out = way.clone();
        for (int i = 0; i < sizes.length; i++) {
            SmallError error = errors.get(i);
            // What does not come from the input is not late with it.
            double gain = error.kind() == SmallError.Kind.GAIN ? 1 + error.deviation(sample) * sizes[i] : 1;
            double delay = error.isDelay() && !error.isInput() ? error.deviation(sample) * sizes[i] : 0;
            if (gain != 1 || delay != 0) {
                double[] factor = factor(window.lines(), line -> 2 * Math.PI * window.frequency(line), gain, delay);
                out[error.owner()] = product(out[error.owner()], factor);
            }
        }
        return out;
    }

    /**
     * How late an output's own sensor is [s].
     *
     * @param sizes one an error, in standard deviations [1]. Not modified.
     */
    public double delay(int output, double[] sizes) {
        return IntStream.range(0, sizes.length).filter(i -> errors.get(i).owner() == output && errors.get(i).isDelay())
                .mapToDouble(i -> errors.get(i).deviation(sample) * sizes[i]).sum();
    }

    int count() {
        return errors.size();
    }

    SmallError error(int i) {
        return errors.get(i);
    }

    /** What one standard deviation of each error adds to the whitened residual. */
    Columns columns() {
        return columns;
    }

    /** Products of a whitened vector with all columns. */
    double[] products(double[] vector) {
        return columns.products(vector);
    }

    /**
     * What the errors make of a residual.
     *
     * @param errors in standard deviations
     * @param square what is left, as a sum of squares
     */
    record Explained(double[] errors, double square) {}

    /**
     * The errors that explain a residual best: least |r - D n|² + |n|² within the bounds. Those that would leave them stay there, and are
     * let go again where they would come back; exact, since errors that sensors share are as good as collinear.
     *
     * @param off errors that are not asked, see {@link #off}
     */
    Explained explain(double[] residual, boolean[] off) {
        return explain(products(residual), ScalarProduct.of(residual, residual), off);
    }

    /**
     * The same of a residual of which no more is known.
     *
     * @param products Dᵀr. Not modified.
     * @param square |r|²
     */
    Explained explain(double[] products, double square, boolean[] off) {
        double[] n = new double[columns.count()];
        boolean[] held = off.clone();
        for (int i = 0; i < n.length; i++) {
            n[i] = off[i] ? 0 : begun[i];
            held[i] |= begun[i] != 0;
        }
        for (int round = 0; round < ROUNDS; round++) {
            solve(n, products, held);
            boolean settled = true;
            for (int i = 0; i < n.length; i++) {
                if (!held[i] && Math.abs(n[i]) > errors.get(i).most()) {
                    n[i] = Math.copySign(errors.get(i).most(), n[i]);
                    held[i] = true;
                    settled = false;
                }
            }
            if (settled && !letGo(n, products, held, off)) {
                break;
            }
        }
        double[] left = gradient(n, products);
        // |r - D n|² = |r|² - n·(Dᵀr + Dᵀ(r - D n))
        return new Explained(n, Math.max(0, square - ScalarProduct.of(n, products) - ScalarProduct.of(n, left)));
    }

    /**
     * Solves for the errors that are not held.
     *
     * @param n Modified.
     */
    private void solve(double[] n, double[] products, boolean[] held) {
        int[] free = IntStream.range(0, n.length).filter(i -> !held[i]).toArray();
        double[] b = new double[free.length];
        for (int i = 0; i < free.length; i++) {
            b[i] = products[free[i]];
            for (int j = 0; j < n.length; j++) {
                b[i] -= held[j] ? gram[free[i]][j] * n[j] : 0;
            }
        }
        double[] solved = factor(free).solve(b);
        for (int i = 0; i < free.length; i++) {
            n[free[i]] = solved[i];
        }
    }

    /** Of DᵀD + 1 for some of the errors. */
    SymmetricFactor factor(int[] which) {
        BitSet asked = new BitSet();
        IntStream.of(which).forEach(asked::set);
        return factors.computeIfAbsent(asked, some -> factored(which));
    }

    private SymmetricFactor factored(int[] which) {
        DMatrixRMaj a = new DMatrixRMaj(which.length, which.length);
        for (int i = 0; i < which.length; i++) {
            for (int j = 0; j < which.length; j++) {
                a.set(i, j, gram[which[i]][which[j]] + (i == j ? 1 : 0));
            }
        }
        return SymmetricFactor.of(a).orElseThrow();
    }

    /**
     * Frees errors whose bound holds them against their will.
     *
     * @param held Modified.
     */
    private boolean letGo(double[] n, double[] products, boolean[] held, boolean[] off) {
        double[] g = gradient(n, products);
        boolean any = false;
        for (int i = 0; i < n.length; i++) {
            if (held[i] && !off[i] && (g[i] - n[i]) * n[i] < 0) {
                held[i] = false;
                any = true;
            }
        }
        return any;
    }

    /**
     * Dᵀ(r - D n).
     *
     * @param products Dᵀr
     */
    private double[] gradient(double[] n, double[] products) {
        return IntStream.range(0, n.length).mapToDouble(i -> products[i] - ScalarProduct.of(gram[i], n)).toArray();
    }

    /** The residual without what errors explain. A new array. */
    double[] removed(double[] residual, double[] n) {
        double[] out = residual.clone();
        columns.subtract(n, out);
        return out;
    }

    /** Whether an error of that size stands at its bound and so takes no part in small changes; those of ways have none. */
    boolean isHeld(int i, double size) {
        return Math.abs(size) >= errors.get(i).most() - 1e-9;
    }
}
