/**
 * What an estimator takes a body for: one or two degrees of freedom on a floor that moves, or one that a skyhook damps as well, stepped
 * exactly under the input that {@link wbv.filter.model.InputWindow} draws through the samples, with the derivatives that a filter needs.
 * {@link wbv.filter.model.Spec} says which parameters there are and within which {@link wbv.filter.model.Bounds} they lie.
 */
package wbv.filter.model;
