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
    private final Leaps leaps;

    /**
     * Checks that lengths fit; copies the map, not the samples.
     *
     * @param values samples by channel, in column order, all of one length &gt; 0. Not copied.
     * @throws IllegalArgumentException if there is no channel, no sample, or the lengths differ
     */
    public Recording(Clock clock, Map<Channel, double[]> values, Metadata metadata) {
        this(clock, values, metadata, Leaps.NONE);
    }

    /**
     * As the shorter form, of pieces of a longer one.
     *
     * @param leaps where the next piece begins
     */
    public Recording(Clock clock, Map<Channel, double[]> values, Metadata metadata, Leaps leaps) {
        this.leaps = leaps;
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

    /** Where its time leaps ahead of the clock: nowhere, but in one that is made of pieces. */
    public Leaps leaps() {
        return leaps;
    }

    /** Time of a sample [s]: the clock's, and what it has leapt ahead since. */
    public double time(long sample) {
        return clock.time(sample) + leaps.later(sample);
    }

    /** Time from the first sample to another [s]. */
    public double elapsed(long sample) {
        return time(sample) - clock.start();
    }

    /** First sample after one at which the time leaps ahead; the recording's end where it does not. */
    public int unbroken(int from) {
        return leaps.all().stream().mapToInt(Leaps.Leap::sample).filter(sample -> sample > from).findFirst().orElse(length);
    }

    /** Other values on the same clock. {@code others} is treated as in the constructor. */
    public Recording with(Map<Channel, double[]> others) {
        return new Recording(clock, others, metadata, leaps);
    }

    /**
     * The same at another rate.
     *
     * @param slow samples by channel at that rate, treated as in the constructor
     * @param rate [Hz]
     */
    public Recording at(double rate, Map<Channel, double[]> slow) {
        return new Recording(new Clock(clock.start(), rate), slow, metadata, leaps.slowed(rate / clock.rate()));
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
        return new Recording(new Clock(time(from), clock.rate()), cut, metadata, leaps.within(from, to));
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
