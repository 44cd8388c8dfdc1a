package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** Which samples of a sensor count: not those that are missing, nor those in which the whole sensor repeats itself or reads zero. */
final class Dropouts {

    private static final int LEAST = 3;
    /** How often chance may take a recording for one with a dropout. */
    private static final double RARE = 0.01;

    private final boolean[] valid;
    private final int found;

    Dropouts(Recording recording, Channel channel) {
        int n = recording.length();
        List<double[]> sensor = recording.channels().stream().filter(other -> other.location().equals(channel.location()))
                .map(recording::values).toList();
        double[] own = recording.values(channel);
        double least = Arrays.stream(own).filter(v -> !Double.isNaN(v)).min().orElse(0);
        double greatest = Arrays.stream(own).filter(v -> !Double.isNaN(v)).max().orElse(0);
        int enough = byChance(own);
        boolean[] bad = new boolean[n];
        int run = 0;
        int count = 0;
        for (int i = 0; i < n; i++) {
            boolean repeats = i > 0;
            boolean zero = true;
            for (double[] each : sensor) {
                repeats &= i > 0 && each[i] == each[i - 1];
                zero &= each[i] == 0;
            }
            // A channel alone repeats by chance where values are rounded; many in a row it does not, unless it is clipped.
            run = i > 0 && own[i] == own[i - 1] && own[i] > least && own[i] < greatest ? run + 1 : 0;
            bad[i] = sensor.size() > 1 && (repeats || zero);
            if (sensor.size() == 1 && run >= enough - 1) {
                Arrays.fill(bad, i - run, i + 1, true);
            }
        }
        for (boolean each : bad) {
            count += each ? 1 : 0;
        }
        found = count;
        valid = new boolean[n];
        for (int i = 0; i < n; i++) {
            boolean near = bad[i] || i > 0 && bad[i - 1] || i + 1 < n && bad[i + 1];
            valid[i] = !Double.isNaN(own[i]) && !(near && found >= LEAST);
        }
    }

    /** The least number of equal samples in a row that no chance makes of how often two neighbours are equal. */
    private static int byChance(double[] x) {
        long equal = IntStream.range(1, x.length).filter(i -> x[i] == x[i - 1]).count();
        double chance = (double) equal / x.length;
        return equal == 0 ? LEAST : Math.max(LEAST, 1 + (int) Math.ceil(Math.log(RARE / x.length) / Math.log(chance)));
    }

    boolean[] valid() {
        return valid;
    }

    /** Samples in which the sensor repeats itself or reads zero. */
    int found() {
        return found;
    }
}
