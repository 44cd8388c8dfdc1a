package wbv.task;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.IntOption;
import com.github.javacliparser.MultiChoiceOption;
import com.github.javacliparser.StringOption;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import moa.core.ObjectRepository;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.MainTask;
import moa.tasks.TaskMonitor;
import wbv.recording.AtomicFile;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.state.FeatureSpec;
import wbv.state.StateModel;
import wbv.state.StateModelFile;
import wbv.state.StateTraining;
import wbv.state.Thresholds;
import wbv.state.TrueStates;

/** Learns states of motion from recordings; the result says how many samples each was learned from, the file holds the model. */
public class TrainStates extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;

    public final StringOption filesOption = new StringOption("files", 'f', "Recordings of seat and head, separated by commas.",
            "");
    public final FileOption modelOption = new FileOption("model", 'm', "File for the model.", null, "json", false);
    public final MultiChoiceOption mixtureOption = new MultiChoiceOption("mixture", 'x', "How mixtures are found.",
            Arrays.stream(StateTraining.Mixing.values()).map(Object::toString).toArray(String[]::new),
            new String[] {"minimum message length", "Dirichlet process", "one normal density a state"}, 0);
    public final IntOption seedOption = new IntOption("seed", 'r', "Seed of everything random.", 1, 0, Integer.MAX_VALUE);

    @Override
    public String getPurposeString() {
        return "Learns states of motion (idle, riding, rocking, jerk) from recordings.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return String.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        List<String> files = Words.of(filesOption.getValue());
        if (files.isEmpty() || modelOption.getValue() == null || modelOption.getValue().isEmpty()) {
            throw new IllegalArgumentException("-f needs at least one recording, and -m a file for the model");
        }
        try {
            Recording first = new RecordingFile(Path.of(files.get(0))).load();
            StateTraining training = new StateTraining(FeatureSpec.of(first.clock().rate(), "seat", "head", first.channels(),
                    files.get(0)),
                    Thresholds.USUAL);
            for (int i = 0; i < files.size(); i++) {
                monitor.setCurrentActivity("reading", i / (double) files.size());
                training.add(files.get(i), i == 0 ? first : new RecordingFile(Path.of(files.get(i))).load(),
                        TrueStates.beside(Path.of(files.get(i)), Thresholds.USUAL));
            }
            StateModel model = training.finish(StateTraining.Mixing.values()[mixtureOption.getChosenIndex()], seedOption.getValue(),
                    share -> monitor.setCurrentActivity("training", share));
            String file = StateModelFile.text(model, Map.of("task", getCLICreationString(MainTask.class)));
            AtomicFile.write(Path.of(modelOption.getValue()), file.getBytes(StandardCharsets.UTF_8));
            StringBuilder text = new StringBuilder("state,samples");
            model.rows().forEach((state, rows) -> text.append(System.lineSeparator()).append(state).append(',').append(rows));
            return text.toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
