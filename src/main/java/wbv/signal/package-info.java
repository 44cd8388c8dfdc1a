/**
 * Signals in time and frequency: spectra, frequency responses of one or several inputs, apparent mass and absorbed power,
 * spectrograms, wavelets, envelopes, derivatives and band-limited resampling.
 *
 * <p>Everything is fed sample by sample, keeps memory that does not grow with the recording, and allocates nothing per
 * sample. Two conventions hold throughout: a power spectral density is one-sided [unit²/Hz], so that its sum times the bin
 * width is the signal's power (Parseval); and a cross spectrum is {@code G_yx = E[Y X*]}, so that {@code H = Y/X} and an output
 * that lags has a negative phase.
 */
package wbv.signal;
