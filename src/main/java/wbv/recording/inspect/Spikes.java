package wbv.recording.inspect;

/**
 * Single samples far out, between two jumps of opposite sign and like size, each far beyond the jumps of the second before and
 * followed by quiet. A shock rings after its peak; a spike does not.
 */
final class Spikes {

    /** Times the usual jump before it. */
    private static final double SPIKE = 20;
    /** Share of a jump within which another is like it, or quiet beside it. */
    private static final double LIKE = 0.2;

    private double before = Double.NaN;
    private double jump = Double.NaN;
    private double peakBase = Double.NaN;
    private double scale;
    private long steps;
    private long count;
    private long firstLine;
    private double greatest;
    private double candidate;
    private double candidateScale;
    private long candidateLine;
    private boolean waiting;

    void missed() {
        before = Double.NaN;
        jump = Double.NaN;
        waiting = false;
    }

    void accept(double x, long line) {
        if (!Double.isNaN(before)) {
            double step = x - before;
            if (waiting) {
                boolean quiet = Math.abs(step) < LIKE * Math.abs(candidate);
                if (quiet && Math.abs(candidate) > SPIKE * candidateScale) {
                    firstLine = count == 0 ? candidateLine : firstLine;
                    count++;
                    greatest = Math.max(greatest, Math.abs(candidate));
                }
                waiting = false;
            }
            boolean opposite = before != 0 && jump * step < 0
                    && Math.abs(jump + step) < LIKE * Math.min(Math.abs(jump), Math.abs(step));
            if (opposite && steps > 32 && Math.abs(jump) > SPIKE * peakBase) {
                waiting = true;
                candidate = jump;
                candidateScale = peakBase;
                candidateLine = line - 1;
            }
            peakBase = scale;
            steps++;
            scale += (Math.abs(step) - scale) / Math.min(steps, 64);
            jump = step;
        }
        before = x;
    }

    /** Size of the usual jump from sample to sample, over the last 64 of them. */
    double usualJump() {
        return scale;
    }

    long count() {
        return count;
    }

    /** Where the first stands. */
    long firstLine() {
        return firstLine;
    }

    /** Size of the greatest jump to one. */
    double greatest() {
        return greatest;
    }
}
