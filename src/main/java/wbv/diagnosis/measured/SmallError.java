package wbv.diagnosis.measured;

import java.util.Locale;
import wbv.body.SensorFault;

/**
 * A small error that a sensor has, as every sensor does.
 *
 * @param owner index of the output whose sensor it is, or {@link #INPUT}
 * @param axis  which other axis of the sensor it lets in, or which sensor of the base errs; empty where none
 */
public record SmallError(Kind kind, int owner, String axis) {

    /** Owner of an error that all outputs share. */
    public static final int INPUT = -1;

    /** Standard deviations that a sensor's small error has at most. */
    public static final double MOST = 3;

    /** What sort of error, with what is known of its size beforehand. */
    public enum Kind {
        /** A part of what it measures [1]. */
        GAIN("gain", 0.01),
        /** How late it is, in samples of the recorded clock; the input's sensor has one too, by which all outputs come early. */
        DELAY("delay_s", 0.1),
        /** Angle to an axis across [rad]: one degree. */
        TILT("tilt_to_%s_rad", Math.toRadians(1)),
        /** The part that its sway plays [1]: none to all of tilt times acceleration across. */
        SWAY("sway_to_%s", 1),
        /** Height above the axis about which its place turns [m]. */
        HEIGHT("height_m", 0.3),
        /** Distance from where it should be [m], by the axis about which that shows. */
        ARM("arm_on_%s_m", 0.005),
        /** A part of what the base's sensor along a further axis measures [1]. */
        AXIS_GAIN("gain_of_%s", 0.01),
        /** How late that sensor is, in samples of the recorded clock. */
        AXIS_DELAY("delay_of_%s_s", 0.1),
        /** Angle by which a sensor of the base lets another of its axes in [rad]. */
        AXIS_TILT("tilt_of_%s_rad", Math.toRadians(1)),
        /** Distance of a sensor of the base from where it should be [m], by the axis about which that shows. */
        AXIS_ARM("arm_of_%s_m", 0.005),
        /** No sensor's: how a rig begins anew after a pause [1], as a part of how it may, see {@code Beginnings}. */
        START("start", 1),
        /** No sensor's: a sample of what the way to it answers otherwise than the model says [1], see {@code WrongWay}. */
        WAY("way", 1);

        private final String key;
        private final double deviation;

        Kind(String key, double deviation) {
            this.key = key;
            this.deviation = deviation;
        }

        /** Standard deviation among sensors, in the unit of its key; delays in samples. */
        public double deviation() {
            return deviation;
        }
    }

    /** The name of its value, with the unit. */
    public String key() {
        return String.format(Locale.ROOT, kind.key, axis);
    }

    /**
     * Standard deviation in the unit of its value.
     *
     * @param sample time between two samples as they were recorded [s]
     */
    public double deviation(double sample) {
        return kind == Kind.DELAY || kind == Kind.AXIS_DELAY ? kind.deviation() * sample : kind.deviation();
    }

    /** Standard deviations [1] that it has at most: a sensor that errs more is named. */
    public double most() {
        return isOfSensor() ? MOST : Double.POSITIVE_INFINITY;
    }

    /** Whether it is a sensor's own. */
    public boolean isOfSensor() {
        return kind != Kind.WAY && kind != Kind.START;
    }

    /** Whether it is that of the sensor of the base's first axis, by which all are late or early alike. */
    public boolean isInput() {
        return owner == INPUT && kind == Kind.DELAY;
    }

    /** Whether it says how late a sensor is: that of an output, or of the base's first axis. */
    public boolean isDelay() {
        return kind == Kind.DELAY;
    }

    /** Whether a fault is a large one of these. */
    public boolean isLike(SensorFault fault) {
        return switch (kind) {
            case GAIN -> fault instanceof SensorFault.Gain;
            case DELAY -> fault instanceof SensorFault.Late;
            case TILT -> fault instanceof SensorFault.Misalignment || fault instanceof SensorFault.Turned;
            case ARM -> fault instanceof SensorFault.LeverArm;
            case SWAY, HEIGHT, AXIS_GAIN, AXIS_DELAY, AXIS_TILT, AXIS_ARM, START, WAY -> false;
        };
    }
}
