package wbv.signal;

import java.util.ArrayList;
import java.util.List;

/**
 * Discrete wavelet packets: a signal parted into 2^L bands of equal width by halving every band L times (Coifman and Wickerhauser
 * 1992). The signal is taken as periodic, so that the transform is orthonormal: the bands' energies add up to the signal's, and
 * {@link #join} gives it back.
 *
 * @param wavelet the filters
 * @param levels  L, 1 to 20
 */
public record WaveletPacket(Wavelet wavelet, int levels) {

    public WaveletPacket {
        if (!(levels >= 1 && levels <= 20)) {
            throw new IllegalArgumentException("levels of a wavelet packet must be 1 to 20: " + levels);
        }
    }

    /** Number of bands, 2^L. */
    public int bands() {
        return 1 << levels;
    }

    /** Width of a band [Hz]; band k lies from k times this to k + 1 times this. @param rate sampling rate [Hz] */
    public double width(double rate) {
        return rate / 2 / bands();
    }

    /**
     * The coefficients by band, in order of frequency, each N / 2^L long.
     *
     * @param samples N, a multiple of 2^L, finite. Not modified.
     */
    public double[][] split(double[] samples) {
        if (samples.length == 0 || samples.length % bands() != 0) {
            throw new IllegalArgumentException("a wavelet packet of " + levels + " levels needs a multiple of " + bands()
                    + " samples: "
                    + samples.length);
        }
        List<double[]> nodes = List.of(samples);
        for (int level = 0; level < levels; level++) {
            List<double[]> next = new ArrayList<>();
            for (int i = 0; i < nodes.size(); i++) {
                double[] low = new double[nodes.get(i).length / 2];
                double[] high = new double[low.length];
                halve(nodes.get(i), low, high);
                // Halving the rate of an upper half turns its frequencies round.
                boolean upright = i % 2 == 0;
                next.add(upright ? low : high);
                next.add(upright ? high : low);
            }
            nodes = next;
        }
        return nodes.toArray(double[][]::new);
    }

    /** The signal of the coefficients. @param bands as {@link #split} gives them. Not modified. */
    public double[] join(double[][] bands) {
        if (bands.length != bands()) {
            throw new IllegalArgumentException("there are " + bands() + " bands: " + bands.length);
        }
        List<double[]> nodes = List.of(bands);
        for (int level = 0; level < levels; level++) {
            List<double[]> next = new ArrayList<>();
            for (int i = 0; i < nodes.size(); i += 2) {
                boolean upright = i / 2 % 2 == 0;
                next.add(unite(nodes.get(upright ? i : i + 1), nodes.get(upright ? i + 1 : i)));
            }
            nodes = next;
        }
        return nodes.get(0);
    }

    /** Mean square of each band: its part of the signal's power. @param samples as for {@link #split}. Not modified. */
    public double[] power(double[] samples) {
        double[] power = new double[bands()];
        double[][] bands = split(samples);
        for (int k = 0; k < power.length; k++) {
            for (double value : bands[k]) {
                power[k] += value * value / samples.length;
            }
        }
        return power;
    }

    private void halve(double[] x, double[] low, double[] high) {
        for (int k = 0; k < low.length; k++) {
            for (int n = 0; n < wavelet.taps(); n++) {
                double value = x[Math.floorMod(2 * k + wavelet.taps() / 2 - n, x.length)];
                low[k] += wavelet.low(n) * value;
                high[k] += wavelet.high(n) * value;
            }
        }
    }

    private double[] unite(double[] low, double[] high) {
        double[] x = new double[2 * low.length];
        for (int k = 0; k < low.length; k++) {
            for (int n = 0; n < wavelet.taps(); n++) {
                x[Math.floorMod(2 * k + wavelet.taps() / 2 - n, x.length)] += wavelet.low(n) * low[k] + wavelet.high(n) * high[k];
            }
        }
        return x;
    }
}
