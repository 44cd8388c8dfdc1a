package wbv.recording.inspect;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * Watches the step between rows over blocks: two blocks in a row at another rate are another clock, unless they only lost rows.
 */
final class RateWatch {

    private static final int BLOCK = 256;
    private static final double OTHER = 0.05;

    private final double step;
    private final double[] block = new double[BLOCK];
    private int filled;
    private double previous = Double.NaN;
    private long blockLine;
    private double blockTime;
    private int odd;
    private long oddLine;
    private double oddTime;
    private Finding.TwoClocks found;

    /** @param step between samples at first [s] */
    RateWatch(double step) {
        this.step = step;
    }

    /**
     * Looks at a row in order of time.
     *
     * @param rounding by how much its time may be off [s]
     */
    void accept(double time, long line, double rounding) {
        double difference = time - previous;
        previous = time;
        if (Double.isNaN(difference) || difference == 0) {
            return;
        }
        if (filled == 0) {
            blockLine = line;
            blockTime = time;
        }
        block[filled++] = difference;
        if (filled == BLOCK) {
            filled = 0;
            judge(rounding);
        }
    }

    private void judge(double rounding) {
        Arrays.sort(block);
        double ratio = block[BLOCK / 2] / step;
        boolean other = rounding < step / 10 && Math.abs(ratio - Math.max(1, Math.rint(ratio))) > OTHER * ratio;
        if (other && odd == 0) {
            oddLine = blockLine;
            oddTime = blockTime;
        }
        odd = other ? odd + 1 : 0;
        if (odd == 2 && found == null) {
            found = new Finding.TwoClocks(oddLine, oddTime, String.format(Locale.ROOT, "the rate changes from %.5g to %.5g Hz",
                    1 / step, 1 / (ratio * step)));
        }
    }

    /** The change of rate, if there was one. */
    Optional<Finding.TwoClocks> found() {
        return Optional.ofNullable(found);
    }
}
