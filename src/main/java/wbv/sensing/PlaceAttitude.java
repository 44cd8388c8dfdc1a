package wbv.sensing;

import java.util.List;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;

/** How a place stands in the world from sample to sample: by its quaternion if it has one, else by gravity and gyroscope. */
final class PlaceAttitude {

    /** After this a change of heading that only a gyroscope tells has leaked away [s]. */
    private static final double HEADING_MEMORY = 60;
    /** Samples within which the filter's feedback, coded in steps, is still that of its equations. */
    private static final int FEWEST = 10;

    private final boolean quaternion;
    private final AxisColumns first;
    private final AxisColumns second;
    private final Attitude attitude;
    private final Orientation given = new Orientation();
    private final double[] values = new double[4];
    private final double[] specific = new double[3];
    private final double[] rate = new double[3];
    private boolean known;

    /** @throws DataFault if gravity is to hold the tilt faster than the samples come */
    PlaceAttitude(List<Channel> channels, String place, double hertz, double settling, String why) {
        quaternion = AxisColumns.in(channels, place, Quantity.QUATERNION);
        first = AxisColumns.of(channels, place, quaternion ? Quantity.QUATERNION : Quantity.SPECIFIC_FORCE, why);
        second = quaternion ? first : AxisColumns.of(channels, place, Quantity.ANGULAR_RATE, why + " without a quaternion");
        if (!(settling * hertz >= FEWEST)) {
            throw new DataFault(why + " needs a settling time of " + FEWEST + " samples or more, here " + FEWEST / hertz + " s: "
                    + settling + " s");
        }
        attitude = new Attitude(hertz, settling, HEADING_MEMORY);
    }

    void accept(double[] row) {
        if (quaternion) {
            first.take(row, values);
            double square = values[0] * values[0] + values[1] * values[1] + values[2] * values[2] + values[3] * values[3];
            known = square > 0;
            if (known) {
                given.set(values[0], values[1], values[2], values[3]);
            }
        } else {
            first.take(row, specific);
            second.take(row, rate);
            attitude.accept(specific, rate);
            known = attitude.begun();
        }
    }

    /** Whether the orientation is that of this sample. */
    boolean known() {
        return known;
    }

    /** Place to world. Moves on with the samples. */
    Orientation orientation() {
        return quaternion ? given : attitude.orientation();
    }
}
