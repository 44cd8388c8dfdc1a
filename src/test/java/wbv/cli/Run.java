package wbv.cli;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** One command line run in this Java, with what it printed. */
record Run(int code, String out, String err) {

    static Run of(String... arguments) {
        return with(InputStream.nullInputStream(), arguments);
    }

    static Run with(InputStream in, String... arguments) {
        return run(in, new ByteArrayOutputStream(), arguments);
    }

    /** With a standard output of its own; what was printed there is not told. */
    static Run into(OutputStream printed, String... arguments) {
        return run(InputStream.nullInputStream(), printed, arguments);
    }

    private static synchronized Run run(InputStream in, OutputStream printed, String... arguments) {
        PrintStream out = System.out;
        PrintStream err = System.err;
        InputStream input = System.in;
        ByteArrayOutputStream complained = new ByteArrayOutputStream();
        try {
            System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
            System.setErr(new PrintStream(complained, true, StandardCharsets.UTF_8));
            System.setIn(in);
            int code = Main.execute(arguments);
            return new Run(code, printed instanceof ByteArrayOutputStream text ? text.toString(StandardCharsets.UTF_8) : "",
                    complained.toString(StandardCharsets.UTF_8));
        } finally {
            System.setOut(out);
            System.setErr(err);
            System.setIn(input);
        }
    }
}
