package wbv.identify;

import java.util.Arrays;
import wbv.signal.BandlimitedResampler;

/**
 * Samples at a whole part of their rate, where what an input excites ends far below half of it. Poles that are slow beside the rate
 * lie together near z = 1, where noise of a hundred times the band hides them, and every sample costs the same. The filter is the
 * same for inputs and output, so that a linear model of the one is a linear model of the other; what its ends touch is left out.
 */
public final class Slower {

    /**
     * Rate kept over the highest frequency excited [1]. At four samples a period a model whose output answers within the sample
     * follows what is band-limited; the resampler passes up to 0.4 of the rate, above it nothing is excited.
     */
    private static final double LEAST = 4;

    private Slower() {}

    /**
     * The samples as slow as their band allows, or as they are.
     *
     * @param highest frequency excited [Hz]
     * @param fewest samples that must be left
     */
    public static Samples of(Samples samples, double highest, int fewest) {
        int down = (int) Math.floor(samples.rate() / (LEAST * highest));
        for (; down > 1; down--) {
            int by = down;
            double[] y = slower(samples.y(), by);
            if (y.length >= fewest) {
                return new Samples(samples.rate() / by, Arrays.stream(samples.u()).map(each -> slower(each, by)).toArray(double[][]::new),
                        y);
            }
        }
        return samples;
    }

    private static double[] slower(double[] values, int down) {
        double[] all = BandlimitedResampler.resample(values, 1, down);
        int delay = new BandlimitedResampler(1, down, none -> {}).delay();
        int end = Math.min(all.length / 2, (delay + down - 1) / down);
        return Arrays.copyOfRange(all, end, all.length - end);
    }
}
