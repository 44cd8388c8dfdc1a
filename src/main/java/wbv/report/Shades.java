package wbv.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import wbv.signal.Backing;

/** Where a frequency response is not to be used, and why: what a chart shades, and what files say. */
final class Shades {

    private Shades() { }

    /**
     * Shaded ranges, from halfway to the neighbours.
     *
     * @param at      rising frequencies [Hz]
     * @param several whether there are several inputs
     */
    static List<LineChart.Shade> of(Backing[] backing, double[] at, boolean several) {
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
                    i + 1 == backing.length ? at[i] : (at[i] + at[i + 1]) / 2, words(reason, several), pattern(reason)));
        }
        return found;
    }

    static String words(Backing reason, boolean several) {
        return reason == Backing.NOT_CAUSED && several ? "not caused by these inputs alone" : reason.words();
    }

    private static int pattern(Backing reason) {
        return switch (reason) {
            case NOT_CAUSED -> 1;
            case IN_DOUBT -> 2;
            default -> 0;
        };
    }

    /** What a file says of each frequency; empty where the response may be used. */
    static String[] reasons(Backing[] backing, boolean several) {
        return Arrays.stream(backing).map(each -> each == Backing.USABLE ? "" : words(each, several)).toArray(String[]::new);
    }

    /** What backs at least one of several responses, or the weightiest reason why none is backed. */
    static Backing[] any(List<Backing[]> all) {
        Backing[] any = all.get(0).clone();
        for (Backing[] each : all) {
            for (int k = 0; k < any.length; k++) {
                if (each[k] == Backing.USABLE || any[k] == Backing.NOT_EXCITED) {
                    any[k] = any[k] == Backing.USABLE ? any[k] : each[k];
                }
            }
        }
        return any;
    }

    /**
     * A sentence on the frequencies that have the power but not the coherence; empty if they are no more than chance takes for such
     * in 1 % of cases, one in twenty being taken wrongly. Hann's window makes neighbours alike: every other one counts.
     *
     * @param from   first bin to be counted
     * @param others the other motions of the inputs' place
     */
    static String sentence(Backing[] backing, int from, boolean several, OtherAxes others, int output) {
        long caused = count(backing, from, Backing.NOT_CAUSED);
        int excited = (int) (backing.length - from - count(backing, from, Backing.NOT_EXCITED));
        if (!Backing.isBeyondChance(caused, excited)) {
            return "";
        }
        String what = words(Backing.NOT_CAUSED, several) + " at " + caused + " of " + excited + " excited frequencies";
        return what + others.likeliest(output, backing).map(found -> ": highest partial coherence there with " + found.channel() + " ("
                + Digits.significant(found.partial(), 2) + " at " + found.bins() + " of them)").orElse(others.recorded()
                ? ": none of the other motions recorded there shows in it" : "");
    }

    static long count(Backing[] backing, int from, Backing what) {
        return Arrays.stream(backing).skip(from).filter(what::equals).count();
    }
}
