package wbv.diagnosis.fit;

import java.util.Locale;
import java.util.stream.IntStream;
import wbv.diagnosis.measured.Measured;
import wbv.recording.DataFault;

/**
 * The two stretches of a recording that it is judged in.
 *
 * @param fit     what models are fitted in
 * @param heldOut what is kept from fits, to prove them
 */
public record Windows(Window fit, Window heldOut) {

    /** Time from the start in which motion is still that of what was before [s], and part of a short record that it is at most. */
    public static final double SETTLING = 2;
    /** The most of a record that this may take, as a share of its length. */
    public static final double SETTLING_SHARE = 0.05;
    /** Time at the end that answers to what comes after it, which no filter has seen [s]. */
    private static final double END = 0.6;
    /** Part of an output that must count. */
    private static final double LEAST_VALID = 0.25;

    /**
     * Fitted at the beginning and proved at the end; on a rig over all samples and with constants.
     *
     * @throws DataFault if too little of an output of a sitter counts in one of them
     */
    static Windows of(Measured measured) {
        int split = measured.split();
        int start = start(measured);
        int proof = measured.isChosen() ? split + start : split;   // another ride begins with what nobody saw before it
        Windows all = new Windows(of(start, split - start, measured), toEnd(proof, measured));
        return measured.onRig() ? all : all.counted(measured);
    }

    /** On a rig with constants. */
    private static Window of(int from, int length, Measured measured) {
        double rate = measured.recording().clock().rate();
        return measured.onRig() ? new Window(from, length, rate, 0) : new Window(from, length, rate);
    }

    /** Fitted at the end and proved at the beginning, for what shows only late. */
    static Windows late(Measured measured) {
        int start = start(measured);
        int split = measured.recording().length() - measured.split();
        return new Windows(toEnd(split, measured), of(start, split - start, measured));
    }

    /** Fitted in all there is, which proves nothing then. */
    static Windows whole(Measured measured) {
        Window all = toEnd(start(measured), measured);
        return new Windows(all, all);
    }

    private static int start(Measured measured) {
        double settling = SETTLING * measured.recording().clock().rate();
        return measured.model().driven() ? 0
                : (int) Math.round(measured.onRig() ? Math.min(settling, SETTLING_SHARE * measured.recording().length()) : settling);
    }

    private static Window toEnd(int from, Measured measured) {
        int left = measured.recording().length() - from;
        return of(from, measured.onRig() ? left : left - (int) (END * measured.recording().clock().rate()), measured);
    }

    /** Whether it is the end of the recording that is fitted. */
    boolean isLate() {
        return fit.start() > heldOut.start();
    }

    private Windows counted(Measured measured) {
        counted(measured, fit, "fit");
        counted(measured, heldOut, "prove anything on");
        return this;
    }

    private static void counted(Measured measured, Window window, String what) {
        double rate = measured.recording().clock().rate();
        int end = window.start() + window.length();
        for (int o = 0; o < measured.outputs().size(); o++) {
            boolean[] valid = measured.valid(o);
            long counted = IntStream.range(window.start(), end).filter(i -> valid[i]).count();
            if (counted < LEAST_VALID * window.length()) {
                throw new DataFault(String.format(Locale.ROOT,
                        "between %.4g and %.4g s only %.0f %% of %s counts, the rest is lost there or in the input: "
                                + "too little to %s; cut the recording, or take the sensor out of the model",
                        window.start() / rate, end / rate, 100.0 * counted / window.length(), measured.outputs().get(o), what));
            }
        }
    }
}
