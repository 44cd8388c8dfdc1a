package wbv.diagnosis.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.algebra.BoundedLeastSquares;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.search.Search;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.signal.RealDft;
import wbv.signal.ScalarProduct;

/** The small errors of sensors, held to what they do to a recording that has none beside those of its making. */
class NuisancesTest {

    private static final Path CASE = Path.of("data/arff/concealed/001");

    private static Model model() throws Exception {
        return ModelFile.read(CASE.resolve("model.json"));
    }

    private static Recording recording() throws Exception {
        return new RecordingFile(CASE.resolve("recording.csv.gz")).load();
    }

    private static Fitter.State fitted(Evidence evidence) {
        return new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence));
    }

    /** At 20 Hz 4 ms turn a phase by 29 degrees: to first order a sixth of the amplitude would be left unexplained. */
    @Test
    void aDelayIsExactUpToTheHighestLine() throws Exception {
        Recording plain = recording();
        Channel head = Channel.parse("head.acc.z");
        Map<Channel, double[]> values = new LinkedHashMap<>();
        plain.channels()
                .forEach(channel -> values.put(channel, channel.equals(head) ? late(plain.values(channel), 0.004 * plain.clock().rate())
                        : plain.values(channel)));
        Evidence before = new Evidence(model(), plain);
        Evidence after = new Evidence(model(), new Recording(plain.clock(), values, plain.metadata()));
        Fitter.State without = fitted(before);
        Fitter.State with = fitted(after);
        assertEquals(without.reduced(), with.reduced(), 0.02);
        int o = before.outputs().indexOf(head);
        double relative = with.frame().nuisances().delays().of(o, with.errors())
                - without.frame().nuisances().delays().of(o, without.errors());
        assertTrue(relative > 0.001 && relative < 0.0045, "the rest of it is the input's: " + relative);
    }

    /**
     * What a sensor reads that is late and tilted and has a wrong gain is seen with all three, and nothing more is left of it than of a
     * sound one.
     */
    @Test
    void aModelIsSeenAsItsSensorsReadIt() throws Exception {
        Recording plain = recording();
        Channel head = Channel.parse("head.acc.z");
        Channel across = Channel.parse("head.acc.x");
        Map<Channel, double[]> values = new LinkedHashMap<>();
        plain.channels().forEach(channel -> values.put(channel, plain.values(channel)));
        double[] fore = values.get(across);
        double[] late = late(values.get(head), 0.002 * plain.clock().rate());
        values.put(head, IntStream.range(0, late.length).mapToDouble(i -> 1.01 * late[i] + 0.02 * fore[i]).toArray());
        // A bias across is not acceleration, and does not come through a tilt.
        values.put(across, Arrays.stream(fore).map(a -> a + 2).toArray());
        Evidence sound = new Evidence(model(), plain);
        Evidence wrong = new Evidence(model(), new Recording(plain.clock(), values, plain.metadata()));
        int o = sound.outputs().indexOf(head);
        Fitter.State without = fitted(sound);
        Fitter.State with = fitted(wrong);
        assertEquals(left(sound, new Readings(sound).of(without)[o], o), left(wrong, new Readings(wrong).of(with)[o], o), 0.002);
        double[] simulated = wrong.whole().series(new Simulator(wrong.whole()).run(with.candidate().at(with.x()), false).outputs()[o]);
        assertTrue(left(wrong, simulated, o) > 1.3 * left(wrong, new Readings(wrong).of(with)[o], o),
                "the model alone is seen too early");
        Map<String, Double> before = Readings.errors(sound, without).get("head.acc.z");
        Map<String, Double> after = Readings.errors(wrong, with).get("head.acc.z");
        assertEquals(0.01, after.get("gain") - before.get("gain"), 0.005);
        assertEquals(0.002, after.get("delay_s") - before.get("delay_s"), 0.001);
        assertEquals(0.02, after.get("tilt_to_x_rad") - before.get("tilt_to_x_rad"), 0.005);
    }

    /** Of a sensor that is turned and late the axis across is late too, as it was recorded: what comes of it is not delayed once more. */
    @Test
    void aTurnedSensorThatIsLateIsLateOnce() throws Exception {
        double angle = 0.4;
        Model turned = ModelFile.parse(Files.readString(CASE.resolve("model.json")).replace("\"sensor\": \"head.acc.z\"",
                "\"sensor\": \"head.acc.z\", \"faults\": [{\"fault\": \"sensor.misalignment\", \"across\": \"head.acc.x\", \"angle_rad\": "
                        + angle + "}]"),
                "turned");
        double[] left = new double[2];
        for (int i = 0; i < 2; i++) {
            Recording plain = recording();
            Channel head = Channel.parse("head.acc.z");
            Channel across = Channel.parse("head.acc.x");
            double[] z = late(plain.values(head), 0.004 * i * plain.clock().rate());
            double[] x = late(Arrays.stream(plain.values(across)).map(value -> 5 * value).toArray(), 0.004 * i * plain.clock().rate());
            Map<Channel, double[]> values = new LinkedHashMap<>();
            plain.channels().forEach(channel -> values.put(channel, plain.values(channel)));
            values.put(head, IntStream.range(0, z.length).mapToDouble(k -> z[k] * Math.cos(angle) + x[k] * Math.sin(angle)).toArray());
            values.put(across, IntStream.range(0, z.length).mapToDouble(k -> x[k] * Math.cos(angle) - z[k] * Math.sin(angle)).toArray());
            left[i] = fitted(new Evidence(turned, new Recording(plain.clock(), values, plain.metadata()))).reduced();
        }
        assertEquals(left[0], left[1], 0.03 * left[0]);
    }

    /** Root mean square of what is left held out, over that of the signal. */
    private static double left(Evidence evidence, double[] model, int output) {
        double error = 0;
        double signal = 0;
        Window held = evidence.heldOut();
        for (int i = held.start(); i < held.start() + held.length(); i++) {
            error += Math.pow(evidence.measured(output)[i] - model[i], 2);
            signal += Math.pow(evidence.measured(output)[i], 2);
        }
        return Math.sqrt(error / signal);
    }

    /** By the discrete Fourier transform over the whole record. @param samples by which it is late, any fraction */
    private static double[] late(double[] x, double samples) {
        RealDft transform = new RealDft(RealDft.covering(x.length));
        double[] spectrum = transform.forward(Arrays.copyOf(x, transform.length()));
        for (int k = 0; 2 * k < spectrum.length; k++) {
            double turn = 2 * Math.PI * k * samples / transform.length();
            double re = spectrum[2 * k] * Math.cos(turn) + spectrum[2 * k + 1] * Math.sin(turn);
            spectrum[2 * k + 1] = spectrum[2 * k + 1] * Math.cos(turn) - spectrum[2 * k] * Math.sin(turn);
            spectrum[2 * k] = re;
        }
        return Arrays.copyOf(transform.inverse(spectrum), x.length);
    }

    /** Least squares within bounds: no single error can be moved, and none that is held at its bound let go, without loss. */
    @Test
    void theErrorsFoundAreTheBest() throws Exception {
        Evidence evidence = new Evidence(model(), recording());
        Fitter.State state = fitted(evidence);
        Nuisances nuisances = state.frame().nuisances();
        boolean[] off = new boolean[nuisances.count()];
        off[1] = true;
        Random random = new Random(7);
        double[] r = new double[nuisances.columns().get(0).length];
        for (int i = 0; i < nuisances.count(); i++) {
            double size = 8 * random.nextGaussian();
            for (int k = 0; k < r.length; k++) {
                r[k] += size * nuisances.columns().get(i)[k];
            }
        }
        BoundedLeastSquares.Explained found = nuisances.explain(r, off);
        assertTrue(IntStream.range(0, off.length).anyMatch(i -> nuisances.squares().isHeld(i, found.errors()[i])),
                "some stand at their bounds");
        assertTrue(!nuisances.squares().isHeld(0, SmallError.MOST - 0.1) && nuisances.squares().isHeld(0, -SmallError.MOST));
        double least = cost(nuisances, r, found.errors());
        assertEquals(least, found.square() + ScalarProduct.of(found.errors(), found.errors()), 1e-6 * least);
        for (int i = 0; i < off.length; i++) {
            for (double move : new double[] {-0.01, 0.01}) {
                double[] n = found.errors().clone();
                n[i] = Math.max(-SmallError.MOST, Math.min(SmallError.MOST, n[i] + move));
                assertTrue(off[i] ? n[i] == move : cost(nuisances, r, n) >= least * (1 - 1e-12), nuisances.error(i).toString());
            }
        }
    }

    private static double cost(Nuisances nuisances, double[] r, double[] n) {
        double[] left = nuisances.removed(r, n);
        return ScalarProduct.of(left, left) + ScalarProduct.of(n, n);
    }
}
