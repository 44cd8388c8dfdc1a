package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.law.ScheduledFriction;
import wbv.body.law.ScheduledLink;
import wbv.body.number.Modulator;
import wbv.recording.Channel;
import wbv.recording.Recording;

/** A mass on a bench whose stiffness, damping or friction goes by a channel that is no input of its model. */
class ScheduledTest {

    private static final Channel POSITION = Channel.parse("mass.pos.z");
    private static final Channel ROLLER = Channel.parse("roller.pos.x");
    private static final Channel COIL = Channel.parse("coil.volt.s");

    /** A beam that a roller makes longer and shorter: its stiffness goes by the third power of its length. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void aRollerUnderABeamIsFound(long seed) {
        Diagnosis d = diagnosed(bench(ROLLER, roller(seed), ScheduledTest::ofBeam, by -> 25, by -> 0, seed), seed);
        isNamed(d, "stiffness.scheduled");
        ScheduledLink law = (ScheduledLink) d.model().links().get(0).laws().get(0);
        double stiffness = d.model().links().get(0).stiffness();
        Modulator.Level level = (Modulator.Level) law.modulator();
        for (double u = -1; u <= 1; u += 0.1) {
            double found = stiffness * (1 + u * (law.linear() + u * (law.square() + u * (law.cube() + u * law.fourth()))));
            assertEquals(ofBeam(level.value(u)), found, 0.05 * ofBeam(level.value(u)), d.sentence());
        }
        assertTrue(d.sentence().contains("mm of " + ROLLER), d.sentence());
        assertEquals(d.model(), ModelFile.parse(ModelFile.text(d.model()), "again"));
    }

    /** A damper with a coil, switched between four voltages. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(longs = {3})
    void aCoilThatDampsIsFound(long seed) {
        Diagnosis d = diagnosed(bench(COIL, switched(seed), by -> 8000, by -> 25 * (1 + 0.6 * by), by -> 0, seed), seed);
        isNamed(d, "damping.scheduled");
        ScheduledLink law = (ScheduledLink) d.model().links().get(0).laws().get(0);
        Modulator.Level level = (Modulator.Level) law.modulator();
        for (double u : new double[] {-1, 1}) {
            double found = d.model().links().get(0).damping()
                    * (1 + u * (law.linear() + u * (law.square() + u * (law.cube() + u * law.fourth()))));
            assertEquals(25 * (1 + 0.6 * level.value(u)), found, 0.05 * found, d.sentence());
        }
    }

    /** A yield force that saturates with the voltage, told at the voltages that were there. */
    @Tag("exam")
    @ParameterizedTest
    @ValueSource(longs = {4, 5})
    void aYieldForceIsFound(long seed) {
        Diagnosis d = diagnosed(bench(COIL, switched(seed), by -> 8000, by -> 25, ScheduledTest::ofCoil, seed), seed);
        isNamed(d, "friction.scheduled");
        ScheduledFriction law = (ScheduledFriction) d.model().links().get(0).laws().get(0);
        Modulator.Level level = (Modulator.Level) law.modulator();
        for (double volt = Math.ceil(level.low() - 0.1); volt <= 3; volt++) {
            double u = Math.max(-1, Math.min(1, (2 * volt - level.low() - level.high()) / (level.high() - level.low())));
            double found = law.middle() + u * (law.linear() + u * (law.square() + u * (law.cube() + u * law.fourth())));
            assertEquals(ofCoil(volt), found, 0.05 * ofCoil(3), d.sentence());
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1", "2", "3"})
    void aRollerThatDoesNothingIsNotNamed(long seed) {
        Diagnosis d = diagnosed(bench(ROLLER, roller(seed), by -> 8000, by -> 25, by -> 0, seed), seed);
        assertEquals(List.of(), d.missing(), d.sentence());
    }

    /** A spring that stiffens stays one, whatever else was recorded. */
    @Tag("slow")
    @Test
    void aRollerThatDoesNothingIsNotTakenForASpring() {
        long seed = 6;
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        Bench bench = new Bench(200, 30, 50, 2)
                .run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 * x[0] - 25 * v[0] - 3e8 * x[0] * x[0] * x[0]);
        Diagnosis d = diagnosed(bench.recording("mass.force.z", bench.sampled(push), POSITION,
                Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random), ROLLER, bench.sampled(roller(seed))), seed);
        assertEquals(List.of("stiffness.hardening"), d.missing().stream().map(Diagnosis.Named::mechanism).toList(), d.sentence());
    }

    @Test
    void aLevelReadsWhatItWrites() {
        Modulator level = new Modulator.Level(COIL, -0.5, 3);
        assertEquals(level, Modulator.parse(level.toString()));
    }

    private static double ofBeam(double roller) {
        return 8000 / Math.pow(1 + 12 * roller, 3);
    }

    private static double ofCoil(double volt) {
        return 14 - 12 * Math.exp(-volt / 1.5);
    }

    private static void isNamed(Diagnosis d, String mechanism) {
        assertEquals(List.of(mechanism + " at ground-mass"), d.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList(),
                d.sentence());
        Diagnosis.Proof proof = d.fit().channels().get(0);
        double noise = 0.003;   // of the channel's own size, which is the unit of these errors
        assertTrue(proof.after().value() < (mechanism.startsWith("friction") ? 2.5 : 1.2) * Math.max(noise, proof.floor()),
                d.sentence() + " " + proof);
    }

    private static Diagnosis diagnosed(Recording bench, long seed) {
        Random random = new Random(100 + seed);
        Model model = Bench.oscillator(2 * Math.exp(0.1 * random.nextGaussian()), 8000 * Math.exp(0.1 * random.nextGaussian()),
                25 * Math.exp(0.1 * random.nextGaussian()), POSITION);
        return Bench.diagnosed(model, bench);
    }

    private static DoubleUnaryOperator roller(long seed) {
        double phase = new Random(200 + seed).nextDouble() * 6;
        return t -> 0.01 * Math.sin(2 * Math.PI * 0.043 * t + phase) + 0.006 * Math.sin(2 * Math.PI * 0.11 * t);
    }

    private static DoubleUnaryOperator switched(long seed) {
        int[] steps = new Random(200 + seed).ints(16, 0, 4).toArray();
        return t -> steps[(int) (t / 2.5)];
    }

    /** 2 kg under forty tones up to 20 Hz, with 0.3 % noise. */
    private static Recording bench(Channel channel, DoubleUnaryOperator by, DoubleUnaryOperator stiffness, DoubleUnaryOperator damping,
            DoubleUnaryOperator friction, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.4925, friction.applyAsDouble(1) > 0 ? 8 : 2.5, random);
        Bench bench = new Bench(200, 40, 50, 2).run((t, x, v, out) -> {
            double at = by.applyAsDouble(t);
            out[0] = push.applyAsDouble(t) - stiffness.applyAsDouble(at) * x[0] - damping.applyAsDouble(at) * v[0];
        }, new double[1], new double[1], (t, x, v, out) -> out[0] = friction.applyAsDouble(by.applyAsDouble(t)));
        return bench.recording("mass.force.z", bench.sampled(push), POSITION,
                Bench.noisyBy(0.003, bench.sampled(bench.position(0)), random),
                channel, Bench.noisy(bench.sampled(by), channel == COIL ? 0.005 : 2e-5, random));
    }
}
