package wbv.filter;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import wbv.filter.model.Bounds;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/** Bounds that hold all the time. */
public record FixedBounds(List<Bound> each) implements Constraint {

    /**
     * One of them.
     *
     * @param mode 0 or 1
     * @param low in the unit of the attribute
     * @param high likewise
     */
    public record Bound(int mode, Bounds.Attribute attribute, double low, double high) implements java.io.Serializable {

        public Bound {
            if (mode < 0 || mode >= Bounds.MODES) {
                throw new IllegalArgumentException("a body has modes 1 and 2: " + (mode + 1));
            }
            if (!(low <= high)) {
                throw new IllegalArgumentException("lower bound of " + attribute.name().toLowerCase(Locale.ROOT)
                        + " must be <= the upper: " + low + ", " + high);
            }
        }
    }

    public FixedBounds {
        each = List.copyOf(each);
    }

    /**
     * Reads bounds separated by commas, such as {@code frequency=3:6,damping=0.2:0.5,real=-12:-8,2.imaginary=40:}; an end left
     * out is no bound, and {@code 2.} before a name means the faster mode.
     *
     * @return {@link Constraint#NONE} for an empty text
     * @throws IllegalArgumentException if the text is none of these
     */
    public static Constraint parse(String text) {
        if (text.isBlank()) {
            return NONE;
        }
        List<Bound> found = new ArrayList<>();
        for (String word : text.split(",")) {
            found.add(bound(word.trim()));
        }
        return new FixedBounds(found);
    }

    private static Bound bound(String word) {
        String[] sides = word.split("=", 2);
        String[] ends = sides.length == 2 ? sides[1].split(":", -1) : new String[0];
        if (ends.length != 2) {
            throw new IllegalArgumentException("a bound is written like frequency=3:6: '" + word + "'");
        }
        boolean second = sides[0].startsWith("2.");
        String name = second || sides[0].startsWith("1.") ? sides[0].substring(2) : sides[0];
        return new Bound(second ? 1 : 0, attribute(name), number(ends[0], Double.NEGATIVE_INFINITY, word),
                number(ends[1], Double.POSITIVE_INFINITY, word));
    }

    private static Bounds.Attribute attribute(String name) {
        return Arrays.stream(Bounds.Attribute.values()).filter(a -> a != Bounds.Attribute.BASE_SHARE)
                .filter(a -> a.name().equalsIgnoreCase(name)).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("what can be bounded is one of "
                        + Arrays.stream(Bounds.Attribute.values()).filter(a -> a != Bounds.Attribute.BASE_SHARE)
                                .map(a -> a.name().toLowerCase(Locale.ROOT))
                                .collect(Collectors.joining(", "))
                        + ": '" + name + "'"));
    }

    private static double number(String text, double none, String word) {
        try {
            return text.isBlank() ? none : Double.parseDouble(text);
        } catch (NumberFormatException wrong) {
            throw new IllegalArgumentException("a bound has numbers for ends, or nothing: '" + word + "'", wrong);
        }
    }

    @Override
    public void at(long sample, Bounds bounds) {
        for (int i = 0; i < each.size(); i++) {
            Bound bound = each.get(i);
            bounds.set(bound.mode(), bound.attribute(), bound.low(), bound.high());
        }
    }

    @Override
    public void reset() {}

    /** Bounds that hold all the time have no memory. */
    @Override
    public void save(StateWriter out) {}

    @Override
    public void load(StateReader in) {}
}
