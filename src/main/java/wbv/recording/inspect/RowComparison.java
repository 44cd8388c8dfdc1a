package wbv.recording.inspect;

/** Comparison of rows. */
final class RowComparison {

    private RowComparison() {}

    /** True if two rows hold the same numbers, NaN being the same as NaN. */
    static boolean same(double[] one, double[] two) {
        for (int i = 0; i < one.length; i++) {
            if (one[i] != two[i] && !(Double.isNaN(one[i]) && Double.isNaN(two[i]))) {
                return false;
            }
        }
        return true;
    }
}
