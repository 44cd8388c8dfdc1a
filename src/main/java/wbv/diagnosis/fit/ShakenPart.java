package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.diagnosis.measured.Measured;
import wbv.diagnosis.mechanism.Addition;

/** The part of a ride in which a person is shaken hardest, to try on it what may not be worth the whole. */
final class ShakenPart {

    /** Its length [s]. */
    private static final double BRIEF = 36;
    /** How many times as long the whole has to be for that to be worth it. */
    private static final double WORTH_A_PART = 1.6;

    private ShakenPart() {}

    /** Of what is fitted; empty where that is hardly longer, goes by the clock, or is a rig's. */
    static Optional<Measured> of(Evidence evidence) {
        int n = (int) Math.round(BRIEF * evidence.recording().clock().rate());
        Window fit = evidence.fit();
        boolean whole = evidence.onRig() || evidence.isLate() || Addition.byTheClock(evidence.model().assembly())
                || fit.length() < WORTH_A_PART * n;
        return whole ? Optional.empty() : Optional.of(evidence.measured().part(hardest(evidence, n), n));
    }

    private static int hardest(Evidence evidence, int length) {
        double[] ride = evidence.excitation().series(evidence.excitation().baseSpectrum());
        int end = evidence.fit().start() + evidence.fit().length();
        return IntStream.iterate(0, at -> at + length <= end, at -> at + length / 4).boxed()
                .max(Comparator.comparingDouble(at -> Motion.rms(Arrays.copyOfRange(ride, at, at + length), length))).orElseThrow();
    }
}
