package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Window;
import wbv.signal.ScalarProduct;

/** Bands in which errors are told: edges at 1, 2, 5, 10 Hz and so on, as far as there is signal. */
final class Bands {

    private static final double[] STEPS = {1, 2, 5};
    /** Part of the signal's power below and above which nothing is divided further. */
    private static final double TAIL = 0.005;
    private static final double NARROWEST = 1.5;
    private static final int LEAST_LINES = 12;
    private static final int MOST = 6;

    private Bands() {}

    /** Rising edges over a window's lines [Hz], the window's own ends included. */
    static double[] edges(Evidence evidence, Window window) {
        double[] power = new double[window.lines()];
        double total = 0;
        for (int o = 0; o < evidence.outputs().size(); o++) {
            double[] y = window.spectrum(evidence.measured(o), evidence.valid(o));
            double size = ScalarProduct.of(y, y);
            for (int line = 0; line < power.length && size > 0; line++) {
                double part = (y[2 * line] * y[2 * line] + y[2 * line + 1] * y[2 * line + 1]) / size;
                power[line] += part;
                total += part;
            }
        }
        double low = window.frequency(0);
        double high = window.frequency(power.length - 1);
        double from = reached(window, power, TAIL * total);
        double to = reached(window, power, (1 - TAIL) * total);
        List<Double> edges = new ArrayList<>(List.of(low));
        double spacing = (high - low) / Math.max(1, power.length - 1);
        for (int decade = -2; decade <= 4; decade++) {
            for (double step : STEPS) {
                double edge = step * Math.pow(10, decade);
                double last = edges.get(edges.size() - 1);
                if (edge > from && last < to && edge > NARROWEST * last && high > NARROWEST * edge
                        && edge - last > LEAST_LINES * spacing
                        && edges.size() < MOST) {
                    edges.add(edge);
                }
            }
        }
        edges.add(high);
        return edges.stream().mapToDouble(e -> e).toArray();
    }

    /** The frequency up to which there is so much power. */
    private static double reached(Window window, double[] power, double wanted) {
        double sum = 0;
        for (int line = 0; line < power.length; line++) {
            sum += power[line];
            if (sum >= wanted) {
                return window.frequency(line);
            }
        }
        return window.frequency(power.length - 1);
    }
}
