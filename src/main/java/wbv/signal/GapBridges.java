package wbv.signal;

import java.util.Arrays;

/** A {@link GapBridge} for each of several channels that run side by side. */
public final class GapBridges {

    private final GapBridge[] bridges;
    private int untilFirst;

    /**
     * Bridges by curves alone.
     *
     * @param longest missing samples in a row that are bridged, at least 1
     */
    public GapBridges(int channels, int longest) {
        bridges = new GapBridge[channels];
        Arrays.setAll(bridges, i -> new GapBridge(longest));
        untilFirst = new GapBridge(longest).delay();
    }

    /** Samples by which the streams come out late, and so how many of missing values flush the last ones out. */
    public int delay() {
        return bridges[0].delay();
    }

    /**
     * Takes a sample of every channel and gives the one of {@link #delay()} samples ago.
     *
     * @param values one a channel, in its own unit; NaN where missing. Modified.
     * @return false while nothing has come out yet
     */
    public boolean accept(double[] values) {
        for (int i = 0; i < bridges.length; i++) {
            values[i] = bridges[i].accept(values[i]);
        }
        if (untilFirst > 0) {
            untilFirst--;
            return false;
        }
        return true;
    }

    /** Samples bridged so far, in all channels. */
    public long bridged() {
        return Arrays.stream(bridges).mapToLong(GapBridge::bridged).sum();
    }
}
