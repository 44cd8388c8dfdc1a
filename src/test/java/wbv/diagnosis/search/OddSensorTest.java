package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Bench;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Interval;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** A sensor late by half a sample, which is no more than several sensors scatter by together, and five times as much as one does. */
class OddSensorTest {

    @TempDir
    private Path folder;

    private Diagnosis diagnosed(List<String> words, long seed) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("late", words, 0.1, Setting.RIG, false, seed));
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        return Diagnoser.diagnose(ModelFile.read(model), made.recording(), (step, share) -> {});
    }

    /** Data tell one clock against the other alone, and no sensor reads what is yet to come. Late by half a sample, 2.5 ms. */
    @ParameterizedTest
    @ValueSource(strings = {"mass.pos.z", "mass.force.z"})
    void ofOneSensorAndOneInputTheLaterIsBlamed(String late) {
        Diagnosis diagnosis = onBench(late);
        assertEquals(List.of("sensor.delay at " + late),
                diagnosis.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList(), diagnosis.sentence());
        Interval delay = diagnosis.missing().get(0).intervals().get("delay_s");
        assertTrue(delay.low() < 0.0025 && 0.0025 < delay.high(), diagnosis.sentence());
    }

    @Test
    void ofTwoInTimeNoneIs() {
        assertEquals(List.of(), onBench("none").missing());
    }

    private static Diagnosis onBench(String late) {
        Random random = new Random(3);
        int fine = 50;
        DoubleUnaryOperator push = Bench.tones(40, 0.3, 0.4925, 2.5, random);
        Bench bench = new Bench(200, 30, fine, 2).run((t, x, v, out) -> out[0] = push.applyAsDouble(t) - 8000 * x[0] - 25 * v[0]);
        double[] position = bench.position(0);
        int shift = late.equals("mass.pos.z") ? fine / 2 : 0;
        double[] read = new double[position.length];
        System.arraycopy(position, 0, read, shift, position.length - shift);
        double later = late.equals("mass.force.z") ? fine / 2 * bench.step() : 0;
        Recording recording = bench.recording("mass.force.z",
                Bench.noisyBy(0.005, bench.sampled((double t) -> push.applyAsDouble(Math.max(0, t - later))), random), "mass.pos.z",
                Bench.noisyBy(0.001, bench.sampled(read), random));
        Model model = Bench.oscillator(2.1, 8400, 23, Channel.parse("mass.pos.z"));
        return Diagnoser.diagnose(model, recording, (step, share) -> {});
    }

    @Tag("slow")
    @Test
    void theOneThatIsLateIsBlamed() throws Exception {
        Diagnosis diagnosis = diagnosed(List.of("sensor.delay"), 5208654190441538260L);
        assertEquals(List.of("sensor.delay at head.acc.z"),
                diagnosis.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList(), diagnosis.sentence());
        // Its own scatter of a tenth of a sample comes on top of what was concealed.
        assertEquals(0.00794, diagnosis.missing().get(0).parameters().get("delay_s"), 0.0025);
        Interval delay = diagnosis.missing().get(0).intervals().get("delay_s");
        assertTrue(0.001 < delay.low() && delay.low() < 0.00794 && 0.00794 < delay.high(), diagnosis.sentence());
    }

    @Tag("slow")
    @Test
    void scatterIsNot() throws Exception {
        for (long seed = 1; seed <= 3; seed++) {
            Diagnosis diagnosis = diagnosed(List.of(), seed);
            assertEquals(List.of(), diagnosis.missing(), diagnosis.sentence());
        }
    }
}
