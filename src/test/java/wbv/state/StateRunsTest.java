package wbv.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.rig.RigFiles;
import wbv.rig.RigSpec;

/** The shipped model of motion states, and what it says of a stream. */
class StateRunsTest {

    private static final String TRAIN = "data/arff/states-train.arff";

    @TempDir
    private Path folder;

    private static Recording recording(String file) throws IOException {
        return new RecordingFile(Path.of(file)).load();
    }

    private static StateRuns runs(Recording recording) {
        StateModel model = StateModelFile.shipped();
        StateRuns runs = new StateRuns(model);
        List<double[]> channels = model.features().channels().stream().map(recording::values).toList();
        double[] sample = new double[channels.size()];
        for (int i = 0; i < recording.length(); i++) {
            for (int c = 0; c < sample.length; c++) {
                sample[c] = channels.get(c)[i];
            }
            runs.accept(sample);
        }
        runs.finish();
        return runs;
    }

    /** What ships is what {@code wbv states train data/arff/states-train.arff data/arff/states-bare.arff} writes. */
    @Tag("slow")
    @Test
    void theShippedModelIsTheOneThatTheCommandTrains() throws IOException {
        Recording recording = recording(TRAIN);
        StateTraining training = new StateTraining(FeatureSpec.of(recording.clock().rate(), "seat", "head", recording.channels(), TRAIN),
                Thresholds.USUAL);
        for (String file : List.of(TRAIN, "data/arff/states-bare.arff")) {
            training.add(file, recording(file), TrueStates.beside(Path.of(file), Thresholds.USUAL));
        }
        String trained = StateModelFile.text(training.finish(StateTraining.Mixing.MESSAGE_LENGTH, 1, share -> {}), Map.of());
        try (InputStream in = StateModelFile.class.getResourceAsStream("seated.json")) {
            String shipped = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            assertEquals(bare(trained), bare(shipped));
        }
    }

    /** People, seats and levels that it was not trained on; {@code StatesProof regimes} is the table. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"random:7,usual,2", "random:7,usual,4", "random:8,'usual,-cushion',6", "random:8,'usual,-cushion',7"})
    void itHoldsAtEveryLevelAndOnBothSeats(String subject, String effects, int regime) throws IOException {
        Path file = folder.resolve("ride.arff");
        RigFiles.write(RigSpec.parse("subject=" + subject + " effects=" + effects + " excitation=ride:" + regime + " seconds=60 seed="
                + (700 + regime) + " channels=seat.acc.z,head.acc.z,seat.gyr.x,seat.gyr.y"), file, false);
        StateTrack track = new StateTrack(StateModelFile.shipped(), "ride", recording(file.toString()));
        Confusion confusion = TrueStates.beside(file, Thresholds.USUAL).orElseThrow().against(track, false);
        assertTrue(confusion.accuracy() > 0.88, "accuracy " + confusion.accuracy());
        assertTrue(confusion.macroF1() > 0.7, "macro-F1 " + confusion.macroF1());
    }

    private static String bare(String model) {
        return model.substring(0, model.indexOf("\"provenance\""));
    }

    /** A person that it was not trained on, against what the rig injected. */
    @Test
    void ofAnotherPersonItIsRightNineTimesInTen() throws IOException {
        Path file = Path.of("data/arff/states-other.arff");
        Recording other = recording(file.toString());
        StateRuns runs = runs(other);
        List<MotionState> truth = TrueStates.beside(file, Thresholds.USUAL).orElseThrow().states();
        int right = 0;
        int told = 0;
        long end = 0;
        for (StateRuns.Run run : runs.runs()) {
            assertEquals(end, run.from(), "one after another, without a gap");
            end = run.to();
            for (long i = run.from(); i < run.to() && run.state().isPresent(); i++) {
                told++;
                right += truth.get((int) i) == run.state().get() ? 1 : 0;
            }
        }
        assertEquals(other.length() - runs.model().features().delay(), end);
        assertTrue(told > 0.9 * other.length(), told + " told");
        assertTrue(right > 0.9 * told, right + " of " + told);
        assertTrue(runs.agreement() > 0.9, "agreement " + runs.agreement());
        double seconds = runs.seconds().values().stream().mapToDouble(Double::doubleValue).sum();
        assertEquals(end / 60.0, seconds + runs.silence(), 1e-9);
    }

    /** A seat that is thrown to and fro with four times gravity is like nothing that was learned. */
    @Test
    void itIsSilentWhereItNeverWas() {
        StateRuns runs = new StateRuns(StateModelFile.shipped());
        for (int i = 0; i < 60 * 60; i++) {
            double thrown = i < 30 * 60 ? 0 : 40 * Math.sin(2 * Math.PI * 2 * i / 60);
            runs.accept(new double[] {thrown, thrown, 0, 0});
        }
        runs.finish();
        assertEquals(30, runs.silence(), 2);
        assertEquals(30, runs.seconds().get(MotionState.IDLE), 2);
    }

    @Test
    void itNeedsItsChannelsAndItsRate() {
        StateModel model = StateModelFile.shipped();
        List<Channel> channels = model.features().channels();
        assertTrue(StateRuns.canTell(model, channels, 60.2));
        assertFalse(StateRuns.canTell(model, channels, 100));
        assertFalse(StateRuns.canTell(model, channels.subList(0, 3), 60));
    }

    @Test
    void nothingToldOfNothing() {
        StateRuns runs = new StateRuns(StateModelFile.shipped());
        for (int i = 0; i < 300; i++) {
            runs.accept(new double[] {Double.NaN, Double.NaN, Double.NaN, Double.NaN});
        }
        runs.finish();
        assertTrue(runs.seconds().isEmpty());
        assertTrue(Double.isNaN(runs.agreement()));
    }
}
