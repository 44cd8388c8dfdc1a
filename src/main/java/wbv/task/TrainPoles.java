package wbv.task;

import com.github.javacliparser.FileOption;
import com.github.javacliparser.FloatOption;
import com.github.javacliparser.StringOption;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import moa.core.ObjectRepository;
import moa.tasks.AuxiliarMainTask;
import moa.tasks.MainTask;
import moa.tasks.TaskMonitor;
import wbv.pole.Density;
import wbv.pole.Layout;
import wbv.pole.PlaceClusters;
import wbv.pole.PoleTraining;
import wbv.pole.PoleWindows;
import wbv.pole.PolygonFile;
import wbv.recording.AtomicFile;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/**
 * Learns what the poles of a measured place say of absent ones; the result tells how they gather, the file holds the polygons.
 */
public class TrainPoles extends AuxiliarMainTask {

    private static final long serialVersionUID = 1;

    public final StringOption filesOption = new StringOption("files", 'f', "Recordings with all sensors, separated by commas.",
            "");
    public final FileOption polygonsOption = new FileOption("polygons", 'p', "File for the trained polygons.", null, "json",
            false);
    public final StringOption baseOption = new StringOption("base", 'b', "Place that shakes the seat.", "platform");
    public final StringOption measuredOption = new StringOption("measured", 'm', "Place whose sensor stays.", "seat");
    public final StringOption absentOption = new StringOption("absent", 'a', "Places whose sensors will go, separated by commas.",
            "sternum,head");
    public final FloatOption windowOption = new FloatOption("window", 'w', "Length of a window [s].", 25, 10, 600);
    public final FloatOption hopOption = new FloatOption("hop", 'h', "Time from one window to the next [s].", 5, 0.1, 600);

    @Override
    public String getPurposeString() {
        return "Learns from recordings what the poles of one place say of places whose sensors will go.";
    }

    @Override
    public Class<?> getTaskResultType() {
        return String.class;
    }

    @Override
    protected Object doMainTask(TaskMonitor monitor, ObjectRepository repository) {
        String polygons = Words.needed(polygonsOption);
        List<String> files = Words.of(Words.needed(filesOption));
        if (files.isEmpty()) {
            throw new IllegalArgumentException("-f needs at least one recording");
        }
        try {
            PoleWindows windows = new PoleWindows(windowOption.getValue(), hopOption.getValue(), PoleWindows.USUAL.poles());
            Recording first = new RecordingFile(Path.of(files.get(0))).load();
            PoleTraining training = new PoleTraining(Layout.along('z', baseOption.getValue(), measuredOption.getValue(),
                    Words.of(absentOption.getValue()), first.channels()), windows);
            for (int i = 0; i < files.size(); i++) {
                monitor.setCurrentActivity("identifying", i / (double) files.size());
                training.add(training.examine(files.get(i), i == 0 ? first : new RecordingFile(Path.of(files.get(i))).load()));
            }
            PoleTraining.Result result = training.finish();
            String text = PolygonFile.text(result.trained(), Map.of("task", getCLICreationString(MainTask.class)));
            AtomicFile.write(Path.of(polygons), text.getBytes(StandardCharsets.UTF_8));
            return text(result);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String text(PoleTraining.Result result) {
        StringBuilder text = new StringBuilder("place,poles,clusters,noise,epsilon");
        for (PlaceClusters place : result.places()) {
            text.append(String.format(Locale.ROOT, "%n%s,%d,%d,%d,%.4f", place.place(), place.poles().size(), place.count(),
                    place.members(Density.NOISE).size(), place.curve().epsilon()));
        }
        return text.toString();
    }
}
