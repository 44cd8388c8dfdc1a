package wbv.recording.inspect;

import java.util.ArrayList;
import java.util.List;
import wbv.recording.Channel;

/** Whether a channel stays at its greatest or its least value, abruptly reached and more than once. */
final class Clipping {

    private static final int CLIPPED_RUN = 3;
    /** Share of samples at the extremes beyond which a channel is one that switches between two values. */
    private static final double STEPPED = 0.8;

    private final Extreme top = new Extreme();
    private final Extreme bottom = new Extreme();
    private double min = Double.POSITIVE_INFINITY;
    private double max = Double.NEGATIVE_INFINITY;

    /** @param standstill of the same channel, which has seen this sample */
    void accept(double x, Standstill standstill, long line) {
        if (x >= max) {
            top.met(x > max, standstill.abruptRun(), line);
            max = x;
        }
        if (x <= min) {
            bottom.met(x < min, standstill.abruptRun(), line);
            min = x;
        }
    }

    /** @param count samples of the channel */
    List<Finding> findings(Channel channel, long count) {
        List<Finding> findings = new ArrayList<>();
        if (max > min && top.inRuns + bottom.inRuns <= STEPPED * count) {
            add(findings, channel, top, max);
            add(findings, channel, bottom, min);
        }
        return findings;
    }

    private static void add(List<Finding> findings, Channel channel, Extreme extreme, double at) {
        if (at != 0 && extreme.runs >= 2) {
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
