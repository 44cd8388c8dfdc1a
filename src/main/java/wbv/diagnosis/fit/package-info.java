/**
 * Models that are fitted to what was recorded. {@link wbv.diagnosis.fit.Evidence} is what they are judged by;
 * {@link wbv.diagnosis.fit.Candidate} a model with numbers that may move; {@link wbv.diagnosis.fit.Fitter} moves them until the residual,
 * as {@link wbv.diagnosis.fit.Whitening} whitens it and without what {@link wbv.diagnosis.fit.Nuisances} explain, is least.
 */
package wbv.diagnosis.fit;
