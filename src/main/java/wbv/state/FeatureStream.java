package wbv.state;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Features of motion, sample by sample: how seat and head jerk, how strongly they shake, and how much the seat rocks.
 *
 * <p>Jerk is the slope of a parabola through the samples about (A. Savitzky and M. J. E. Golay, Anal. Chem. 36 (1964) 1627-1639),
 * which is a low-passed derivative with linear phase; {@link FeatureSpec#corner} states its corner. Features come out
 * {@link FeatureSpec#delay} samples late. Shaking is the root mean square of both jerks over the last quarter of a second.
 * Rocking is the root mean square over 0.3 s of roll and pitch rate, each averaged over a quarter of a second, which takes out
 * 4 Hz and more. Both are logarithms, for they run over decades.
 */
public final class FeatureStream implements Serializable {

    private static final long serialVersionUID = 1;

    private static final double SHAKING_WINDOW = 0.25;
    private static final double MEAN_WINDOW = 0.25;
    private static final double ROCKING_WINDOW = 0.3;
    /** Below these there is noise only [m/s³, rad/s]. */
    private static final double QUIET_JERK = 0.3;
    private static final double QUIET_RATE = 0.003;

    private final FeatureSpec spec;
    private final int half;
    private final double perSlope;
    private final double[] seat;
    private final double[] head;
    private final Window shaking;
    private final Window roll;
    private final Window pitch;
    private final Window rocking;
    private final double[] late;
    private long taken;

    public FeatureStream(FeatureSpec spec) {
        this.spec = spec;
        half = spec.delay();
        double squares = 0;
        for (int i = 1; i <= half; i++) {
            squares += 2.0 * i * i;
        }
        perSlope = spec.rate() / squares;
        seat = new double[2 * half + 1];
        head = new double[2 * half + 1];
        shaking = new Window(samples(SHAKING_WINDOW));
        roll = new Window(samples(MEAN_WINDOW));
        pitch = new Window(samples(MEAN_WINDOW));
        rocking = new Window(samples(ROCKING_WINDOW));
        late = new double[half + 1];
        reset();
    }

    /** Forgets all samples. */
    public void reset() {
        Arrays.fill(seat, Double.NaN);
        Arrays.fill(head, Double.NaN);
        Arrays.fill(late, Double.NaN);
        shaking.clear();
        roll.clear();
        pitch.clear();
        rocking.clear();
        taken = 0;
    }

    private int samples(double seconds) {
        return Math.max(1, (int) Math.round(seconds * spec.rate()));
    }

    /**
     * Takes a sample, and gives the features of the one {@link FeatureSpec#delay} before.
     *
     * @param sample values of {@link FeatureSpec#channels}, NaN where missing. Not modified.
     * @param into   features as {@link FeatureSpec#NAMES}; NaN where a sample that they need is missing. Modified.
     */
    public void step(double[] sample, double[] into) {
        int width = seat.length;
        int at = (int) (taken % width);
        seat[at] = sample[0];
        head[at] = sample[1];
        double seatJerk = slope(seat, at);
        double headJerk = slope(head, at);
        shaking.add((seatJerk * seatJerk + headJerk * headJerk) / 2);
        roll.add(sample[2]);
        pitch.add(sample[3]);
        double meanRoll = roll.mean();
        double meanPitch = pitch.mean();
        rocking.add(meanRoll * meanRoll + meanPitch * meanPitch);
        late[(int) (taken % late.length)] = Math.sqrt(rocking.mean());
        double rate = late[(int) ((taken + 1) % late.length)];
        into[FeatureSpec.SEAT_JERK] = seatJerk;
        into[FeatureSpec.HEAD_JERK] = headJerk;
        into[FeatureSpec.SHAKING] = Math.log10(QUIET_JERK + Math.sqrt(shaking.mean()));
        into[FeatureSpec.ROCKING] = Math.log10(QUIET_RATE + rate);
        taken++;
    }

    private double slope(double[] ring, int newest) {
        double sum = 0;
        for (int i = 1; i <= half; i++) {
            int later = (newest - half + i + 2 * ring.length) % ring.length;
            int earlier = (newest - half - i + 2 * ring.length) % ring.length;
            sum += i * (ring[later] - ring[earlier]);
        }
        return sum * perSlope;
    }

    /** Mean of the last values that are there. */
    private static final class Window implements Serializable {
        private static final long serialVersionUID = 1;
        private final double[] values;
        private int next;

        Window(int samples) {
            values = new double[samples];
            clear();
        }

        void clear() {
            Arrays.fill(values, Double.NaN);
            next = 0;
        }

        void add(double value) {
            values[next] = value;
            next = (next + 1) % values.length;
        }

        double mean() {
            double sum = 0;
            int there = 0;
            for (double value : values) {
                if (!Double.isNaN(value)) {
                    sum += value;
                    there++;
                }
            }
            return sum / there;
        }
    }
}
