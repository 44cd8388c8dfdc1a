package wbv.filter.model;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Mean square of the last samples, as if there had been zeros before the first. */
final class MovingPower implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final double[] squares;
    private int next;
    private double sum;

    /** @param samples &gt;= 1 */
    MovingPower(int samples) {
        this.squares = new double[samples];
    }

    void reset() {
        Arrays.fill(squares, 0);
        next = 0;
        sum = 0;
    }

    void hear(double value) {
        sum += value * value - squares[next];
        squares[next] = value * value;
        next++;
        if (next == squares.length) {
            next = 0;
            sum = 0; // added up again, so that rounding does not
            for (double square : squares) {
                sum += square;
            }
        }
    }

    double power() {
        return Math.max(0, sum) / squares.length;
    }

    @Override
    public void save(StateWriter out) {
        out.put(squares);
        out.put(next);
        out.put(sum);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(squares);
        next = in.integer(0, squares.length - 1, "a place in a window");
        sum = in.number();
    }
}
