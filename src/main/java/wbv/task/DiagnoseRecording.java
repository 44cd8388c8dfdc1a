package wbv.task;

import com.github.javacliparser.FileOption;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import moa.core.ObjectRepository;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.body.Model;
import wbv.body.PublishedModels;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/** Diagnoses a recording against a model; the result is the verdict, what is missing, and how well the completed model predicts. */
public class DiagnoseRecording extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;

    public final FileOption fileOption = new FileOption("file", 'f', "Recording, in any format that wbv reads.", null, null, false);
    public final FileOption modelOption = new FileOption("model", 'm',
            "Model of the sitter, as JSON, or the name of a published one.", null, "json", false);

    @Override
    public String getPurposeString() {
        return "Says where a model and a recording differ and which physics was left out.";
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        try {
            Model model = PublishedModels.find(Words.needed(modelOption));
            Recording recording = new RecordingFile(Path.of(Words.needed(fileOption))).load();
            Diagnosis diagnosis = Diagnoser.diagnose(PublishedModels.named(modelOption.getValue())
                    ? model.seenBy(recording.channels()) : model, recording,
                    (step, share) -> monitor.setCurrentActivity(step, share));
            return text(diagnosis);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String text(Diagnosis diagnosis) {
        StringBuilder text = new StringBuilder("verdict,").append(diagnosis.verdict().word()).append('\n');
        for (Diagnosis.Named named : diagnosis.missing()) {
            text.append("missing,").append(named.mechanism()).append(',').append(named.where()).append(',').append(named.probability());
            named.parameters().forEach((key, value) -> text.append(',').append(key).append('=').append(value));
            text.append('\n');
        }
        diagnosis.fit().nrmseAfter().forEach((channel, after) -> text.append("held-out error,").append(channel).append(',')
                .append(diagnosis.fit().nrmseBefore().get(channel)).append(',').append(after).append('\n'));
        return text.append("sentence,\"").append(diagnosis.sentence()).append('"').toString();
    }

    @Override
    public Class<?> getTaskResultType() {
        return String.class;
    }
}
