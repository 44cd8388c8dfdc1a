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
    @CsvSource({"mass.pos.z, mass.force.z, 0, 1", "mass.pos.z, mass.force.z, 3e8, 2", "mass.vel.z, mass.force.z, 0, 3",
        "mass.acc.z, mass.force.z, 0, 4", "foot.force.z, foot.force.z, 0, 5", "foot.force.z, foot.force.z, 3e8, 6"})
    @Tag("slow")
    void aForceOfTheOtherSignIsTurnedAndTheDiagnosisGoesOn(String sensor, String wrong, double cubic, long seed) {
        Recording bench = bench(Channel.parse(sensor), cubic, seed);
        Diagnosis right = diagnosed(sensor, bench);
        Diagnosis turned = diagnosed(sensor, turned(bench, Channel.parse(wrong)));
        assertTrue(!right.sentence().contains("of the other sign"), right.sentence());
        assertTrue(turned.sentence().startsWith(wrong + " is of the other sign"), turned.sentence());
        assertTrue(turned.sentence().endsWith(right.sentence()), turned.sentence() + "\n" + right.sentence());
        assertEquals(cubic > 0 ? List.of("stiffness.hardening") : List.of(),
                turned.missing().stream().map(Diagnosis.Named::mechanism).toList(), turned.sentence());
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
        Model model = new Model("damper", Optional.empty(), 'z', new Model.Base("table", Optional.of(STROKE)),
                List.of(Model.Body.fixed("frame")),
                List.of(new Model.Link("table", "frame", 18000, 1000, Optional.of(FOOT), List.of(), List.of())));
        Diagnosis right = Bench.diagnosed(model, bench);
        Diagnosis turned = Bench.diagnosed(model, turned(bench, FOOT));
        assertEquals(List.of(), right.missing(), right.sentence());
        assertTrue(turned.sentence().startsWith(FOOT + " is of the other sign") && turned.sentence().endsWith(right.sentence()),
                turned.sentence());
        assertEquals(List.of(), turned.missing(), turned.sentence());
    }

    private static Recording turned(Recording recording, Channel wrong) {
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        recording.channels().forEach(channel -> channels.put(channel,
                Arrays.stream(recording.values(channel)).map(x -> channel.equals(wrong) ? -x : x).toArray()));
        return new Recording(recording.clock(), channels, recording.metadata());
    }

    private static Diagnosis diagnosed(String sensor, Recording recording) {
        return Bench.diagnosed(Bench.oscillator(2, 7000, 30, Channel.parse(sensor)), recording);
    }

    /** 2 kg on 8 kN/m and 25 N s/m under forty tones up to 20 Hz, with 0.3 % noise. */
    private static Recording bench(Channel sensor, double cubic, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator push = Bench.tones(40, 0.5, 0.49, 3.4, random);
        Bench bench = new Bench(200, 30, 50, 2)
                .run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 25 * v[0] - 8000 * x[0] - cubic * x[0] * x[0] * x[0]);
        double[] pushed = bench.sampled(push);
        double[] accelerated = bench.sampled(bench.acceleration(0));
        double[] below = pushed.clone();
        Arrays.setAll(below, j -> pushed[j] - 2 * accelerated[j]);
        double[] read = switch (sensor.quantity()) {
            case POSITION -> bench.sampled(bench.position(0));
            case VELOCITY -> bench.sampled(bench.velocity(0));
            case ACCELERATION -> accelerated;
            default -> below;
        };
        return bench.recording(PUSH, pushed, sensor, Bench.noisyBy(0.003, read, random));
    }
}
