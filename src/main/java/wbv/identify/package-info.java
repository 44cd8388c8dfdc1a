/**
 * Linear models from inputs and an output: ARMAX in one go ({@link wbv.identify.PredictionError}) or sample by sample
 * ({@link wbv.identify.RecursiveArmax}), and a model in continuous time by instrumental variables
 * ({@link wbv.identify.RefinedInstruments}).
 *
 * <p>Two things are kept apart by name. <em>Prediction</em> uses the measured output up to the sample before; <em>simulation</em>
 * runs free on the input alone. Every fit returns the state that the system had at the first sample. Poles are of the s-plane
 * ({@link wbv.identify.Pole}); those of ARMAX models come through {@code s = ln(z)/T}, and real ones are no modes.
 */
package wbv.identify;
