package wbv.cli;

import java.io.PrintStream;
import java.util.Locale;
import java.util.Optional;
import java.util.Timer;
import java.util.TimerTask;

/**
 * How far a command is, in one line on the terminal's standard error; nothing in a pipe.
 *
 * <p>Drawn anew several times a second from the first half second on, with the time that has passed, also while a step has nothing to tell;
 * wiped when closed, so that what a command prints stays clean.
 */
final class ProgressBar implements AutoCloseable {

    private static final int WIDTH = 30;
    /** When progress is first drawn, and how long it then stands, so that short commands show none. */
    private static final long FIRST_MS = 500;
    private static final long BETWEEN_MS = 200;
    private static final String WIPE = "\r\u001b[K";

    /** @param fraction 0 to 1, or NaN where the length is not known */
    private record Step(String name, double fraction) {}

    private final PrintStream out;
    private final long started = System.nanoTime();
    private final Optional<Timer> timer;
    private volatile Step step = new Step("working", Double.NaN);
    private boolean visible;
    private boolean closed;

    ProgressBar(PrintStream out, boolean shown) {
        this.out = out;
        this.timer = shown ? Optional.of(new Timer("progress", true)) : Optional.empty();
        timer.ifPresent(each -> each.schedule(new TimerTask() {
            @Override
            public void run() {
                draw();
            }
        }, FIRST_MS, BETWEEN_MS));
    }

    static ProgressBar hidden() {
        return new ProgressBar(System.err, false);
    }

    /** The launcher tells whether standard error is a terminal; Java by itself knows only of standard input and output together. */
    static ProgressBar onTerminal() {
        return new ProgressBar(System.err, Optional.ofNullable(System.getProperty("wbv.terminal")).map(Boolean::parseBoolean)
                .orElseGet(() -> System.console() != null));
    }

    /**
     * Says how far a step has come.
     *
     * @param fraction 0 to 1, or NaN where the length is not known
     */
    void at(String name, double fraction) {
        step = new Step(name, fraction);
    }

    private synchronized void draw() {
        if (closed) {
            return;
        }
        visible = true;
        Step now = step;
        long seconds = (System.nanoTime() - started) / 1_000_000_000L;
        if (Double.isNaN(now.fraction())) {
            out.printf(Locale.ROOT, "%s%s ... %d s", WIPE, now.name(), seconds);
        } else {
            double share = Math.max(0, Math.min(1, now.fraction()));
            int full = (int) Math.round(WIDTH * share);
            out.printf(Locale.ROOT, "%s%s [%s%s] %3.0f %%  %d s", WIPE, now.name(), "#".repeat(full), "-".repeat(WIDTH - full), 100 * share,
                    seconds);
        }
        out.flush();
    }

    @Override
    public synchronized void close() {
        timer.ifPresent(Timer::cancel);
        if (visible && !closed) {
            out.print(WIPE);
            out.flush();
        }
        closed = true;
    }
}
