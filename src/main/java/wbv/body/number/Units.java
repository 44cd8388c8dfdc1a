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

    /**
     * The unit of what multiplies a link's motion where the link is about an axis: it carries moments and turns, {@code N·m/(rad/s)}.
     *
     * @param unit along an axis
     * @param modulated whether its force goes by something beside, which is another's and keeps its unit
     */
    public static String about(String unit, boolean modulated) {
        String moment = unit.replaceFirst("^N", "N·m");
        int per = moment.indexOf('/');
        String below = per < 0 ? "" : moment.substring(per);
        return moment.substring(0, per < 0 ? moment.length() : per)
                + (modulated ? below.replaceFirst("m", "rad") : below.replace("m", "rad"));
    }

    /** Newtons per something; newtons where it is empty. */
    public static String newtonsPer(String unit) {
        return unit.isEmpty() ? "N" : unit.contains("·") ? "N/(" + unit + ")" : "N/" + unit;
    }
}
