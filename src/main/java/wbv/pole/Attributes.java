package wbv.pole;

import java.util.List;
import wbv.filter.Bounds.Attribute;
import wbv.identify.Pole;

/** Attributes of poles, by the names under which bounds reach the constrained estimator. */
public final class Attributes {

    /** All that a pole has. */
    public static final List<Attribute> OF_A_POLE = List.of(Attribute.FREQUENCY, Attribute.DAMPING, Attribute.REAL,
            Attribute.IMAGINARY);

    private Attributes() { }

    /** Value of an attribute [Hz, 1 or rad/s]. */
    public static double of(Pole pole, Attribute attribute) {
        return switch (attribute) {
            case FREQUENCY -> pole.frequency();
            case DAMPING -> pole.damping();
            case REAL -> pole.re();
            case IMAGINARY -> pole.im();
            case OUTPUT -> throw new IllegalArgumentException("a pole has no output");
        };
    }

    /** Unit of an attribute; empty for a ratio. */
    public static String unit(Attribute attribute) {
        return switch (attribute) {
            case FREQUENCY -> "Hz";
            case DAMPING -> "";
            case REAL, IMAGINARY -> "rad/s";
            case OUTPUT -> "m/s²";
        };
    }
}
