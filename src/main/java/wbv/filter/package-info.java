/**
 * Streaming estimators of what a body is: they take one sample of what shook it and one of how it moved, and keep the
 * parameters of its model with their uncertainty.
 *
 * <p>All keep the contract of {@link wbv.filter.Estimator} and are made by a {@link wbv.filter.EstimatorDesign}, by
 * {@link wbv.filter.Method}: extended, unscented and particle filters of one or two degrees of freedom, and their fusion. They
 * detect changes through the port {@link wbv.filter.drift.Alarm} and take bounds through {@link wbv.filter.Constraint}.
 * {@link wbv.filter.CorrectionFunction} says where an extended filter converges. Nothing here knows a host framework, and nothing is
 * allocated per sample.
 */
package wbv.filter;
