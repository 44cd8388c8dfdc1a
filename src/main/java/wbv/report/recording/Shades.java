package wbv.report.recording;

import java.util.ArrayList;
import java.util.List;
import wbv.report.page.LineChart;
import wbv.signal.Backing;
import wbv.study.Unbacked;

/** Where a frequency response is not to be used, as a chart shades it. */
public final class Shades {

    private Shades() {}

    /**
     * Shaded ranges, from halfway to the neighbours. Neither array is modified.
     *
     * @param at      by bin, rising frequencies [Hz]
     * @param several whether there are several inputs
     */
    public static List<LineChart.Shade> of(Backing[] backing, double[] at, boolean several) {
        List<LineChart.Shade> found = new ArrayList<>();
        for (int i = 0; i < backing.length; i++) {
            Backing reason = backing[i];
            if (reason == Backing.USABLE) {
                continue;
            }
            int from = i;
            while (i + 1 < backing.length && backing[i + 1] == reason) {
                i++;
            }
            found.add(new LineChart.Shade(from == 0 ? at[0] : (at[from - 1] + at[from]) / 2,
                    i + 1 == backing.length ? at[i] : (at[i] + at[i + 1]) / 2, Unbacked.words(reason, several), pattern(reason)));
        }
        return found;
    }

    private static int pattern(Backing reason) {
        return switch (reason) {
            case NOT_CAUSED -> 1;
            case IN_DOUBT, BELOW_NOISE -> 2;
            default -> 0;
        };
    }
}
