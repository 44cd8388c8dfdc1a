package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.body.simulate.Excitation;
import wbv.diagnosis.measured.Coherence;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * How the level of a force follows that of the ride from block to block: that of everything does which the ride causes.
 *
 * @param slope in logarithms: 0 not at all, 1 in proportion; infinite where other motion of the recording explains the force
 * @param doubt standard deviation of the slope [1]; infinite where the ride has one level or is short
 */
public record LevelDependence(double slope, double doubt) {

    private static final double FOLLOWING = 0.5;
    private static final double INDEPENDENT = 0.4;
    private static final double STEADY = 0.8;
    private static final double PROPORTION = 1;
    /** Below this variance of its level, in logarithms, a ride has but one. */
    private static final double LEVELS = 0.05;
    /** Length of a block [s]. */
    private static final double BLOCK = 4;
    private static final int FEWEST = 5;
    /** Standard deviations that a normal deviate passes once in a thousand times [1]. */
    private static final double EXCLUDED = 3.1;
    private static final double COHERENT = 0.35;

    /**
     * @param force spectrum at the window's lines [N]
     * @param telling the same, each line weighed by what it tells of the force's level
     */
    static LevelDependence of(Evidence evidence, Window window, double[] force, double[] telling) {
        if (answers(evidence, window, window.series(force))) {
            return new LevelDependence(Double.POSITIVE_INFINITY, 0);
        }
        double[] series = window.series(telling);
        Excitation excitation = evidence.excitation();
        double[] ride = excitation.series(excitation.baseSpectrum());
        int block = (int) (BLOCK * evidence.recording().clock().rate());
        // Where nothing was measured no force shows.
        int[] starts = IntStream.range(0, window.length() / block).map(b -> b * block)
                .filter(start -> measured(evidence, window.start() + start, block)).toArray();
        double[] x = new double[starts.length];
        double[] y = new double[x.length];
        for (int b = 0; b < x.length; b++) {
            for (int i = starts[b]; i < starts[b] + block; i++) {
                x[b] += ride[window.start() + i] * ride[window.start() + i];
                y[b] += series[i] * series[i];
            }
            x[b] = Math.log(x[b] + 1e-12);
            y[b] = Math.log(y[b] + 1e-12);
        }
        return line(x, y);
    }

    private static boolean measured(Evidence evidence, int from, int length) {
        return IntStream.range(0, evidence.outputs().size()).anyMatch(o -> {
            boolean[] valid = evidence.valid(o);
            return 2 * IntStream.range(from, from + length).filter(i -> valid[i]).count() > length;
        });
    }

    private static LevelDependence line(double[] x, double[] y) {
        double mx = Arrays.stream(x).average().orElse(0);
        double my = Arrays.stream(y).average().orElse(0);
        double sxy = 0;
        double sxx = 0;
        for (int b = 0; b < x.length; b++) {
            sxy += (x[b] - mx) * (y[b] - my);
            sxx += (x[b] - mx) * (x[b] - mx);
        }
        // A ride of one level tells nothing, nor do a few blocks: then only the size speaks.
        if (x.length < FEWEST || sxx / x.length < LEVELS) {
            return new LevelDependence(0, Double.POSITIVE_INFINITY);
        }
        double slope = sxy / sxx;
        double left = 0;
        for (int b = 0; b < x.length; b++) {
            left += Math.pow(y[b] - my - slope * (x[b] - mx), 2);
        }
        return new LevelDependence(slope, Math.sqrt(left / (x.length - 2) / sxx));
    }

    /** Whether any other channel of the recording explains a good part of the force: then something couples it in, and nobody pushes. */
    private static boolean answers(Evidence evidence, Window window, double[] force) {
        for (Channel channel : evidence.recording().channels()) {
            boolean along = channel.axis() == evidence.model().axis() && channel.quantity() == Quantity.ACCELERATION;
            if (along || channel.quantity() == Quantity.QUATERNION || channel.quantity() == Quantity.MAGNETIC_FIELD) {
                continue;   // motion along the model's own axis answers the force itself
            }
            double[] series = Arrays.copyOfRange(evidence.series(channel), window.start(), window.start() + force.length);
            Coherence with = Coherence.of(evidence.recording().clock().rate(), series, force, Coherence.Weight.OUTPUT);
            if (with.share() > COHERENT && with.isSure()) {
                return true;
            }
        }
        return false;
    }

    /** Whether the force is an answer to other motion that was measured. */
    boolean isAnswer() {
        return slope == Double.POSITIVE_INFINITY;
    }

    /** Whether the ride has levels enough to tell. */
    public boolean isTold() {
        return doubt < FOLLOWING;
    }

    /** Whether it is not ruled out that it hardly follows: beside what the ride causes there may be what it does not. */
    boolean mayBeWeak() {
        return slope - EXCLUDED * Math.min(doubt, 1) < FOLLOWING;
    }

    /** Whether it is known not to follow as what the ride causes does. */
    public boolean isSteady() {
        return slope + 2 * doubt < STEADY;
    }

    /** Whether it hardly follows, and not in proportion. */
    boolean isWeak() {
        return slope < INDEPENDENT && slope + 2 * doubt < PROPORTION;
    }

    /** Whether it is known to follow hardly at all. */
    boolean isSurelyWeak() {
        return Math.abs(slope) + 2 * doubt < INDEPENDENT;
    }
}
