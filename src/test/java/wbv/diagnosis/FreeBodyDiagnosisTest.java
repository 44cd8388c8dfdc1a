package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** A slide that no spring holds, pushed by a measured force over friction that its model lacks. */
class FreeBodyDiagnosisTest {

    private static final Channel FORCE = Channel.parse("slide.force.z");
    private static final Channel POSITION = Channel.parse("slide.pos.z");
    private static final double MASS = 12;
    private static final double FRICTION = 20;
    /** Standard deviation of a sample of the position [m]. */
    private static final double NOISE = 1e-4;

    /** Under way when the recording begins, and 7 cm from where its encoder counts from. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"100, 12, 2, 1.15, 0.9, 0"})
    void frictionUnderASlideIsFound(double rate, double seconds, long seed, double massError, double dampingError, double speed) {
        isFound(rate, seconds, seed, massError, dampingError, speed);
    }

    @Tag("exam")
    @ParameterizedTest
    @CsvSource({"100, 12, 3, 0.9, 1.1, 0.4", "100, 12, 4, 1.05, 0.88, -0.2", "250, 12, 5, 0.95, 1.1, 0.3", "1000, 6, 6, 1.05, 0.88, -0.2",
        "1000, 6, 7, 0.92, 1.1, 0.4"})
    void overSeedsAndRates(double rate, double seconds, long seed, double massError, double dampingError, double speed) {
        isFound(rate, seconds, seed, massError, dampingError, speed);
    }

    private static void isFound(double rate, double seconds, long seed, double massError, double dampingError, double speed) {
        Diagnosis d = Bench.diagnosed(slide(MASS * massError, 15 * dampingError), record(rate, seconds, seed, FRICTION, speed));
        assertEquals(List.of("friction.coulomb"), d.missing().stream().map(Diagnosis.Named::mechanism).toList(), d.sentence());
        assertEquals(FRICTION, d.missing().get(0).parameters().get("friction_N"), 0.1 * FRICTION, d.sentence());
        assertTrue(d.fit().after() < 3, d.sentence() + " " + d.fit().after());
    }

    @Test
    void aSlideWithoutFrictionLacksNothing() {
        Diagnosis d = Bench.diagnosed(slide(MASS * 1.1, 15 * 0.9), record(100, 10, 5, 0, 0.3));
        assertTrue(d.missing().isEmpty(), d.sentence());
    }

    /** No spring brings the slide back between two recordings, nor does the encoder count from where it did. */
    @Test
    void eachRecordingCountsFromItsOwnZero() {
        Diagnosis d = together(0);
        assertTrue(d.missing().isEmpty(), d.sentence());
        assertEquals(1, d.fit().after(), 0.2, d.sentence());
        assertTrue(d.fit().channels().get(0).after().value() < 1e-3, "the error that is claimed is that of the recording that proves");
    }

    @Tag("slow")
    @Test
    void frictionIsFoundInSeveralRecordings() {
        Diagnosis d = together(FRICTION);
        assertEquals(List.of("friction.coulomb"), d.missing().stream().map(Diagnosis.Named::mechanism).toList(), d.sentence());
        assertEquals(FRICTION, d.missing().get(0).parameters().get("friction_N"), 0.02 * FRICTION, d.sentence());
        assertEquals(1, d.fit().after(), 0.2, d.sentence());
    }

    private static Diagnosis together(double friction) {
        Map<String, Recording> fitted = new LinkedHashMap<>();
        fitted.put("one", counted(record(100, 10, 5, friction, 0), 0.004));
        fitted.put("two", counted(record(100, 10, 6, friction, 0), -0.007));
        Rides rides = Rides.of(fitted, Optional.of(Map.entry("three", counted(record(100, 10, 7, friction, 0), 0.013))));
        return Diagnoser.diagnose(Question.of(slide(MASS * 1.1, 15 * 0.9), rides.recording()).proved(rides.provedFrom()),
                (step, share) -> {});
    }

    private static Recording counted(Recording bench, double from) {
        double[] position = Arrays.stream(bench.values(POSITION)).map(x -> x - from).toArray();
        return new Recording(bench.clock(), Map.of(FORCE, bench.values(FORCE), POSITION, position), bench.metadata());
    }

    /**
     * With the numbers as they are the free run differs from the bench by less than an encoder's noise, however often friction turns round.
     */
    @ParameterizedTest
    @CsvSource({"100, 11", "100, 12", "1000, 13"})
    void whatTurnsRoundWithinAStepIsTimed(double rate, long seed) {
        Recording bench = record(rate, 10, seed, FRICTION, 0);
        double[] measured = bench.values(POSITION);
        double[] simulated = simulated(slide(MASS, 15, List.of(new wbv.body.law.CoulombFriction(FRICTION, 1e-6))), bench);
        double[] off = new double[measured.length];
        Arrays.setAll(off, i -> measured[i] - simulated[i]);
        assertTrue(Bench.rms(off) < 1.5 * NOISE, 1e3 * Bench.rms(off) + " mm");
        assertTrue(Bench.rms(measured) > 300 * NOISE);
    }

    static double[] simulated(Model model, Recording input) {
        return new Simulator(Excitation.of(model, input, input.length())).outputs(model.assembly())[0];
    }

    static Model slide(double mass, double damping) {
        return slide(mass, damping, List.of());
    }

    private static Model slide(double mass, double damping, List<wbv.body.law.Law> laws) {
        return new Model("slide", Optional.empty(), 'z', new Model.Base("bench", Optional.empty()),
                List.of(Bench.body("slide", mass, Optional.of(POSITION))),
                List.of(new Model.Link("bench", "slide", 0, damping, Optional.empty(), laws, List.of())),
                List.of(new Model.Input("slide", FORCE)));
    }

    /** Under forty tones up to 6 Hz. */
    static Recording record(double rate, double seconds, long seed, double friction, double speed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.15, 15, random);
        Bench bench = new Bench(rate, seconds, (int) Math.round(20000 / rate), MASS).run(
                (t, x, v, out) -> out[0] = push.applyAsDouble(t) - 15 * v[0],
                new double[] {speed == 0 ? 0 : 0.07}, new double[] {speed}, (t, x, v, out) -> out[0] = friction);
        return bench.recording(FORCE, bench.sampled(push), POSITION, Bench.noisy(bench.sampled(bench.position(0)), NOISE, random));
    }
}
