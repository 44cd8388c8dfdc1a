package wbv.identify;

import java.util.List;

/**
 * A model in continuous time with what is known of it.
 *
 * @param model      the model
 * @param initial    T(s), what the motion before the first sample left behind, n long, highest power first; coefficient j from 0 on [unit_y
 *                   (rad/s)^j]
 * @param deviations standard deviations of {@code a, b of each input}, as long as both together and in their units
 * @param scatter    covariance of {@code a}, in products of their units, n by n, that counts what the model leaves unexplained ({@link
 *                   BatchScatter}); not copied
 * @param variance   of what the simulated output leaves of the measured one, in the output's unit squared
 * @param iterations that it took
 * @param converged  whether the last step was small
 */
public record TransferFit(TransferModel model, double[] initial, double[] deviations, double[][] scatter, double variance,
        int iterations, boolean converged) {

    /** Its modes, the slowest first, with their deviations. */
    public List<EquivalentBody.Mode> modes() {
        return ModeDeviations.ofContinuous(model.a(), scatter);
    }
}
