package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.diagnosis.measured.Inputs;
import wbv.diagnosis.measured.Measured;
import wbv.diagnosis.mechanism.Addition;

/**
 * A part of a ride to try on it what may not be worth the whole: of a person's that in which he is shaken hardest, of a rig's its
 * beginning, before which it was at rest or where its first motion is fitted.
 *
 * @param inputs what models are simulated with on it
 */
record ShakenPart(Measured measured, Inputs inputs) {

    /** What it is, is asked more than once. */
    record Asked() implements Known.Question<Optional<Evidence>> {}

    /** Its length on a sitter's ride [s]. */
    private static final double BRIEF = 36;
    /** Its length of a rig's in periods of the slowest mode: as many as a sitter's ride has of his, which is one of about 4 Hz. */
    private static final double PERIODS = 4 * BRIEF;
    /** Samples of a rig's at least: as many as a sitter's has at 60 Hz. */
    private static final double SAMPLES = 60 * BRIEF;
    /** How many times as long the whole has to be for that to be worth it. */
    private static final double WORTH_A_PART = 1.6;

    /** Of what is fitted; empty where that is hardly longer, goes by the clock as a known force does, or is of driven links. */
    static Optional<ShakenPart> of(Evidence evidence) {
        int n = length(evidence);
        Window fit = evidence.fit();
        boolean whole = evidence.isLate() || evidence.model().driven() || Addition.byTheClock(evidence.model().assembly())
                || fit.length() < WORTH_A_PART * n;
        return whole ? Optional.empty() : Optional.of(of(evidence, evidence.onRig() ? 0 : hardest(evidence, n), n));
    }

    private static ShakenPart of(Evidence evidence, int from, int length) {
        Measured part = evidence.measured().part(from, length);
        return new ShakenPart(part, Inputs.whole(part.input().pushedAs(evidence.whole(), from)));
    }

    private static int length(Evidence evidence) {
        double rate = evidence.recording().clock().rate();
        return evidence.onRig()
                ? (int) evidence.model().assembly().structure().slowestMode().stream().map(f -> PERIODS * rate / f).reduce(SAMPLES,
                        Math::max)
                : (int) Math.round(BRIEF * rate);
    }

    private static int hardest(Evidence evidence, int length) {
        double[] ride = evidence.excitation().series(evidence.excitation().baseSpectrum());
        int end = evidence.fit().start() + evidence.fit().length();
        return IntStream.iterate(0, at -> at + length <= end, at -> at + length / 4).boxed()
                .max(Comparator.comparingDouble(at -> Motion.rms(Arrays.copyOfRange(ride, at, at + length), length))).orElseThrow();
    }
}
