package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.pole.Layout;
import wbv.pole.PoleTraining;
import wbv.pole.PoleWindows;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.report.poles.PolesPage;
import wbv.result.OutputFolder;
import wbv.study.PolesStudy;

/** {@code wbv poles}: what the poles of a place that stays measured say of places whose sensors will go. */
@Command(name = "poles", mixinStandardHelpOptions = true,
        description = "Learns from recordings with all sensors what the poles of one place (the seat) say of others (sternum, "
                + "head), so that 'wbv track --without' can do without their sensors. One recording in ten is held back and "
                + "checked. Writes polygons.json, poles.csv and report.html.",
        footer = {"", "Example:",
            "  for r in 1 2 3 4 5 6 7 8; do",
            "    wbv simulate subject=1 regime=$r seconds=90 seed=$r --out ride$r.csv; done",
            "  wbv poles ride*.csv --out out"})
final class Poles implements Callable<Integer> {

    private static final int HELD_BACK = 10;

    @Parameters(paramLabel = "RECORDING", arity = "1..*", description = "recordings with all sensors, one trial each")
    private List<Path> files = new ArrayList<>();

    @Option(names = "--check", paramLabel = "RECORDING", split = ",",
            description = "further recordings to hold back, such as those of other subjects")
    private List<Path> others = new ArrayList<>();

    @Option(names = "--base", paramLabel = "PLACE", defaultValue = "platform",
            description = "what shakes the seat (${DEFAULT-VALUE})")
    private String base;

    @Option(names = "--measured", paramLabel = "PLACE", defaultValue = "seat",
            description = "place whose sensor stays (${DEFAULT-VALUE})")
    private String measured;

    @Option(names = "--absent", paramLabel = "PLACE", split = ",", defaultValue = "sternum,head",
            description = "places whose sensors will go (${DEFAULT-VALUE})")
    private List<String> absent = new ArrayList<>();

    @Option(names = "--axis", paramLabel = "AXIS", defaultValue = "z", description = "x, y or z (${DEFAULT-VALUE})")
    private char axis;

    @Option(names = "--window", paramLabel = "S", defaultValue = "25", description = "length of a window (${DEFAULT-VALUE})")
    private double window;

    @Option(names = "--hop", paramLabel = "S", defaultValue = "5", description = "from one window to the next (${DEFAULT-VALUE})")
    private double hop;

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if ("xyz".indexOf(axis) < 0) {
            throw new ParameterException(spec.commandLine(), "--axis must be x, y or z: " + axis);
        }
        if (!(window >= 10 && window <= 600) || !(hop >= 0.1 && hop <= window)) {
            throw new ParameterException(spec.commandLine(),
                    "--window must be 10 to 600 s and --hop 0.1 s to the window: " + window + ", " + hop);
        }
        Usage.place(spec, "--base", base);
        Usage.place(spec, "--measured", measured);
        absent.forEach(place -> Usage.place(spec, "--absent", place));
        List<Path> checked = new ArrayList<>(others);
        List<Path> learned = new ArrayList<>();
        for (int i = 0; i < files.size(); i++) {
            (i % HELD_BACK == HELD_BACK - 1 ? checked : learned).add(files.get(i));
        }
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            Layout layout = layout(load(learned.get(0)));
            PoleTraining training = new PoleTraining(layout, new PoleWindows(window, hop, PoleWindows.USUAL.poles()));
            for (int i = 0; i < learned.size(); i++) {
                bar.at("identifying", i / (double) learned.size());
                training.add(training.examine(learned.get(i).toString(), load(learned.get(i))));
            }
            PolesStudy study = new PolesStudy(training.finish());
            for (Path each : checked) {
                bar.at("checking", Double.NaN);
                study.check(each.toString(), load(each));
            }
            List<Path> inputs = new ArrayList<>(learned);
            inputs.addAll(checked);
            Map<String, String> provenance = new ResultProvenance(spec).of(inputs).entries();
            study.write(provenance, folder);
            PolesPage.write(study, provenance, folder);
            folder.publish();
            bar.close();
            answer.print(study.summary(), "Wrote " + out.file("report.html") + ", polygons.json, poles.csv, results.json\n",
                    out.json("results.json"));
        }
        return 0;
    }

    private Layout layout(Recording first) {
        try {
            return Layout.along(axis, base, measured, absent, first.channels());
        } catch (IllegalArgumentException twice) {
            throw new ParameterException(spec.commandLine(), twice.getMessage());
        }
    }

    private static Recording load(Path file) throws IOException {
        return new RecordingFile(file).load();
    }
}
