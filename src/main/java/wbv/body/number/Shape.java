package wbv.body.number;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What a term of a learned law goes by: a power of a link's deflection r times one of its speed v, such as {@code |v|v} or {@code r^2 v}.
 *
 * @param deflection what it takes of r [m]
 * @param speed what it takes of v [m/s]
 */
public record Shape(Part deflection, Part speed) {

    /** Whatever the motion, 1. */
    public static final Shape ONE = new Shape(Part.ONE, Part.ONE);
    /** The deflection itself [m]. */
    public static final Shape DEFLECTION = new Shape(Part.PLAIN, Part.ONE);
    /** The speed itself [m/s]. */
    public static final Shape SPEED = new Shape(Part.ONE, Part.PLAIN);

    /** Half a sign is reached at 0.58 of this: what is as small has none yet. */
    private static final double NO_DEFLECTION = 1e-5;
    private static final double NO_SPEED = 1e-3;

    /** A function of one variable x. */
    public enum Part {
        ONE("1", 0), PLAIN("x", 1), MAGNITUDE("|x|", 1), SQUARE("x^2", 2), SIGNED_SQUARE("|x|x", 2), CUBE("x^3", 3), SIGN("sign(x)", 0),
        POSITIVE("x+", 1), NEGATIVE("x-", 1), POSITIVE_SQUARE("x+^2", 2), NEGATIVE_SQUARE("x-^2", 2);

        private final String pattern;
        private final int power;

        Part(String pattern, int power) {
            this.pattern = pattern;
            this.power = power;
        }

        /** @param small an x without a sign yet */
        private double of(double x, double small) {
            return switch (this) {
                case ONE -> 1;
                case PLAIN -> x;
                case MAGNITUDE -> Math.abs(x);
                case SQUARE -> x * x;
                case SIGNED_SQUARE -> Math.abs(x) * x;
                case CUBE -> x * x * x;
                case SIGN -> x / Math.sqrt(x * x + small * small);
                case POSITIVE -> Math.max(x, 0);
                case NEGATIVE -> Math.min(x, 0);
                case POSITIVE_SQUARE -> x > 0 ? x * x : 0;
                case NEGATIVE_SQUARE -> x < 0 ? x * x : 0;
            };
        }

        private String text(String name) {
            return pattern.replace("x", name);
        }

        private static Optional<Part> of(String text, String name) {
            return Arrays.stream(values()).filter(part -> part != ONE && part.text(name).equals(text)).findFirst();
        }

        /** Which power of the variable it is. */
        public int power() {
            return power;
        }
    }

    /**
     * Its value, in its own unit, {@link #unit}.
     *
     * @param r deflection [m]
     * @param v speed [m/s]
     */
    public double of(double r, double v) {
        return (deflection == Part.ONE ? 1 : deflection.of(r, NO_DEFLECTION)) * (speed == Part.ONE ? 1 : speed.of(v, NO_SPEED));
    }

    /** Whether it is the deflection itself or the speed itself. */
    public boolean isLinear() {
        return equals(DEFLECTION) || equals(SPEED);
    }

    /**
     * Reads {@code |v|v}, {@code r^2 v} or {@code 1}.
     *
     * @throws IllegalArgumentException if it is none: the message says what is known
     */
    public static Shape parse(String text) {
        Shape out = ONE;
        for (String word : text.equals("1") ? new String[0] : text.split(" ")) {
            Optional<Part> r = Part.of(word, "r");
            Optional<Part> v = Part.of(word, "v");
            boolean twice = r.isPresent() ? out.deflection != Part.ONE : out.speed != Part.ONE;
            if (r.isEmpty() && v.isEmpty() || twice) {
                throw new IllegalArgumentException("'" + text + "' is no shape of a law: 1, or one of "
                        + Arrays.stream(Part.values()).filter(part -> part != Part.ONE).map(part -> part.text("r"))
                                .collect(Collectors.joining(", "))
                        + ", or the same of v, or one of each as in 'r^2 v'");
            }
            out = new Shape(r.orElse(out.deflection), v.orElse(out.speed));
        }
        return out;
    }

    /** Unit of its value, to be written behind a number of newtons per that: {@code m²·(m/s)}; empty for none. */
    public String unit() {
        return Units.product(Units.power("m", deflection.power()), Units.power("(m/s)", speed.power()));
    }

    @Override
    public String toString() {
        String r = deflection == Part.ONE ? "" : deflection.text("r");
        String v = speed == Part.ONE ? "" : speed.text("v");
        return r.isEmpty() && v.isEmpty() ? "1" : r + (r.isEmpty() || v.isEmpty() ? "" : " ") + v;
    }
}
