package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ForkJoinPool;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.law.LearnedMemory;
import wbv.body.number.Modulator;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/** What broke earlier attempts, each as a recording in which nothing or one thing is wrong. */
class TrapsTest {

    private static final Path NULL_CASE = Path.of("data/arff/concealed/001");
    private static final Channel HEAD = Channel.parse("head.acc.z");
    private static final BiConsumer<String, Double> QUIET = (step, share) -> {};

    @TempDir
    private Path folder;

    private static Model model() throws IOException {
        return ModelFile.read(NULL_CASE.resolve("model.json"));
    }

    private static Recording recording() throws IOException {
        return new RecordingFile(NULL_CASE.resolve("recording.csv.gz")).load();
    }

    /** The recording in which nothing is missing, with one channel changed. */
    private static Recording with(Channel channel, java.util.function.UnaryOperator<double[]> change) throws IOException {
        Recording recording = recording();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (Channel each : recording.channels()) {
            double[] own = recording.values(each).clone();
            values.put(each, each.equals(channel) ? change.apply(own) : own);
        }
        return new Recording(recording.clock(), values, recording.metadata());
    }

    private static Diagnosis diagnose(Recording recording) throws IOException {
        return Diagnoser.diagnose(model(), recording, QUIET);
    }

    /** χ² is absolute: noise of input and outputs, both counted, leave 1. */
    @Test
    void whereNothingIsMissingOnlyNoiseIsLeft() throws IOException {
        Diagnosis diagnosis = diagnose(recording());
        assertEquals(1, diagnosis.fit().before(), 0.06);
        assertEquals(1, diagnosis.fit().heldBefore(), 0.06);
    }

