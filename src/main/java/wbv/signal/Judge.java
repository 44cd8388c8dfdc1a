package wbv.signal;

import java.util.Arrays;
import org.apache.commons.math3.distribution.FDistribution;

/**
 * Tells what backs a response at a frequency, by the power of its input and the coherence of its output.
 *
 * <p>Coherence: see {@link FrequencyResponse.Excited}. Power: below a given part of its largest an input is not excited, whatever
 * the coherence. Where the coherence is low, an input that stands on its own floor is not excited either: its tenth percentile
 * over all frequencies, if that lies at least 20 dB below the largest density, and as far above as two estimates of one density
 * differ in 1 % of cases (F with 2n and 2n degrees of freedom). An input of even density has no floor.
 */
final class Judge {

    /** A floor lies at least 20 dB below what is excited; else it is excitation. */
    private static final double FLOOR = 0.01;
    private static final double LOW = 0.1;

    private final int firstBin;
    private final double least;
    private final double ruledOut;
    private final double averages;
    private final FrequencyResponse.Excited excited;

    /**
     * @param averages independent averages;
     * @param firstBin first bin that holds no mean or trend
     */
    Judge(double averages, int inputs, int firstBin, FrequencyResponse.Excited excited) {
        this.averages = averages;
        this.firstBin = firstBin;
        this.excited = excited;
        least = excited.leastCoherence(averages, inputs);
        ruledOut = averages > inputs && excited.coherence() < 1
                ? new CoherenceDistribution(averages, inputs).quantile(FrequencyResponse.Excited.RARE, excited.coherence()) : 0;
    }

    /**
     * What backs the response at every bin.
     *
     * @param density   of the input
     * @param coherence with all inputs
     * @param own       share of the input that no other input explains
     */
    Backing[] of(double[] density, double[] coherence, double[] own, double leastOwn) {
        double[] known = Arrays.copyOfRange(density, Math.min(1, density.length), density.length);
        Arrays.sort(known);
        double largest = known.length == 0 ? 0 : known[known.length - 1];
        double floor = known.length == 0 ? 0 : known[(int) (LOW * known.length)];
        double reach = floor <= FLOOR * largest ? floor * new FDistribution(null, 2 * averages, 2 * averages)
                .inverseCumulativeProbability(0.99) : 0;
        Backing[] all = new Backing[density.length];
        for (int k = 0; k < all.length; k++) {
            boolean little = k < firstBin || !(density[k] > 0) || density[k] < excited.floor() * largest;
            if (little) {
                all[k] = Backing.NOT_EXCITED;
            } else if (own[k] < leastOwn) {
                all[k] = Backing.NOT_APART;
            } else if (coherence[k] >= least && averages > 1) {
                all[k] = Backing.USABLE;
            } else if (density[k] <= reach) {
                all[k] = Backing.NOT_EXCITED;
            } else {
                all[k] = coherence[k] < ruledOut ? Backing.NOT_CAUSED : Backing.IN_DOUBT;
            }
        }
        return all;
    }
}
