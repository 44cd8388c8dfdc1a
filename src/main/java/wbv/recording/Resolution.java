package wbv.recording;

/**
 * How finely times are written, learned as they pass. Times with six significant digits are written to 10 µs at first and to
 * 0.1 s after three hours, so it is kept by power of ten.
 */
final class Resolution {

    private static final int FINEST = 12;
    private static final int ENOUGH = 32;
    private static final double[] TEN = new double[20];

    static {
        TEN[0] = 1;
        for (int i = 1; i < TEN.length; i++) {
            TEN[i] = TEN[i - 1] * 10;
        }
    }

    private final int[] decimals = new int[TEN.length];
    private final long[] met = new long[TEN.length];
    private int decade;

    /** Distance between times that can be told apart at this time [s]; 0 where it is below a picosecond. */
    double of(double time) {
        double size = Math.abs(time);
        int now = 0;
        while (now < TEN.length - 1 && size >= TEN[now]) {
            now++;
        }
        decade = now;
        met[now]++;
        while (decimals[now] < FINEST && !whole(size * TEN[decimals[now]])) {
            decimals[now]++;
        }
        return distance(now);
    }

    /** True if enough times of this size were met to trust what was said of the last. */
    boolean settled() {
        return met[decade] >= ENOUGH;
    }

    /** The coarsest that times were written [s], decades with few of them left out. */
    double coarsest() {
        double coarsest = 0;
        for (int i = 0; i < met.length; i++) {
            coarsest = met[i] >= ENOUGH ? Math.max(coarsest, distance(i)) : coarsest;
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
