package wbv.recording.inspect;

import java.io.IOException;
import java.util.Arrays;
import wbv.recording.Clock;
import wbv.recording.RowReader;

/**
 * Samples between unevenly spaced rows: the cubic through the two rows before and the two after (Lagrange) where they are half a
 * step to two steps apart, a straight line elsewhere. A hole longer than two and a half steps stays empty.
 */
final class Interpolation implements UniformReader.Laying {

    private static final double HOLE = 2.5;

    private final OrderedRows rows;
    private final Clock clock;
    /** Four rows around the sample, oldest first; a time of NaN where there is none. */
    private final double[][] window;
    private long sample;
    private boolean begun;
    private boolean ended;
    private long filled;
    private long repeated;
    private long interpolated;

    Interpolation(RowReader rows, Clock clock, int width) {
        this.rows = new OrderedRows(rows, width);
        this.clock = clock;
        this.window = new double[4][width];
        for (double[] row : window) {
            row[0] = Double.NaN;
        }
    }

    @Override
    public boolean next(double[] row) throws IOException {
        if (!begun) {
            begun = true;
            shift();
            shift();
            shift();
        }
        double time = clock.time(sample);
        while (window[2][0] < time) {
            shift();
        }
        if (Double.isNaN(window[2][0]) && !(Math.abs(window[1][0] - time) <= clock.step() / 2)) {
            return false;
        }
        sample++;
        between(time, row);
        return true;
    }

    private void between(double time, double[] row) {
        double[] left = window[1];
        double[] right = window[2];
        if (right[0] == time || Double.isNaN(right[0]) || left[0] > time) {
            System.arraycopy(right[0] == time ? right : left, 0, row, 0, row.length);
            return;
        }
        double hole = HOLE * clock.step();
        double span = right[0] - left[0];
        if (span > hole) {
            filled++;
            Arrays.fill(row, Double.NaN);
            return;
        }
        interpolated++;
        boolean cubic = even(left[0] - window[0][0]) && even(span) && even(window[3][0] - right[0]);
        double u = (time - left[0]) / span;
        for (int i = 1; i < row.length; i++) {
            double value = cubic ? cubic(time, i) : Double.NaN;
            row[i] = Double.isNaN(value) ? left[i] + u * (right[i] - left[i]) : value;
        }
    }

    /** True for a spacing that a cubic bears: between rows that nearly coincide it would swing far out. */
    private boolean even(double spacing) {
        return spacing >= clock.step() / 2 && spacing <= 2 * clock.step();
    }

    private double cubic(double time, int column) {
        double sum = 0;
        for (int i = 0; i < 4; i++) {
            double weight = 1;
            for (int j = 0; j < 4; j++) {
                if (j != i) {
                    weight *= (time - window[j][0]) / (window[i][0] - window[j][0]);
                }
            }
            sum += weight * window[i][column];
        }
        return sum;
    }

    /** Moves the window on by one usable row; by none at all once the rows have ended. */
    private void shift() throws IOException {
        double[] oldest = window[0];
        System.arraycopy(window, 1, window, 0, 3);
        window[3] = oldest;
        double newest = latest();
        do {
            ended = ended || !rows.next(oldest);
            repeated += !ended && oldest[0] == newest ? 1 : 0;
        } while (!ended && oldest[0] == newest);
        if (ended) {
            oldest[0] = Double.NaN;
        }
    }

    private double latest() {
        for (int i = 2; i >= 0; i--) {
            if (!Double.isNaN(window[i][0])) {
                return window[i][0];
            }
        }
        return Double.NaN;
    }

    @Override
    public Relay relay(long samples) {
        return new Relay(rows.read(), samples, filled, rows.repeated() + repeated, rows.disordered(), interpolated);
    }
}
