package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Normal;

/**
 * How likely a model's own numbers are where a fit had to move them: a law that explains a recording only if a spring is three times as
 * stiff as its user says is less likely than one that explains it with the spring as given.
 *
 * <p>The logarithm of a stiffness or damping over its given value is Cauchy distributed about 0: most are off a little, and now and then
 * one is plainly wrong, which tells nothing of the others (Jeffreys, Theory of Probability 1961, §5.2). What the data leave open of a
 * number counts as scatter: one that hardly matters may be found anywhere, and where a fit leaves much, since its form is not quite right,
 * so may others, of which the data then tell no more than of the form. Relative to numbers as given, so that all that stayed give 0.
 */
public final class OwnNumbers {

    private OwnNumbers() {}

    /**
     * Logarithm of how likely the own numbers of a fit are, against as given [nat], 0 or less.
     *
     * @param fit without derivatives; they are found
     */
    public static double logPrior(Fitter fitter, Fitter.State fit) {
        return logPrior(fitter, fit, Calibration.standard().sharpness(fit.reduced(), fit.frame().whitening().degrees()));
    }

    /**
     * The same where the data's evidence is as sharp as told.
     *
     * @param sharpness [1], see {@link Calibration#sharpness}
     */
    public static double logPrior(Fitter fitter, Fitter.State fit, double sharpness) {
        int[] moved = IntStream.range(0, fit.candidate().given())
                .filter(i -> fit.candidate().knobs().get(i).isOfLink() && fit.x()[i] != 0).toArray();
        if (moved.length == 0) {
            return 0;
        }
        Fitter.State sloped = fitter.lookWithSlopes(fit.candidate(), fit.x(), fit.frame());
        double[][] curvature = sloped.failed() ? new double[0][] : curvature(fit.candidate(), new Normal(sloped).curvature(), sharpness);
        double scale = Priors.NUMBER;
        return -Arrays.stream(moved).mapToDouble(i -> fit.x()[i] * fit.x()[i] / (scale * scale + variance(curvature, i))).map(Math::log1p)
                .sum();
    }

    /**
     * The same where the data tell so much less, and nothing is known of a link's numbers before but by what it is asked for here: of that
     * so little is kept that the equations have an answer.
     */
    private static double[][] curvature(Candidate candidate, double[][] curvature, double sharpness) {
        double[][] out = new double[curvature.length][curvature.length];
        for (int i = 0; i < out.length; i++) {
            for (int j = 0; j < out.length; j++) {
                out[i][j] = sharpness * curvature[i][j];
            }
            Knob knob = candidate.knobs().get(i);
            double kept = knob.isOfLink() ? Math.sqrt(Math.ulp(1.0)) : 1;
            out[i][i] += (kept - sharpness) / (knob.deviation() * knob.deviation());
        }
        return out;
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
