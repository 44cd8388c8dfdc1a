package wbv.diagnosis.learn;

import java.util.Arrays;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.inference.WilcoxonSignedRankTest;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Priors;

/**
 * What two fits leave of the same data that neither has seen, stretch by stretch, held against each other by signed ranks (Diebold and
 * Mariano 1995, section 1): not line by line of the spectrum, of which a few hold nearly all where a rig is moved by a sine, and without
 * supposing how what is left is distributed.
 *
 * @param less by stretch, in any unit: what the one leaves less than the other
 */
record Forecasts(double[] less) {

    /**
     * Of two fits, both in the same whitening.
     *
     * @param one looked at on data not used
     * @param other likewise
     */
    static Forecasts of(Fitter.State one, Fitter.State other) {
        return of(squares(one), squares(other));
    }

    /**
     * Of two series of squares of what is left, by time.
     *
     * @param one in any unit. Not modified.
     * @param other in that unit, as long. Not modified.
     */
    static Forecasts of(double[] one, double[] other) {
        double[] less = new double[Effort.STRETCHES];
        for (int i = 0; i < one.length; i++) {
            less[(int) ((long) Effort.STRETCHES * i / one.length)] += other[i] - one[i];
        }
        return new Forecasts(less);
    }

    /** Whether the one leaves less by more than chance. */
    boolean isBetter() {
        return StatUtils.mean(less) > 0
                && new WilcoxonSignedRankTest().wilcoxonSignedRankTest(new double[less.length], less, true) < 2 * Priors.CHANCE;
    }

    /** Square of what is left, whitened, by time, all outputs together. */
    private static double[] squares(Fitter.State state) {
        Window window = state.frame().whitening().window();
        double[] residual = state.residual();
        int each = 2 * window.lines();
        double[] out = new double[window.length()];
        for (int from = 0; from < residual.length; from += each) {
            double[] series = window.series(Arrays.copyOfRange(residual, from, from + each));
            Arrays.setAll(out, i -> out[i] + series[i] * series[i]);
        }
        return out;
    }
}
