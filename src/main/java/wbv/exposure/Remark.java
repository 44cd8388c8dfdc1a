package wbv.exposure;

import wbv.recording.inspect.Severity;

/**
 * Something that the reader of an exposure has to know.
 *
 * @param severity how much it matters
 * @param message  one line: where, what, how much
 * @param advice   one line: what it means for the result, or what to do
 */
public record Remark(Severity severity, String message, String advice) {}
