package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.BiFunction;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.measured.Measured;
import wbv.diagnosis.measured.NoiseLevel;
import wbv.diagnosis.search.Search;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.signal.BandlimitedResampler;

/** Sampled faster, with rows lost, gaps, axes that were not recorded, models with a number left out: the answer stays what it was. */
class RecordingsAsTheyAreTest {

    /** Nothing is missing. */
    private static final Path NULL = Path.of("data/arff/concealed/001");
    /** The spring on the platform softens. */
    private static final Path SOFTENING = Path.of("data/arff/concealed/003");

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"5, 3, 0", "64, 15, 0.01"})
    void aFastRecordingIsLikeAnyOther(int up, int down, double noise) throws IOException {
        Random random = new Random(1);
        Recording usual = recording(SOFTENING);
        Recording fast = each(usual, usual.clock().rate() * up / down,
                (channel, x) -> Arrays.stream(BandlimitedResampler.resample(x, up, down))
                        .map(value -> value + noise * random.nextGaussian()).toArray());
        Diagnosis diagnosis = diagnose(model(SOFTENING), fast);
        assertEquals(1, diagnosis.missing().size(), diagnosis.sentence());
        assertEquals("stiffness.softening", diagnosis.missing().get(0).mechanism());
        assertEquals("platform-pelvis", diagnosis.missing().get(0).where());
        assertEquals(0.681e-3, diagnosis.missing().get(0).parameters().get("knee_m"), 0.01e-3);
        assertEquals(usual.duration() * Measured.FIT_SHARE, diagnosis.fit().heldOut()[0], 0.1);
    }

    @Test
    void aSlowRecordingNeedsItsNoise() throws IOException {
        Recording usual = recording(NULL);
        Recording slow = each(usual, usual.clock().rate() * 2 / 3, (channel, x) -> BandlimitedResampler.resample(x, 2, 3));
        DataFault refused = assertThrows(DataFault.class, () -> diagnose(model(NULL), slow));
        assertTrue(refused.getMessage().contains("40.00 Hz") && refused.getMessage().contains("--noise"), refused.getMessage());
        double noise = new NoiseLevel().ofPlace(usual, Channel.parse("platform.acc.z"));
        Diagnosis diagnosis = Diagnoser.diagnose(new Question(model(NULL), slow, Optional.empty(), OptionalDouble.of(noise)),
                (step, share) -> {});
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, diagnosis.verdict(), diagnosis.sentence());
    }

    @ParameterizedTest
    @CsvSource({"1, 0.01", "2, 0.04"})
    void lostRowsAreNoMismatch(long seed, double share) throws IOException {
        Recording recording = recording(NULL);
        Random random = new Random(seed);
        boolean[] lost = new boolean[recording.length()];
        for (int i = 0; i < lost.length; i++) {
            lost[i] = random.nextDouble() < share;
        }
        assertSilent(each(recording, (channel, x) -> {
            for (int i = 0; i < x.length; i++) {
                x[i] = lost[i] ? Double.NaN : x[i];
            }
            return x;
        }));
    }

    @Test
    void gapsOfTheInputAreNoPush() throws IOException {
        assertSilent(each(recording(NULL), (channel, x) -> {
            if (channel.location().equals("platform")) {
                Arrays.fill(x, 2000, 2030, Double.NaN);
                Arrays.fill(x, 4000, 4060, Double.NaN);
            }
            return x;
        }));
    }

    @Test
    void valuesOfTheInputThatAreSentAgainAreNoPush() throws IOException {
        assertSilent(each(recording(NULL), (channel, x) -> {
            if (channel.location().equals("platform")) {
                Arrays.fill(x, 2000, 2030, x[2000]);
                Arrays.fill(x, 4000, 4060, x[4000]);
            }
            return x;
        }));
    }

    @Test
    void silenceIsNotConcludedFromNothing() throws IOException {
        Recording recording = recording(SOFTENING);
        Recording stopped = each(recording, (channel, x) -> {
            if (channel.location().equals("platform")) {
                Arrays.fill(x, (int) (0.69 * x.length), x.length, Double.NaN);
            }
            return x;
        });
        DataFault refused = assertThrows(DataFault.class, () -> diagnose(model(SOFTENING), stopped));
        assertTrue(refused.getMessage().contains("too little to prove"), refused.getMessage());
    }

    /** What is missing of an output takes nothing off what is seen of the mismatch. */
    @Test
    void gapsOfAnOutputDiluteNothing() throws IOException {
        Recording recording = recording(SOFTENING);
        double whole = before(recording);
        double part = before(each(recording, (channel, x) -> {
            for (int k = 0; k < 10 && channel.location().equals("head"); k++) {
                Arrays.fill(x, k * x.length / 10, k * x.length / 10 + 3 * x.length / 100, Double.NaN);
            }
            return x;
        }));
        assertTrue(part > 0.9 * whole, part + " against " + whole);
    }

    /** What a diagnosis calls {@code fit().before()}: the fitted model without physics missing; no mechanism need be tried for it. */
    private static double before(Recording recording) throws IOException {
        Evidence evidence = new Evidence(model(SOFTENING), recording);
        return new Search(evidence, (step, share) -> {}).base(Baseline.of(evidence)).reduced();
    }

    @Test
    void axesThatWereNotRecordedTellNoNoise() throws IOException {
        assertSilent(each(recording(NULL), (channel, x) -> channel.location().equals("platform") && channel.axis() != 'z'
                && channel.quantity() == Quantity.ACCELERATION ? new double[x.length] : x));
    }

    @Test
    void aDampingThatWasLeftOutIsFound() throws IOException {
        Model given = model(NULL);
        List<Model.Link> links = new ArrayList<>(given.links());
        Model.Link last = links.remove(links.size() - 1);
        links.add(new Model.Link(last.from(), last.to(), last.stiffness(), 0, last.sensor(), last.laws(), last.drives()));
        Diagnosis diagnosis = diagnose(
                new Model(given.name(), given.source(), given.axis(), given.base(), given.bodies(), links, given.inputs()),
                recording(NULL));
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, diagnosis.verdict(), diagnosis.sentence());
        double found = diagnosis.model().links().get(links.size() - 1).damping();
        assertEquals(last.damping(), found, 0.1 * last.damping());
    }

    private static void assertSilent(Recording recording) throws IOException {
        Diagnosis diagnosis = diagnose(model(NULL), recording);
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, diagnosis.verdict(), diagnosis.sentence());
        assertTrue(diagnosis.missing().isEmpty());
    }

    private static Diagnosis diagnose(Model model, Recording recording) {
        return Diagnoser.diagnose(model, recording, (step, share) -> {});
    }

    private static Model model(Path folder) throws IOException {
        return ModelFile.read(folder.resolve("model.json"));
    }

    private static Recording recording(Path folder) throws IOException {
        return new RecordingFile(folder.resolve("recording.csv.gz")).load();
    }

    private static Recording each(Recording recording, BiFunction<Channel, double[], double[]> change) {
        return each(recording, recording.clock().rate(), change);
    }

    /** @param change may change the samples that it is given */
    private static Recording each(Recording recording, double rate, BiFunction<Channel, double[], double[]> change) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, change.apply(channel, recording.values(channel).clone())));
        return new Recording(new Clock(recording.clock().start(), rate), values, recording.metadata());
    }
}
