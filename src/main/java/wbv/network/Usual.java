package wbv.network;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * What a window is held against: what {@link FrequencyFit} leaves unexplained in windows like those trained on. Arrays are not
 * copied: treat them as read-only.
 *
 * @param left     no more than this in all but three in a thousand windows, {@link FrequencyFit.Found#left} [m/s²]
 * @param coloured the same of {@link FrequencyFit.Found#coloured}
 * @param moved    the same of {@link FrequencyFit.Found#moved}: how far the network was from what the window says
 * @param widening factors, one for each target, by which the fit's deviations of each target are multiplied, so that intervals of 90 % hold
 */
public record Usual(double left, double coloured, double moved, double[] widening) {

    private static final double SHARE = 0.997;

    /**
     * Everything is usual, where that is not known.
     *
     * @param targets values read
     */
    static Usual unknown(int targets) {
        double[] ones = new double[targets];
        Arrays.fill(ones, 1);
        return new Usual(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE, ones);
    }

    static Usual of(List<FrequencyFit.Found> found, List<LabelledMotion> trials) {
        List<Estimate> estimates = found.stream().map(each -> new Estimate(each.value(), each.deviation())).toList();
        return new Usual(quantile(found, FrequencyFit.Found::left), quantile(found, FrequencyFit.Found::coloured),
                quantile(found, FrequencyFit.Found::moved), widening(estimates, trials));
    }

    /** What makes intervals of 90 % hold the truth of 90 % of trials, by target (split conformal, Lei et al. 2018). */
    static double[] widening(List<Estimate> estimates, List<LabelledMotion> trials) {
        double[] widening = new double[trials.get(0).truth().length];
        for (int j = 0; j < widening.length; j++) {
            double[] ratio = new double[trials.size()];
            for (int i = 0; i < ratio.length; i++) {
                ratio[i] = Math.abs(estimates.get(i).value()[j] - trials.get(i).truth()[j]) / estimates.get(i).deviation()[j];
            }
            Arrays.sort(ratio);
            widening[j] = ratio[rank(0.9, ratio.length)] / Estimate.NINETY;
        }
        return widening;
    }

    private static double quantile(List<FrequencyFit.Found> found, ToDoubleFunction<FrequencyFit.Found> what) {
        double[] sorted = found.stream().mapToDouble(what).sorted().toArray();
        return sorted[rank(SHARE, sorted.length)];
    }

    private static int rank(double share, int count) {
        return (int) Math.min(count - 1, Math.ceil(share * (count + 1)) - 1);
    }

    /** How a window's fit compares: 1 where it leaves as much as windows trained on may. */
    double misfit(FrequencyFit.Found found) {
        return Math.max(found.moved() / moved, Math.max(found.left() / left, found.coloured() / coloured));
    }

    /**
     * An estimate whose variance has grown: by that of all bodies trained on and the square of how far network and fit lie apart,
     * times the share of the misfit that windows trained on would not have, {@code 1 - 1/misfit²}. A window that is unlike them
     * all says no more than that.
     *
     * @param other  the network's where the estimate is the fit's, and the other way round
     * @param spread standard deviation of each target over the bodies trained on
     */
    static Estimate doubted(Estimate estimate, Estimate other, double misfit, double[] spread) {
        double share = misfit > 1 ? 1 - 1 / (misfit * misfit) : 0;
        double[] deviation = new double[spread.length];
        for (int j = 0; j < deviation.length; j++) {
            double apart = estimate.value()[j] - other.value()[j];
            deviation[j] = Math.sqrt(estimate.deviation()[j] * estimate.deviation()[j]
                    + share * (spread[j] * spread[j] + apart * apart));
        }
        return new Estimate(estimate.value(), deviation);
    }
}
