/**
 * Where a simulation and a recording differ, what physics was left out, the model with it, and the proof.
 *
 * <p>{@link wbv.diagnosis.Evidence} is the recording as the model sees it; {@link wbv.diagnosis.Candidate} a model with numbers
 * that may move; {@link wbv.diagnosis.Fitter} moves them until the whitened residual is least.
 *
 * <p>What fits leave makes a {@link wbv.diagnosis.Posterior}, as sharp as a {@link wbv.diagnosis.Calibration} says, and a
 * {@link wbv.diagnosis.DecisionRule} reads it; where it names nothing, a law is learned ({@link wbv.diagnosis.Learning}).
 */
package wbv.diagnosis;
