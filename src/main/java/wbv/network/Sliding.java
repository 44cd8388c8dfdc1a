package wbv.network;

import java.io.Serializable;
import java.util.Arrays;
import wbv.signal.GapBridge;

/**
 * The last {@value Imaging#SAMPLES} samples of a stream of two channels, short gaps bridged; what a network looks at while
 * samples come in. Samples come out of the bridge {@link #delay} late.
 */
public final class Sliding implements Serializable {

    private static final long serialVersionUID = 1;
    /** Missing samples in a row that are bridged, 0.1 s. */
    private static final int LONGEST_GAP = 6;

    private final double[][] recent = new double[2][Imaging.SAMPLES];
    private final GapBridge[] bridges = {new GapBridge(LONGEST_GAP), new GapBridge(LONGEST_GAP)};
    private int at;
    private long taken;
    private long whole;

    /** Samples between one that comes in and the image's last. */
    public int delay() {
        return bridges[0].delay();
    }

    /** Takes a sample of excitation and answer, NaN where missing. */
    public void accept(double excitation, double answer) {
        double u = bridges[0].accept(excitation);
        double y = bridges[1].accept(answer);
        recent[0][at] = u;
        recent[1][at] = y;
        at = at + 1 == Imaging.SAMPLES ? 0 : at + 1;
        taken++;
        whole = Double.isFinite(u) && Double.isFinite(y) ? whole + 1 : 0;
    }

    /** Samples taken. */
    public long taken() {
        return taken;
    }

    /** Whether the last {@value Imaging#SAMPLES} samples are all there. */
    public boolean whole() {
        return whole >= Imaging.SAMPLES;
    }

    /** The samples, oldest first. A copy. */
    public double[][] motion() {
        double[][] motion = new double[2][];
        for (int c = 0; c < 2; c++) {
            motion[c] = Arrays.copyOf(Arrays.copyOfRange(recent[c], at, Imaging.SAMPLES), Imaging.SAMPLES);
            System.arraycopy(recent[c], 0, motion[c], Imaging.SAMPLES - at, at);
        }
        return motion;
    }
}
