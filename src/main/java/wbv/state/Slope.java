package wbv.state;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * The derivative of a stream: the slope of the polynomial of fourth order that fits the samples of a fifteenth of a second best
 * (A. Savitzky and M. J. E. Golay, Anal. Chem. 36 (1964) 1627-1639), or the plain difference where these are three only.
 */
final class Slope implements Serializable, Snapshot {

    private static final long serialVersionUID = 2;
    private static final double HALF = 1.0 / 30;

    private final double[] weights;
    private final double[] ring;
    private long taken;
    private int place;

    Slope(double rate) {
        weights = weights(rate);
        ring = new double[2 * weights.length + 1];
        clear();
    }

    void clear() {
        Arrays.fill(ring, Double.NaN);
        taken = 0;
        place = 0;
    }

    /** By how many samples it is late. */
    static int delay(double rate) {
        return Math.max(1, (int) Math.round(rate * HALF));
    }

    /** For each distance from 1 to {@link #delay}; times (later - earlier). */
    static double[] weights(double rate) {
        double[] weights = new double[delay(rate)];
        double second = 0;
        double fourth = 0;
        double sixth = 0;
        for (int i = 1; i <= weights.length; i++) {
            double square = (double) i * i;
            second += 2 * square;
            fourth += 2 * square * square;
            sixth += 2 * square * square * square;
        }
        for (int i = 1; i <= weights.length; i++) {
            weights[i - 1] = weights.length == 1 ? rate / 2
                    : rate * (sixth * i - fourth * i * i * i) / (second * sixth - fourth * fourth);
        }
        return weights;
    }

    /** Takes a sample, and gives the slope at the one {@link #delay} before; NaN where a sample is missing. */
    double step(double value) {
        int n = ring.length;
        int at = place;
        place = at + 1 == n ? 0 : at + 1;
        taken++;
        ring[at] = value;
        int half = weights.length;
        int centre = at - half < 0 ? at - half + n : at - half;
        double sum = 0;
        for (int i = 1; i <= half; i++) {
            int later = centre + i < n ? centre + i : centre + i - n;
            int earlier = centre - i < 0 ? centre - i + n : centre - i;
            sum += weights[i - 1] * (ring[later] - ring[earlier]);
        }
        return sum;
    }

    @Override
    public void save(StateWriter out) {
        out.put(ring);
        out.put(taken);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(ring);
        taken = in.count();
        place = (int) Math.floorMod(taken, (long) ring.length);
    }
}
