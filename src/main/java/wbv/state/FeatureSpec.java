package wbv.state;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;

/**
 * From which channels the states are told.
 *
 * @param rate of the recording [Hz]
 * @param seat vertical acceleration of the seat
 * @param head of the head
 * @param roll rate about x
 * @param pitch rate about y, of a place that rocks with the seat
 */
public record FeatureSpec(double rate, Channel seat, Channel head, Channel roll, Channel pitch) implements Serializable {

    /** What a row of features holds. */
    public static final List<String> NAMES = List.of("seat_jerk_m_per_s3", "head_jerk_m_per_s3", "shaking_log10_m_per_s3",
            "surge_log10_m_per_s2", "sway_log10_rad_per_s");

    /** Places of the features in a row. */
    public static final int SEAT_JERK = 0;
    /** Jerk of the head [m/s³]. */
    public static final int HEAD_JERK = 1;
    /** Shaking, log10 of m/s³. */
    public static final int SHAKING = 2;
    /** Surge of the seat, log10 of m/s². */
    public static final int SURGE = 3;
    /** Sway, log10 of rad/s. */
    public static final int SWAY = 4;
    /** How many features tell the activity: those after the two jerks. */
    static final int OF_ACTIVITY = 3;
    /** From where to where levels say something: half of the weakest jolt and rocking, and what is no rest any more. */
    private static final double QUIET_SURGE = 1;
    private static final double QUIET_RATE = 0.03;
    private static final double LOUD_JERK = 3;
    /** What sensors' noise may jerk: half of the weakest ride. */
    private static final double QUIET_JERK = 1;

    private static final double LEAST_RATE = 20;
    private static final double MOST_RATE = 100_000;

    public FeatureSpec {
        if (!(rate >= LEAST_RATE && rate <= MOST_RATE)) {
            throw new IllegalArgumentException("states need 20 to 100 000 Hz: " + rate);
        }
        if (List.of(seat, head, roll, pitch).stream().distinct().count() < 4) {
            throw new IllegalArgumentException("seat, head, roll and pitch must be four channels: " + seat + ", " + head + ", "
                    + roll + ", " + pitch);
        }
    }

    /**
     * The feature of a level of shaking: its logarithm, flat below a sensor's noise and beyond rest.
     *
     * @param level [m/s³]
     */
    static double shaking(double level) {
        return -Math.log10(Math.hypot(1 / Math.hypot(level, QUIET_JERK), 1 / LOUD_JERK));
    }

    /**
     * The feature of a surge: its logarithm, flat below what could be a jolt.
     *
     * @param level [m/s²]
     */
    static double surge(double level) {
        return Math.log10(Math.hypot(level, QUIET_SURGE));
    }

    /**
     * The feature of sway: its logarithm, flat below what could be rocking.
     *
     * @param level [rad/s]
     */
    static double sway(double level) {
        return Math.log10(Math.hypot(level, QUIET_RATE));
    }

    /**
     * The channels of two places: {@code acc.z} of both, and roll and pitch rate of the lower.
     *
     * @param rate of the recording [Hz]
     * @param channels that there are
     * @param where for messages
     * @throws DataFault if one is missing
     */
    public static FeatureSpec of(double rate, String seat, String head, List<Channel> channels, String where) {
        List<Channel> wanted = List.of(new Channel(seat, Quantity.ACCELERATION, 'z'), new Channel(head, Quantity.ACCELERATION,
                'z'),
                new Channel(seat, Quantity.ANGULAR_RATE, 'x'), new Channel(seat, Quantity.ANGULAR_RATE, 'y'));
        require(wanted, channels, where);
        if (!(rate >= LEAST_RATE && rate <= MOST_RATE)) {
            throw DataFault.in(where, "has " + rate + " samples a second; states need 20 to 100 000");
        }
        return new FeatureSpec(rate, wanted.get(0), wanted.get(1), wanted.get(2), wanted.get(3));
    }

    /** The four channels, in the order in which {@link FeatureStream} takes them. */
    public List<Channel> channels() {
        return List.of(seat, head, roll, pitch);
    }

    /** @throws DataFault if a recording lacks a channel, or has another rate */
    void require(List<Channel> there, double itsRate, String where) {
        require(channels(), there, where);
        if (Math.abs(itsRate / rate - 1) > 0.01) {
            throw DataFault.in(where, "has " + itsRate + " samples a second, the model was trained on " + rate
                    + "; train one for this rate");
        }
    }

    private static void require(List<Channel> wanted, List<Channel> there, String where) {
        List<Channel> lacking = new ArrayList<>(wanted);
        lacking.removeAll(there);
        if (!lacking.isEmpty()) {
            throw DataFault.in(where, "has no channel " + lacking.get(0) + ", from which states are told; there are " + there);
        }
    }

    /** Half the width of the derivative [samples], and so the delay of the features. */
    public int delay() {
        return Slope.delay(rate);
    }

    /** Where the derivative's gain has fallen to 1/√2 of a true derivative's [Hz]: 18.4 Hz at 60 Hz. */
    public double corner() {
        double[] slopes = Slope.weights(rate);
        double low = 0;
        double high = rate / 2;
        for (int i = 0; i < 60; i++) {
            double middle = (low + high) / 2;
            if (gain(middle, slopes) > Math.sqrt(0.5)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Gain of the derivative over a true one's. */
    private double gain(double frequency, double[] slopes) {
        double w = 2 * Math.PI * frequency / rate;
        double sum = 0;
        for (int i = 1; i <= slopes.length; i++) {
            sum += 2 * slopes[i - 1] * Math.sin(w * i);
        }
        return w == 0 ? 1 : sum / (rate * w);
    }
}
