package wbv.task;

import com.github.javacliparser.FileOption;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Locale;
import moa.core.ObjectRepository;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.recording.format.RecordingFile;
import wbv.state.MotionState;
import wbv.state.StateFiles;
import wbv.state.StateModelFile;
import wbv.state.StateTrack;

/** Labels a recording with a trained model; the result says how long every state lasted. */
public class ApplyStates extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;

    public final FileOption fileOption = new FileOption("file", 'f', "Recording, in any format that wbv reads.", null, null,
            false);
    public final FileOption modelOption = new FileOption("model", 'm', "model.json of 'wbv states train'.", null, "json", false);
    public final FileOption labelsOption = new FileOption("labels", 't', "File for the label of every sample, as ARFF.", null,
            "arff", true);

    @Override
    public String getPurposeString() {
        return "Labels a recording with states of motion.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return String.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        try {
            StateTrack track = new StateTrack(StateModelFile.read(Path.of(Words.needed(modelOption))), Words.needed(fileOption),
                    new RecordingFile(Path.of(fileOption.getValue())).load());
            if (labelsOption.getValue() != null && !labelsOption.getValue().isEmpty()) {
                StateFiles.writeArff(track, Path.of(labelsOption.getValue()));
            }
            StringBuilder text = new StringBuilder("state,seconds");
            for (MotionState state : track.model().known()) {
                int samples = 0;
                for (int i = 0; i < track.length(); i++) {
                    samples += track.state(i) == state ? 1 : 0;
                }
                text.append(String.format(Locale.ROOT, "%n%s,%.2f", state, samples / track.recording().clock().rate()));
            }
            return text.toString();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
