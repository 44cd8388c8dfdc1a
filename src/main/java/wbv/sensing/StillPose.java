package wbv.sensing;

import java.util.Locale;
import wbv.recording.DataFault;

/**
 * How a sensor is worn, from a pose held still: gravity shows where up is, the angular rate at rest is the gyroscope's bias. What
 * gravity cannot show, the heading, is taken from the sensor (its x axis forward) or from a lean.
 */
public final class StillPose {

    /** A second is enough, and is what a person holds. */
    private static final double SHORTEST = 1;
    private static final double MOST_SHAKE = 0.3;
    private static final double MOST_TURN = 0.05;
    private static final double MOST_OFF = 0.05;

    private final String name;
    private final double rate;
    private final double[] mean = new double[6];
    private final double[] squares = new double[6];
    private final double[] now = new double[6];
    private long count;

    /**
     * A sensor as it is worn.
     *
     * @param alignment sensor to body: x forward, y left, z up
     * @param gravity   what the sensor reads for gravity [m/s²]
     * @param bias      of the angular rate, in the sensor's axes [rad/s], three long
     */
    public record Worn(Orientation alignment, double gravity, double[] bias) {

        /**
         * The same sensor, its forward told by a lean.
         *
         * @param lean angular rate while leaning forward, three long, of any unit. Not modified.
         */
        public Worn leaning(double[] lean) {
            double[] turned = new double[3];
            alignment.outward(lean, turned);
            double across = Math.hypot(turned[0], turned[1]);
            if (!(across > Math.abs(turned[2]))) {
                throw new IllegalArgumentException("a lean turns about the left, not about the upright: "
                        + java.util.Arrays.toString(turned));
            }
            // A lean forward turns about +y: a heading of the body of so much brings it there.
            double half = Math.atan2(turned[0], turned[1]) / 2;
            Orientation about = Orientation.of(Math.cos(half), 0, 0, Math.sin(half));
            Orientation whole = Orientation.of(alignment.w(), alignment.x(), alignment.y(), alignment.z());
            whole.before(about);
            return new Worn(whole, gravity, bias);
        }
    }

    /**
     * Begins with no sample.
     *
     * @param name of the sensor, for messages
     * @param rate samples per second [Hz]
     */
    public StillPose(String name, double rate) {
        this.name = name;
        this.rate = rate;
    }

    /**
     * Takes a sample of the pose; one with anything missing is passed over.
     *
     * @param specific [m/s²], three long
     * @param turning [rad/s], three long: x, y, z, as the other. Neither is modified.
     */
    public void accept(double[] specific, double[] turning) {
        if (!Vectors.known(specific) || !Vectors.known(turning)) {
            return;
        }
        System.arraycopy(specific, 0, now, 0, 3);
        System.arraycopy(turning, 0, now, 3, 3);
        count++;
        for (int i = 0; i < 6; i++) {
            double before = now[i] - mean[i];
            mean[i] += before / count;
            squares[i] += before * (now[i] - mean[i]);
        }
    }

    /**
     * How the sensor is worn.
     *
     * @throws DataFault if the pose was too short or not still, or if what is read is not gravity
     */
    public Worn worn() {
        if (count < SHORTEST * rate) {
            throw fault("%.2g s of a still pose are too few: hold it for %.0f s", count / rate, SHORTEST);
        }
        double shake = Math.sqrt((squares[0] + squares[1] + squares[2]) / count);
        double turn = Math.sqrt((squares[3] + squares[4] + squares[5]) / count);
        if (shake > MOST_SHAKE || turn > MOST_TURN) {
            throw fault("moves by %.2g m/s² and %.2g rad/s in a pose that should be still (at most %.1f and %.2f)", shake, turn,
                    MOST_SHAKE, MOST_TURN);
        }
        double[] up = {mean[0], mean[1], mean[2]};
        double gravity = Vectors.length(up);
        if (Math.abs(gravity / Gravity.STANDARD - 1) > MOST_OFF) {
            throw fault("reads %.3g m/s² at rest, which is not gravity (%.3g): was it removed, or is the unit wrong?", gravity,
                    Gravity.STANDARD);
        }
        Orientation alignment = Orientation.between(up, new double[] {0, 0, 1});
        // Of the two rotations that bring up to z, the one that leaves the sensor's x axis forward.
        double half = -alignment.heading() / 2;
        alignment.before(Orientation.of(Math.cos(half), 0, 0, Math.sin(half)));
        return new Worn(alignment, gravity, new double[] {mean[3], mean[4], mean[5]});
    }

    private DataFault fault(String words, Object... values) {
        return new DataFault(name + ": " + String.format(Locale.ROOT, words, values));
    }
}
