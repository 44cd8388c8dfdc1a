package wbv.task;

import com.github.javacliparser.FileOption;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Locale;
import moa.core.ObjectRepository;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.TaskMonitor;
import wbv.pole.Chord;
import wbv.pole.PolygonFile;
import wbv.pole.RemovalCheck;
import wbv.pole.SensorRemoval;
import wbv.pole.TrainedPoles;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/**
 * Predicts absent places by trained polygons; the result is the pole measured and the bounds over time, and the error where it
 * can be told.
 */
public class PredictAbsent extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;

    public final FileOption fileOption = new FileOption("file", 'f', "Recording, in any format that wbv reads.", null, null,
            false);
    public final FileOption polygonsOption = new FileOption("polygons", 'p', "Trained polygons.", null, "json", false);
    public final FileOption motionOption = new FileOption("motion", 'm', "File for the predicted motion, .csv or .arff.", null,
            "csv", true);

    @Override
    public String getPurposeString() {
        return "Predicts the motion of places without sensors from the poles of a place with one.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return String.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        try {
            TrainedPoles trained = PolygonFile.read(Path.of(Words.needed(polygonsOption)));
            String name = Words.needed(fileOption);
            Recording recording = new RecordingFile(Path.of(name)).load();
            SensorRemoval.Prediction prediction = new SensorRemoval(trained).predict(name, recording);
            if (motionOption.getValue() != null && !motionOption.getValue().isEmpty()) {
                prediction.writeMotion(Path.of(motionOption.getValue()), trained.layout().absent(), recording);
            }
            return text(trained, name, recording, prediction);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String text(TrainedPoles trained, String name, Recording recording, SensorRemoval.Prediction prediction) {
        StringBuilder text = new StringBuilder("time [s],frequency measured [Hz],damping measured");
        for (Channel channel : trained.layout().absent()) {
            text.append(",").append(channel.location()).append(" frequency from [Hz],").append(channel.location())
                    .append(" frequency to [Hz]");
        }
        for (SensorRemoval.Seen seen : prediction.seen()) {
            text.append(String.format(Locale.ROOT, "%n%.2f,%.4f,%.4f", seen.time(), seen.pole().frequency(), seen.pole()
                    .damping()));
            for (Channel channel : trained.layout().absent()) {
                Chord chord = seen.bounds().get(channel).get(0);
                text.append(String.format(Locale.ROOT, ",%.4f,%.4f", chord.lower(), chord.upper()));
            }
        }
        if (!prediction.seen().isEmpty()) {
            for (RemovalCheck check : RemovalCheck.of(trained, name, recording, prediction)) {
                text.append(String.format(Locale.ROOT, "%nerror over variance,%s,%.4f", check.channel(), check.error()));
            }
        }
        return text.toString();
    }
}
