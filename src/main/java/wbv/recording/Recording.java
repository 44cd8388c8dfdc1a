package wbv.recording;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Channels over one uniform clock, held in memory. Missing samples are NaN.
 *
 * <p>Arrays are not copied, neither in nor out: treat them as read-only.
 */
public final class Recording {

    private final Clock clock;
    private final Map<Channel, double[]> values;
    private final Metadata metadata;
    private final int length;

    /**
     * Checks that lengths fit; copies the map, not the samples.
     *
     * @param values samples by channel, in column order, all of one length &gt; 0. Not copied.
     * @throws IllegalArgumentException if there is no channel, no sample, or the lengths differ
     */
    public Recording(Clock clock, Map<Channel, double[]> values, Metadata metadata) {
        if (values.isEmpty()) {
            throw new IllegalArgumentException("a recording needs at least one channel");
        }
        this.clock = clock;
        this.values = new LinkedHashMap<>(values);
        this.metadata = metadata;
        this.length = values.values().iterator().next().length;
        if (length == 0) {
            throw new IllegalArgumentException("a recording needs at least one sample");
        }
        values.forEach((channel, samples) -> {
            if (samples.length != length) {
                throw new IllegalArgumentException(
                        channel + " must have " + length + " samples like the others: " + samples.length);
            }
        });
    }

    /** The times of the samples: start [s] and rate [Hz]. */
    public Clock clock() {
        return clock;
    }

    /** What its file or its maker says beside the channels. */
    public Metadata metadata() {
        return metadata;
    }

    /** Number of samples of every channel. */
    public int length() {
        return length;
    }

    /**
     * The samples from one index to before another, as a recording of its own.
     *
     * @throws IllegalArgumentException if there is none
     */
    public Recording part(int from, int to) {
        if (from < 0 || to > length || from >= to) {
            throw new IllegalArgumentException("a part must lie within samples 0 to " + length + ": " + from + " to " + to);
        }
        Map<Channel, double[]> cut = new LinkedHashMap<>();
        values.forEach((channel, samples) -> cut.put(channel, Arrays.copyOfRange(samples, from, to)));
        return new Recording(new Clock(clock.time(from), clock.rate()), cut, metadata);
    }

    /** Length in time [s]: samples over rate. */
    public double duration() {
        return length / clock.rate();
    }

    /** In column order. A copy. */
    public List<Channel> channels() {
        return List.copyOf(values.keySet());
    }

    /** Whether {@link #values} will have it. */
    public boolean has(Channel channel) {
        return values.containsKey(channel);
    }

    /**
     * The series of a channel, in its SI unit; NaN where missing. Not a copy.
     *
     * @throws DataFault if the recording has no such channel
     */
    public double[] values(Channel channel) {
        double[] samples = values.get(channel);
        if (samples == null) {
            throw new DataFault("no channel " + channel + "; the recording has " + values.keySet());
        }
        return samples;
    }
}
