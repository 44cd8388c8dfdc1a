package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * What the matrices of a {@link PlaneNet} change by with one of its numbers. A number moves few entries: of a body those of its own motions
 * and of the joints that hold it, of a joint those of the two bodies it joins.
 *
 * @param entries of M, C and K
 * @param carried entries of T
 * @param read    entries of R
 */
record MatrixSlope(List<Entry> entries, List<Single> carried, List<Single> read) {

    /**
     * Of central differences, over a number's spread: the cube root of what a double rounds by, nearly, where their two errors are alike.
     */
    private static final double STEP = 1e-5;

    /** What the same entry of M, C and K changes by. */
    record Entry(int row, int column, double mass, double damping, double stiffness) {}

    /** What an entry of another matrix changes by. */
    record Single(int row, int column, double value) {}

    MatrixSlope {
        entries = List.copyOf(entries);
        carried = List.copyOf(carried);
        read = List.copyOf(read);
    }

    /** One for each number of a net, by central differences. */
    static List<MatrixSlope> of(PlaneNet net) {
        double[] at = net.at();
        double[] spread = net.spread();
        return IntStream.range(0, at.length).mapToObj(p -> {
            double[] moved = at.clone();
            double h = STEP * spread[p];
            moved[p] = at[p] + h;
            PlaneMatrices high = PlaneMatrices.of(net.at(moved));
            moved[p] = at[p] - h;
            PlaneMatrices low = PlaneMatrices.of(net.at(moved));
            return new MatrixSlope(entries(high, low, h), singles(high.carried(), low.carried(), h), singles(high.read(), low.read(), h));
        }).toList();
    }

    private static List<Entry> entries(PlaneMatrices high, PlaneMatrices low, double h) {
        List<Entry> out = new ArrayList<>();
        int n = high.mass().length;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                double mass = i == j ? (high.mass()[i] - low.mass()[i]) / (2 * h) : 0;
                double damping = (high.damping()[i][j] - low.damping()[i][j]) / (2 * h);
                double stiffness = (high.stiffness()[i][j] - low.stiffness()[i][j]) / (2 * h);
                if (mass != 0 || damping != 0 || stiffness != 0) {
                    out.add(new Entry(i, j, mass, damping, stiffness));
                }
            }
        }
        return out;
    }

    private static List<Single> singles(double[][] high, double[][] low, double h) {
        List<Single> out = new ArrayList<>();
        for (int i = 0; i < high.length; i++) {
            for (int j = 0; j < high[i].length; j++) {
                if (high[i][j] != low[i][j]) {
                    out.add(new Single(i, j, (high[i][j] - low[i][j]) / (2 * h)));
                }
            }
        }
        return out;
    }
}
