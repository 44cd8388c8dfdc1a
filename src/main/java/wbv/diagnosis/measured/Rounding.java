package wbv.diagnosis.measured;

import java.util.Arrays;
import java.util.Optional;
import wbv.signal.ScalarProduct;

/**
 * The steps in which a sensor reads, as its values show them: all are whole numbers of steps apart.
 *
 * @param step [the channel's unit]
 */
public record Rounding(double step) {

    /** So often each value comes at least, on average, where a sensor has steps that a recording shows. */
    private static final int OFTEN = 4;
    /** Off a whole number of steps by as much as values written to a thousandth of a step are [steps]. */
    private static final double OFF = 0.01;

    /**
     * The rounding of a series; empty where it has none.
     *
     * @param x a series of any unit; gaps do not count. Not modified.
     */
    static Optional<Rounding> of(double[] x) {
        double[] sorted = Arrays.stream(x).filter(value -> !Double.isNaN(value)).sorted().toArray();
        if (sorted.length == 0) {
            return Optional.empty();
        }
        double nothing = 1e-9 * (sorted[sorted.length - 1] - sorted[0]);
        double least = Double.POSITIVE_INFINITY;
        int different = 1;
        for (int i = 1; i < sorted.length; i++) {
            double apart = sorted[i] - sorted[i - 1];
            if (apart > nothing) {
                least = Math.min(least, apart);
                different++;
            }
        }
        if (different < 2 || sorted.length < OFTEN * different) {
            return Optional.empty();
        }
        // The least difference is one step, as it is written; over all of them a step is known better.
        double step = (sorted[sorted.length - 1] - sorted[0]) / Math.round((sorted[sorted.length - 1] - sorted[0]) / least);
        double level = sorted[0];
        boolean whole = Arrays.stream(sorted).allMatch(value -> Math.abs((value - level) / step - Math.rint((value - level) / step)) < OFF);
        return whole && !isSwitched(x, sorted, step) ? Optional.of(new Rounding(step)) : Optional.empty();
    }

    /**
     * Whether the values are levels that somebody chose, as those of a commanded voltage are, and no continuous signal was rounded to them:
     * they lie within one step of their mean, where rounding is no noise of its own (Widrow 1956), or stay at a level and leave it for one
     * that is no neighbour.
     */
    private static boolean isSwitched(double[] x, double[] sorted, double step) {
        double[] centred = Measured.centred(sorted);
        if (ScalarProduct.of(centred, centred) <= step * step * centred.length) {
            return true;
        }
        int changes = 0;
        int far = 0;
        int stays = 0;
        for (int i = 1; i < x.length; i++) {
            double steps = Math.abs(x[i] - x[i - 1]) / step;
            if (steps < 0.5) {
                stays++;
            } else if (steps > 0.5) {
                changes++;
                far += steps > 1.5 ? 1 : 0;
            }
        }
        return stays > changes && 4 * far > changes;
    }

    /**
     * The same where what rounding does is more than the small errors that every sensor has.
     *
     * @param x a series of any unit; gaps do not count. Not modified.
     */
    public static Optional<Rounding> coarse(double[] x) {
        double[] there = Arrays.stream(x).filter(value -> !Double.isNaN(value)).toArray();
        double[] centred = Measured.centred(there);
        return of(x).filter(
                steps -> steps.noise() > SmallError.Kind.GAIN.deviation() * Math.sqrt(ScalarProduct.of(centred, centred) / centred.length));
    }

    /** Standard deviation of what it adds to a signal that crosses many steps, in the step's unit (Widrow 1956). */
    public double noise() {
        return step / Math.sqrt(12);
    }
}
