package wbv.body.number;

/** Units put together from others. */
public final class Units {

    private Units() {}

    /** {@code m²}; empty for no power. */
    static String power(String unit, int power) {
        return switch (power) {
            case 0 -> "";
            case 1 -> unit;
            case 2 -> unit + "²";
            default -> unit + "³";
        };
    }

    /** {@code m·s}; {@code m²} of two that are one; the other where one is empty. */
    public static String product(String a, String b) {
        return a.isEmpty() || b.isEmpty() ? a + b : a.equals(b) ? power(a, 2) : a + "·" + b;
    }

    /** Newtons per something; newtons where it is empty. */
    public static String newtonsPer(String unit) {
        return unit.isEmpty() ? "N" : unit.contains("·") ? "N/(" + unit + ")" : "N/" + unit;
    }
}
