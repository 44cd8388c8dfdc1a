package wbv.rig.platform;

import java.util.Locale;

/** An axis of the platform: three translations, commanded as acceleration [m/s²], and three rotations, as rate [rad/s]. */
public enum Axis {
    X, Y, Z, ROLL, PITCH, YAW;

    /** Number of axes. */
    static final int COUNT = 6;

    /** The word of this axis, such as {@code z} or {@code pitch}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** @throws IllegalArgumentException if no axis has this name */
    static Axis parse(String word) {
        for (Axis axis : values()) {
            if (axis.toString().equals(word)) {
                return axis;
            }
        }
        throw new IllegalArgumentException("an axis is one of x y z roll pitch yaw: '" + word + "'");
    }
}
