package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.ModelFile;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** Sensors that are AC coupled, by a filter that is stepped in time here. */
class AcCoupledTest {

    private static final Channel PUSH = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");
    private static final Channel FOOT = Channel.parse("foot.force.z");
    private static final Channel HEAD = Channel.parse("head.acc.z");

    @TempDir
    private Path folder;

    /** On a bench, under a load that does not move about zero, with the corner well below its resonance at 10 Hz or near to it. */
    @ParameterizedTest
    @CsvSource({"mass.pos.z, 0.5, 1", "mass.pos.z, 3, 2", "foot.force.z, 0.2, 3", "foot.force.z, 1.5, 4"})
    void onABenchItIsNamedWithItsCorner(String sensor, double corner, long seed) {
        isNamed(diagnosed(bench(sensor, corner, seed)), sensor, corner);
    }

    @ParameterizedTest
    @CsvSource({"mass.pos.z, 5", "foot.force.z, 6"})
    void whereNothingIsConcealedNothingIsNamed(String sensor, long seed) {
        Diagnosis d = diagnosed(bench(sensor, 0, seed));
        assertEquals(List.of(), d.missing(), d.sentence());
    }

    @Tag("slow")
    @Test
    void aPersonsAccelerometerIsNamedToo() throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("null", List.of(), 0.1, Setting.RIG, false, 7));
        Recording ride = made.recording();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        ride.channels().forEach(channel -> values.put(channel,
                channel.equals(HEAD) ? Bench.coupled(ride.values(channel), 1 / ride.clock().rate(), 1) : ride.values(channel)));
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        isNamed(Diagnoser.diagnose(ModelFile.read(model), new Recording(ride.clock(), values, ride.metadata()), (step, share) -> {}),
                HEAD.toString(), 1);
    }

    private static void isNamed(Diagnosis d, String sensor, double corner) {
        assertEquals(List.of("sensor.ac-coupled at " + sensor), d.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList(),
                d.sentence());
        Interval interval = d.missing().get(0).intervals().get("corner_hz");
        assertTrue(interval.low() < corner && corner < interval.high(), d.sentence() + " " + interval);
        assertEquals(corner, d.missing().get(0).parameters().get("corner_hz"), 0.05 * corner);
    }

    private static Diagnosis diagnosed(Recording bench) {
        return Bench.diagnosed(Bench.oscillator(2, 7000, 30, bench.has(POSITION) ? POSITION : FOOT), bench);
    }

    /** 2 kg on 8 kN/m and 25 N s/m under 2 N and forty tones up to 20 Hz, 0.3 % noise; read past a high-pass or not. */
    private static Recording bench(String sensor, double corner, long seed) {
        Random random = new Random(seed);
        DoubleUnaryOperator tones = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        DoubleUnaryOperator push = t -> tones.applyAsDouble(t) + 2 * Math.min(1, t);
        Bench bench = new Bench(200, 30, 50, 2).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 * x[0] - 25 * v[0]);
        double[] read = bench.position(0);
        if (!sensor.equals(POSITION.toString())) {
            double[] speed = bench.velocity(0);
            Arrays.setAll(read, i -> 8000 * read[i] + 25 * speed[i]);
        }
        double[] out = bench.sampled(corner > 0 ? Bench.coupled(read, bench.step(), corner) : read);
        return bench.recording(PUSH, bench.sampled(push), sensor, Bench.noisyBy(0.003, out, random));
    }
}
