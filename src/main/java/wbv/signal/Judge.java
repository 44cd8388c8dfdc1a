package wbv.signal;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.FDistribution;

/**
 * Tells what backs a response at a frequency, by the power of its input and the coherence of its output.
 *
 * <p>Coherence: see {@link FrequencyResponse.Excited}. Power: below a given part of its largest an input is not excited, whatever
 * the coherence. Where the coherence is low, an input that stands on its own floor is not excited either: its tenth percentile
 * over all frequencies, if that lies at least 20 dB below the largest density, and as far above as two estimates of one density
 * differ in 1 % of cases (F with 2n and 2n degrees of freedom). An input of even density has no floor.
 *
 * <p>The output's own noise is its density where no input is excited. What the inputs leave of it elsewhere is another cause's only
 * where that is more than noise alone leaves in 5 % of cases: {@code 2 (n - m) (1 - γ²) G_yy / noise} is χ² with 2 (n - m) degrees
 * of freedom (Goodman 1963), n averages, m inputs.
 */
final class Judge {

    /** A floor lies at least 20 dB below what is excited; else it is excitation. */
    private static final double FLOOR = 0.01;
    private static final double LOW = 0.1;
    /** Bins from which the output's noise is known: their median scatters by a tenth or less from 8 averages on. */
    private static final int LEAST_STILL = 20;

    private final int firstBin;
    private final double least;
    private final double ruledOut;
    private final double averages;
    private final int inputs;
    private final FrequencyResponse.Excited excited;

    /**
     * @param averages independent averages;
     * @param firstBin first bin that holds no mean or trend
     */
    Judge(double averages, int inputs, int firstBin, FrequencyResponse.Excited excited) {
        this.averages = averages;
        this.inputs = inputs;
        this.firstBin = firstBin;
        this.excited = excited;
        least = excited.leastCoherence(averages, inputs);
        ruledOut = averages > inputs && excited.coherence() < 1
                ? new CoherenceDistribution(averages, inputs).quantile(FrequencyResponse.Excited.RARE, excited.coherence()) : 0;
    }

    /**
     * Density of the output's own noise: its median where no input is excited; 0 where there is no such band.
     *
     * @param densities of the inputs
     * @param coherence of the output with all of them
     */
    double noise(double[] output, double[] coherence, double[]... densities) {
        double[][] reaches = Arrays.stream(densities).map(this::reach).toArray(double[][]::new);
        double[] still = IntStream.range(firstBin, output.length - 1).filter(k -> coherence[k] < least
                && IntStream.range(0, densities.length).allMatch(i -> densities[i][k] <= Math.max(reaches[i][0], reaches[i][1])))
                .mapToDouble(k -> output[k]).sorted().toArray();
        double free = 2 * averages;
        return still.length < LEAST_STILL ? 0
                : still[still.length / 2] * free / new ChiSquaredDistribution(free).inverseCumulativeProbability(0.5);
    }

    /** Densities up to which an input is not excited: a part of its largest, and its own floor. */
    private double[] reach(double[] density) {
        double[] known = Arrays.copyOfRange(density, Math.min(1, density.length), density.length);
        Arrays.sort(known);
        double largest = known.length == 0 ? 0 : known[known.length - 1];
        double floor = known.length == 0 ? 0 : known[(int) (LOW * known.length)];
        double reach = floor <= FLOOR * largest ? floor * new FDistribution(null, 2 * averages, 2 * averages)
                .inverseCumulativeProbability(0.99) : 0;
        return new double[] {excited.floor() * largest, reach};
    }

    /**
     * What backs the response at every bin.
     *
     * @param density   of the input
     * @param output    density of the output
     * @param noise     its own, see {@link #noise}
     * @param coherence with all inputs
     * @param own       share of the input that no other input explains
     */
    Backing[] of(double[] density, double[] output, double noise, double[] coherence, double[] own, double leastOwn) {
        double[] reaches = reach(density);
        double free = 2 * (averages - inputs);
        double most = noise > 0 && free > 0
                ? noise * new ChiSquaredDistribution(free).inverseCumulativeProbability(1 - FrequencyResponse.Excited.RARE) / free : 0;
        Backing[] all = new Backing[density.length];
        for (int k = 0; k < all.length; k++) {
            boolean little = k < firstBin || !(density[k] > 0) || density[k] < reaches[0];
            if (little) {
                all[k] = Backing.NOT_EXCITED;
            } else if (own[k] < leastOwn) {
                all[k] = Backing.NOT_APART;
            } else if (coherence[k] >= least && averages > 1) {
                all[k] = Backing.USABLE;
            } else if (density[k] <= reaches[1]) {
                all[k] = Backing.NOT_EXCITED;
            } else {
                boolean low = coherence[k] < ruledOut;
                all[k] = !low ? Backing.IN_DOUBT : (1 - coherence[k]) * output[k] <= most ? Backing.BELOW_NOISE : Backing.NOT_CAUSED;
            }
        }
        return all;
    }
}
