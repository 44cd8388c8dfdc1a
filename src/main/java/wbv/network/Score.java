package wbv.network;

import java.util.Arrays;
import java.util.List;

/**
 * How far estimates of one target lie from the truth.
 *
 * @param count        trials
 * @param missing      trials for which the method gave nothing; they count as if it had said the population's mean
 * @param rmse         root mean square error, in the target's unit
 * @param deviation    standard deviation of the error, likewise
 * @param standardised ratio of {@code rmse} to the standard deviation of the truth
 * @param covered      share of trials whose interval of 90 % holds the truth; NaN where the method states none
 * @param stated       root mean square of the stated standard deviations; NaN likewise
 */
public record Score(int count, int missing, double rmse, double deviation, double standardised, double covered, double stated) {

    /**
     * The score of one target.
     *
     * @param target    number of the target
     * @param estimates as many as trials
     * @param mean      the population's mean, in the target's unit, for what is missing
     * @param spread    the population's standard deviation, likewise
     */
    public static Score of(int target, List<LabelledMotion> trials, List<Estimate> estimates, double mean, double spread) {
        int n = trials.size();
        double[] error = new double[n];
        int missing = 0;
        int inside = 0;
        double stated = 0;
        for (int i = 0; i < n; i++) {
            double truth = trials.get(i).truth()[target];
            double value = estimates.get(i).value()[target];
            double sigma = estimates.get(i).deviation()[target];
            if (!Double.isFinite(value)) {
                missing++;
                value = mean;
            }
            error[i] = value - truth;
            inside += Math.abs(error[i]) <= Estimate.NINETY * sigma ? 1 : 0;
            stated += sigma * sigma / n;
        }
        double bias = Arrays.stream(error).average().orElse(Double.NaN);
        double squares = Arrays.stream(error).map(e -> e * e).average().orElse(Double.NaN);
        double rmse = Math.sqrt(squares);
        return new Score(n, missing, rmse, Math.sqrt(Math.max(0, squares - bias * bias)), rmse / spread,
                Double.isNaN(stated) ? Double.NaN : inside / (double) n, Math.sqrt(stated));
    }
}
