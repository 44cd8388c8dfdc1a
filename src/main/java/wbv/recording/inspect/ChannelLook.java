package wbv.recording.inspect;

import java.util.ArrayList;
import java.util.List;
import wbv.recording.Channel;

/** Looks at one channel, sample by sample, with a few numbers of memory. */
final class ChannelLook {

    private static final int CLIPPED_RUN = 3;
    /** Share of the usual jump by which a value that is clipped is reached; the top of a slow swing is reached by less. */
    private static final double ABRUPT = 0.25;
    /** Share of samples at the extremes beyond which a channel is one that switches between two values. */
    private static final double STEPPED = 0.8;
    private static final double SPIKE = 20;
    private static final double LIKE = 0.2;

    private final Channel channel;
    private long count;
    private long missing;
    private double mean;
    private double squares;
    private double min = Double.POSITIVE_INFINITY;
    private double max = Double.NEGATIVE_INFINITY;

    private double value = Double.NaN;
    private long run;
    private boolean abrupt;
    private long runLine;
    private long longest;
    private long longestLine;
    private double longestValue;
    private final Extreme top = new Extreme();
    private final Extreme bottom = new Extreme();

    private double before = Double.NaN;
    private double jump = Double.NaN;
    private double peakBase = Double.NaN;
    private double scale;
    private long steps;
    private long spikes;
    private long spikeLine;
    private double greatest;
    private double candidate;
    private double candidateScale;
    private long candidateLine;
    private boolean waiting;

    ChannelLook(Channel channel) {
        this.channel = channel;
    }

    void accept(double x, long line) {
        if (Double.isNaN(x)) {
            missing++;
            run = 0;
            value = Double.NaN;
            before = Double.NaN;
            jump = Double.NaN;
            waiting = false;
            return;
        }
        count++;
        double d = x - mean;
        mean += d / count;
        squares += d * (x - mean);
        run(x, line);
        if (x >= max) {
            top.met(x > max, abrupt ? run : 0, line);
            max = x;
        }
        if (x <= min) {
            bottom.met(x < min, abrupt ? run : 0, line);
            min = x;
        }
        spike(x, line);
    }

    private void run(double x, long line) {
        if (x == value) {
            run++;
        } else {
            abrupt = Math.abs(x - value) > ABRUPT * scale;
            value = x;
            run = 1;
            runLine = line;
        }
        if (run > longest) {
            longest = run;
            longestLine = runLine;
            longestValue = x;
        }
    }

    /**
     * A spike is one sample far out, between two jumps of opposite sign and like size, each far beyond the jumps of the second
     * before and followed by quiet. A shock rings after its peak; a spike does not.
     */
    private void spike(double x, long line) {
        if (!Double.isNaN(before)) {
            double step = x - before;
            if (waiting) {
                boolean quiet = Math.abs(step) < LIKE * Math.abs(candidate);
                if (quiet && Math.abs(candidate) > SPIKE * candidateScale) {
                    spikeLine = spikes == 0 ? candidateLine : spikeLine;
                    spikes++;
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

    Channel channel() {
        return channel;
    }

    Summary summary() {
        return count == 0 ? new Summary(0, missing, Double.NaN, Double.NaN, Double.NaN, Double.NaN)
                : new Summary(count, missing, mean, Math.sqrt(squares / count), min, max);
    }

    /**
     * What is wrong with the channel by itself.
     *
     * @param stuckRun   samples of one value from which on it counts as stuck
     * @param zeroRows   rows in which the whole location is zero: reported there
     */
    List<Finding> findings(long stuckRun, long zeroRows) {
        List<Finding> findings = new ArrayList<>();
        long rows = count + missing;
        boolean still = count > 2 && longest >= (restless() ? Math.min(stuckRun, count) : count);
        if (still && !(longestValue == 0 && zeroRows >= longest)) {
            findings.add(new Finding.Stuck(channel, longestValue, longest, longestLine, rows));
        }
        if (restless() && !still && spikes > 0) {
            findings.add(new Finding.Spikes(channel, spikes, greatest, spikeLine));
        }
        boolean steps = top.inRuns + bottom.inRuns > STEPPED * count;
        if (max > min && !steps) {
            clipped(findings, top, max);
            clipped(findings, bottom, min);
        }
        return findings;
    }

    /** True for what never stands still, its noise being greater than its digits: an accelerometer and a gyroscope. */
    private boolean restless() {
        return switch (channel.quantity()) {
            case ACCELERATION, SPECIFIC_FORCE, ANGULAR_RATE -> true;
            default -> false;
        };
    }

    private void clipped(List<Finding> findings, Extreme extreme, double at) {
        if (at != 0 && longest < count && extreme.runs >= 2) {
            findings.add(new Finding.Clipped(channel, at, extreme.inRuns, extreme.line));
        }
    }

    /** How long the channel stayed at its greatest or least value. */
    private static final class Extreme {
        private long runs;
        private long inRuns;
        private long line;

        private void met(boolean beyond, long run, long atLine) {
            if (beyond) {
                runs = 0;
                inRuns = 0;
            }
            if (run >= CLIPPED_RUN) {
                line = inRuns == 0 ? atLine - CLIPPED_RUN + 1 : line;
                runs += run == CLIPPED_RUN ? 1 : 0;
                inRuns += run == CLIPPED_RUN ? CLIPPED_RUN : 1;
            }
        }
    }
}
