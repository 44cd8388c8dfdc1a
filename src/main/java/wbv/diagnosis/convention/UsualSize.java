package wbv.diagnosis.convention;

import java.util.Arrays;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * How large what is measured and modelled usually is: log-normal, so broad that it decides only between conventions of which all else is
 * the same, as a force in kN and a position in mm are.
 *
 * @param usual     [SI unit]
 * @param deviation of the logarithm [1]
 */
record UsualSize(double usual, double deviation) {

    /** A decade either way, assumed. */
    private static final double DECADE = Math.log(10);
    /** What sits on a seat (ISO 2631 and all tables of people: 40 to 120 kg), assumed a little wider. */
    private static final UsualSize SITTER = new UsualSize(60, 0.5);
    /** What a bench carries, assumed. */
    private static final UsualSize LOAD = new UsualSize(10, 1.5 * DECADE);

    UsualSize {
        if (!(usual > 0 && deviation > 0)) {
            throw new IllegalArgumentException("a usual size and its deviation must be > 0: " + usual + ", " + deviation);
        }
    }

    /** That of what a channel of a recording carries, by its root mean square. */
    static double cost(Recording recording, Channel channel) {
        double[] read = LostSamples.centred(recording.values(channel));
        return cost(channel.quantity(), Math.sqrt(Arrays.stream(read).map(value -> value * value).average().orElseThrow()));
    }

    /** Root mean square of what moves where vibration is measured, assumed; 0 where nothing is usual. */
    private static double cost(Quantity quantity, double rms) {
        return switch (quantity) {
            case ACCELERATION, SPECIFIC_FORCE -> new UsualSize(1, DECADE).cost(rms);
            case VELOCITY -> new UsualSize(0.05, DECADE).cost(rms);
            case POSITION -> new UsualSize(0.003, DECADE).cost(rms);
            case FORCE -> new UsualSize(100, DECADE).cost(rms);
            case ANGULAR_RATE -> new UsualSize(0.2, DECADE).cost(rms);
            case ANGLE -> new UsualSize(0.02, DECADE).cost(rms);
            default -> 0;
        };
    }

    /** That of all that a model carries. */
    static double cost(Model model) {
        return (model.isRig() ? LOAD : SITTER).cost(model.mass());
    }

    /**
     * Minus the logarithm of how usual a size is [nat], 0 at most usual.
     *
     * @param size [SI unit]
     */
    double cost(double size) {
        double off = Math.log(Math.max(size, Double.MIN_NORMAL) / usual) / deviation;
        return off * off / 2;
    }
}
