package wbv.study;

import java.util.Arrays;
import java.util.List;
import wbv.result.Digits;
import wbv.signal.Backing;

/** Where a frequency response is not to be used, and why: in words, for files and people. */
public final class Unbacked {

    private Unbacked() {}

    /**
     * Why, as a clause.
     *
     * @param several whether there are several inputs
     */
    public static String words(Backing reason, boolean several) {
        return reason == Backing.NOT_CAUSED && several ? "not caused by these inputs alone" : reason.words();
    }

    /** What a file says of each frequency; empty where the response may be used. */
    static String[] reasons(Backing[] backing, boolean several) {
        return Arrays.stream(backing).map(each -> each == Backing.USABLE ? "" : words(each, several)).toArray(String[]::new);
    }

    /** What backs at least one of several responses, or the weightiest reason why none is backed. */
    public static Backing[] any(List<Backing[]> all) {
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
     * in 1 % of cases, one in twenty being taken wrongly. Not modified. Hann's window makes neighbours alike: every other one counts.
     *
     * @param from   first bin to be counted
     * @param others the other motions of the inputs' place
     */
    public static String sentence(Backing[] backing, int from, boolean several, OtherAxes others, int output) {
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

    /**
     * How often something backs or fails, from a bin on.
     *
     * @param backing Not modified.
     */
    public static long count(Backing[] backing, int from, Backing what) {
        return Arrays.stream(backing).skip(from).filter(what::equals).count();
    }
}
