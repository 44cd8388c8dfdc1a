/**
 * What was recorded, how far to trust it, and models that are fitted to it. {@link wbv.diagnosis.fit.Evidence} is the recording as a model
 * sees it; {@link wbv.diagnosis.fit.Candidate} a model with numbers that may move; {@link wbv.diagnosis.fit.Fitter} moves them until the
 * residual, as {@link wbv.diagnosis.fit.Whitening} whitens it and without what {@link wbv.diagnosis.fit.Nuisances} explain, is least.
 */
package wbv.diagnosis.fit;