    /** Ordinary scatter of a sensor's gain is not a fault; ten times as much is. */
    @Tag("slow")
    @Test
    void aSensorIsBlamedOnlyOutsideItsOrdinaryScatter() throws IOException {
        Diagnosis little = diagnose(with(HEAD, x -> scaled(x, 1.007)));
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, little.verdict(), little.sentence());
        Diagnosis much = diagnose(with(HEAD, x -> scaled(x, 1.2)));
        assertEquals("sensor.gain", much.missing().get(0).mechanism(), much.sentence());
        assertEquals(1.2, much.missing().get(0).parameters().get("factor"), 0.02);
    }

    private static double[] scaled(double[] x, double factor) {
        for (int i = 0; i < x.length; i++) {
            x[i] *= factor;
        }
        return x;
    }

    /** A large clock error is far beyond what a first-order look can see. */
    @Tag("slow")
    @Test
    void aDelayOfFiveSamplesIsFound() throws IOException {
        Diagnosis diagnosis = diagnose(with(HEAD, x -> {
            double[] out = new double[x.length];
            System.arraycopy(x, 0, out, 5, x.length - 5);
            return out;
        }));
        assertEquals("sensor.delay", diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
        assertEquals(5 / 60.0, diagnosis.missing().get(0).parameters().get("delay_s"), 0.002);
    }

    /** Clipping shifts the mean; that is no bias beside it. */
    @Tag("slow")
    @Test
    void clippingIsNotABiasToo() throws IOException {
        Diagnosis diagnosis = diagnose(with(HEAD, x -> {
            for (int i = 0; i < x.length; i++) {
                x[i] = Math.min(x[i], 1.5);
            }
            return x;
        }));
        assertEquals(1, diagnosis.missing().size(), diagnosis.sentence());
        assertEquals("sensor.clipping", diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
        // Levels are about the mean, which clipping from above has pulled down a little.
        assertEquals(1.5, diagnosis.missing().get(0).parameters().get("high"), 0.15);
    }

    /** Samples held while packets are lost are not mechanics. */
    @Test
    void droppedSamplesAreMaskedAndNamed() throws IOException {
        Recording recording = recording();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        Random random = new Random(3);
        boolean[] lost = new boolean[recording.length()];
        for (int k = 0; k < 40; k++) {
            int at = 200 + random.nextInt(recording.length() - 300);
            for (int i = at; i < at + 6; i++) {
                lost[i] = true;
            }
        }
        for (Channel each : recording.channels()) {
            double[] x = recording.values(each).clone();
            for (int i = 1; i < x.length && each.location().equals("head"); i++) {
                x[i] = lost[i] ? x[i - 1] : x[i];
            }
            values.put(each, x);
        }
        Diagnosis diagnosis = diagnose(new Recording(recording.clock(), values, recording.metadata()));
        assertEquals(1, diagnosis.missing().size(), diagnosis.sentence());
        assertEquals("sensor.dropouts", diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
    }

    /** A sitter who does not sit still is noise, not physics; one who is pushed is pushed. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(doubles = {2, 12})
    void aPersonsOwnForceIsNoiseUnlessItIsLarge(double newtons) throws IOException {
        Recording recording = recording();
        Model model = model();
        Excitation excitation = Excitation.of(model, recording, recording.length());
        double[] force = new double[recording.length()];
        Random random = new Random(1);
        double power = 0;
        double state = 0;
        for (int i = 0; i < force.length; i++) {
            state = 0.85 * state + random.nextGaussian();
            force[i] = state;
            power += state * state;
        }
        double[] spectrum = excitation.spectrum(scaled(force, newtons / Math.sqrt(power / force.length)));
        double[][] way = new Simulator(excitation).linearised(model.assembly()).ofBodyForce(model.index("torso"));
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, recording.values(channel).clone()));
        for (int o = 0; o < way.length; o++) {
            double[] answer = new double[spectrum.length];
            for (int k = 0; k < spectrum.length; k += 2) {
                answer[k] = way[o][k] * spectrum[k] - way[o][k + 1] * spectrum[k + 1];
                answer[k + 1] = way[o][k] * spectrum[k + 1] + way[o][k + 1] * spectrum[k];
            }
            double[] series = excitation.series(answer);
            double[] y = values.get(model.outputs().get(o));
            for (int i = 0; i < y.length; i++) {
                y[i] += series[i];
            }
        }
        Diagnosis diagnosis = diagnose(new Recording(recording.clock(), values, recording.metadata()));
        if (newtons < 4) {
            assertEquals(Diagnosis.Verdict.NOTHING_MISSING, diagnosis.verdict(), diagnosis.sentence());
        } else {
            assertEquals("input.unmeasured", diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
            assertEquals("torso", diagnosis.missing().get(0).where(), diagnosis.sentence());
            assertEquals(newtons, diagnosis.missing().get(0).parameters().get("rms_N"), 0.15 * newtons);
        }
    }

    /**
     * Nearly all that is missing enters at the torso, as a push there would; but it goes with the motion of the base, as what a mass does
     * that swings.
     */
    @Tag("slow")
    @Test
    void whatGoesWithTheBaseIsNoPush() throws Exception {
        Diagnosis diagnosis = diagnosed(
                new ConcealedSpec("swing", List.of("drift.slow", "mode.hidden"), 1, Setting.RIG, false, -7188853427568828664L));
        assertTrue(diagnosis.missing().stream()
                .anyMatch(named -> named.mechanism().equals("mode.hidden") && named.where().equals("torso")), diagnosis.sentence());
        assertTrue(diagnosis.missing().stream().noneMatch(named -> named.mechanism().equals("input.unmeasured")), diagnosis.sentence());
    }

    /**
     * What a link loses in the first moments of motion is no slow drift, as well as one would fit: it goes by what the link did of late.
     */
    @Tag("slow")
    @Test
    void whatIsOverInSecondsIsNoSlowDrift() throws Exception {
        Diagnosis diagnosis = diagnosed(
                new ConcealedSpec("lost", List.of("unlisted.thixotropy"), 0.3, Setting.FIELD, false, -5830821692404056944L));
        assertEquals(Diagnosis.Verdict.LEARNED_LAW, diagnosis.verdict(), diagnosis.sentence());
        // The level of the ride and that of the link go together: either says of late.
        assertTrue(
                diagnosis.learned().orElseThrow().terms().stream()
                        .allMatch(term -> term instanceof LearnedMemory || term.modulator() instanceof Modulator.Ride),
                diagnosis.sentence());
    }

    /**
     * A slow drift promises more than a step to first order, and after as many steps of its fit stands far behind the best of sixty
     * moments.
     */
    @Tag("slow")
    @Test
    void whatPromisesMostIsFittedToTheEnd() throws Exception {
        Diagnosis diagnosis = diagnosed(
                new ConcealedSpec("slow", List.of("drift.slow"), 0.1, Setting.ROTATION, false, -1668959073756272010L));
        assertEquals(List.of("drift.slow at torso-head"),
                diagnosis.missing().stream().map(named -> named.mechanism() + " at " + named.where()).toList(), diagnosis.sentence());
    }

    /** A mass that swings on the torso pushes it about as evenly as a hand would. */
    @Tag("exam")
    @Test
    void aHiddenMassIsNoPush() throws Exception {
        Diagnosis diagnosis = diagnosed(
                new ConcealedSpec("hidden", List.of("mode.hidden"), 0.1, Setting.ROTATION, false, -6316656002689495598L));
        assertEquals("mode.hidden", diagnosis.missing().get(0).mechanism(), diagnosis.sentence());
        assertEquals("torso", diagnosis.missing().get(0).where(), diagnosis.sentence());
    }

    /** So does a sitter who does not sit still. */
    @Tag("slow")
    @Test
    void aSitterWhoMovesIsNoPush() throws Exception {
        Diagnosis diagnosis = diagnosed(new ConcealedSpec("moving", List.of(), 1, Setting.RIG, false, 4017626126363145775L));
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, diagnosis.verdict(), diagnosis.sentence());
    }

    private Diagnosis diagnosed(ConcealedSpec spec) throws Exception {
        ConcealedCase made = Concealer.make(spec);
        Path model = Files.writeString(folder.resolve("model.json"), made.model());
        return Diagnoser.diagnose(ModelFile.read(model), made.recording(), QUIET);
    }

    /** A law is a law on any number of threads. */
    @Tag("slow")
    @Test
    void theAnswerDoesNotDependOnTheNumberOfThreads() throws Exception {
        Path folder = Path.of("data/arff/concealed/009");
        Model model = ModelFile.read(folder.resolve("model.json"));
        Recording recording = new RecordingFile(folder.resolve("recording.csv.gz")).load();
        String one = on(1, model, recording);
        assertEquals(one, on(3, model, recording));
    }

    private static String on(int threads, Model model, Recording recording) throws Exception {
        ForkJoinPool pool = new ForkJoinPool(threads);
        try {
            Diagnosis diagnosis = pool.submit(() -> Diagnoser.diagnose(model, recording, QUIET)).get();
            return diagnosis.sentence() + diagnosis.missing() + diagnosis.alternatives() + diagnosis.fit().after();
        } finally {
            pool.shutdown();
        }
    }

    /** A wrong input explains nothing, and is refused rather than explained. */
    @Test
    void anInputThatCausesNothingIsRefused() throws IOException {
        Random random = new Random(2);
        Recording noise = with(Channel.parse("platform.acc.z"), x -> random.doubles(x.length, -1, 1).toArray());
        DataFault fault = assertThrows(DataFault.class, () -> diagnose(noise));
        assertTrue(fault.getMessage().contains("does not cause"), fault.getMessage());
        Recording still = with(Channel.parse("platform.acc.z"), x -> new double[x.length]);
        assertThrows(DataFault.class, () -> diagnose(still));
    }

    @Test
    void aShortRecordingIsRefused() throws IOException {
        Recording whole = recording();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        whole.channels().forEach(channel -> values.put(channel, java.util.Arrays.copyOf(whole.values(channel), 600)));
        DataFault fault = assertThrows(DataFault.class, () -> diagnose(new Recording(whole.clock(), values, whole.metadata())));
        assertTrue(fault.getMessage().contains("15"), fault.getMessage());
    }
}
