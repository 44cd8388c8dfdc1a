package wbv.recording.signals;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;

/** What people call times, rates and steps in files without a rule for it; the last word of a dotted name or a path counts. */
final class ClockWords {

    private static final Set<String> RATES = Set.of("fs", "ratehz", "rate", "samplerate", "samplingrate", "samplingfrequency",
            "samplefrequency", "sr", "freq");
    private static final Set<String> STEPS = Set.of("dt", "ts", "sampletime", "sampleinterval", "samplinginterval", "increment");
    private static final Set<String> TIMES = Set.of("t", "time", "times", "timestamp", "timestamps");

    private ClockWords() {}

    /** The rate [Hz] that a number of this name states, as such or as a step [s]. */
    static OptionalDouble rate(String name, double value) {
        boolean rate = RATES.contains(bare(name));
        return value > 0 && (rate || STEPS.contains(bare(name))) ? OptionalDouble.of(rate ? value : 1 / value) : OptionalDouble.empty();
    }

    /** Whether numbers of this name are times. */
    static boolean isTime(String name) {
        return TIMES.contains(bare(name));
    }

    private static String bare(String name) {
        return name.substring(Math.max(name.lastIndexOf('.'), name.lastIndexOf('/')) + 1).toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]",
                "");
    }
}
