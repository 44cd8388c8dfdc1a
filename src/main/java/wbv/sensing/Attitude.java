package wbv.sensing;

import java.io.Serializable;

/**
 * Orientation of a sensor, and its free acceleration, from the specific force and the angular rate that it reads: the rate is
 * integrated, and its drift is held by gravity, which is what the specific force amounts to in the mean.
 *
 * <p>A filter of second order on the rotation group with estimate of the gyroscope's bias (Mahony, Hamel and Pflimlin, IEEE
 * Trans. Automatic Control 53, 2008). It begins as the mean of the specific force so far and settles into its time constant, over
 * which shaking averages out. Heading has no such hold: it starts at 0, and with a memory it leaks back there, so that only its
 * changes within that time remain.
 */
public final class Attitude implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double DAMPING = Math.sqrt(0.5);

    private final double step;
    private final double settling;
    private final double headingMemory;
    private final Orientation orientation = new Orientation();
    private final double[] bias = new double[3];
    private final double[] up = new double[3];
    private final double[] last = new double[3];
    private long count;

    /**
     * Knows nothing before the first sample.
     *
     * @param rate          samples per second [Hz], &gt; 0
     * @param settling      time constant with which gravity holds the tilt [s], &gt; 0; some times the slowest motion's period
     * @param headingMemory time after which a change of heading has leaked to 1/e [s]; infinite to keep it, drift and all
     */
    public Attitude(double rate, double settling, double headingMemory) {
        if (!(rate > 0) || !(settling > 0) || !(headingMemory > 0)) {
            throw new IllegalArgumentException("rate, settling time and heading's memory must be > 0: " + rate + " Hz, "
                    + settling
                    + " s, " + headingMemory + " s");
        }
        this.step = 1 / rate;
        this.settling = settling;
        this.headingMemory = headingMemory;
    }

    /**
     * Takes a sample; while something is missing (NaN), the rest goes on: without a rate the last one holds, without a specific
     * force
     * nothing corrects it.
     *
     * @param specific [m/s²], three long
     * @param rate [rad/s], both in the sensor's axes, three long. Not modified.
     */
    public void accept(double[] specific, double[] rate) {
        if (Vectors.known(rate)) {
            System.arraycopy(rate, 0, last, 0, 3);
        }
        boolean seen = Vectors.known(specific);
        if (count == 0 && seen) {
            orientation.set(Orientation.between(specific, new double[] {0, 0, 1}));
            levelHeading(1);
        }
        double ex = 0;
        double ey = 0;
        double ez = 0;
        if (seen) {
            // What turns the up that is believed into the one that is read: f × R⁻¹z, over g.
            up[0] = 0;
            up[1] = 0;
            up[2] = 1;
            orientation.inward(up, up);
            ex = (specific[1] * up[2] - specific[2] * up[1]) / Gravity.STANDARD;
            ey = (specific[2] * up[0] - specific[0] * up[2]) / Gravity.STANDARD;
            ez = (specific[0] * up[1] - specific[1] * up[0]) / Gravity.STANDARD;
        }
        double elapsed = (count + 1) * step;
        double gain = Math.max(2 * DAMPING / settling, 1 / elapsed);
        double learning = elapsed > settling ? step / (settling * settling) : 0;
        bias[0] -= learning * ex;
        bias[1] -= learning * ey;
        bias[2] -= learning * ez;
        orientation.turn(step * (last[0] - bias[0] + gain * ex), step * (last[1] - bias[1] + gain * ey),
                step * (last[2] - bias[2] + gain * ez));
        if (headingMemory < Double.POSITIVE_INFINITY) {
            levelHeading(-Math.expm1(-step / headingMemory));
        }
        count += seen || count > 0 ? 1 : 0;
    }

    /** Turns the world about its upright by a share of the heading. */
    private void levelHeading(double share) {
        double half = -share * orientation.heading() / 2;
        double c = Math.cos(half);
        double s = Math.sin(half);
        orientation.set(c * orientation.w() - s * orientation.z(), c * orientation.x() - s * orientation.y(),
                c * orientation.y() + s * orientation.x(), c * orientation.z() + s * orientation.w());
    }

    /** Sensor to world, z up, heading 0 at first. Not a copy: it moves on with the samples. */
    public Orientation orientation() {
        return orientation;
    }

    /** Whether there was a sample yet from which to begin. */
    public boolean begun() {
        return count > 0;
    }

    /** Bias of the angular rate as known now [rad/s], three long, a new array. What turns about the upright is not seen. */
    public double[] bias() {
        return bias.clone();
    }

    /**
     * Free acceleration in the world's axes [m/s²].
     *
     * @param specific of the sensor [m/s²], three long. Not modified.
     * @param out [m/s²], three long. Modified.
     */
    public void free(double[] specific, double[] out) {
        Gravity.removeInWorld(orientation, specific, out);
    }

    /**
     * Free acceleration in the sensor's own axes [m/s²].
     *
     * @param specific of the sensor [m/s²], three long. Not modified.
     * @param out [m/s²], three long. Modified.
     */
    public void freeInSensor(double[] specific, double[] out) {
        Gravity.removeInWorld(orientation, specific, out);
        orientation.inward(out, out);
    }
}
