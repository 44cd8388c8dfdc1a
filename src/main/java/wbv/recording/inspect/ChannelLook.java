package wbv.recording.inspect;

import java.util.ArrayList;
import java.util.List;
import wbv.recording.Channel;

/** Looks at one channel, sample by sample: one detector for each thing that can be wrong with it. */
final class ChannelLook {

    private final Channel channel;
    private final Distribution distribution = new Distribution();
    private final Standstill standstill = new Standstill();
    private final Clipping clipping = new Clipping();
    private final Spikes spikes = new Spikes();

    ChannelLook(Channel channel) {
        this.channel = channel;
    }

    /**
     * Takes a sample; NaN is missing.
     *
     * @param line where it stands
     */
    void accept(double x, long line) {
        if (Double.isNaN(x)) {
            distribution.missed();
            standstill.missed();
            spikes.missed();
            return;
        }
        distribution.accept(x);
        standstill.accept(x, spikes.usualJump(), line);
        clipping.accept(x, standstill, line);
        spikes.accept(x, line);
    }

    Channel channel() {
        return channel;
    }

    Summary summary() {
        return distribution.summary();
    }

    /**
     * What is wrong with the channel by itself.
     *
     * @param stuckRun   samples of one value from which on it counts as stuck
     * @param zeroRows   rows in which the whole location is zero: reported there
     */
    List<Finding> findings(long stuckRun, long zeroRows) {
        List<Finding> findings = new ArrayList<>();
        long count = distribution.count();
        boolean still = count > 2 && standstill.longest() >= (restless() ? Math.min(stuckRun, count) : count);
        if (still && !(standstill.longestValue() == 0 && zeroRows >= standstill.longest())) {
            findings.add(new Finding.Stuck(channel, standstill.longestValue(), standstill.longest(), standstill.longestLine(),
                    distribution.rows()));
        }
        if (restless() && !still && spikes.count() > 0) {
            findings.add(new Finding.Spikes(channel, spikes.count(), spikes.greatest(), spikes.firstLine()));
        }
        if (standstill.longest() < count) {
            findings.addAll(clipping.findings(channel, count));
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
}
