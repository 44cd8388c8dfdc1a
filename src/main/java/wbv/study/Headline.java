package wbv.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import wbv.exposure.Directive;
import wbv.recording.Channel;
import wbv.recording.inspect.Severity;
import wbv.result.Digits;
import wbv.signal.FrequencyResponse;

/** What a recording is and the most important thing found in it, in one sentence. */
public final class Headline {

    /** Places of which one must be there for a recording to be of someone who sits. */
    private static final Set<String> SEATED = Set.of("seat", "head", "sternum", "pelvis", "lumbar");

    private final Analysis analysis;

    /** Of one analysis. */
    public Headline(Analysis analysis) {
        this.analysis = analysis;
    }

    /** The sentence, with its full stop. */
    public String sentence() {
        List<String> parts = new ArrayList<>();
        analysis.findings().stream().filter(each -> each.severity() == Severity.FAULT).findFirst()
                .ifPresent(fault -> parts.add("to be used with care, for " + fault.message()));
        Optional<JudgedExposure> exposure = analysis.exposure().map(JudgedExposure::new);
        boolean grave = exposure.map(each -> each.verdict() == Directive.Verdict.ABOVE_ACTION
                || each.verdict() == Directive.Verdict.ABOVE_LIMIT).orElse(false);
        if (grave) {
            parts.add(exposure.get().words());
        }
        parts.add(answer());
        if (!grave) {
            exposure.ifPresent(each -> parts.add(each.words()));
        }
        return what() + ": " + String.join(parts.size() > 2 ? "; " : ", and ", parts) + ".";
    }

    private String what() {
        double seconds = analysis.inspection().duration();
        String duration = (seconds < 600 ? Digits.significant(seconds, 3) + "\u00a0s" : JudgedExposure.duration(seconds / 60)) + " of ";
        boolean simulated = analysis.metadata().source().map(source -> source.startsWith("simulated")).orElse(false);
        boolean seated = analysis.inspection().summaries().keySet().stream().map(Channel::location).anyMatch(SEATED::contains);
        return duration + (simulated ? "simulated " : "") + (seated ? "seated vibration" : "vibration") + " at "
                + Digits.significant(analysis.inspection().clock().rate(), 4) + "\u00a0Hz";
    }

    private String answer() {
        Channel output = analysis.followed().get(analysis.leading()).channel();
        String from = subject(analysis.input(), output);
        String to = subject(output, analysis.input());
        Optional<FrequencyResponse> response = analysis.frequencyResponse(analysis.leading()).filter(h -> peak(h) >= 0);
        if (response.isEmpty()) {
            return "at no frequency does " + from + " explain how " + to + " moves";
        }
        FrequencyResponse h = response.get();
        double peak = h.h1().magnitude(peak(h));
        String at = " at " + Digits.significant(h.frequency()[peak(h)], 2) + "\u00a0Hz";
        if (!analysis.input().quantity().unit().equals(output.quantity().unit())) {
            return to + " answers " + from + " most" + at;
        }
        return peak > 1 ? to + " moves " + Digits.significant(peak, 2) + " times as much as " + from + at
                : to + " moves less than " + from + " at every frequency, " + Digits.significant(peak, 2) + " times as much" + at;
    }

    /** A channel as the subject of a sentence: its place, where that tells it from the other. */
    private static String subject(Channel channel, Channel other) {
        return channel.location().equals(other.location()) ? channel.toString() : "the " + channel.location().replace('_', ' ');
    }

    /** The bin of the greatest modulus among those that can be believed; -1 if there is none. */
    public static int peak(FrequencyResponse h) {
        int peak = -1;
        for (int k = 0; k < h.frequency().length; k++) {
            if (h.usable()[k] && (peak < 0 || h.h1().magnitude(k) > h.h1().magnitude(peak))) {
                peak = k;
            }
        }
        return peak;
    }
}
