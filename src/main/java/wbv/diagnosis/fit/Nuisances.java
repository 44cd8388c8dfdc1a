package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Drive;
import wbv.body.Spectra;
import wbv.diagnosis.algebra.BoundedLeastSquares;
import wbv.diagnosis.algebra.Columns;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.signal.ScalarProduct;

/**
 * The small errors that every sensor has (gain, clock, tilt, place), each with what is known of it beforehand. Being small they act
 * linearly, and what they act on was measured, so they are not simulated: for any residual their best values follow from a small
 * quadratic problem, within three standard deviations. What is larger has to be named. Delays alone are exact about where a fit has them,
 * see {@link #around}.
 */
public final class Nuisances {

    private static final int HALVINGS = 20;

    private final Window window;
    private final double sample;
    private final List<SmallError> errors;
    /** What one standard deviation of each error adds to the whitened residual. */
    private final Columns columns;
    private final BoundedLeastSquares squares;
    private final SensorDelays delays;
    /** What errors of ways are scaled by, see {@link #bounded}. */
    private final double way;

    /**
     * The errors of all acceleration sensors of the outputs, as a whitening sees them; none of what was computed.
     *
     * @param ways those of ways, as series
     */
    public static Nuisances of(Evidence evidence, Whitening whitening, ErrorShapes ways) {
        double sample = evidence.measured().sample();
        ErrorShapes shapes = evidence.shapes(whitening.window()).and(ways.in(evidence, whitening.window()));
        Columns all = new Columns(shapes.shapes().stream().map(whitening::whiten).toArray(double[][]::new));
        return new Nuisances(whitening.window(), sample, shapes.errors(), all, squares(all, shapes.errors()),
                SensorDelays.of(evidence, shapes.errors()), 1);
    }

    private static BoundedLeastSquares squares(Columns columns, List<SmallError> errors) {
        return new BoundedLeastSquares(columns.gram(), errors.stream().mapToDouble(SmallError::most).toArray());
    }

    private Nuisances(Window window, double sample, List<SmallError> errors, Columns columns, BoundedLeastSquares squares,
            SensorDelays delays, double way) {
        this.window = window;
        this.sample = sample;
        this.errors = errors;
        this.columns = columns;
        this.squares = squares;
        this.delays = delays;
        this.way = way;
    }

    /**
     * The same, with gains that are a part of what was measured as far as that is no noise: noise that is multiplied with itself does not
     * go away in the mean (Fuller, Measurement Error Models, 1987).
     *
     * @param from what was simulated
     * @param outputs spectra by output, in its unit. Not modified.
     */
    Nuisances withoutNoise(Evidence evidence, Excitation from, double[][] outputs, Whitening whitening) {
        double[][] all = IntStream.range(0, count()).mapToObj(i -> {
            SmallError error = errors.get(i);
            if (error.kind() != SmallError.Kind.GAIN) {
                return columns.get(i);
            }
            double[][] own = Arrays.stream(outputs).map(output -> new double[output.length]).toArray(double[][]::new);
            own[error.owner()] = evidence.spectra().reading(from, error.owner(), outputs[error.owner()]);
            return evidence.spectra().whitened(from, own, error.deviation(sample), whitening);
        }).toArray(double[][]::new);
        Columns heard = new Columns(all);
        return new Nuisances(window, sample, errors, heard, squares(heard, errors), delays, way);
    }

    /**
     * The same, where delays of these sizes are exact and only what they are more or less counts to first order.
     *
     * @param sizes in standard deviations
     */
    Nuisances around(double[] sizes) {
        return new Nuisances(window, sample, errors, columns, squares.from(sizes), delays.about(sizes), way);
    }

    /**
     * The same, with errors of ways that together are no larger than what is known of them: a way that has to be another altogether is not
     * this law's.
     *
     * @param residual that they are to explain. Not modified.
     * @param off errors that are not asked, see {@link #off}
     */
    Nuisances bounded(double[] residual, boolean[] off) {
        long ways = IntStream.range(0, count()).filter(this::isWay).count();
        Nuisances out = this;
        for (int round = 0; round < HALVINGS && ways > 0 && out.size(out.explain(residual, off).errors()) > ways; round++) {
            out = out.scaled(Math.sqrt(0.5));
        }
        return out;
    }

    /** Sum of the squares of all errors of ways, in what is known of them. */
    private double size(double[] sizes) {
        return IntStream.range(0, sizes.length).filter(this::isWay).mapToDouble(i -> Math.pow(way * sizes[i], 2)).sum();
    }

    private Nuisances scaled(double factor) {
        double[] by = IntStream.range(0, count()).mapToDouble(i -> isWay(i) ? factor : 1).toArray();
        double[][] all = IntStream.range(0, count()).mapToObj(columns::get).toArray(double[][]::new);
        Arrays.setAll(all, i -> isWay(i) ? Arrays.stream(all[i]).map(value -> factor * value).toArray() : all[i]);
        return new Nuisances(window, sample, errors, new Columns(all), squares.scaled(by), delays, factor * way);
    }

    private boolean isWay(int i) {
        return errors.get(i).kind() == SmallError.Kind.WAY;
    }

    /** What an error of so many standard deviations is of what is known of it. */
    double scale(int i) {
        return isWay(i) ? way : 1;
    }

    /** How late sensors are. */
    public SensorDelays delays() {
        return delays;
    }

    /**
     * Adds to a residual what {@link SensorDelays#lateness} took out of it to first order, so that errors count from nothing.
     *
     * @param residual Modified.
     */
    void restore(double[] residual, boolean[] off) {
        columns.subtract(delays.takenBack(off), residual);
    }

    /** The errors of sensors that a candidate holds at fault in the same way: there the fault says it all. */
    public boolean[] off(Candidate candidate) {
        boolean[] out = new boolean[count()];
        for (Hypothesis hypothesis : candidate.added()) {
            for (Addition addition : hypothesis.additions()) {
                for (int i = 0; i < out.length; i++) {
                    out[i] |= says(addition, errors.get(i));
                }
            }
        }
        return out;
    }

    /** Whether an addition is a large error of the same kind, a late input among them. */
    private static boolean says(Addition addition, SmallError error) {
        return addition instanceof Addition.Driven driven && driven.drive() instanceof Drive.Late && error.isInput()
                || addition instanceof Addition.OfSensor at && at.output() == error.owner() && error.isLike(at.fault());
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
                double[] factor = Lateness.factor(window.lines(), line -> 2 * Math.PI * window.frequency(line), gain, delay);
                outputs(error).forEach(o -> out[o] = Spectra.product(out[o], factor));
            }
        }
        return out;
    }

    /** Outputs whose own an error is: of a delay all of its clock. */
    IntStream outputs(SmallError error) {
        return error.isDelay() ? delays.outputs(error) : IntStream.of(error.owner());
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

    /** What the errors are found by. */
    BoundedLeastSquares squares() {
        return squares;
    }

    /**
     * The errors that explain a whitened residual best, in standard deviations.
     *
     * @param residual Not modified.
     * @param off errors that are not asked, see {@link #off}. Not modified.
     */
    BoundedLeastSquares.Explained explain(double[] residual, boolean[] off) {
        return squares.explain(columns.products(residual), ScalarProduct.of(residual, residual), off);
    }

    /** The residual without what errors explain. A new array. */
    double[] removed(double[] residual, double[] n) {
        double[] out = residual.clone();
        columns.subtract(n, out);
        return out;
    }
}
