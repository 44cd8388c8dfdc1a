/**
 * What least squares are solved by, in numbers alone: {@link wbv.diagnosis.algebra.Columns} multiply long vectors,
 * {@link wbv.diagnosis.algebra.DampedEquations} are a step's, {@link wbv.diagnosis.algebra.BoundedLeastSquares} keep numbers within bounds.
 */
package wbv.diagnosis.algebra;
