/**
 * The numbers of a model: their names with units ({@link wbv.body.number.Key}), what they may be ({@code Check}), and what they
 * may hang on (a {@link wbv.body.number.Modulator}, by a {@link wbv.body.number.Shape}).
 */
package wbv.body.number;
