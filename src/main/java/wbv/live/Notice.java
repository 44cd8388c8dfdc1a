package wbv.live;

import wbv.recording.inspect.Severity;

/**
 * Something that somebody should know, of a seat or of the whole stream.
 *
 * @param number   counts all notices, from 1
 * @param seat     empty where it is about no seat
 * @param time     by the sensor's clock [s]; NaN where there is none
 * @param kind     a word: {@code limit-value}, {@code stuck}
 * @param reason   in words
 * @param advice   what to do about it; may be empty
 * @param over     true where it tells the end of what was told before
 */
public record Notice(long number, String seat, double time, Severity severity, String kind, String reason, String advice, boolean over) {}
