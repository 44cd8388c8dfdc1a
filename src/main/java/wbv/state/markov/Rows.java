package wbv.state.markov;

import java.util.ArrayList;
import java.util.List;

/** Rows of features. */
public final class Rows {

    private Rows() {}

    /**
     * Whether no value is missing or infinite.
     *
     * @param row as long as it is, each number in its own unit. Not modified.
     */
    public static boolean complete(double[] row) {
        double sum = 0;
        for (double value : row) {
            sum += value;
        }
        return Double.isFinite(sum);
    }

    /** The complete rows of all sequences, by row, each column in its own unit, evenly thinned to so many at most. */
    public static double[][] thinned(List<double[][]> sequences, int most) {
        List<double[]> all = new ArrayList<>();
        for (double[][] sequence : sequences) {
            for (double[] row : sequence) {
                if (complete(row)) {
                    all.add(row);
                }
            }
        }
        int step = Math.max(1, (all.size() + most - 1) / most);
        List<double[]> kept = new ArrayList<>();
        for (int i = 0; i < all.size(); i += step) {
            kept.add(all.get(i));
        }
        return kept.toArray(double[][]::new);
    }
}
