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
import org.junit.jupiter.api.Test;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.RecordingFile;

/** The shipped model of motion states, and what it says of a stream. */
class StateRunsTest {

    private static final String TRAIN = "data/arff/states-train.arff";

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

    /** What ships is what {@code wbv states train data/arff/states-train.arff} writes. */
    @Test
    void theShippedModelIsTheOneThatTheCommandTrains() throws IOException {
        Recording recording = recording(TRAIN);
        StateTraining training = new StateTraining(FeatureSpec.of(recording.clock().rate(), "seat", "head", recording.channels(), TRAIN),
                Thresholds.USUAL);
        training.add(TRAIN, recording);
        String trained = StateModelFile.text(training.finish(StateTraining.Mixing.MESSAGE_LENGTH, 0, 1, share -> { }), Map.of());
        try (InputStream in = StateModelFile.class.getResourceAsStream("seated.json")) {
            String shipped = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            assertEquals(bare(trained), bare(shipped));
        }
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

    /** The last third of the ride rocks and shakes at once, on all axes: nothing like it was learned. */
    @Test
    void itIsSilentWhereItNeverWas() throws IOException {
        StateRuns runs = runs(recording("data/arff/ride-subject1.arff"));
        double silent = runs.runs().stream().filter(run -> run.state().isEmpty() && run.from() > 99 * 60)
                .mapToDouble(run -> (run.to() - run.from()) / 60.0).sum();
        assertEquals(50, silent, 2);
        assertEquals(silent, runs.silence(), 2);
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
