package wbv.pole;

import java.util.List;
import wbv.filter.model.Bounds.Attribute;
import wbv.identify.Pole;
import wbv.identify.SkyhookBody;

/** Attributes of poles, by the names under which bounds reach the constrained estimator. */
public final class Attributes {

    /** All that a pole has. */
    public static final List<Attribute> OF_A_POLE = List.of(Attribute.FREQUENCY, Attribute.DAMPING, Attribute.REAL,
            Attribute.IMAGINARY);

    /** All that bounds a body without a sensor: its pole, and what share of its damping acts against the base. */
    public static final List<Attribute> OF_A_BODY = List.of(Attribute.FREQUENCY, Attribute.DAMPING, Attribute.BASE_SHARE);

    private Attributes() {}

    /** Value of an attribute [Hz, 1 or rad/s]. */
    public static double of(Pole pole, Attribute attribute) {
        return switch (attribute) {
            case FREQUENCY -> pole.frequency();
            case DAMPING -> pole.damping();
            case REAL -> pole.re();
            case IMAGINARY -> pole.im();
            case BASE_SHARE, OUTPUT -> throw new IllegalArgumentException("a pole has no " + attribute);
        };
    }

    /** Value of an attribute [Hz or 1]. */
    public static double of(SkyhookBody body, Attribute attribute) {
        return switch (attribute) {
            case FREQUENCY -> body.frequency();
            case DAMPING -> body.damping();
            case BASE_SHARE -> body.baseShare();
            case REAL, IMAGINARY, OUTPUT -> throw new IllegalArgumentException("a body is bounded by " + OF_A_BODY + ", not " + attribute);
        };
    }

    /** Unit of an attribute; empty for a ratio. */
    public static String unit(Attribute attribute) {
        return switch (attribute) {
            case FREQUENCY -> "Hz";
            case DAMPING, BASE_SHARE -> "";
            case REAL, IMAGINARY -> "rad/s";
            case OUTPUT -> "m/s²";
        };
    }
}
