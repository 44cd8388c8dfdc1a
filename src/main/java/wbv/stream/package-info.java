/**
 * Recordings and simulated experiments as MOA streams: attribute {@code t} [s], the inputs, and the output as the class.
 */
package wbv.stream;
