package wbv.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.format.RecordingFile;
import wbv.rig.RigSpec;
import weka.classifiers.Evaluation;
import weka.core.CheckOptionHandler;
import weka.core.CheckScheme;
import weka.core.Instances;
import weka.core.converters.ArffLoader;

/** Weka's own checks of our learners, and our exports in Weka's own loader. */
class WekaTest {

    @ParameterizedTest
    @ValueSource(strings = {"MessageLengthClusterer", "DirichletClusterer"})
    void clusterersPassWekasCheck(String name) throws Exception {
        weka.clusterers.CheckClusterer check = new weka.clusterers.CheckClusterer();
        check.setOptions(new String[] {"-W", "wbv.state." + name});
        passes(check, 5);
    }

    @Test
    void classifierPassesWekasCheck() throws Exception {
        weka.classifiers.CheckClassifier check = new weka.classifiers.CheckClassifier();
        check.setOptions(new String[] {"-W", "wbv.state.SequenceClassifier"});
        passes(check, 5);
    }

    @ParameterizedTest
    @ValueSource(strings = {"MessageLengthClusterer", "DirichletClusterer", "SequenceClassifier"})
    void optionsPassWekasCheck(String name) throws Exception {
        CheckOptionHandler check = new CheckOptionHandler();
        check.setOptions(new String[] {"-W", "wbv.state." + name});
        String said = said(check::doTests);
        assertTrue(check.getSuccess(), said);
    }

    private static void passes(CheckScheme check, int least) throws Exception {
        String said = said(check::doTests);
        long good = said.lines().filter(line -> line.strip().endsWith("...yes")).count();
        assertTrue(good >= least, said);
        for (String bad : List.of("Problem during", "incorrect", "...FAILED", "Exception", "did not")) {
            assertFalse(said.contains(bad), bad + "\n" + said);
        }
    }

    private static String said(Runnable tests) {
        PrintStream out = System.out;
        ByteArrayOutputStream heard = new ByteArrayOutputStream();
        try {
            System.setOut(new PrintStream(heard, true));
            tests.run();
        } finally {
            System.setOut(out);
        }
        return heard.toString();
    }

    @Tag("slow")
    @Test
    void exportsOpenInWekasLoaderAndTeachItsLearners(@TempDir Path folder) throws Exception {
        StateTrack track = track();
        StateFiles.writeArff(track, folder.resolve("labels.arff"));
        StateFiles.writeBags(track, folder.resolve("bags.arff"));
        Instances rows = load(folder.resolve("labels.arff"));
        assertEquals(track.length(), rows.numInstances());
        int probe = track.length() / 2;
        assertEquals(track.features()[probe][0], rows.instance(probe).value(1), "digit for digit");
        assertEquals(track.state(probe).toString(), rows.instance(probe).stringValue(FeatureSpec.NAMES.size() + 1));

        MessageLengthClusterer clusterer = new MessageLengthClusterer();
        rows.deleteAttributeAt(FeatureSpec.NAMES.size() + 1);
        rows.deleteAttributeAt(0);
        assertTrue(rows.instance(0).hasMissingValue(), "the first rows have no derivative yet");
        clusterer.setMost(3);
        clusterer.buildClusterer(new Instances(rows, 0, 600));
        double log = clusterer.logDensityForInstance(rows.instance(0));
        assertTrue(Double.isFinite(log), "what is missing is taken to be ordinary: " + log);

        Instances bags = load(folder.resolve("bags.arff"));
        bags.setClassIndex(2);
        assertEquals(track.length() / 60, bags.numInstances());
        assertEquals(60, bags.instance(3).relationalValue(1).numInstances());
        assertEquals(track.features()[3 * 60 + 5][1], bags.instance(3).relationalValue(1).instance(5).value(1));
        Evaluation evaluation = new Evaluation(bags);
        evaluation.crossValidateModel(new SequenceClassifier(), bags, 4, new Random(1));
        assertTrue(evaluation.pctCorrect() > 85, evaluation.toSummaryString());
    }

    private static Instances load(Path file) throws Exception {
        ArffLoader loader = new ArffLoader();
        loader.setFile(file.toFile());
        return loader.getDataSet();
    }

    private static StateTrack track() throws Exception {
        var recording = new RecordingFile(Path.of("data/arff/states-train.arff")).load();
        StateTraining training = new StateTraining(FeatureSpec.of(60, "seat", "head", recording.channels(), "states-train.arff"),
                Thresholds.USUAL);
        training.add("states-train.arff", recording);
        StateModel model = training.finish(StateTraining.Mixing.SINGLE, 1, share -> {});
        return new StateTrack(model, "ride", RigSpec.parse("subject=2 excitation=ride:1 seconds=90 seed=3 "
                + "channels=seat.acc.z,head.acc.z,seat.gyr.x,seat.gyr.y").recording());
    }
}
