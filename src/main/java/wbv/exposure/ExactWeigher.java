package wbv.exposure;

import java.util.Arrays;
import java.util.function.DoubleConsumer;
import wbv.signal.GapBridge;
import wbv.signal.RealDft;

/**
 * The exact analog weighting of recorded data, all frequencies up to half the rate, by Fourier transforms of long blocks that are
 * padded on both sides and overlap (Stockham 1966): what spills over a block's ends is added to its neighbours. A pad holds
 * eight periods of the lowest corner, after which the filter has forgotten everything; only what lies within 0.1 Hz of half the
 * rate rings longer, and is not exact. The recording's mean is taken out, and counts as having been there always.
 */
public final class ExactWeigher implements Weigher {

    /** Rate at which the weighted values come at least [Hz]. */
    private static final double WORKING_RATE = 400;
    private static final double PERIODS = 8;
    /** Length of a block in pads. */
    private static final int PADS = 6;
    /**
     * The same where pads are longer than so many samples, as those of motion sickness at rates of kHz: a third of the memory for half as
     * much time again.
     */
    private static final int FEW_PADS = 2;
    private static final int LONG_PAD = 1 << 17;

    private final int factor;
    private final int pad;
    private final int block;
    private final double mean;
    private final GapBridge bridge;
    private final RealDft forward;
    private final RealDft inverse;
    private final double[] response;
    private final double[] frame;
    private final double[] sum;
    private final boolean[] missing;
    private final DoubleConsumer sink;
    private int warmUp;
    private int filled;
    private long taken;

    /**
     * Lays out blocks for a filter and a rate; nothing is weighted yet.
     *
     * @param rate   sampling rate [Hz]
     * @param mean   of all samples, in their unit
     * @param boxcar true if a sample is the mean over the sampling period, so that its droop is undone
     * @param sink   takes the weighted values
     */
    public ExactWeigher(AnalogFilter filter, double rate, double mean, boolean boxcar, DoubleConsumer sink) {
        this.mean = mean;
        this.sink = sink;
        pad = pad(filter, rate);
        int points = points(pad);
        block = points - 2 * pad;
        factor = factor(filter, rate);
        bridge = new GapBridge(Weigher.longestBridge(rate));
        warmUp = bridge.delay();
        forward = new RealDft(points);
        inverse = factor == 1 ? forward : new RealDft(points * factor);
        response = new double[points];
        double[] h = new double[2];
        for (int k = 0; k < points / 2; k++) { // the line at half the rate is left out: it has no phase
            double frequency = k * rate / points;
            filter.response(frequency, h);
            double gain = factor * (boxcar ? Boxcar.gain(frequency / rate) : 1);
            response[2 * k] = h[0] * gain;
            response[2 * k + 1] = h[1] * gain;
        }
        frame = new double[points];
        sum = new double[points * factor];
        missing = new boolean[points];
    }

    private static int pad(AnalogFilter filter, double rate) {
        return (int) Math.ceil(PERIODS / filter.slowest() * rate);
    }

    private static int points(int pad) {
        return RealDft.covering(((pad > LONG_PAD ? FEW_PADS : PADS) + 2) * pad);
    }

    /** Weighted values for a sample at a rate [Hz]. */
    static int factor(AnalogFilter filter, double rate) {
        int points = points(pad(filter, rate));
        int factor = (int) Math.ceil(Math.max(1, WORKING_RATE / rate - 1e-9));
        while (!RealDft.fits(points * factor)) {
            factor++;
        }
        return factor;
    }

    @Override
    public int factor() {
        return factor;
    }

    @Override
    public void accept(double value) {
        double bridged = bridge.accept(value);
        if (warmUp > 0) {
            warmUp--;
        } else {
            present(bridged);
        }
    }

    private void present(double value) {
        boolean absent = Double.isNaN(value);
        missing[(int) (taken % missing.length)] = absent;
        frame[pad + filled] = absent ? 0 : value - mean;
        taken++;
        filled++;
        if (filled == block) {
            transform();
        }
    }

    /** Weighs the block, adds what it gives to what its neighbours left, and gives on what is complete. */
    private void transform() {
        add();
        give(block);
        int shift = block * factor;
        System.arraycopy(sum, shift, sum, 0, sum.length - shift);
        Arrays.fill(sum, sum.length - shift, sum.length, 0);
        Arrays.fill(frame, 0);
        filled = 0;
    }

    private void add() {
        double[] spectrum = forward.forward(frame);
        for (int i = 0; i < response.length; i += 2) {
            double re = spectrum[i];
            double im = spectrum[i + 1];
            spectrum[i] = re * response[i] - im * response[i + 1];
            spectrum[i + 1] = re * response[i + 1] + im * response[i];
        }
        Arrays.fill(spectrum, response.length, spectrum.length, 0);
        double[] values = inverse.inverse(spectrum);
        for (int i = 0; i < sum.length; i++) {
            sum[i] += values[i];
        }
    }

    /** Gives on the first samples of the frame, which begins one pad before the first sample of the block. */
    private void give(int samples) {
        long first = taken - filled - pad;
        for (int i = (int) Math.max(0, -first); i < samples; i++) {
            boolean absent = missing[(int) ((first + i) % missing.length)];
            for (int j = 0; j < factor; j++) {
                sink.accept(absent ? Double.NaN : sum[i * factor + j]);
            }
        }
    }

    @Override
    public void finish() {
        for (int i = bridge.delay(); i > 0; i--) {
            accept(Double.NaN);
        }
        if (filled > 0) {
            add();
        }
        give(pad + filled);
    }
}
