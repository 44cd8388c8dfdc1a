package wbv.signal;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Bridges short runs of missing samples in a stream by the cubic through the two samples on either side, so that a lost packet
 * does not cost a whole segment of a spectrum. Longer runs stay missing. The stream comes out {@link #delay()} samples late.
 */
public final class GapBridge implements Serializable {

    private static final long serialVersionUID = 1;

    private final int longest;
    private final double[] ring;
    private long pushed;
    private long bridged;

    /** @param longest missing samples in a row that are bridged, at least 1 */
    public GapBridge(int longest) {
        if (longest < 1) {
            throw new IllegalArgumentException("longest gap to bridge must be at least 1 sample: " + longest);
        }
        this.longest = longest;
        this.ring = new double[longest + 4];
        Arrays.fill(ring, Double.NaN);
    }

    /** Samples by which the stream comes out late. */
    public int delay() {
        return longest + 2;
    }

    /** Samples bridged so far. */
    public long bridged() {
        return bridged;
    }

    /** Takes a sample, NaN where missing, and gives the one of {@link #delay()} samples ago; NaN before the first. */
    public double accept(double value) {
        ring[at(0)] = value;
        if (!Double.isNaN(value) && !Double.isNaN(ring[at(1)]) && Double.isNaN(ring[at(2)])) {
            bridge();
        }
        double out = ring[at(delay())];
        pushed++;
        return out;
    }

    /** The two newest samples are there and the one before is not: fills the gap if it is short and has two samples before it. */
    private void bridge() {
        int gap = 1;
        while (gap <= longest && Double.isNaN(ring[at(2 + gap)])) {
            gap++;
        }
        if (gap > longest || 3 + gap >= ring.length || Double.isNaN(ring[at(3 + gap)])) {
            return;
        }
        // Points at 0, 1 before the gap and 1 + gap + 1, 1 + gap + 2 after it.
        double[] y = {ring[at(3 + gap)], ring[at(2 + gap)], ring[at(1)], ring[at(0)]};
        double[] x = {0, 1, gap + 2, gap + 3};
        for (int i = 0; i < gap; i++) {
            ring[at(1 + gap - i)] = lagrange(x, y, 2 + i);
            bridged++;
        }
    }

    private static double lagrange(double[] x, double[] y, double at) {
        double sum = 0;
        for (int i = 0; i < 4; i++) {
            double weight = y[i];
            for (int j = 0; j < 4; j++) {
                weight *= j == i ? 1 : (at - x[j]) / (x[i] - x[j]);
            }
            sum += weight;
        }
        return sum;
    }

    /** Place in the ring of the sample pushed some samples ago. */
    private int at(int ago) {
        return (int) Math.floorMod(pushed - ago, (long) ring.length);
    }
}
