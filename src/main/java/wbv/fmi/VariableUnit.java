package wbv.fmi;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import wbv.recording.Quantity;

/**
 * The unit that a variable is declared in.
 *
 * @param name      as declared; empty where nothing is
 * @param factor    SI units in one of it
 * @param offset    its zero in SI units
 * @param exponents of the SI base units that it is made of, zeros left out; empty where it is not said
 */
public record VariableUnit(String name, double factor, double offset, Optional<Map<String, Integer>> exponents) {

    /** Nothing is declared: SI. */
    public static final VariableUnit NONE = new VariableUnit("", 1, 0, Optional.empty());

    public VariableUnit {
        if (!(Math.abs(factor) > 0) || Double.isInfinite(factor) || !Double.isFinite(offset)) {
            throw new IllegalArgumentException(
                    "the unit '" + name + "' must have a finite factor that is not 0 and a finite offset: " + factor + ", " + offset);
        }
    }

    double toSi(double value) {
        return factor * value + offset;
    }

    double fromSi(double value) {
        return (value - offset) / factor;
    }

    /** Whether it is that of a force: by its base units, or its name where these are not said. */
    boolean isForce() {
        return exponents.map(own -> own.equals(exponents(Quantity.FORCE))).orElse(name.equals("N") || name.equals("kN"));
    }

    /** Whether it may be the unit of a quantity; one that says nothing of itself may. */
    boolean fits(Quantity quantity) {
        return exponents.isEmpty() || quantity == Quantity.MAGNETIC_FIELD || quantity == Quantity.QUATERNION
                || exponents.get().equals(exponents(quantity));
    }

    /** Radians, which count as 1, and zeros are left out. */
    static Map<String, Integer> significant(Map<String, Integer> exponents) {
        Map<String, Integer> out = new LinkedHashMap<>(exponents);
        out.remove("rad");
        out.values().removeIf(exponent -> exponent == 0);
        return out;
    }

    private static Map<String, Integer> exponents(Quantity quantity) {
        return switch (quantity) {
            case ACCELERATION, SPECIFIC_FORCE -> Map.of("m", 1, "s", -2);
            case VELOCITY -> Map.of("m", 1, "s", -1);
            case POSITION -> Map.of("m", 1);
            case ANGULAR_RATE -> Map.of("s", -1);
            case FORCE -> Map.of("kg", 1, "m", 1, "s", -2);
            case VOLTAGE -> Map.of("kg", 1, "m", 2, "s", -3, "A", -1);
            case TEMPERATURE -> Map.of("K", 1);
            case ANGLE, MAGNETIC_FIELD, QUATERNION -> Map.of();
        };
    }
}
