package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.diagnosis.measured.NoiseLevel;
import wbv.diagnosis.measured.Repeatable;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** Rigs whose truth is known, simulated here with code of their own. */
class RigDiagnosisTest {

    private static final Channel FORCE = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");
    private static final Channel STROKE = Channel.parse("actuator.pos.z");
    private static final Channel DAMPER = Channel.parse("damper.force.z");
    private static final Channel OTHER = Channel.parse("other.force.z");

    @Tag("slow")
    @Test
    void aDuffingOscillatorStiffens() {
        Diagnosis d = diagnose(Bench.oscillator(2, 7000, 30, POSITION), duffing(3e8), Optional.empty());
        assertEquals(Diagnosis.Verdict.MISSING_PHYSICS, d.verdict(), d.sentence());
        assertEquals("stiffness.hardening", d.missing().get(0).mechanism());
        assertEquals(3e8, d.missing().get(0).parameters().get("k3_N_per_m3"), 0.05 * 3e8);
        assertTrue(d.fit().nrmseAfter().get(POSITION.toString()) < 0.05, d.fit().toString());
    }

    @Tag("slow")
    @Test
    void aLinearOscillatorLacksNothing() {
        Diagnosis d = diagnose(Bench.oscillator(2, 7000, 30, POSITION), duffing(0), Optional.empty());
        assertTrue(d.missing().isEmpty(), d.sentence());
    }

    @Tag("slow")
    @Test
    void aSpeedWithoutItsSignBlamesTheSensor() {
        Recording truth = duffing(0);
        double[] y = truth.values(POSITION);
        double[] speed = new double[y.length];
        for (int i = 1; i + 1 < y.length; i++) {
            speed[i] = Math.abs(y[i + 1] - y[i - 1]) / 2 * truth.clock().rate();
        }
        Channel velocity = Channel.parse("mass.vel.z");
        Diagnosis d = diagnose(Bench.oscillator(2, 7000, 30, velocity),
                new Recording(truth.clock(), Map.of(FORCE, truth.values(FORCE), velocity, speed), Metadata.NONE),
                Optional.empty());
        assertEquals("sensor.rectifying", d.missing().get(0).mechanism(), d.sentence());
    }

    /** Against a simulation that has friction of the right size and no play. */
    @Test
    void frictionThatEngagesOverATravelIsBacklash() {
        Diagnosis d = diagnose(driven(0, 0), damper(true), Optional.of(OTHER));
        assertEquals(List.of("contact.backlash"), d.missing().stream().map(Diagnosis.Named::mechanism).toList(), d.sentence());
        assertEquals(0.006, d.missing().get(0).parameters().get("engagement_m"), 0.0006);
        // The gain of the only force is that of all numbers of the link.
        assertFalse(d.fit().sensors().getOrDefault(DAMPER.toString(), Map.of()).containsKey("gain"), d.fit().sensors().toString());
    }

    @Tag("slow")
    @Test
    void aDamperThatSticksHasFriction() {
        Diagnosis d = diagnose(driven(20000, 3000), damper(false), Optional.empty());
        assertEquals("friction.coulomb", d.missing().get(0).mechanism(), d.sentence());
    }

    @Test
    void whatDoesNotRepeatIsFoundWhereTheStrokeRepeats() {
        Random random = new Random(4);
        Recording truth = damper(true);
        double[] force = truth.values(DAMPER).clone();
        boolean[] valid = new boolean[force.length];
        for (int i = 0; i < force.length; i++) {
            force[i] += 250 * random.nextGaussian();
            valid[i] = true;
        }
        double rest = Repeatable.rest(wbv.body.simulate.Stroke.ofPosition(truth.values(STROKE), truth.clock().step()), force, valid,
                force.length);
        assertEquals(250, rest, 80);
    }

    @Test
    void whiteNoiseIsNoStrongerThanTheQuietestBand() {
        Random random = new Random(4);
        double[] x = new double[8000];
        for (int i = 0; i < x.length; i++) {
            x[i] = 5 * Math.sin(0.3 * i) + 0.2 * random.nextGaussian();
        }
        assertEquals(0.2, new NoiseLevel().bound(x), 0.03);
    }

    /** On average over short recordings too, of which the quietest of many bands is quieter than the noise by chance. */
    @Test
    void whiteNoiseIsAsStrongInAShortRecording() {
        double sum = 0;
        int times = 40;
        for (int seed = 0; seed < times; seed++) {
            double[] x = new Random(seed).doubles(1500, -1, 1).toArray();
            sum += 3 * Math.pow(new NoiseLevel().bound(x), 2) / times;
        }
        assertEquals(1, sum, 0.06);
    }

    private static Diagnosis diagnose(Model model, Recording recording, Optional<Channel> simulation) {
        return Diagnoser.diagnose(new Question(model, recording, simulation, OptionalDouble.empty()), (step, share) -> {});
    }

    private static Model driven(double stiffness, double damping) {
        return new Model("damper", Optional.empty(), 'z', new Model.Base("actuator", Optional.of(STROKE)),
                List.of(Model.Body.fixed("frame")),
                List.of(new Model.Link("actuator", "frame", stiffness, damping, Optional.of(DAMPER), List.of(), List.of())));
    }

    /** 2 kg on 8 kN/m and 25 N s/m under a force of two hundred tones up to 20 Hz, with 0.3 % noise. */
    private static Recording duffing(double cubic) {
        Random random = new Random(11);
        DoubleUnaryOperator push = Bench.tones(200, 0.5, 0.1, 1.5, random);
        Bench bench = new Bench(200, 30, 50, 2)
                .run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 25 * v[0] - 8000 * x[0] - cubic * x[0] * x[0] * x[0]);
        return bench.recording(FORCE, bench.sampled(push), POSITION, Bench.noisy(bench.sampled(bench.position(0)), 8e-6, random));
    }

    /**
     * A stroke of two tones that fade in; friction that follows it at once, or over a travel, and a simulation that knows only
     * the former.
     */
    private static Recording damper(boolean engaging) {
        int n = 6000;
        double rate = 200;
        Random random = new Random(5);
        double[] stroke = new double[n];
        double[] force = new double[n];
        double[] other = new double[n];
        double z = 0;
        for (int j = 0; j < n; j++) {
            double t = j / rate;
            stroke[j] = Math.min(1, t / 5) * (0.02 * Math.sin(2 * Math.PI * 0.5 * t) + 0.008 * Math.sin(2 * Math.PI * 0.83 * t));
            double moved = j == 0 ? 0 : stroke[j - 1] - stroke[j];
            z = Math.max(-0.006, Math.min(0.006, z + moved));
            double speed = moved * rate;
            other[j] = 9000 * Math.tanh(speed / 0.005);
            double engaged = Math.expm1(3 * Math.abs(z) / 0.006) / Math.expm1(3);
            force[j] = (engaging ? Math.copySign(9000 * engaged, z) : other[j] - 15000 * stroke[j] + 4000 * speed)
                    + 90 * random.nextGaussian();
        }
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(STROKE, stroke);
        channels.put(DAMPER, force);
        channels.put(OTHER, other);
        return new Recording(new Clock(0, rate), channels, Metadata.NONE);
    }
}
