package wbv.recording;

/**
 * Messages as one clean line, whatever a file, a name or an option brought into them: control characters are written as visible
 * escapes, words without end are cut in their middle, and so is the whole.
 */
public final class OneLine {

    /** Letters of the longest word: a path is seldom longer, and keeps its beginning and its file name. */
    static final int LONGEST_WORD = 240;
    /** Letters of the longest line. */
    static final int LONGEST = 1500;

    private OneLine() {}

    /** The text as one line. */
    public static String of(String text) {
        if (isClean(text)) {
            return text;
        }
        StringBuilder line = new StringBuilder();
        int from = 0;
        for (int i = 0; i <= text.length(); i++) {
            if (i == text.length() || text.charAt(i) == ' ') {
                line.append(cut(visible(text.substring(from, i)), LONGEST_WORD)).append(i < text.length() ? " " : "");
                from = i + 1;
            }
        }
        return cut(line.toString(), LONGEST);
    }

    /** True for nearly every text there is: then nothing is copied. */
    private static boolean isClean(String text) {
        int word = 0;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            word = c == ' ' ? 0 : word + 1;
            if (word > LONGEST_WORD || isHidden(c)) {
                return false;
            }
        }
        return text.length() <= LONGEST;
    }

    /** True for what moves a terminal's cursor or breaks a line. */
    private static boolean isHidden(char c) {
        return switch (Character.getType(c)) {
            case Character.CONTROL, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR -> true;
            default -> false;
        };
    }

    private static String visible(String word) {
        StringBuilder shown = new StringBuilder(word.length());
        for (char c : word.toCharArray()) {
            switch (c) {
                case '\n' -> shown.append("\\n");
                case '\r' -> shown.append("\\r");
                case '\t' -> shown.append("\\t");
                default -> shown.append(isHidden(c) ? String.format("\\u%04x", (int) c) : Character.toString(c));
            }
        }
        return shown.toString();
    }

    /** A text of at most so many letters: the beginning, two thirds of it, and the end. */
    private static String cut(String text, int most) {
        if (text.length() <= most) {
            return text;
        }
        int tail = most / 3;
        return text.substring(0, most - tail - 1) + "…" + text.substring(text.length() - tail);
    }
}
