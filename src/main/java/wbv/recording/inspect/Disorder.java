package wbv.recording.inspect;

import java.util.Optional;

/** Counts rows that are out of order, and tells a clock that starts again or two that take turns from a single wrong time. */
final class Disorder {

    private static final int RESTART = 10;

    private long count;
    private long line;
    private double time;
    private int run;
    private long runLine;
    private double runTime;
    private Finding.TwoClocks restart;

    /** A row was out of order. */
    void out(double atTime, long atLine) {
        if (count == 0) {
            line = atLine;
            time = atTime;
        }
        if (run == 0) {
            runLine = atLine;
            runTime = atTime;
        }
        count++;
        run++;
        if (restart == null && run >= RESTART) {
            restart = new Finding.TwoClocks(runLine, runTime, "time starts again");
        }
    }

    /** A row was in order. */
    void in() {
        run = 0;
    }

    /**
     * What is wrong, if anything is.
     *
     * @param rows all there were
     */
    Optional<Finding> finding(long rows) {
        if (restart != null) {
            return Optional.of(restart);
        }
        if (count >= RESTART && count > rows / 10) {
            return Optional.of(new Finding.TwoClocks(line, time, "two clocks take turns"));
        }
        return count > 0 ? Optional.of(new Finding.TimeBackwards(count, line, time)) : Optional.empty();
    }
}
