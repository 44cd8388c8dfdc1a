package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** Benches on which a force sensor counts the other way round, simulated here with code of their own. */
class ForceSignTest {

    private static final Channel PUSH = Channel.parse("mass.force.z");
    private static final Channel FOOT = Channel.parse("foot.force.z");
    private static final Channel STROKE = Channel.parse("table.pos.z");

    /** What pushes, or what measures the spring below; with a spring that stiffens or without. */
    @ParameterizedTest
    @CsvSource({"mass.pos.z, mass.force.z, 0, 1", "mass.pos.z, mass.force.z, 3e8, 2", "mass.vel.z, mass.force.z, 0, 3", "mass.acc.z, mass.force.z, 0, 4",
        "foot.force.z, foot.force.z, 0, 5", "foot.force.z, foot.force.z, 3e8, 6"})
    void aForceOfTheOtherSignIsTurnedAndTheDiagnosisGoesOn(String sensor, String wrong, double cubic, long seed) {
        Recording bench = bench(Channel.parse(sensor), cubic, seed);
        Diagnosis right = diagnosed(sensor, bench);
        Diagnosis turned = diagnosed(sensor, turned(bench, Channel.parse(wrong)));
        assertTrue(!right.sentence().contains("sign"), right.sentence());
        assertTrue(turned.sentence().startsWith(wrong + " is of the other sign"), turned.sentence());
        assertTrue(turned.sentence().endsWith(right.sentence()), turned.sentence() + "\n" + right.sentence());
        assertEquals(cubic > 0 ? List.of("stiffness.hardening") : List.of(), turned.missing().stream().map(Diagnosis.Named::mechanism).toList(), turned.sentence());
        assertEquals(right.missing(), turned.missing());
    }

    /** A spring and a damper between a table that moves as measured and the ground. */
    @ParameterizedTest
    @CsvSource({"7", "8"})
    void aDrivenLinksForceIsTurnedToo(long seed) {
        int n = 4000;
        double rate = 200;
        Random random = new Random(seed);
        double[] phase = random.doubles(20, 0, 2 * Math.PI).toArray();
        double[] stroke = new double[n];
        double[] force = new double[n];
        for (int j = 0; j < n; j++) {
            double speed = 0;
            for (int k = 0; k < phase.length; k++) {
                double w = 2 * Math.PI * (0.3 + 0.21 * k);
                stroke[j] += 0.002 * Math.sin(w * j / rate + phase[k]);
                speed += 0.002 * w * Math.cos(w * j / rate + phase[k]);
            }
            force[j] = -20000 * stroke[j] - 900 * speed + random.nextGaussian();
        }
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(STROKE, stroke);
        channels.put(FOOT, force);
        Recording bench = new Recording(new Clock(0, rate), channels, Metadata.NONE);
        Model model = new Model("damper", Optional.empty(), 'z', new Model.Base("table", Optional.of(STROKE)), List.of(Model.Body.fixed("frame")),
                List.of(new Model.Link("table", "frame", 18000, 1000, Optional.of(FOOT), List.of(), List.of())));
        Diagnosis right = diagnosed(model, bench);
        Diagnosis turned = diagnosed(model, turned(bench, FOOT));
        assertEquals(List.of(), right.missing(), right.sentence());
        assertTrue(turned.sentence().startsWith(FOOT + " is of the other sign") && turned.sentence().endsWith(right.sentence()), turned.sentence());
        assertEquals(List.of(), turned.missing(), turned.sentence());
    }

    private static Recording turned(Recording recording, Channel wrong) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        recording.channels().forEach(channel -> channels.put(channel, Arrays.stream(recording.values(channel)).map(x -> channel.equals(wrong) ? -x : x).toArray()));
        return new Recording(recording.clock(), channels, recording.metadata());
    }

    private static Diagnosis diagnosed(String sensor, Recording recording) {
        Channel channel = Channel.parse(sensor);
        Optional<Channel> onMass = channel.equals(FOOT) ? Optional.empty() : Optional.of(channel);
        Optional<Channel> below = channel.equals(FOOT) ? Optional.of(channel) : Optional.empty();
        return diagnosed(new Model("bench", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(new Model.Body("mass", 2, onMass, List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("ground", "mass", 7000, 30, below, List.of(), List.of())), List.of(new Model.Input("mass", PUSH))), recording);
    }

    private static Diagnosis diagnosed(Model model, Recording recording) {
        return Diagnoser.diagnose(new Question(model, recording, Optional.empty(), OptionalDouble.empty()), (step, share) -> { });
    }

    /** 2 kg on 8 kN/m and 25 N s/m under forty tones up to 20 Hz, by semi-implicit Euler steps of 1/10000 s, with 0.3 % noise. */
    private static Recording bench(Channel sensor, double cubic, long seed) {
        int n = 6000;
        int fine = 50;
        double rate = 200;
        Random random = new Random(seed);
        double[] phase = random.doubles(40, 0, 2 * Math.PI).toArray();
        double[] u = new double[n];
        double[] y = new double[n];
        double x = 0;
        double v = 0;
        for (int j = 0; j < n; j++) {
            u[j] = push(j / rate, phase);
            double spring = 25 * v + 8000 * x + cubic * x * x * x;
            y[j] = switch (sensor.quantity()) {
                case POSITION -> x;
                case VELOCITY -> v + (u[j] - spring) / 4 / rate / fine;   // half a step on: so these steps know it
                case ACCELERATION -> (u[j] - spring) / 2;
                default -> spring;
            };
            for (int i = 0; i < fine; i++) {
                v += (push((j + i / (double) fine) / rate, phase) - 25 * v - 8000 * x - cubic * x * x * x) / 2 / rate / fine;
                x += v / rate / fine;
            }
        }
        double size = Math.sqrt(Arrays.stream(y).map(a -> a * a).average().orElseThrow());
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(PUSH, u);
        channels.put(sensor, Arrays.stream(y).map(a -> a + 0.003 * size * random.nextGaussian()).toArray());
        return new Recording(new Clock(0, rate), channels, Metadata.NONE);
    }

    private static double push(double t, double[] phase) {
        double sum = 0;
        for (int k = 0; k < phase.length; k++) {
            sum += 3.4 * Math.sin(2 * Math.PI * (0.5 + 0.49 * k) * t + phase[k]);
        }
        return Math.min(1, t) * sum;
    }
}
