package wbv.exposure;

import java.util.Map;
import wbv.recording.Quantity;

/**
 * The twelve axes on which the comfort of one who sits is evaluated (ISO 2631-1:1997 8.2), with weighting and factor k. Rotations
 * are angular accelerations; {@link #filter} takes the angular rate that sensors give.
 */
public enum ComfortAxis {
    SEAT_X("seat", 'x', Weighting.WD, 1), SEAT_Y("seat", 'y', Weighting.WD, 1), SEAT_Z("seat", 'z', Weighting.WK, 1),
    ROLL("rotation", 'x', Weighting.WE, 0.63), PITCH("rotation", 'y', Weighting.WE, 0.40),
    YAW("rotation", 'z', Weighting.WE, 0.20),
    BACKREST_X("backrest", 'x', Weighting.WC, 0.8), BACKREST_Y("backrest", 'y', Weighting.WD, 0.5),
    BACKREST_Z("backrest", 'z', Weighting.WD, 0.4),
    FEET_X("feet", 'x', Weighting.WK, 0.25), FEET_Y("feet", 'y', Weighting.WK, 0.25), FEET_Z("feet", 'z', Weighting.WK, 0.4);

    private final String point;
    private final char axis;
    private final Weighting weighting;
    private final double factor;

    ComfortAxis(String point, char axis, Weighting weighting, double factor) {
        this.point = point;
        this.axis = axis;
        this.weighting = weighting;
        this.factor = factor;
    }

    /** {@code seat}, {@code rotation} of the seat, {@code backrest} or {@code feet}. */
    public String point() {
        return point;
    }

    /** {@code x}, {@code y} or {@code z}; of a rotation, the axis that it turns about. */
    public char axis() {
        return axis;
    }

    /** For accelerations, angular ones [rad/s²] of a rotation; what is measured goes through {@link #filter}. */
    public Weighting weighting() {
        return weighting;
    }

    /** Factor k [1], of a rotation [m/rad]. */
    public double factor() {
        return factor;
    }

    /** True for a rotation. */
    public boolean rotates() {
        return point.equals("rotation");
    }

    /** What has to be measured: an acceleration, or an angular rate [rad/s]. */
    public Quantity measured() {
        return rotates() ? Quantity.ANGULAR_RATE : Quantity.ACCELERATION;
    }

    /** The weighting for what is measured. */
    public AnalogFilter filter() {
        return rotates() ? weighting.filter().differentiated() : weighting.filter();
    }

    /**
     * Total of a point, {@code √(Σ k² a_w²)} [m/s²].
     *
     * @param levels r.m.s. by axis; those of other points are left out
     */
    public static double total(String point, Map<ComfortAxis, Double> levels) {
        return Math.sqrt(levels.entrySet().stream().filter(entry -> entry.getKey().point.equals(point))
                .mapToDouble(ComfortAxis::square).sum());
    }

    /**
     * Overall total value a_v of all axes measured [m/s²].
     *
     * @param levels r.m.s. by axis
     */
    public static double total(Map<ComfortAxis, Double> levels) {
        return Math.sqrt(levels.entrySet().stream().mapToDouble(ComfortAxis::square).sum());
    }

    private static double square(Map.Entry<ComfortAxis, Double> level) {
        double value = level.getKey().factor * level.getValue();
        return value * value;
    }
}
