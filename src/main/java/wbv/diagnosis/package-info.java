/**
 * Where a simulation and a recording differ, what physics was left out, the model with it, and the proof.
 *
 * <p>{@link wbv.diagnosis.Evidence} is the recording as the model sees it; {@link wbv.diagnosis.Candidate} a model with numbers
 * that may move; {@link wbv.diagnosis.Fitter} moves them until the whitened residual is least.
 */
package wbv.diagnosis;
