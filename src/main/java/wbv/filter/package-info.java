/**
 * Streaming estimators of what a body is: they take one sample of what shook it and one of how it moved, and keep the
 * parameters of its model with their uncertainty.
 *
 * <p>{@link wbv.filter.BodyEstimator} is an extended Kalman filter on one degree of freedom whose noise adapts. It detects
 * changes through the port {@link wbv.filter.Alarm}. {@link wbv.filter.ExactStep} discretises any small linear model with
 * its derivatives. Nothing here knows a host framework, and nothing is allocated per sample.
 */
package wbv.filter;
