package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** A bench that changes while it is recorded, and the same bench so many times as fast: what is named goes by periods, not by seconds. */
class ChangingBenchTest {

    private static final Channel FORCE = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");
    private static final double SECONDS = 30;
    private static final DoubleUnaryOperator STEADY = share -> 1;

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, 0.8, 1", "1, 0.97, 2", "40, 0.8, 3", "40, 0.97, 4"})
    void aSpringThatGivesWayAtOnceDidSoAtThatMoment(double pace, double factor, long seed) {
        Diagnosis d = diagnosed(pace, share -> share < 0.4 ? 1 : factor, STEADY, seed);
        Diagnosis.Named named = only(d, "drift.step");
        assertEquals(factor, named.parameters().get("stiffness_factor"), 0.1 * (1 - factor), d.sentence());
        assertEquals(0.4 * SECONDS / pace, named.parameters().get("time_s"), 0.5 / pace, d.sentence());
        assertTrue(named.intervals().get("time_s").contains(0.4 * SECONDS / pace), d.sentence());
        assertTrue(named.intervals().get("time_s").high() - named.intervals().get("time_s").low() < 5 / pace, d.sentence());
    }

    /** What has changed by then shows in data not used as little as their noise does. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"40, 21", "40, 22"})
    void aSpringThatGaveWayEarlyIsNamedWhereDataNotUsedShowLittle(double pace, long seed) {
        only(diagnosed(pace, share -> share < 0.15 ? 1 : 0.97, STEADY, seed), "drift.step");
    }

    /** Along half a cosine, which is none of the library's, over fifteen periods. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, 13", "40, 14"})
    void aSpringThatGivesWayInAWhileTellsHowLongThatWas(double pace, long seed) {
        Diagnosis d = diagnosed(pace, share -> 1 - 0.1 * (1 - Math.cos(Math.PI * Math.max(0, Math.min(1, (share - 0.4) / 0.05 + 0.5)))),
                STEADY, seed);
        Diagnosis.Named named = only(d, "drift.step");
        assertEquals(0.8, named.parameters().get("stiffness_factor"), 0.01, d.sentence());
        assertEquals(0.4 * SECONDS / pace, named.parameters().get("time_s"), 0.1 / pace, d.sentence());
        // Of all ramps that of 0.727 of its length is nearest to half a cosine, in least squares.
        assertEquals(0.727 * 0.05 * SECONDS, pace * named.parameters().get("duration_s"), 0.1, d.sentence());
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, 5", "40, 6"})
    void aSpringThatWarmsUpChangesSlowly(double pace, long seed) {
        only(diagnosed(pace, share -> 1 - 0.2 * -Math.expm1(-2 * share), STEADY, seed), "drift.slow");
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, 7", "40, 8"})
    void aDamperThatFailsIsNoSpring(double pace, long seed) {
        Diagnosis d = diagnosed(pace, STEADY, share -> share < 0.5 ? 1 : 0.7, seed);
        Diagnosis.Named named = only(d, "drift.step");
        assertEquals(1, named.parameters().get("stiffness_factor"), 0.02, d.sentence());
        assertEquals(0.7, named.parameters().get("damping_factor"), 0.05, d.sentence());
    }

    /** With a spring that stays as it is: no part of a change of its. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, 11", "40, 12"})
    void aDamperThatFadesDoesSoAlone(double pace, long seed) {
        Diagnosis d = diagnosed(pace, STEADY, share -> 1 - 0.5 * -Math.expm1(-2 * share), seed);
        assertEquals(-0.5, only(d, "drift.slow").parameters().get("damping_change"), 0.05, d.sentence());
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, 9", "40, 10"})
    void whatStaysAsItIsLacksNothing(double pace, long seed) {
        Diagnosis d = diagnosed(pace, STEADY, STEADY, seed);
        assertEquals(List.of(), d.missing(), d.sentence());
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, d.verdict(), d.sentence());
    }

    private static Diagnosis.Named only(Diagnosis d, String mechanism) {
        assertEquals(Diagnosis.Verdict.MISSING_PHYSICS, d.verdict(), d.sentence());
        assertEquals(List.of(mechanism + " at ground-mass"),
                d.missing().stream().map(named -> named.mechanism() + " at " + named.where()).toList(), d.sentence());
        return d.missing().get(0);
    }

    /**
     * 2 kg on 8 kN/m and 25 N s/m under forty tones up to 20 Hz, with 0.3 % noise; all of it so many times as fast.
     *
     * @param spring factor of its stiffness at a share of the recording
     * @param damper of its damping
     */
    private static Diagnosis diagnosed(double pace, DoubleUnaryOperator spring, DoubleUnaryOperator damper, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator tones = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        DoubleUnaryOperator push = t -> pace * pace * tones.applyAsDouble(pace * t);
        Bench bench = new Bench(200 * pace, SECONDS / pace, 50, 2).run((t, x, v, out) -> {
            double share = pace * t / SECONDS;
            out[0] = push.applyAsDouble(t) - 8000 * pace * pace * spring.applyAsDouble(share) * x[0]
                    - 25 * pace * damper.applyAsDouble(share) * v[0];
        });
        Recording recording = bench.recording(FORCE, bench.sampled(push), POSITION,
                Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random));
        return Bench.diagnosed(Bench.oscillator(2, 7000 * pace * pace, 30 * pace, POSITION), recording);
    }
}
