package wbv.control.trial;

import java.util.Optional;
import wbv.rig.Subject;

/**
 * What goes wrong on a ride.
 *
 * @param loss    share of readings that are lost, each sensor by itself, 0 to 1
 * @param silence of a sensor, if any
 * @param delay   of damper and actuator beside the usual [s], &gt;= 0 to 0.05
 * @param change  of who sits there, if any
 */
public record Faults(double loss, Optional<Silence> silence, double delay, Optional<Change> change) {

    /** Nothing does. */
    public static final Faults NONE = new Faults(0, Optional.empty(), 0, Optional.empty());

    /** Sensors of a seat. */
    public enum Sensor { FLOOR, FRAME, DEFLECTION, SPRING, TRUNK }

    /**
     * A sensor that says nothing any more.
     *
     * @param from when [s]
     */
    public record Silence(Sensor sensor, double from) {}

    /**
     * Another sitter.
     *
     * @param at when [s]
     */
    public record Change(Subject to, double at) {}

    public Faults {
        if (!(loss >= 0 && loss <= 1)) {
            throw new IllegalArgumentException("share of lost readings must be 0 to 1: " + loss);
        }
        if (!(delay >= 0 && delay <= 0.05)) {
            throw new IllegalArgumentException("a further delay must be 0 to 0.05 s: " + delay);
        }
    }
}
