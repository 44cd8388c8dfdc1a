package wbv.recording.inspect;

/** How long a channel keeps one value: now, and at most. */
final class Standstill {

    /** Share of the usual jump by which a value that is clipped is reached; the top of a slow swing is reached by less. */
    private static final double ABRUPT = 0.25;

    private double value = Double.NaN;
    private long run;
    private boolean abrupt;
    private long line;
    private long longest;
    private long longestLine;
    private double longestValue;

    void missed() {
        run = 0;
        value = Double.NaN;
    }

    /** @param usualJump from sample to sample, by which it is told whether a value was reached abruptly */
    void accept(double x, double usualJump, long atLine) {
        if (x == value) {
            run++;
        } else {
            abrupt = Math.abs(x - value) > ABRUPT * usualJump;
            value = x;
            run = 1;
            line = atLine;
        }
        if (run > longest) {
            longest = run;
            longestLine = line;
            longestValue = x;
        }
    }

    /** Samples of the present value so far, if it was reached abruptly; else 0. */
    long abruptRun() {
        return abrupt ? run : 0;
    }

    /** Samples of one value at most. */
    long longest() {
        return longest;
    }

    /** Where they begin. */
    long longestLine() {
        return longestLine;
    }

    double longestValue() {
        return longestValue;
    }
}
