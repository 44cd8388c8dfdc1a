package wbv.identify;

/**
 * A model in continuous time with what is known of it.
 *
 * @param model      the model
 * @param initial    T(s), what the motion before the first sample left behind, highest power first
 * @param deviations standard deviations of {@code a, b of each input}
 * @param variance   of what the simulated output leaves of the measured one, in the output's unit squared
 * @param iterations that it took
 * @param converged  whether the last step was small
 */
public record TransferFit(TransferModel model, double[] initial, double[] deviations, double variance, int iterations,
                          boolean converged) { }
