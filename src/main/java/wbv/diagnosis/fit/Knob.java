package wbv.diagnosis.fit;

import java.util.List;
import java.util.stream.Stream;

/**
 * A number of an assembly that a fit may move, in a coordinate x in which it is well scaled: {@code value = reference e^x} or
 * {@code value = reference + unit x}.
 *
 * @param name       what it is, with its place: {@code seat-torso stiffness_N_per_m}
 * @param slot       where it stands
 * @param reference  value at x = 0, in the unit of the number
 * @param unit       in that unit, size of one x for an additive knob; 0 for a multiplicative one
 * @param low        least x [1]
 * @param high       greatest x [1]
 * @param deviation  standard deviation of x [1] before the data are seen; infinite where nothing is known
 * @param tied       other numbers that go with it
 */
public record Knob(String name, Slot slot, double reference, double unit, double low, double high, double deviation, List<Tied> tied) {

    /** A number that is a knob's value times a factor. */
    record Tied(Slot slot, double factor) {}

    /**
     * One of a single number.
     *
     * @param reference in the unit of the number
     * @param unit likewise
     * @param low [1]
     * @param high [1]
     * @param deviation [1]
     */
    public Knob(String name, Slot slot, double reference, double unit, double low, double high, double deviation) {
        this(name, slot, reference, unit, low, high, deviation, List.of());
    }

    public Knob {
        tied = List.copyOf(tied);
        if (!(low < high)) {
            throw new IllegalArgumentException(name + " must have room to move: " + low + " to " + high);
        }
        if (!(deviation > 0)) {
            throw new IllegalArgumentException(name + " must have a standard deviation > 0: " + deviation);
        }
    }

    /** Whether it is a stiffness or damping of a link, found as a factor of what was given. */
    public boolean isOfLink() {
        return unit == 0 && (slot.kind() == Slot.Kind.STIFFNESS || slot.kind() == Slot.Kind.DAMPING);
    }

    /** Whether it is when something happens, which slopes do not find. A time that something takes is found by factors. */
    public boolean isMoment() {
        return unit != 0 && name.endsWith("time_s");
    }

    /**
     * Multiplicative.
     *
     * @param low
     * @param high as values, of the sign of the reference
     */
    static Knob factor(String name, Slot slot, double reference, double low, double high, double deviation) {
        return new Knob(name, slot, reference, 0, Math.log(low / reference), Math.log(high / reference), deviation);
    }

    /**
     * Additive.
     *
     * @param low
     * @param high as values
     */
    static Knob sum(String name, Slot slot, double reference, double unit, double low, double high, double deviation) {
        return new Knob(name, slot, reference, unit, (low - reference) / unit, (high - reference) / unit, deviation);
    }

    /**
     * The same of a number in a unit that is so many times smaller.
     *
     * @param factor [1]
     */
    public Knob scaled(double factor) {
        return new Knob(name, slot, factor * reference, factor * unit, low, high, deviation, tied);
    }

    /**
     * The same, known at least so well.
     *
     * @param most standard deviation of x [1]
     */
    Knob surer(double most) {
        return new Knob(name, slot, reference, unit, low, high, Math.min(most, deviation), tied);
    }

    /** With another number that goes with it. */
    Knob tied(Slot other, double factor) {
        return new Knob(name, slot, reference, unit, low, high, deviation,
                Stream.concat(tied.stream(), Stream.of(new Tied(other, factor))).toList());
    }

    /** Whose number it is. */
    public String place() {
        return name.substring(0, name.lastIndexOf(' '));
    }

    /** What it is, with its unit; it holds no space, a place may. */
    public String key() {
        return name.substring(name.lastIndexOf(' ') + 1);
    }

    /**
     * The number at a coordinate, in its own unit.
     *
     * @param x [1]
     */
    public double value(double x) {
        return unit == 0 ? reference * Math.exp(x) : reference + unit * x;
    }

    /**
     * The coordinate [1] of a value, kept within bounds.
     *
     * @param value in the unit of the number
     */
    public double coordinate(double value) {
        double x = unit == 0 ? Math.log(value / reference) : (value - reference) / unit;
        return within(x);
    }

    /**
     * The nearest coordinate [1] within bounds.
     *
     * @param x [1]
     */
    public double within(double x) {
        return Math.max(low, Math.min(high, x));
    }

    /**
     * d value / d x, in the unit of the number.
     *
     * @param x coordinate [1]
     */
    public double slope(double x) {
        return unit == 0 ? reference * Math.exp(x) : unit;
    }
}
