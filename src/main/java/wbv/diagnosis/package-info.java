/**
 * Where a simulation and a recording differ, what physics was left out, the model with it, and the proof.
 *
 * <p>{@link wbv.diagnosis.Evidence} is the recording as the model sees it; {@link wbv.diagnosis.Candidate} a model with numbers
 * that may move; {@link wbv.diagnosis.Fitter} moves them until the whitened residual is least.
 *
 * <p>{@link wbv.diagnosis.Weighing} compares what was fitted: the {@link wbv.diagnosis.LogLikelihood} with every process that a hypothesis leaves room
 * for, integrated to an evidence, of all of which a {@link wbv.diagnosis.Posterior} is made and read by a {@link wbv.diagnosis.DecisionRule}.
 */
package wbv.diagnosis;
