package wbv.recording;

import java.util.Optional;

/** What a channel measures. The symbol is the middle word of a channel name; values are in the unit given, always. */
public enum Quantity {
    /** Acceleration of the place, gravity removed. */
    ACCELERATION("acc", "m/s²", "xyz"),
    /** Specific force as an accelerometer reads it: +9.81 m/s² on the axis that points up, at rest. */
    SPECIFIC_FORCE("accg", "m/s²", "xyz"),
    ANGULAR_RATE("gyr", "rad/s", "xyz"),
    VELOCITY("vel", "m/s", "xyz"),
    POSITION("pos", "m", "xyz"),
    ANGLE("ang", "rad", "xyz"),
    FORCE("force", "N", "xyz"),
    /** Voltage, of a coil or an actuator. It has no axis: {@code coil.volt.s}. */
    VOLTAGE("volt", "V", "s"),
    /** Temperature. It has no axis: {@code oil.temp.s}. */
    TEMPERATURE("temp", "°C", "s"),
    /** Magnetic field in the sensor's own arbitrary unit (1 is about the local field of the earth). */
    MAGNETIC_FIELD("mag", "a.u.", "xyz"),
    /** Orientation, sensor to world, unit quaternion with the real part w first. */
    QUATERNION("quat", "1", "wxyz");

    private final String symbol;
    private final String unit;
    private final String axes;

    Quantity(String symbol, String unit, String axes) {
        this.symbol = symbol;
        this.unit = unit;
        this.axes = axes;
    }

    /** The word used in channel names, such as {@code acc}. */
    public String symbol() {
        return symbol;
    }

    /** The SI unit of every value of this quantity. */
    public String unit() {
        return unit;
    }

    /** The axis letters that a channel of this quantity may carry, in their usual order. */
    public String axes() {
        return axes;
    }

    /** The quantity with this symbol, if there is one. */
    public static Optional<Quantity> ofSymbol(String symbol) {
        for (Quantity quantity : values()) {
            if (quantity.symbol.equals(symbol)) {
                return Optional.of(quantity);
            }
        }
        return Optional.empty();
    }
}
