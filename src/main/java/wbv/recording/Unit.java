package wbv.recording;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * A unit that a column may be in, as {@code value * times / over} in SI: two numbers, so that the usual factors are exact.
 *
 * @param dimension the SI unit that comes out, as {@link Quantity#unit} writes it, or {@code s}
 */
public record Unit(String dimension, double times, double over) {

    /** Standard gravity [m/s²], exact by definition (CGPM 1901). */
    public static final double STANDARD_GRAVITY = 9.80665;

    private static final Map<String, Unit> UNITS = units();

    /**
     * The unit with this symbol, if it is known. {@code ²}, {@code ^2} and {@code 2} are the same, {@code µ} and {@code u} too.
     */
    public static Optional<Unit> of(String symbol) {
        return Optional.ofNullable(UNITS.get(plain(symbol)));
    }

    /** The symbols of all units that come out as this SI unit. */
    public static String symbols(String dimension) {
        StringBuilder text = new StringBuilder();
        UNITS.forEach((symbol, unit) -> {
            if (unit.dimension.equals(dimension)) {
                text.append(text.isEmpty() ? "" : ", ").append(symbol);
            }
        });
        return text.toString();
    }

    /** The same with a further factor, such as -1 for an axis that points the other way. */
    public Unit scaled(double scale) {
        return new Unit(dimension, times * scale, over);
    }

    /**
     * A value in SI units.
     *
     * @param value in this unit
     */
    public double toSi(double value) {
        return value * times / over;
    }

    private static String plain(String symbol) {
        return symbol.strip().replace("²", "2").replace("^", "").replace("µ", "u").replace("μ", "u").replace("°", "deg")
                .replace("ₙ", "").replace("\\", "");
    }

    private static Map<String, Unit> units() {
        Map<String, Unit> units = new LinkedHashMap<>();
        add(units, Quantity.ACCELERATION.unit(), 1, 1, "m/s2", "m/s/s");
        add(units, Quantity.ACCELERATION.unit(), 1, 1000, "mm/s2");
        add(units, Quantity.ACCELERATION.unit(), 1, 100, "cm/s2");
        add(units, Quantity.ACCELERATION.unit(), STANDARD_GRAVITY, 1, "g");
        add(units, Quantity.ACCELERATION.unit(), STANDARD_GRAVITY, 1000, "mg");
        add(units, Quantity.ANGULAR_RATE.unit(), 1, 1, "rad/s");
        add(units, Quantity.ANGULAR_RATE.unit(), 1, 1000, "mrad/s");
        add(units, Quantity.ANGULAR_RATE.unit(), Math.PI, 180, "deg/s", "dps");
        add(units, Quantity.ANGULAR_RATE.unit(), Math.PI, 180_000, "mdeg/s", "mdps");
        add(units, Quantity.ANGULAR_RATE.unit(), Math.PI, 30, "rpm");
        add(units, Quantity.VELOCITY.unit(), 1, 1, "m/s");
        add(units, Quantity.VELOCITY.unit(), 1, 1000, "mm/s");
        add(units, Quantity.VELOCITY.unit(), 1, 100, "cm/s");
        add(units, Quantity.VELOCITY.unit(), 1, 3.6, "km/h");
        add(units, Quantity.POSITION.unit(), 1, 1, "m");
        add(units, Quantity.POSITION.unit(), 1, 1000, "mm");
        add(units, Quantity.POSITION.unit(), 1, 100, "cm");
        add(units, Quantity.POSITION.unit(), 1, 1e6, "um");
        add(units, Quantity.POSITION.unit(), 0.0254, 1, "in");
        add(units, Quantity.ANGLE.unit(), 1, 1, "rad");
        add(units, Quantity.ANGLE.unit(), 1, 1000, "mrad");
        add(units, Quantity.ANGLE.unit(), Math.PI, 180, "deg");
        add(units, Quantity.FORCE.unit(), 1, 1, "N");
        add(units, Quantity.FORCE.unit(), 1000, 1, "kN");
        add(units, Quantity.FORCE.unit(), STANDARD_GRAVITY, 1, "kgf");
        add(units, Quantity.FORCE.unit(), 4.4482216152605, 1, "lbf");
        add(units, Quantity.VOLTAGE.unit(), 1, 1, "V");
        add(units, Quantity.VOLTAGE.unit(), 1, 1000, "mV");
        add(units, Quantity.TEMPERATURE.unit(), 1, 1, "°C", "degC");
        add(units, Quantity.MAGNETIC_FIELD.unit(), 1, 1, "a.u.");
        add(units, Quantity.QUATERNION.unit(), 1, 1, "1");
        add(units, "s", 1, 1, "s");
        add(units, "s", 1, 1000, "ms");
        add(units, "s", 1, 1e6, "us");
        add(units, "s", 1, 1e9, "ns");
        add(units, "s", 60, 1, "min");
        add(units, "s", 3600, 1, "h");
        return units;
    }

    private static void add(Map<String, Unit> units, String dimension, double times, double over, String... symbols) {
        for (String symbol : symbols) {
            units.put(symbol, new Unit(dimension, times, over));
        }
    }
}
