package wbv.recording;

/**
 * What a calendar said.
 *
 * @param seconds from the beginning of 1970 on [s], of its own zone where it named none
 * @param zoned   whether it named its zone, so that the seconds are those of universal time
 */
public record CalendarTime(double seconds, boolean zoned) {}
