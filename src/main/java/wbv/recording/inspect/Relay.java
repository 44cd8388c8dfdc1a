package wbv.recording.inspect;

/**
 * What was done to rows to lay them on a uniform clock.
 *
 * @param rows         rows read
 * @param samples      samples given out
 * @param filled       of these, missing in the file: NaN
 * @param repeated     rows left out because their sample was taken
 * @param backwards    rows left out because time ran backwards
 * @param interpolated samples computed between rows
 */
public record Relay(long rows, long samples, long filled, long repeated, long backwards, long interpolated) {

    /** The account as one sentence. */
    public String sentence() {
        StringBuilder text = new StringBuilder().append(rows).append(rows == 1 ? " row" : " rows").append(" laid on ")
                .append(samples).append(" samples of a uniform clock");
        part(text, filled, "missing and left empty");
        part(text, repeated, "repeated rows left out");
        part(text, backwards, "rows out of order left out");
        part(text, interpolated, "interpolated (by local cubics, by lines where rows crowd or lack)");
        return text.append('.').toString();
    }

    private static void part(StringBuilder text, long count, String what) {
        if (count > 0) {
            text.append(", ").append(count).append(' ').append(what);
        }
    }
}
