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
 * @param rate of the recording [Hz] @param seat vertical acceleration of the seat @param head of the head
 * @param roll rate about x @param pitch rate about y, of a place that rocks with the seat
 */
public record FeatureSpec(double rate, Channel seat, Channel head, Channel roll, Channel pitch) implements Serializable {

    /** What a row of features holds. */
    public static final List<String> NAMES = List.of("seat_jerk_m_per_s3", "head_jerk_m_per_s3", "shaking_log10_m_per_s3",
            "rocking_log10_rad_per_s");

    /** Places of the features in a row. */
    static final int SEAT_JERK = 0;
    static final int HEAD_JERK = 1;
    static final int SHAKING = 2;
    static final int ROCKING = 3;

    private static final double DERIVATIVE = 1.0 / 30;
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
     * The channels of two places: {@code acc.z} of both, and roll and pitch rate of the lower.
     *
     * @param channels that there are @param where for messages
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
        return Math.max(1, (int) Math.round(rate * DERIVATIVE));
    }

    /** Where the derivative's gain has fallen to 1/√2 of a true derivative's [Hz]: 7.3 Hz at 60 Hz. */
    public double corner() {
        double low = 0;
        double high = rate / 2;
        for (int i = 0; i < 60; i++) {
            double middle = (low + high) / 2;
            if (gain(middle) > Math.sqrt(0.5)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Gain of the derivative over a true one's. */
    private double gain(double frequency) {
        double w = 2 * Math.PI * frequency / rate;
        double sum = 0;
        double squares = 0;
        for (int i = 1; i <= delay(); i++) {
            sum += i * Math.sin(w * i);
            squares += i * i;
        }
        return w == 0 ? 1 : sum / (squares * w);
    }
}
