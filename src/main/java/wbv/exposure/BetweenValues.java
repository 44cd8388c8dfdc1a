package wbv.exposure;

import java.util.Arrays;
import wbv.signal.BandlimitedResampler;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Looks between values of a signal that ends at a quarter of their rate for a peak that is higher than they are. */
final class BetweenValues implements Snapshot {

    /** Where the signal ends and its first image begins, as parts of the rate of the values. */
    private static final double SIGNAL = 0.25;
    private static final double IMAGES = 0.75;
    private static final double ATTENUATION = 75;

    /** For each place between two values the weights of those about it. */
    private final double[][] phases;
    /** Values that an interval needs, and one more. */
    private final double[] recent;
    private final int centre;

    /** @param steps from one value to the next; one looks nowhere */
    BetweenValues(int steps) {
        this(phases(steps, SIGNAL, IMAGES, ATTENUATION));
    }

    /** Another of the same filter, that has heard nothing. */
    BetweenValues fresh() {
        return new BetweenValues(phases);
    }

    private BetweenValues(double[][] phases) {
        this.phases = phases;
        this.recent = new double[phases[0].length + 1];
        this.centre = phases[0].length / 2 - 1;
        Arrays.fill(recent, Double.NaN);
    }

    /** From one value to the next. */
    int steps() {
        return phases.length;
    }

    /**
     * The weights of a resampler's filter for each place between two samples, in the order of the samples.
     *
     * @param up places from one sample to the next, of which the first is the sample itself; the rest as {@link
     *           BandlimitedResampler#raising}
     */
    static double[][] phases(int up, double passband, double stopband, double attenuation) {
        double[][] out = {new double[0]};
        int[] filled = {0};
        BandlimitedResampler resampler = BandlimitedResampler.raising(up, passband, stopband, attenuation,
                value -> out[0][filled[0]++] = value);
        int reach = resampler.delay();
        out[0] = new double[up * (2 * reach + 2)];
        for (int i = 0; i < 2 * reach + 2; i++) {
            resampler.accept(i == reach ? 1 : 0);
        }
        resampler.finish();
        double[][] phases = new double[up][2 * reach];
        for (int p = 0; p < up; p++) {
            for (int i = 0; i < 2 * reach; i++) {
                phases[p][i] = out[0][up * reach + p - up * (i - reach + 1)];
            }
        }
        return phases;
    }

    /** Hears two values, NaN where missing. */
    void hear(double first, double second, Weigher.Sink sink) {
        int width = recent.length - 1;
        for (int i = 2; i <= width; i++) {
            recent[i - 2] = recent[i];
        }
        recent[width - 1] = first;
        recent[width] = second;
        double least = sink.leastBetween();
        double middle = Math.abs(recent[centre + 1]);
        if (Math.abs(recent[centre]) > least || middle > least) {
            look(0, sink);
        }
        if (middle > least || Math.abs(recent[centre + 2]) > least) {
            look(1, sink);
        }
    }

    private void look(int from, Weigher.Sink sink) {
        for (int p = 1; p < phases.length; p++) {
            double[] taps = phases[p];
            double sum = 0;
            for (int i = 0; i < taps.length; i++) {
                sum += taps[i] * recent[from + i];
            }
            sink.between(sum);
        }
    }

    @Override
    public void save(StateWriter out) {
        out.put(recent);
    }

    @Override
    public void load(StateReader in) {
        in.numbers(recent);
    }
}
