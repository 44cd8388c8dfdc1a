package wbv.live;

/**
 * What became of a few numbers since the beginning, in memory that does not grow: when it is full, every second point is dropped and
 * from then on every second one is kept.
 */
final class History {

    /** Points held at most, even. */
    static final int MOST = 720;

    private final double[][] columns;
    private int held;
    private long stride = 1;
    private long seen;
    private int thinnings;

    /** @param columns numbers of a point, the time first */
    History(int columns) {
        this.columns = new double[columns][MOST];
    }

    void accept(double... point) {
        if (seen++ % stride != 0) {
            return;
        }
        if (held == MOST) {
            for (double[] column : columns) {
                for (int i = 0; i < MOST / 2; i++) {
                    column[i] = column[2 * i];
                }
            }
            held = MOST / 2;
            stride *= 2;
            thinnings++;
        }
        for (int i = 0; i < columns.length; i++) {
            columns[i][held] = point[i];
        }
        held++;
    }

    int held() {
        return held;
    }

    /** How often points were dropped: whoever drew them before draws them anew. */
    int thinnings() {
        return thinnings;
    }

    int columns() {
        return columns.length;
    }

    double value(int column, int point) {
        return columns[column][point];
    }
}
