package wbv.exposure;

import java.util.ArrayList;
import java.util.List;

/**
 * The frequency weightings of whole-body vibration (ISO 8041-1:2017 Table 3 and Formulae (1) to (5); ISO 2631-1:1997).
 *
 * <p>{@code H(s) = Hh(s) Hl(s) Ht(s) Hs(s)}: band limits with Q = 1/√2, then
 * {@code Ht = K (1 + s/ω3) / (1 + s/(Q4 ω4) + (s/ω4)²)} from acceleration to velocity, then the upward step
 * {@code Hs = (ω5/ω6)² (1 + s/(Q5 ω5) + (s/ω5)²) / (1 + s/(Q6 ω6) + (s/ω6)²)}. A corner at infinity makes its part 1.
 */
public enum Weighting {
    /** Vertical, seat and standing. */
    WK("Wk", 0.4, 100, new Transition(12.5, 12.5, 0.63, 1), new Step(2.37, 0.91, 3.35, 0.91), Range.WHOLE_BODY),
    /** Horizontal, seat and standing; lateral and vertical at a backrest. */
    WD("Wd", 0.4, 100, new Transition(2, 2, 0.63, 1), Step.NONE, Range.WHOLE_BODY),
    /** Motion sickness, vertical. */
    WF("Wf", 0.08, 0.63, new Transition(Double.POSITIVE_INFINITY, 0.25, 0.86, 1), new Step(0.0625, 0.80, 0.10, 0.80),
            new Range(0.1, 0.5, -13, -9, -4, 0)),
    /** Fore and aft at a backrest. */
    WC("Wc", 0.4, 100, new Transition(8, 8, 0.63, 1), Step.NONE, Range.WHOLE_BODY),
    /** Rotation: angular accelerations. */
    WE("We", 0.4, 100, new Transition(1, 1, 0.63, 1), Step.NONE, Range.WHOLE_BODY),
    /** Under the head of one who lies. */
    WJ("Wj", 0.4, 100, Transition.NONE, new Step(3.75, 0.91, 5.32, 0.91), Range.WHOLE_BODY),
    /** Vertical in rail vehicles (ISO 2631-4). */
    WB("Wb", 0.4, 100, new Transition(16, 16, 0.55, 1.024), new Step(2.5, 0.9, 4, 0.95), Range.WHOLE_BODY),
    /** Any direction in buildings (ISO 2631-2). */
    WM("Wm", Math.pow(10, -0.1), 100, new Transition(1 / (0.028 * 2 * Math.PI), 1 / (0.028 * 2 * Math.PI), 0.5, 1), Step.NONE,
            new Range(1, 80, -3, 1, 18, 22)),
    /** The band limits 0.4 and 100 Hz alone: acceleration that is counted, not weighted. */
    BAND("band-limited", 0.4, 100, Transition.NONE, Step.NONE, Range.WHOLE_BODY);

    private final String symbol;
    private final AnalogFilter filter;
    private final Range range;

    Weighting(String symbol, double from, double to, Transition transition, Step step, Range range) {
        this.symbol = symbol;
        this.range = range;
        List<AnalogSection> sections = new ArrayList<>(List.of(AnalogSection.highPass(from, Math.sqrt(0.5)),
                AnalogSection.lowPass(to, Math.sqrt(0.5))));
        if (transition != Transition.NONE) {
            double zero = 2 * Math.PI * transition.f3;
            double pole = 2 * Math.PI * transition.f4;
            sections.add(new AnalogSection(transition.gain, transition.gain / zero, 0, 1, 1 / (transition.q4 * pole),
                    1 / (pole * pole)));
        }
        if (step != Step.NONE) {
            double zero = 2 * Math.PI * step.f5;
            double pole = 2 * Math.PI * step.f6;
            double gain = zero * zero / (pole * pole);
            sections.add(new AnalogSection(gain, gain / (step.q5 * zero), gain / (zero * zero), 1, 1 / (step.q6 * pole),
                    1 / (pole * pole)));
        }
        this.filter = new AnalogFilter(sections, from);
    }

    /** As the standards write it. */
    public String symbol() {
        return symbol;
    }

    /** From acceleration to weighted acceleration, band limits included. */
    public AnalogFilter filter() {
        return filter;
    }

    /** The factor at a frequency [Hz]. */
    public double factor(double frequency) {
        return filter.modulus(frequency);
    }

    /** Where the nominal frequency range begins [Hz]. */
    public double nominalFrom() {
        return range.from;
    }

    /** Where the nominal frequency range ends [Hz]. */
    public double nominalTo() {
        return range.to;
    }

    /** Parts by which an instrument may read too little and too much at a frequency [Hz] (ISO 8041-1 Tables 4 and 5). */
    public Tolerance tolerance(double frequency) {
        double band = Math.rint(1e6 * 10 * Math.log10(frequency)) / 1e6; // the transitions are powers of ten themselves
        if (band <= range.first || band >= range.fourth) {
            return new Tolerance(1, 0.26);
        }
        return band < range.second || band > range.third ? new Tolerance(0.21, 0.26) : new Tolerance(0.11, 0.12);
    }

    /**
     * How far a weighting may be off at a frequency.
     *
     * @param below share that may be lacking, 0 to 1
     * @param above share that may be too much
     */
    public record Tolerance(double below, double above) {}

    /**
     * @param gain K
     * @param f3 [Hz]
     * @param f4 [Hz]
     */
    private record Transition(double f3, double f4, double q4, double gain) {
        private static final Transition NONE = new Transition(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 1);
    }

    /**
     * @param f5 [Hz]
     * @param f6 [Hz]
     */
    private record Step(double f5, double q5, double f6, double q6) {
        private static final Step NONE = new Step(Double.POSITIVE_INFINITY, 1, Double.POSITIVE_INFINITY, 1);
    }

    /** Nominal range [Hz], and the transitions of the tolerances in tenths of decades from 1 Hz. */
    private record Range(double from, double to, int first, int second, int third, int fourth) {
        private static final Range WHOLE_BODY = new Range(0.5, 80, -6, -2, 18, 22);
    }
}
