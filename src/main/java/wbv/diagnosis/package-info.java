/**
 * Where a simulation and a recording differ, what physics was left out, the model with it, and the proof.
 *
 * <p>{@link wbv.diagnosis.Diagnoser} is the way through: values alone are fitted ({@code fit}), mechanisms are tried at every place
 * ({@code search}), and what they leave makes a {@link wbv.diagnosis.Posterior}, as sharp as a {@link wbv.diagnosis.search.Calibration}
 * says, which a {@link wbv.diagnosis.DecisionRule} reads; where it names nothing, a law is learned ({@code learn},
 * {@link wbv.diagnosis.Learning}). {@code picture} draws what was found, {@code surrogate} stands for simulations.
 *
 * <p>On the way an {@link wbv.diagnosis.Inquiry} holds the evidence and what counts as noise in it, a {@link wbv.diagnosis.Conclusion} is
 * drawn from the hypotheses that were fitted, and {@link wbv.diagnosis.Verdicts} says what each {@link wbv.diagnosis.Explanation} comes to.
 */
package wbv.diagnosis;
