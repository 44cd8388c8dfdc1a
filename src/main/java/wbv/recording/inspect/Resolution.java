package wbv.recording.inspect;

import java.util.Arrays;

/**
 * How finely times are written, learned as they pass. Times with six significant digits are written to 10 µs at first and to
 * 0.1 s after three hours, so it is kept by power of ten; a new power begins one digit coarser than the one before.
 */
final class Resolution {

    private static final int FINEST = 12;
    private static final int ENOUGH = 32;
    private static final double UNKNOWN = 1;
    /** Powers of ten below one that are kept apart. */
    private static final int BELOW = 6;
    private static final double[] TEN = new double[20];

    static {
        TEN[0] = 1;
        for (int i = 1; i < TEN.length; i++) {
            TEN[i] = TEN[i - 1] * 10;
        }
    }

    private final int[] decimals = new int[TEN.length + BELOW];
    private final long[] met = new long[decimals.length];
    private int decade;

    /** Distance between times that can be told apart at this time [s]; 0 where it is below a picosecond. */
    double of(double time) {
        double size = Math.abs(time);
        if (size == 0) {
            return met[decade] > 0 ? distance(decade) : UNKNOWN;
        }
        int now = decadeOf(size);
        if (met[now] == 0 && now > decade && met[decade] > 0) {
            decimals[now] = Math.max(0, decimals[decade] - (now - decade));
        }
        decade = now;
        met[now]++;
        while (decimals[now] < FINEST && !whole(size * TEN[decimals[now]])) {
            decimals[now]++;
        }
        return distance(now);
    }

    private int decadeOf(double size) {
        int now = decade;
        while (now < decimals.length - 1 && size >= bound(now)) {
            now++;
        }
        while (now > 0 && size < bound(now - 1)) {
            now--;
        }
        return now;
    }

    /** The upper end of a decade. */
    private static double bound(int decade) {
        return decade >= BELOW ? TEN[decade - BELOW] : 1 / TEN[BELOW - decade];
    }

    /** True if enough times of this size were met to trust what was said of the last. */
    boolean settled() {
        return met[decade] >= ENOUGH;
    }

    /** The coarsest that times were written [s], decades with few of them left out. */
    double coarsest() {
        double coarsest = 0;
        long enough = Math.min(ENOUGH, Arrays.stream(met).sum() / 2);
        for (int i = 0; i < met.length; i++) {
            coarsest = met[i] > 0 && met[i] >= enough ? Math.max(coarsest, distance(i)) : coarsest;
        }
        return coarsest;
    }

    private double distance(int at) {
        return decimals[at] >= FINEST ? 0 : 1 / TEN[decimals[at]];
    }

    private static boolean whole(double scaled) {
        return Math.abs(scaled - Math.rint(scaled)) <= 4 * Math.ulp(scaled);
    }
}
