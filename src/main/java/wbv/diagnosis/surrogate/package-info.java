/**
 * A linear model that stands for a simulation of which only the outputs are known: a chain along one axis
 * ({@link wbv.diagnosis.surrogate.ChainSearch}) or rigid bodies in a plane ({@link wbv.diagnosis.surrogate.PlaneSearch}), and the diagnosis
 * with it ({@link wbv.diagnosis.surrogate.Surrogate}).
 */
package wbv.diagnosis.surrogate;
