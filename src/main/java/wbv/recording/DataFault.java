package wbv.recording;

/**
 * The user's data or model is at fault, not the program: one line that says where (file, line, channel), what is wrong and
 * what would be right. Commands print it and end with exit code 1.
 */
public final class DataFault extends RuntimeException {

    public DataFault(String message) {
        super(message);
    }

    public DataFault(String message, Throwable cause) {
        super(message, cause);
    }

    /** A fault at a line of a file: {@code file:line: message}. */
    public static DataFault at(String file, long line, String message) {
        return new DataFault(file + ":" + line + ": " + message);
    }

    /** A fault of a file as a whole: {@code file: message}. */
    public static DataFault in(String file, String message) {
        return new DataFault(file + ": " + message);
    }
}
