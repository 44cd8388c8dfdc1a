package wbv.identify;

import java.util.List;

/**
 * An ARMAX model with what is known of it.
 *
 * @param model      the model
 * @param initial    state at the first sample, in the output's unit, {@link Orders#memory} long
 * @param deviations standard deviations of {@code a, b of each input, c}, in this order, as long as all of them and in their units
 * @param scatter    covariance of {@code a} [1], na by na, that counts what the model leaves unexplained ({@link BatchScatter}); not copied
 * @param samples    it was fitted to
 * @param iterations that it took
 * @param converged  whether the last step was small; else it is the best that was found
 */
public record ArmaxFit(Armax model, double[] initial, double[] deviations, double[][] scatter, int samples, int iterations,
        boolean converged) {

    /** Its modes, the slowest first, with their deviations. */
    public List<EquivalentBody.Mode> modes() {
        return ModeDeviations.ofDiscrete(model.a(), scatter, model.rate());
    }

    /** Schwarz's criterion {@code N ln σ² + d ln N} (1978) [1]: the lower the better. */
    public double schwarz() {
        int d = deviations.length + initial.length;
        return samples * Math.log(Math.max(model.variance(), Double.MIN_NORMAL)) + d * Math.log(samples);
    }
}
