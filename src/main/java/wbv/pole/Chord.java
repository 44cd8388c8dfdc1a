package wbv.pole;

import java.io.Serializable;

/**
 * Where a line at a measured value cuts a {@link ConstraintPolygon}.
 *
 * @param lower least value of the other attribute, in the unit of that
 * @param upper largest, likewise
 * @param inside whether the measured value lies over the polygon; else the bounds are those at its nearest edge
 */
public record Chord(double lower, double upper, boolean inside) implements Serializable {

    public Chord {
        if (!(lower <= upper)) {
            throw new IllegalArgumentException("lower bound must be <= upper: " + lower + ", " + upper);
        }
    }

    /** Halfway between the bounds, in the attribute's unit. */
    public double middle() {
        return (lower + upper) / 2;
    }
}
