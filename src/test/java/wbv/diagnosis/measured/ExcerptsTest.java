package wbv.diagnosis.measured;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.law.Law;
import wbv.body.law.StepChange;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/** A long recording is judged by pieces of it, which keep their time. */
class ExcerptsTest {

    private static final double RATE = 200;
    private static final int SAMPLES = 120_000;
    private static final int READINGS = 16_000;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel MASS = Channel.parse("seat.acc.z");

    @Test
    void piecesAreEvenlySpreadAndKeepTheirTime() {
        Recording counted = recording(counted(), counted());
        Excerpts pieces = Excerpts.of(model(40000, List.of()), counted, OptionalDouble.empty(), READINGS).orElseThrow();
        Recording laid = pieces.recording();
        assertTrue(laid.length() > 0.9 * READINGS && laid.length() <= READINGS, laid.length() + " samples");
        double[] x = laid.values(MASS);
        for (int i = 0; i < x.length; i++) {
            if (!Double.isNaN(x[i])) {
                assertEquals(counted.time((long) x[i]), laid.time(i), 1e-6);
            }
        }
        assertEquals(0, x[0]);
        assertEquals(SAMPLES - 1, x[x.length - 1]);
        // Each third of the recording gives a third of what counts.
        long middle = Arrays.stream(x).filter(at -> at > SAMPLES / 3.0 && at < 2 * SAMPLES / 3.0).count();
        assertEquals(laid.length() / 3.0, middle, 0.1 * laid.length());
    }

    @Test
    void whatProvesIsSpreadOverItsOwnPart() {
        Recording counted = recording(counted(), counted());
        double from = counted.time(SAMPLES / 2);
        Excerpts pieces = Excerpts.of(model(40000, List.of()), counted, OptionalDouble.of(from), READINGS).orElseThrow();
        int split = (int) pieces.recording().clock().nearest(pieces.provedFrom().orElseThrow());
        double[] x = pieces.recording().values(MASS);
        assertEquals(SAMPLES / 2, x[split]);
        assertEquals(SAMPLES / 2 - 1, Arrays.stream(x, 0, split).filter(at -> !Double.isNaN(at)).max().orElseThrow());
        assertEquals(Measured.FIT_SHARE, (double) split / x.length, 0.1);
    }

    @Test
    void whatIsShortOrGoesOnAsItWasSentIsJudgedWhole() {
        Recording counted = recording(counted(), counted());
        assertEquals(Optional.empty(), Excerpts.of(model(40000, List.of()), counted, OptionalDouble.empty(), SAMPLES));
        assertEquals(Optional.empty(), Excerpts.of(model(0, List.of()), counted, OptionalDouble.empty(), READINGS));
    }

    /** A seat that softens at one moment moves in the pieces as it does in the whole, once what it did before has died down. */
    @Test
    void lawsThatGoByTheClockRunInPiecesAsInTheWhole() {
        double[] base = smooth(smooth(new Random(5).doubles(SAMPLES, -20, 20).toArray()));
        Model softening = model(40000, List.of(new StepChange(311, 0.5, 0.8)));
        double[] whole = new Simulator(new Excitation(RATE, base, Map.of())).outputs(softening.assembly())[0];
        Recording laid = Excerpts.of(softening, recording(base, whole), OptionalDouble.empty(), READINGS).orElseThrow().recording();
        Measured measured = new Measured(softening, laid, OptionalDouble.of(0.01), false, OptionalDouble.empty());
        double[] pieces = new Simulator(measured.input()).outputs(softening.assembly())[0];
        boolean[] counts = measured.valid(0);
        int[] counted = IntStream.range(0, laid.length()).filter(i -> counts[i]).toArray();
        assertTrue(counted.length > 0.75 * laid.length(), counted.length + " of " + laid.length());
        double rms = Math.sqrt(Arrays.stream(counted).mapToDouble(i -> Math.pow(laid.values(MASS)[i], 2)).average().orElseThrow());
        // The input's mean, of the pieces, is no motion, and moved the whole.
        double mean = LostSamples.mean(laid.values(Channel.parse("platform.acc.z")));
        double off = Math.sqrt(Arrays.stream(counted).mapToDouble(i -> Math.pow(laid.values(MASS)[i] - pieces[i] - mean, 2)).average()
                .orElseThrow());
        assertTrue(off < 0.01 * rms, off + " of " + rms);
    }

    /** White noise of which pieces are lost is as strong as it was. */
    @Test
    void noiseIsReadWhereNothingIsBridged() {
        Random random = new Random(8);
        double sum = 0;
        int times = 20;
        for (int draw = 0; draw < times; draw++) {
            double[] x = random.doubles(20_000, -1, 1).toArray();
            for (int gap = 1500; gap + 400 < x.length; gap += 4000) {
                Arrays.fill(x, gap, gap + 400, Double.NaN);
            }
            sum += 3 * Math.pow(new NoiseLevel().bound(x), 2) / times;
        }
        assertEquals(1, sum, 0.03);
    }

    /** Slower than about 5 Hz. */
    private static double[] smooth(double[] x) {
        double[] out = new double[x.length];
        for (int i = 1; i < x.length; i++) {
            out[i] = out[i - 1] + 0.15 * (x[i] - out[i - 1]);
        }
        return out;
    }

    private static double[] counted() {
        return IntStream.range(0, SAMPLES).asDoubleStream().toArray();
    }

    private static Recording recording(double[] base, double[] mass) {
        return new Recording(new Clock(7, RATE), new LinkedHashMap<>(Map.of(BASE, base, MASS, mass)), Metadata.NONE);
    }

    private static Model model(double stiffness, List<Law> laws) {
        return new Model("bench", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
                List.of(new Model.Body("seat", 50, Optional.of(MASS), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("platform", "seat", stiffness, 900, Optional.empty(), laws, List.of())), List.of(),
                Optional.of(Model.Subject.RIG));
    }
}
