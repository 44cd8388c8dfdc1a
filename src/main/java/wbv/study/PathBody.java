package wbv.study;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import wbv.filter.model.Spec;
import wbv.identify.EquivalentBody;
import wbv.recording.Channel;

/**
 * What is said of the body between the base and one output: the numbers of its {@link EquivalentBody}, or why there are none.
 *
 * @param output what answers
 * @param others motions of the base, beside the input, that were found to move the output too
 * @param body   empty if none could be fitted
 * @param doubt  why its numbers do not stand; empty if they do
 */
public record PathBody(Channel output, List<Channel> others, Optional<EquivalentBody> body, String doubt) {

    public PathBody {
        others = List.copyOf(others);
        if (body.isEmpty() && doubt.isEmpty()) {
            throw new IllegalArgumentException("where there is no body, a reason is needed: " + output);
        }
    }

    /**
     * What a fit says.
     *
     * @param motions those that {@link EquivalentBody#others} counts
     * @param rate of the recording [Hz], which bounds what can be believed
     */
    public static PathBody of(Channel output, EquivalentBody body, List<Channel> motions, double rate) {
        return new PathBody(output, body.others().stream().map(motions::get).toList(), Optional.of(body), doubt(body, rate));
    }

    static PathBody none(Channel output, String why) {
        return new PathBody(output, List.of(), Optional.empty(), why);
    }

    private static String doubt(EquivalentBody body, double rate) {
        if (!body.carries()) {
            return body.share() > 0
                    ? "a body explains only " + percent(body.share())
                            + (body.others().isEmpty() ? " of this motion" : " of what the base's other motions leave")
                    : "no body moves like this";
        }
        EquivalentBody.Mode slowest = body.modes().get(0);
        if (body.modes().stream().noneMatch(EquivalentBody.Mode::oscillates)) {
            return String.format(Locale.ROOT, "follows its base without a resonance of its own (damping ratio %.2f)", slowest.damping());
        }
        List<EquivalentBody.Mode> told = told(body);
        if (told.isEmpty()) {
            return "the motion does not determine it";
        }
        double most = Math.min(Spec.MOST_FREQUENCY, rate / 2);
        return told.stream().allMatch(mode -> mode.frequency() < Spec.LEAST_FREQUENCY || mode.frequency() > most)
                ? "its resonance would lie beyond what this recording shows" : "";
    }

    private static List<EquivalentBody.Mode> told(EquivalentBody body) {
        return body.modes().stream().filter(mode -> mode.oscillates() && mode.determined()).toList();
    }

    /** The modes whose numbers are given, slowest first; none where they do not stand. */
    public List<EquivalentBody.Mode> modes() {
        return stands() ? told(body.orElseThrow()) : List.of();
    }

    /** Whether its numbers may be printed. */
    public boolean stands() {
        return doubt.isEmpty();
    }

    /** Numbers with ±2σ and what they explain, or why there are none; one line. */
    public String line() {
        return (stands() ? numbers() : "no natural frequency: " + doubt) + body.map(one -> "; " + explains(one) + stretch(one)).orElse("");
    }

    /** Which part of a long recording it is fitted to; empty if that is all of it. */
    private static String stretch(EquivalentBody one) {
        return one.from() > 0 ? String.format(Locale.ROOT, " (of the last %.0f s)", one.to() - one.from()) : "";
    }

    private String numbers() {
        return modes().stream().map(mode -> "natural frequency " + within(mode.frequency(), 2 * mode.frequencyDeviation(), 2)
                + " Hz, damping ratio " + within(mode.damping(), 2 * mode.dampingDeviation(), 3)).collect(Collectors.joining(" and "));
    }

    /**
     * A value and its ±, with decimals enough for the latter not to vanish.
     *
     * @param value of any unit
     * @param half in the same unit
     * @param least decimals
     */
    public static String within(double value, double half, int least) {
        int decimals = Math.max(least, half > 0 ? (int) Math.ceil(-Math.log10(2 * half)) : least);
        return String.format(Locale.ROOT, "%." + decimals + "f ± %." + decimals + "f", value, half);
    }

    /** What it explains of the output, as words; empty if there is no body. */
    public String explained() {
        return body.map(this::explains).orElse("");
    }

    /** Whether the other motions explain more than the digits shown hide. */
    public boolean othersAdd() {
        return !others.isEmpty()
                && body.filter(one -> !percent(one.withOthers()).equals(percent(Math.max(0, one.explained())))).isPresent();
    }

    private String explains(EquivalentBody one) {
        return "explains " + percent(Math.max(0, one.explained())) + (!othersAdd() ? ""
                : ", with " + others.stream().map(Channel::toString).collect(Collectors.joining(", ")) + " "
                        + percent(Math.max(0, one.withOthers())));
    }

    /** For machines. Numbers that do not stand are not among them. */
    Facts facts() {
        List<ModeFacts> told = modes().stream().map(mode -> new ModeFacts(mode.frequency(), mode.frequencyDeviation(), mode.damping(),
                mode.dampingDeviation())).toList();
        return new Facts(told, doubt, body.map(EquivalentBody::explained).orElse(Double.NaN),
                body.map(EquivalentBody::withOthers).orElse(Double.NaN), others.stream().map(Channel::toString).toList(),
                body.map(EquivalentBody::from).orElse(Double.NaN), body.map(EquivalentBody::to).orElse(Double.NaN));
    }

    /** One mode; deviations are one standard deviation. */
    record ModeFacts(double natural_frequency_hz, double natural_frequency_sd_hz, double damping_ratio, double damping_ratio_sd) {}

    /**
     * The equivalent body for machines.
     *
     * @param modes          slowest first; none where the numbers do not stand
     * @param no_number      why there are none; empty if there are
     * @param explained      share of the output's variance that the body simulates by itself
     * @param explained_with the same with the other motions of the base that help
     * @param with           their names
     * @param from_s         beginning of the stretch that was fitted, from the first sample
     * @param to_s           its end
     */
    record Facts(List<ModeFacts> modes, String no_number, double explained, double explained_with, List<String> with, double from_s,
            double to_s) {}

    /** Never rounded up to all. */
    public static String percent(double share) {
        return String.format(Locale.ROOT, share > 0.995 ? "%.1f %%" : "%.0f %%", Math.floor(share * 1000) / 10);
    }
}
