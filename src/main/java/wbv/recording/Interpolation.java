package wbv.recording;

import java.io.IOException;
import java.util.Arrays;

/**
 * Samples between unevenly spaced rows: the cubic through the two rows before and the two after (Lagrange), a straight line where
 * there are fewer or a hole is near. A hole longer than two and a half steps stays empty.
 */
final class Interpolation implements UniformReader.Laying {

    private static final double HOLE = 2.5;

    private final RowReader rows;
    private final Clock clock;
    /** Four rows around the sample, oldest first; a time of NaN where there is none. */
    private final double[][] window;
    private final double[] incoming;
    private long sample;
    private boolean begun;
    private boolean ended;
    private long read;
    private long filled;
    private long repeated;
    private long backwards;
    private long interpolated;

    Interpolation(RowReader rows, Clock clock, int width) {
        this.rows = rows;
        this.clock = clock;
        this.window = new double[4][width];
        this.incoming = new double[width];
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
        while (!ended && window[2][0] < time) {
            shift();
        }
        while (!Double.isNaN(window[2][0]) && window[2][0] < time) {
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
        if (Double.isNaN(right[0]) || right[0] == time || !(left[0] <= time)) {
            System.arraycopy(Double.isNaN(right[0]) ? left : right, 0, row, 0, row.length);
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
        boolean cubic = left[0] - window[0][0] <= hole && window[3][0] - right[0] <= hole;
        double u = (time - left[0]) / span;
        for (int i = 1; i < row.length; i++) {
            double value = cubic ? cubic(time, i) : Double.NaN;
            row[i] = Double.isNaN(value) ? left[i] + u * (right[i] - left[i]) : value;
        }
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
        oldest[0] = Double.NaN;
        double newest = latest();
        while (!ended) {
            if (!rows.read(incoming)) {
                ended = true;
                return;
            }
            read++;
            if (incoming[0] == newest) {
                repeated++;
            } else if (incoming[0] < newest) {
                backwards++;
            } else {
                System.arraycopy(incoming, 0, oldest, 0, incoming.length);
                return;
            }
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
        return new Relay(read, samples, filled, repeated, backwards, interpolated);
    }
}
