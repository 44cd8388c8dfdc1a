package wbv.recording.inspect;

/**
 * What one channel amounts to. All but the counts are NaN where there is no sample.
 *
 * @param count   samples present
 * @param missing samples absent (NaN)
 * @param mean    arithmetic mean, in the channel's unit
 * @param rms     root mean square about the mean, in that unit
 * @param min     least sample, likewise
 * @param max     greatest sample, likewise
 */
public record Summary(long count, long missing, double mean, double rms, double min, double max) {}
