/**
 * Hidden Markov chains whose states are mixtures: trained ({@link wbv.state.markov.BaumWelch}), followed through a stream
 * ({@link wbv.state.markov.ForwardFilter}), looked back on ({@link wbv.state.markov.Trellis}), looked ahead with
 * ({@link wbv.state.markov.Forecast}). Knows nothing of motion.
 */
package wbv.state.markov;
