package wbv.signal;

import java.io.Serializable;
import java.util.Arrays;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Bridges short runs of missing samples in a stream by the cubic through the two samples on either side, so that a lost packet
 * does not cost a whole segment of a spectrum. Where a second sample on a side is missing too, the polynomial through those that
 * are there takes its place. Longer runs stay missing, or get a straight line where a picture is all that is wanted. The stream comes out
 * {@link #delay()} samples late.
 */
public final class GapBridge implements Serializable, Snapshot {

    private static final long serialVersionUID = 2;

    private final int curved;
    private final int longest;
    private final double[] ring;
    private final double[] x = new double[4];
    private final double[] y = new double[4];
    private long pushed;
    private int place;
    private long bridged;

    /**
     * A bridge by curves alone.
     *
     * @param longest missing samples in a row that are bridged, at least 1
     */
    public GapBridge(int longest) {
        this(longest, longest);
    }

    /**
     * A bridge by curves, and by straight lines where a curve would be a guess.
     *
     * @param curved  missing samples in a row that the polynomial bridges, at least 1
     * @param longest missing samples in a row that are bridged at all, the more than {@code curved} by a straight line
     */
    public GapBridge(int curved, int longest) {
        if (curved < 1 || longest < curved) {
            throw new IllegalArgumentException("longest gap to bridge must be at least 1 sample, straight ones no shorter: " + curved
                    + ", " + longest);
        }
        this.curved = curved;
        this.longest = longest;
        this.ring = new double[longest + 4];
        Arrays.fill(ring, Double.NaN);
    }

    /** Another for gaps as long, that has heard nothing. */
    public GapBridge fresh() {
        return new GapBridge(curved, longest);
    }

    /**
     * A whole series, bridged and on time, in its own unit.
     *
     * @param values by sample, of any unit, NaN where missing. Not modified.
     * @param longest as the constructor has it
     */
    public static double[] over(double[] values, int longest) {
        GapBridge bridge = new GapBridge(longest);
        double[] out = new double[values.length];
        int delay = bridge.delay();
        for (int i = 0; i < values.length + delay; i++) {
            double value = bridge.accept(i < values.length ? values[i] : Double.NaN);
            if (i >= delay) {
                out[i - delay] = value;
            }
        }
        return out;
    }

    /** Samples by which the stream comes out late. */
    public int delay() {
        return longest + 2;
    }

    /** Samples bridged so far. */
    public long bridged() {
        return bridged;
    }

    /**
     * Takes a sample of any unit, NaN where missing, and gives the one of {@link #delay()} samples ago, in that unit; NaN before the first.
     */
    public double accept(double value) {
        ring[at(0)] = value;
        if (!Double.isNaN(ring[at(1)]) && Double.isNaN(ring[at(2)])) {
            bridge(Double.isNaN(value) ? 1 : 2);
        }
        double out = ring[at(delay())];
        pushed++;
        place = place + 1 == ring.length ? 0 : place + 1;
        return out;
    }

    /**
     * A run of missing samples ended two samples ago: fills it if it is short.
     *
     * @param present samples behind it, 1 or 2
     */
    private void bridge(int present) {
        int gap = 1;
        while (gap <= longest && Double.isNaN(ring[at(2 + gap)])) {
            gap++;
        }
        if (gap > longest) {
            return;
        }
        // Samples at -1, 0 before the gap and gap + 1, gap + 2 after it.
        int before = gap > curved || Double.isNaN(ring[at(3 + gap)]) ? 1 : 2;
        int after = gap > curved ? 1 : present;
        int points = before + after;
        for (int i = 0; i < before; i++) {
            x[i] = i + 1 - before;
            y[i] = ring[at(2 + gap - (i + 1 - before))];
        }
        for (int i = 0; i < after; i++) {
            x[before + i] = gap + 1 + i;
            y[before + i] = ring[at(1 - i)];
        }
        for (int i = 1; i <= gap; i++) {
            ring[at(2 + gap - i)] = lagrange(points, i);
            bridged++;
        }
    }

    /** The polynomial through the first points at a place. */
    private double lagrange(int points, double at) {
        double sum = 0;
        for (int i = 0; i < points; i++) {
            double weight = y[i];
            for (int j = 0; j < points; j++) {
                weight *= j == i ? 1 : (at - x[j]) / (x[i] - x[j]);
            }
            sum += weight;
        }
        return sum;
    }

    /** Place in the ring of the sample pushed some samples ago, fewer than it holds. */
    private int at(int ago) {
        int at = place - ago;
        return at < 0 ? at + ring.length : at;
    }

    @Override
    public void save(StateWriter out) {
        out.put(ring);
        out.put(pushed);
        out.put(bridged);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(ring);
        pushed = in.count();
        place = (int) Math.floorMod(pushed, (long) ring.length);
        bridged = in.count();
    }
}
