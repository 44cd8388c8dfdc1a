package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
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

    @Test
    void aPersonsAccelerometerIsNamedToo() throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("null", List.of(), 0.1, Setting.RIG, false, 7));
        Recording ride = made.recording();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        ride.channels().forEach(channel -> values.put(channel, channel.equals(HEAD) ? coupled(ride.values(channel), 1 / ride.clock().rate(), 1) : ride.values(channel)));
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        isNamed(Diagnoser.diagnose(ModelFile.read(model), new Recording(ride.clock(), values, ride.metadata()), (step, share) -> { }), HEAD.toString(), 1);
    }

    private static void isNamed(Diagnosis d, String sensor, double corner) {
        assertEquals(List.of("sensor.ac-coupled at " + sensor), d.missing().stream().map(n -> n.mechanism() + " at " + n.where()).toList(), d.sentence());
        Interval interval = d.missing().get(0).intervals().get("corner_hz");
        assertTrue(interval.low() < corner && corner < interval.high(), d.sentence() + " " + interval);
        assertEquals(corner, d.missing().get(0).parameters().get("corner_hz"), 0.05 * corner);
    }

    private static Diagnosis diagnosed(Recording bench) {
        Channel sensor = bench.has(POSITION) ? POSITION : FOOT;
        boolean position = sensor.equals(POSITION);
        Model model = new Model("bench", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(new Model.Body("mass", 2, position ? Optional.of(sensor) : Optional.empty(), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("ground", "mass", 7000, 30, position ? Optional.empty() : Optional.of(sensor), List.of(), List.of())),
                List.of(new Model.Input("mass", PUSH)));
        return Diagnoser.diagnose(new Question(model, bench, Optional.empty(), OptionalDouble.empty()), (step, share) -> { });
    }

    /** 2 kg on 8 kN/m and 25 N s/m under 2 N and forty tones up to 20 Hz, semi-implicit Euler steps of 1/10000 s, 0.3 % noise; read past a high-pass or not. */
    private static Recording bench(String sensor, double corner, long seed) {
        int n = 6000;
        int fine = 50;
        double rate = 200;
        Random random = new Random(seed);
        double[] phase = random.doubles(40, 0, 2 * Math.PI).toArray();
        double[] u = new double[n];
        double[] y = new double[n];
        double[] read = new double[n * fine];
        double x = 0;
        double v = 0;
        for (int i = 0; i < read.length; i++) {
            double t = i / rate / fine;
            double push = push(t, phase);
            if (i % fine == 0) {
                u[i / fine] = push;
            }
            read[i] = sensor.equals(POSITION.toString()) ? x : 8000 * x + 25 * v;
            v += (push - 25 * v - 8000 * x) / 2 / rate / fine;
            x += v / rate / fine;
        }
        double[] out = corner > 0 ? coupled(read, 1 / rate / fine, corner) : read;
        double size = Math.sqrt(java.util.Arrays.stream(out).map(a -> a * a).average().orElseThrow());
        for (int j = 0; j < n; j++) {
            y[j] = out[j * fine] + 0.003 * size * random.nextGaussian();
        }
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        channels.put(PUSH, u);
        channels.put(Channel.parse(sensor), y);
        return new Recording(new Clock(0, rate), channels, Metadata.NONE);
    }

    private static double push(double t, double[] phase) {
        double sum = 2;
        for (int k = 0; k < phase.length; k++) {
            sum += 2.5 * Math.sin(2 * Math.PI * (0.3 + 0.4925 * k) * t + phase[k]);
        }
        return Math.min(1, t) * sum;
    }

    /** What a capacitor and a resistor pass of a series that runs straight between its samples: x' = w (y - x) is held back. */
    private static double[] coupled(double[] y, double step, double corner) {
        double a = 2 * Math.PI * corner * step;
        double kept = Math.exp(-a);
        double share = -Math.expm1(-a) / a;
        double[] out = new double[y.length];
        double x = y[0];
        for (int i = 0; i < y.length; i++) {
            x = i == 0 ? x : kept * x + (share - kept) * y[i - 1] + (1 - share) * y[i];
            out[i] = y[i] - x;
        }
        return out;
    }
}
