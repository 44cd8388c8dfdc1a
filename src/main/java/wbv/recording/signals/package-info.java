/**
 * Files in which every signal stands by itself: UFF 58, MAT, HDF5, Parquet and WAV. What a file says of each signal is its
 * {@link wbv.recording.signals.Label}; which channel a signal is, {@link wbv.recording.format} decides.
 *
 * <p>WAV is read as it comes and Parquet a group of rows at a time; the others hold one signal after the other, so that their samples are
 * held in memory, 8 bytes each.
 */
package wbv.recording.signals;
