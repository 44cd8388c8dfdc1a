package wbv.recording;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Text of people and of files in a CSV that a spreadsheet may open: what begins with {@code = + - @} would be worked out there as
 * a formula. An apostrophe before it makes it text (OWASP, "CSV Injection"). Numbers stay as they are.
 */
public final class TableText {

    private static final Pattern PIECE = Pattern.compile("[^,;\t]+");
    private static final Pattern NUMBER = Pattern.compile("[-+]?(\\d++\\.?\\d*+|\\.\\d++)([eE][-+]?\\d++)?");

    private TableText() {}

    /** A cell; in quotes where a comma, a quote or a line break is in it. Control characters become spaces. */
    public static String cell(String text) {
        String safe = harmless(text.replaceAll("\\p{Cntrl}", " "));
        return safe.equals(text) && text.indexOf(',') < 0 && text.indexOf('"') < 0 ? text : '"' + safe.replace("\"", "\"\"") + '"';
    }

    /** What stands in one line behind a comment mark. A spreadsheet knows no comments and parts it at commas as any other line. */
    public static String comment(String text) {
        return PIECE.matcher(text.replaceAll("\\R+", " ")).replaceAll(piece -> Matcher.quoteReplacement(harmless(piece.group())));
    }

    private static String harmless(String text) {
        String bare = text.strip();
        boolean formula = !bare.isEmpty() && "=+-@".indexOf(bare.charAt(0)) >= 0 && !NUMBER.matcher(bare).matches();
        return formula ? "'" + text : text;
    }
}
