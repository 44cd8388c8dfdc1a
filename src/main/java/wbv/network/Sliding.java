package wbv.network;

import java.io.Serializable;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.signal.GapBridge;

/**
 * The last {@value Imaging#SAMPLES} samples of a stream of channels, short gaps bridged; what a network looks at while
 * samples come in. Samples come out of the bridge {@link #delay} late.
 */
public final class Sliding implements Serializable {

    private static final long serialVersionUID = 1;
    /** Missing samples in a row that are bridged, 0.1 s. */
    private static final int LONGEST_GAP = 6;

    private final double[][] recent;
    private final GapBridge[] bridges;
    private int at;
    private long taken;
    private long whole;

    /** Hears of a window. */
    interface Look {
        /**
         * @param last number of its last sample
         * @param motion the window; empty where samples are missing
         */
        void at(int last, Optional<double[][]> motion);
    }

    /**
     * An empty window.
     *
     * @param channels &gt;= 1
     */
    public Sliding(int channels) {
        recent = new double[channels][Imaging.SAMPLES];
        bridges = new GapBridge[channels];
        Arrays.setAll(bridges, c -> new GapBridge(LONGEST_GAP));
    }

    /**
     * Slides over columns of equal length. Not modified.
     *
     * @param hop samples from one window to the next
     */
    static void over(List<double[]> columns, int hop, Look look) {
        Sliding sliding = new Sliding(columns.size());
        double[] row = new double[columns.size()];
        int length = columns.get(0).length;
        for (int i = 0; i < length + sliding.delay(); i++) {
            int at = i;
            Arrays.setAll(row, c -> at < length ? columns.get(c)[at] : Double.NaN);
            sliding.accept(row);
            int last = i - sliding.delay();
            if (last >= Imaging.SAMPLES - 1 && (last - Imaging.SAMPLES + 1) % hop == 0) {
                look.at(last, sliding.whole() ? Optional.of(sliding.motion()) : Optional.empty());
            }
        }
    }

    /** Samples between one that comes in and the image's last. */
    public int delay() {
        return bridges[0].delay();
    }

    /** Takes a sample of every channel, in its own unit, NaN where missing. Not modified. */
    public void accept(double... row) {
        boolean all = true;
        for (int c = 0; c < recent.length; c++) {
            recent[c][at] = bridges[c].accept(row[c]);
            all &= Double.isFinite(recent[c][at]);
        }
        at = at + 1 == Imaging.SAMPLES ? 0 : at + 1;
        taken++;
        whole = all ? whole + 1 : 0;
    }

    /** Samples taken. */
    public long taken() {
        return taken;
    }

    /** Whether the last {@value Imaging#SAMPLES} samples are all there. */
    public boolean whole() {
        return whole >= Imaging.SAMPLES;
    }

    /** The samples by channel, each in its own unit, {@value Imaging#SAMPLES} long, oldest first. A copy. */
    public double[][] motion() {
        double[][] motion = new double[recent.length][];
        for (int c = 0; c < motion.length; c++) {
            motion[c] = Arrays.copyOf(Arrays.copyOfRange(recent[c], at, Imaging.SAMPLES), Imaging.SAMPLES);
            System.arraycopy(recent[c], 0, motion[c], Imaging.SAMPLES - at, at);
        }
        return motion;
    }
}
