/**
 * A linear model that stands for a simulation of which only the outputs are known, and the diagnosis with it
 * ({@link wbv.diagnosis.surrogate.Surrogate}).
 *
 * <p>A {@link wbv.diagnosis.surrogate.DrivenSimulation} is the simulation as long as the recording lasts. What drove it along one axis is
 * given to a chain ({@link wbv.diagnosis.surrogate.ChainSearch}), what it did in a plane to rigid bodies
 * ({@link wbv.diagnosis.surrogate.PlaneSearch}); both get a body or a link more as long as that pays
 * ({@link wbv.diagnosis.surrogate.Enrichment}). What the best of them misses stays beside it
 * ({@link wbv.diagnosis.surrogate.GivenBeside}).
 */
package wbv.diagnosis.surrogate;
