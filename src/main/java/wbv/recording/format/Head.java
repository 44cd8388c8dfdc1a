package wbv.recording.format;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import wbv.recording.DataFault;

/**
 * The beginning of a file, by which its format is recognised.
 *
 * @param name  the file, for messages
 * @param bytes as they stand
 * @param lines its first lines, stripped, without those that are blank
 */
record Head(String name, byte[] bytes, List<String> lines) {

    /** What stands for bytes that are no text. */
    private static final char UNKNOWN = '\ufffd';
    private static final List<Magic> FOREIGN = List.of(
            new Magic("PK\3\4", "is a zip file or a spreadsheet; export the recording as CSV"),
            new Magic("\u00fa\u00ff", "is a binary Xsens log (.mtb); export it with MT Manager as text (.txt)"),
            new Magic("\u00ff\u00fe", "is UTF-16 text; save it as UTF-8"),
            new Magic("\u00fe\u00ff", "is UTF-16 text; save it as UTF-8"));

    /** What Excel puts before a table to say what parts its cells; the header below shows it. */
    private static final Pattern PARTED = Pattern.compile("(?i)\"?sep=.\"?");
    /** How Excel saves a CSV on Windows, unless it is asked for UTF-8: of such text m/s² is no UTF-8. */
    private static final Charset WINDOWS = Charset.forName("windows-1252");

    /** Looks at an opened file. */
    static Head of(Source source) {
        return new Head(source.name(), source.head(),
                source.headText().lines().map(Head::clean).filter(line -> !line.isEmpty() && !isParted(line)).limit(400).toList());
    }

    /** Whether a line says what parts the cells, and nothing else. */
    static boolean isParted(String line) {
        return PARTED.matcher(line).matches();
    }

    /**
     * Text in UTF-8, or as Windows writes that of western Europe where it is none.
     *
     * @param bytes of which those from an index to before another are the text. Not modified.
     */
    static String text(byte[] bytes, int from, int to) {
        String text = new String(bytes, from, to - from, StandardCharsets.UTF_8);
        return text.indexOf(UNKNOWN) < 0 ? text : new String(bytes, from, to - from, WINDOWS);
    }

    /** Faults what is not text, with advice where the format is known. */
    void requireText() {
        String latin = new String(bytes, StandardCharsets.ISO_8859_1);
        for (Magic magic : FOREIGN) {
            if (latin.startsWith(magic.bytes)) {
                throw DataFault.in(name, magic.advice);
            }
        }
        if (latin.indexOf('\0') >= 0 || unprintable(bytes) > bytes.length / 20) {
            throw DataFault.in(name, "is a binary file, not a recording in text" + advice(name));
        }
        if (lines.isEmpty()) {
            throw DataFault.in(name, "is blank; a recording has a header and rows");
        }
    }

    private static String clean(String line) {
        return (line.startsWith("\uFEFF") ? line.substring(1) : line).strip();
    }

    private static int unprintable(byte[] bytes) {
        int count = 0;
        for (byte b : bytes) {
            count += b >= 0 && b < 32 && b != '\n' && b != '\r' && b != '\t' ? 1 : 0;
        }
        return count;
    }

    private static String advice(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        if (lower.endsWith(".mtb")) {
            return "; export it with MT Manager as text (.txt)";
        }
        if (lower.endsWith(".mvn")) {
            return "; export it with MVN as MVNX (.mvnx)";
        }
        return "; export it as CSV";
    }

    String first() {
        return lines.get(0);
    }

    /** The first line that does not begin with a comment mark; empty if all do. */
    String firstAfter(String comment) {
        return lines.stream().filter(line -> !line.startsWith(comment)).findFirst().orElse("");
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Head head && name.equals(head.name) && Arrays.equals(bytes, head.bytes);
    }

    @Override
    public int hashCode() {
        return name.hashCode();
    }

    private record Magic(String bytes, String advice) {}
}
