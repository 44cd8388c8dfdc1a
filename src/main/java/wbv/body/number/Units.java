package wbv.body.number;

/** Units put together from others. */
public final class Units {

    private static final String RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

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

    /** {@code ·10⁹}, what a number is multiplied by of which zeros would have to be counted; empty for no power. */
    public static String timesTen(int power) {
        StringBuilder raised = new StringBuilder();
        Integer.toString(power).chars().forEach(c -> raised.append(c == '-' ? '⁻' : RAISED.charAt(c - '0')));
        return power == 0 ? "" : "·10" + raised;
    }

    /** Newtons per something; newtons where it is empty. */
    public static String newtonsPer(String unit) {
        return unit.isEmpty() ? "N" : unit.contains("·") ? "N/(" + unit + ")" : "N/" + unit;
    }
}
