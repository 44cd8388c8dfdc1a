package wbv.recording;

/**
 * The user's data or model is at fault, not the program: one line that says where (file, line, channel), what is wrong and
 * what would be right, whatever the data brought into it ({@link OneLine}). Commands print it and end with exit code 1.
 */
public final class DataFault extends RuntimeException {

    private final boolean placed;

    private DataFault(boolean placed, String message, Throwable cause) {
        super(OneLine.of(message), cause);
        this.placed = placed;
    }

    /** A fault that does not know its file; whoever opened that says so by {@link #of}. */
    public DataFault(String message) {
        this(message, null);
    }

    /** As {@link #DataFault(String)}, with what brought it about. */
    public DataFault(String message, Throwable cause) {
        this(false, message, cause);
    }

    /** A fault at a line of a file: {@code file:line: message}. */
    public static DataFault at(String file, long line, String message) {
        return at(file, line, message, null);
    }

    /** As {@link #at(String, long, String)}, with what brought it about. */
    public static DataFault at(String file, long line, String message, Throwable cause) {
        return new DataFault(true, file + ":" + line + ": " + message, cause);
    }

    /** A fault of a file as a whole: {@code file: message}. */
    public static DataFault in(String file, String message) {
        return in(file, message, null);
    }

    /** As {@link #in(String, String)}, with what brought it about. */
    public static DataFault in(String file, String message, Throwable cause) {
        return new DataFault(true, file + ": " + message, cause);
    }

    /** This fault, with the file that it is about where it does not name one itself. */
    public DataFault of(String file) {
        return placed ? this : in(file, getMessage(), this);
    }

    /** This fault, with the line of the file that it is about where it does not name one itself. */
    public DataFault at(String file, long line) {
        return placed ? this : at(file, line, getMessage(), this);
    }
}
