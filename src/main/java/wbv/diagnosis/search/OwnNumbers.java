package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Normal;

/**
 * How likely a model's own numbers are where a fit had to move them: a law that explains a recording only if a spring is three times as
 * stiff as its user says is less likely than one that explains it with the spring as given.
 *
 * <p>The logarithm of a stiffness or damping over its given value is Cauchy distributed about 0: most are off a little, and now and then
 * one is plainly wrong, which tells nothing of the others (Jeffreys, Theory of Probability 1961, §5.2). What the data leave open of a
 * number counts as scatter: one that hardly matters may be found anywhere. Relative to numbers as given, so that all that stayed give 0.
 */
public final class OwnNumbers {

    private OwnNumbers() {}

    /**
     * Logarithm of how likely the own numbers of a fit are, against as given [nat], 0 or less.
     *
     * @param fit without derivatives; they are found
     */
    public static double logPrior(Fitter fitter, Fitter.State fit) {
        int[] moved = IntStream.range(0, fit.candidate().given())
                .filter(i -> fit.candidate().knobs().get(i).isOfLink() && fit.x()[i] != 0).toArray();
        if (moved.length == 0) {
            return 0;
        }
        Fitter.State sloped = fitter.lookWithSlopes(fit.candidate(), fit.x(), fit.frame());
        double[][] curvature = sloped.failed() ? new double[0][] : new Normal(sloped).curvature();
        double scale = Priors.NUMBER;
        return -Arrays.stream(moved).mapToDouble(i -> fit.x()[i] * fit.x()[i] / (scale * scale + variance(curvature, i))).map(Math::log1p)
                .sum();
    }

    /**
     * Variance [1] of a coordinate by the curvature of half a cost; 0 where there is none: derivatives of a run may outgrow all bounds
     * where the run itself does not.
     *
     * @param curvature of all coordinates, or of none
     */
    static double variance(double[][] curvature, int coordinate) {
        boolean told = curvature.length > 0 && Arrays.stream(curvature).flatMapToDouble(Arrays::stream).allMatch(Double::isFinite);
        if (!told) {
            return 0;
        }
        double[] unit = new double[curvature.length];
        unit[coordinate] = 1;
        return Math.max(0, DampedEquations.solve(curvature, unit)[coordinate]);
    }
}
