package wbv.recording.format;

import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.Optional;
import java.util.OptionalLong;
import wbv.recording.CalendarTime;

/**
 * Dates and times of ISO 8601 in one column, as seconds from the first of them: {@code 2025-03-04T10:15:00.005}, with a blank for the T,
 * with a comma in the fraction, with or without a zone ({@code Z}, {@code +01:00}, {@code +0100}, {@code +01}), all alike in that. Without
 * a zone days have 24 hours. Nothing is allocated for a row of the same day.
 */
final class Timestamps {

    /** Characters of a date, of one with a time to the second, and of a fraction to the nanosecond (ISO 8601). */
    private static final int DATE = 10;
    private static final int SECONDS = 19;
    private static final int NANO_DIGITS = 9;
    private static final long NANOS = 1_000_000_000;
    private static final long DAY = 86_400;

    private OptionalLong first = OptionalLong.empty();
    private boolean zoned;
    private int day;
    private long midnight;
    /** Of the text that is read. */
    private byte[] text = new byte[0];
    private int at;
    private int end;

    /** Whether a text may be one: four digits and a dash. */
    static boolean begins(byte[] text, int from, int to) {
        boolean may = to - from >= SECONDS && text[from + 4] == '-';
        for (int i = from; i < from + 4 && may; i++) {
            may = text[i] >= '0' && text[i] <= '9';
        }
        return may;
    }

    /** Seconds from the first [s]; empty of a cell that is none. */
    Optional<Double> of(String cell) {
        byte[] bytes = cell.getBytes(StandardCharsets.UTF_8);
        try {
            return Optional.of(seconds(bytes, 0, bytes.length));
        } catch (NumberFormatException other) {
            return Optional.empty();
        }
    }

    /** What the first was; empty before it. */
    Optional<CalendarTime> origin() {
        return first.stream().mapToObj(nanos -> new CalendarTime(nanos / (double) NANOS, zoned)).findFirst();
    }

    /**
     * Seconds from the first that was read [s].
     *
     * @param bytes of which those from an index to before another are the text. Not modified.
     * @throws NumberFormatException if it is none, or has a zone where the first has none or the other way round
     */
    double seconds(byte[] bytes, int from, int to) {
        text = bytes;
        at = from;
        end = to;
        if (to - from < SECONDS || bytes[from + DATE] != 'T' && bytes[from + DATE] != 't' && bytes[from + DATE] != ' ') {
            throw wrong();
        }
        date();
        at++;
        long seconds = within(2, 23) * 3600L;
        mark(':');
        seconds += within(2, 59) * 60L;
        mark(':');
        seconds += within(2, 60);   // of a second that leaps
        long nanos = fraction();
        boolean has = at < end;
        long ahead = has ? zone() : 0;
        if (at < end || first.isPresent() && has != zoned) {
            throw wrong();
        }
        long now = Math.addExact(Math.multiplyExact(midnight + seconds - ahead, NANOS), nanos);
        if (first.isEmpty()) {
            first = OptionalLong.of(now);
            zoned = has;
        }
        return (now - first.getAsLong()) / (double) NANOS;
    }

    private void date() {
        int year = within(4, 9999);
        mark('-');
        int month = within(2, 12);
        mark('-');
        int written = (year * 100 + month) * 100 + within(2, 31);
        if (written != day) {
            try {
                midnight = LocalDate.of(year, month, written % 100).toEpochDay() * DAY;
            } catch (DateTimeException none) {
                throw wrong();
            }
            day = written;
        }
    }

    /** Nanoseconds of the fraction, if there is one. */
    private long fraction() {
        if (at == end || text[at] != '.' && text[at] != ',') {
            return 0;
        }
        at++;
        long nanos = 0;
        int digits = 0;
        for (; at < end && text[at] >= '0' && text[at] <= '9'; at++) {
            nanos = digits < NANO_DIGITS ? 10 * nanos + text[at] - '0' : nanos;
            digits++;
        }
        if (digits == 0) {
            throw wrong();
        }
        for (int i = digits; i < NANO_DIGITS; i++) {
            nanos *= 10;
        }
        return nanos;
    }

    /** How far its clock is ahead of universal time [s]. */
    private long zone() {
        byte sign = text[at++];
        if (sign == 'Z' || sign == 'z') {
            return 0;
        }
        if (sign != '+' && sign != '-') {
            throw wrong();
        }
        long ahead = within(2, 23) * 3600L;
        if (at < end) {
            at += text[at] == ':' ? 1 : 0;
            ahead += within(2, 59) * 60L;
        }
        return sign == '-' ? -ahead : ahead;
    }

    private int within(int digits, int most) {
        int value = 0;
        for (int i = 0; i < digits; i++) {
            if (at == end || text[at] < '0' || text[at] > '9') {
                throw wrong();
            }
            value = 10 * value + text[at++] - '0';
        }
        if (value > most) {
            throw wrong();
        }
        return value;
    }

    private void mark(char mark) {
        if (at == end || text[at++] != mark) {
            throw wrong();
        }
    }

    private static NumberFormatException wrong() {
        return new NumberFormatException("no date and time");
    }
}
