package wbv.live;

import java.util.Locale;
import wbv.exposure.Directive;
import wbv.seat.SeatResult;

/**
 * How much a seat needs someone to look after it, and why: a person beyond the limit value first, then a seat that nothing is known
 * of, sensors that fail, the action value reached or near. Equal ones by their exposure.
 *
 * @param rank  the higher, the sooner
 * @param tone  a class of the page's style sheet
 * @param words in words; empty if nothing is the matter
 */
record Attention(double rank, String tone, String words) {

    /** Time ahead at which the action value counts as near [min]. */
    private static final double NEAR = 30;

    static Attention of(LiveSeat seat) {
        SeatResult.Exposure exposure = seat.latest().flatMap(SeatResult::exposure).orElse(null);
        double share = exposure == null ? 0
                : Math.min(0.99, Math.max(exposure.a8() / Directive.LIMIT.a8(), exposure.vdv() / Directive.LIMIT.vdv()) / 4);
        Directive.Verdict verdict = exposure == null ? Directive.Verdict.UNKNOWN : exposure.verdict();
        if (verdict == Directive.Verdict.ABOVE_LIMIT) {
            return new Attention(6 + share, "fault", "above the limit value");
        }
        if (seat.refused()) {
            return new Attention(5 + share, "fault", "its samples cannot be used");
        }
        if (seat.silent()) {
            return new Attention(4 + share, "fault", "no samples come");
        }
        int ailing = seat.begun() ? seat.watch().ailing() : 0;
        if (ailing > 0) {
            return new Attention(3 + share, "warning", ailing + (ailing == 1 ? " channel fails" : " channels fail"));
        }
        if (verdict == Directive.Verdict.ABOVE_ACTION) {
            return new Attention(2 + share, "warning", "above the action value");
        }
        if (exposure != null && exposure.minutesToAction() < NEAR && exposure.seconds() > 60) {
            return new Attention(1 + share, "warning",
                    String.format(Locale.ROOT, "action value in %.0f min", Math.max(1, exposure.minutesToAction())));
        }
        return new Attention(share, exposure == null ? "plain" : "good", "");
    }
}
