package wbv.filter.model;

import java.io.Serializable;
import java.util.Arrays;

/**
 * Lower and upper bounds of what describes a body, for one sample: a table that a {@link wbv.filter.Constraint} fills in and an estimator
 * reads. It is used again for the next sample, so nothing is allocated.
 *
 * <p>A body of two degrees of freedom has modes 0 and 1, mode 0 the slower.
 */
public final class Bounds implements Serializable {

    private static final long serialVersionUID = 1;

    /** What can be bounded. The poles of a mode are {@code -ζω ± jω√(1 - ζ²)}, in the s-plane. */
    public enum Attribute {
        /** Natural frequency f0 [Hz]. */
        FREQUENCY,
        /** Damping ratio ζ [1]. */
        DAMPING,
        /** Real part of the poles, -ζω [rad/s]; negative. */
        REAL,
        /** Imaginary part of the upper pole, ω√(1 - ζ²) [rad/s]; &gt;= 0, and 0 for ζ &gt;= 1. */
        IMAGINARY,
        /**
         * Share κ of the damping that acts against the base [1]; of a {@link wbv.filter.EstimatorDesign#withSkyhook body that has one},
         * mode 0 only.
         */
        BASE_SHARE,
        /** The body's output [m/s² or rad/s], gravity and bias of the sensor not counted; of mode 0 only. */
        OUTPUT
    }

    /** Modes that a body has at most. */
    public static final int MODES = 2;

    private static final double WITHIN = 1.02;
    private static final int ATTRIBUTES = Attribute.values().length;

    private final double[] lower = new double[MODES * ATTRIBUTES];
    private final double[] upper = new double[MODES * ATTRIBUTES];

    /** No bounds: everything is allowed. */
    public Bounds() {
        clear();
    }

    /** Nothing is bounded. */
    public void clear() {
        Arrays.fill(lower, Double.NEGATIVE_INFINITY);
        Arrays.fill(upper, Double.POSITIVE_INFINITY);
    }

    /**
     * {@link #set(int, Attribute, double, double)} for mode 0.
     *
     * @param low in the unit of the attribute
     * @param high likewise
     */
    public void set(Attribute attribute, double low, double high) {
        set(0, attribute, low, high);
    }

    /**
     * Bounds one attribute.
     *
     * @param mode 0 or 1
     * @param low  in the unit of the attribute; may be negative infinity
     * @param high in the same unit, &gt;= low, may be infinity; equal to low, the attribute is known
     */
    public void set(int mode, Attribute attribute, double low, double high) {
        if (!(low <= high)) {
            throw new IllegalArgumentException("lower bound of " + attribute + " must be <= the upper: " + low + ", " + high);
        }
        int i = index(mode, attribute);
        lower[i] = low;
        upper[i] = high;
    }

    /** Keeps frequency and damping of the first modes a little within what {@link Spec} takes for a body. */
    public void setToBody(int modes) {
        for (int m = 0; m < modes; m++) {
            set(m, Attribute.FREQUENCY, Spec.LEAST_FREQUENCY * WITHIN, Spec.MOST_FREQUENCY / WITHIN);
            set(m, Attribute.DAMPING, Spec.LEAST_DAMPING * WITHIN, Spec.MOST_DAMPING / WITHIN);
        }
    }

    /** The lower bound, in the unit of the attribute; negative infinity where there is none. */
    public double lower(int mode, Attribute attribute) {
        return lower[index(mode, attribute)];
    }

    /** The upper bound, in the unit of the attribute; infinity where there is none. */
    public double upper(int mode, Attribute attribute) {
        return upper[index(mode, attribute)];
    }

    private static int index(int mode, Attribute attribute) {
        return mode * ATTRIBUTES + attribute.ordinal();
    }
}
