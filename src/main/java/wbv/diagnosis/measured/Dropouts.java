package wbv.diagnosis.measured;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** Which samples of a sensor count: not those that are missing, nor those in which the whole sensor repeats itself or reads zero. */
final class Dropouts {

    private static final int LEAST = 3;
    /** How often chance may take a recording for one with a dropout. */
    private static final double RARE = 0.01;
    /** Lost samples of an input that a straight line stands for. */
    static final int BRIDGED = 2;
    /** How long a sitter rings on [s]. */
    private static final double RINGING = 1;

    /** Samples that are missing, repeated or zero. */
    private final boolean[] lost;
    private final boolean[] valid;
    private final int found;

    Dropouts(Recording recording, Channel channel) {
        int n = recording.length();
        List<double[]> sensor = recording.channels().stream().filter(other -> other.location().equals(channel.location()))
                .map(recording::values).toList();
        double[] own = recording.values(channel);
        boolean alone = sensor.size() == 1;
        double least = Arrays.stream(own).filter(v -> !Double.isNaN(v)).min().orElse(0);
        double greatest = Arrays.stream(own).filter(v -> !Double.isNaN(v)).max().orElse(0);
        // A clipped sensor repeats its ends without losing anything.
        boolean[] repeated = runs(n, i -> i > 0 && sensor.stream().allMatch(x -> x[i] == x[i - 1])
                && !(alone && (own[i] <= least || own[i] >= greatest)), enough(n, sensor, Dropouts::repeating, alone ? LEAST - 1 : 1));
        boolean[] bad = alone ? repeated
                : runs(n, i -> sensor.stream().allMatch(x -> x[i] == 0), enough(n, sensor, Dropouts::vanishing, 1));
        for (int i = 0; i < n; i++) {
            bad[i] |= repeated[i] || alone && i + 1 < n && repeated[i + 1];
        }
        found = (int) IntStream.range(0, n).filter(i -> bad[i]).count();
        lost = new boolean[n];
        valid = new boolean[n];
        for (int i = 0; i < n; i++) {
            boolean near = bad[i] || i > 0 && bad[i - 1] || i + 1 < n && bad[i + 1];
            lost[i] = Double.isNaN(own[i]) || bad[i] && found >= LEAST;
            valid[i] = !Double.isNaN(own[i]) && !(near && found >= LEAST);
        }
    }

    /** Samples that are in a run of at least some for which something holds. */
    private static boolean[] runs(int n, IntPredicate holds, int enough) {
        boolean[] out = new boolean[n];
        int run = 0;
        for (int i = 0; i < n; i++) {
            run = holds.test(i) ? run + 1 : 0;
            if (run >= enough) {
                Arrays.fill(out, i - run + 1, i + 1, true);
            }
        }
        return out;
    }

    /**
     * The least length of a run that chance does not make in a recording.
     *
     * @param chances that one sample of it comes about, by channel
     */
    private static int enough(int n, List<double[]> sensor, ToDoubleFunction<double[]> chances, int least) {
        double chance = sensor.stream().mapToDouble(chances).reduce(1, (a, b) -> a * b);
        return chance > 0 ? (int) Math.max(least, Math.ceil(Math.log(RARE / n) / Math.log(chance))) : least;
    }

    /** How often a new value is the one before it, as rounding makes it: a run, however long, happens once. */
    private static double repeating(double[] x) {
        long begun = IntStream.range(1, x.length).filter(i -> x[i] == x[i - 1] && (i == 1 || x[i - 1] != x[i - 2])).count();
        long values = IntStream.range(0, x.length).filter(i -> i == 0 || x[i] != x[i - 1]).count();
        return (double) begun / values;
    }

    /** How often a value is zero, a run of them counted once. */
    private static double vanishing(double[] x) {
        long begun = IntStream.range(0, x.length).filter(i -> x[i] == 0 && (i == 0 || x[i - 1] != 0)).count();
        long others = IntStream.range(0, x.length).filter(i -> x[i] != 0).count();
        return others == 0 ? 1 : (double) begun / (begun + others);
    }

    /** Samples that count: neither lost nor beside one that is repeated. */
    boolean[] valid() {
        return valid;
    }

    /**
     * Samples at which what moves a sitter is known, if this sensor reads it: not in its gaps, nor while what nobody saw there still rings.
     *
     * @param rate [Hz]
     */
    boolean[] driven(double rate) {
        boolean[] out = new boolean[lost.length];
        Arrays.fill(out, true);
        int ringing = (int) (RINGING * rate);
        int run = 0;
        for (int i = 0; i < lost.length; i++) {
            run = lost[i] ? run + 1 : 0;
            if (run > BRIDGED) {
                Arrays.fill(out, i - run + 1, Math.min(lost.length, i + 1 + ringing), false);
            }
        }
        return out;
    }

    /** Samples in which the sensor repeats itself or reads zero. */
    int found() {
        return found;
    }
}
