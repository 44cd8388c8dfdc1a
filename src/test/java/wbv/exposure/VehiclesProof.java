package wbv.exposure;

import java.util.List;
import java.util.Locale;

/**
 * The derived columns of the thesis' Table 2-3 from its own inputs, row by row: estimated dose {@code 1.4 a T^(1/4)} and
 * {@code A(8) = a (T / 8 h)^(1/2)}. Prints the table of docs/thesis.md, chapter 2.
 */
final class VehiclesProof {

    /**
     * A row as printed.
     *
     * @param hours NaN where none is printed @param low @param high a_w [m/s²] @param dose [m/s^1.75] @param a8 [m/s²], NaN if none
     */
    record Row(String vehicle, double hours, double low, double high, double dose, boolean doseIsEstimated, double a8) {

        double estimatedLow() {
            return Vibration.estimatedDose(low, hours * 3600);
        }

        double estimatedHigh() {
            return Vibration.estimatedDose(high, hours * 3600);
        }

        double a8Low() {
            return low * Math.sqrt(hours / 8);
        }

        double a8High() {
            return high * Math.sqrt(hours / 8);
        }
    }

    /** In the order of the print; a star there marks what was estimated. */
    static final List<Row> ROWS = List.of(
            new Row("skidder, \"loaded\"", 7, 1.83, 1.83, 23.057, true, 1.718),
            new Row("skidder, \"unloaded\"", 7, 2.1, 2.1, 26.459, true, 1.964),
            new Row("bus, urban", 5.5, 0.41, 0.41, 9.4, false, 0.34),
            new Row("bus, rough surface", 0.17, 1.51, 1.51, 10.5, false, 0.53),
            new Row("tractor", 0.17, 31, 31, 26, false, 4.475),
            new Row("rapid mixer granulator", Double.NaN, 20, 20, 35, false, 3.464),
            new Row("gantry crane on tyres", 0.016667, 24, 24, 26, false, Double.NaN),
            new Row("sprayer", 10.1, 0.53, 0.69, 11.426, true, 0.775),
            new Row("tractor sprayer", 8.9, 0.36, 0.78, 10.676, true, 0.823),
            new Row("ploughing", 8.9, 0.49, 0.93, 13.299, true, 0.9809),
            new Row("cultivating", 8.9, 0.53, 1.39, 17.98, true, 1.099),
            new Row("garbage truck", 5, 0.31, 0.31, 2.64, false, 2.087),
            new Row("front-end loader", 8, 0.31, 0.31, 9.2, false, 0.47),
            new Row("aircraft landing, front and rear", 0.01667, 0.6, 0.9, 5.2, false, 0.041),
            new Row("truck", 1, 1.418, 1.418, 15.377, true, 0.501));

    private VehiclesProof() {}

    public static void main(String[] args) {
        System.out.println("| vehicle | T [h] | a_w [m/s²] | VDV printed | 1.4 a_w T^¼ is | A(8) printed | a_w (T/8)^½ is |");
        System.out.println("|---|---|---|---|---|---|---|");
        for (Row row : ROWS) {
            System.out.printf(Locale.ROOT, "| %s | %s | %s | %s%s | %s | %s | %s |%n", row.vehicle(), text(row.hours()),
                    between(row.low(), row.high()), text(row.dose()), row.doseIsEstimated() ? "*" : "",
                    between(row.estimatedLow(), row.estimatedHigh()), text(row.a8()), between(row.a8Low(), row.a8High()));
        }
    }

    private static String between(double low, double high) {
        return low == high || Double.isNaN(low) ? text(low) : text(low) + " to " + text(high);
    }

    private static String text(double value) {
        return Double.isNaN(value) ? "–"
                : String.format(Locale.ROOT, "%.4g", value).replaceAll("(\\.\\d*?)0+$", "$1").replaceAll("\\.$", "");
    }
}
