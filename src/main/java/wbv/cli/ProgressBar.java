package wbv.cli;

import java.io.PrintStream;
import java.util.Locale;

/**
 * A progress bar on the terminal's standard error for what takes longer than a second; nothing in a pipe.
 *
 * <p>Drawn at most ten times a second, and wiped when closed, so that what a command prints stays clean.
 */
final class ProgressBar implements AutoCloseable {

    private static final int WIDTH = 30;
    private static final long SILENT_NANOS = 1_000_000_000L;
    private static final long BETWEEN_NANOS = 100_000_000L;

    private final PrintStream out;
    private final boolean terminal;
    private final long started = System.nanoTime();
    private long drawn = started;
    private boolean visible;

    ProgressBar() {
        this(System.err, System.console() != null);
    }

    ProgressBar(PrintStream out, boolean terminal) {
        this.out = out;
        this.terminal = terminal;
    }

    /** Shows how far a step has come. @param fraction 0 to 1, or NaN where the length is not known */
    void at(String step, double fraction) {
        long now = System.nanoTime();
        if (!terminal || now - started < SILENT_NANOS || now - drawn < BETWEEN_NANOS) {
            return;
        }
        drawn = now;
        visible = true;
        if (Double.isNaN(fraction)) {
            out.printf(Locale.ROOT, "\r\u001b[K%s ...", step);
        } else {
            int full = (int) Math.round(WIDTH * Math.max(0, Math.min(1, fraction)));
            out.printf(Locale.ROOT, "\r\u001b[K%s [%s%s] %3.0f %%", step, "#".repeat(full), "-".repeat(WIDTH - full), 100 * fraction);
        }
        out.flush();
    }

    @Override
    public void close() {
        if (visible) {
            out.print("\r\u001b[K");
            out.flush();
        }
    }
}
