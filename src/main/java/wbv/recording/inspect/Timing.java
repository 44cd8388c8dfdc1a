package wbv.recording.inspect;

/**
 * How the times of a recording behave: what a {@link Tracker} needs to number its rows a second time, and whether their
 * irregularity is real.
 *
 * @param phase      time of the first row by the first look [s]
 * @param step       time between samples by the first look [s]
 * @param blur       by how much single times are off by the first look, earliest to latest [s]; 0 but for
 *                   real jitter
 * @param resolution coarsest rounding of the times met [s]
 * @param jitter     root mean square departure of the times from even spacing [s], their rounding included
 * @param irregular  true if that is more than rounding explains, so that rows have to be interpolated
 */
public record Timing(double phase, double step, double blur, double resolution, double jitter, boolean irregular) {}
