package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.recording.AtomicFile;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.report.states.StatesPage;
import wbv.result.OutputFolder;
import wbv.state.FeatureSpec;
import wbv.state.MotionState;
import wbv.state.StateModel;
import wbv.state.StateModelFile;
import wbv.state.StateTrack;
import wbv.state.StateTraining;
import wbv.state.Thresholds;
import wbv.state.TrueStates;
import wbv.study.StatesStudy;

/** {@code wbv states train}: learns states from recordings. */
@Command(name = "train", mixinStandardHelpOptions = true,
        description = "Learns states of motion from recordings of seat and head. Where the rig's truth lies beside a recording, it "
                + "names the samples, elsewhere thresholds do. Writes model.json, report.html, and of the first recording labels.csv, "
                + "labels.arff, bags.arff.",
        footer = {"", "Example:", "  wbv states train data/arff/states-train.arff data/arff/states-bare.arff \\", "      --out model"})
final class StatesTrain implements Callable<Integer> {

    @Parameters(paramLabel = "RECORDING", arity = "1..*",
            description = "recordings with vertical acceleration of seat and head, and roll and "
                    + "pitch rate of the seat")
    private List<Path> files = new ArrayList<>();

    @Option(names = "--seat", paramLabel = "PLACE", defaultValue = "seat", description = "the lower place (${DEFAULT-VALUE})")
    private String seat;

    @Option(names = "--head", paramLabel = "PLACE", defaultValue = "head", description = "the upper place (${DEFAULT-VALUE})")
    private String head;

    @Option(names = "--mixture", paramLabel = "WAY", defaultValue = "message-length",
            description = "message-length, dirichlet or single (${DEFAULT-VALUE})")
    private String mixture;

    @Option(names = "--jerk", paramLabel = "M/S3", defaultValue = "40",
            description = "jerk beyond which a place jerks in a jolt (${DEFAULT-VALUE} m/s³)")
    private double jerk;

    @Option(names = "--surge", paramLabel = "M/S2", defaultValue = "1.8", description = "change of the seat's mean acceleration from "
            + "0.15 s to the next beyond which a jolt acts (${DEFAULT-VALUE} m/s²)")
    private double surge;

    @Option(names = "--rocking", paramLabel = "RAD/S", defaultValue = "0.05",
            description = "rate from which it rocks (${DEFAULT-VALUE} rad/s)")
    private double rocking;

    @Option(names = "--rest", paramLabel = "M/S3", defaultValue = "3", description = "jerk below which it rests (${DEFAULT-VALUE} m/s³)")
    private double rest;

    @Mixin
    private CommonOptions.Seed seed;

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        StateTraining.Mixing mixing = Arrays.stream(StateTraining.Mixing.values()).filter(way -> way.toString().equals(mixture))
                .findFirst()
                .orElseThrow(() -> new ParameterException(spec.commandLine(), "--mixture must be one of "
                        + Arrays.stream(StateTraining.Mixing.values()).map(Object::toString).collect(Collectors.joining(", "))
                        + ": " + mixture));
        Usage.place(spec, "--seat", seat);
        Usage.place(spec, "--head", head);
        Thresholds thresholds;
        try {
            thresholds = new Thresholds(jerk, surge, rocking, rest);
        } catch (IllegalArgumentException wrong) {
            throw new ParameterException(spec.commandLine(), wrong.getMessage());
        }
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            Recording first = new RecordingFile(files.get(0)).load();
            StateTraining training = new StateTraining(FeatureSpec.of(first.clock().rate(), seat, head, first.channels(),
                    files.get(0).toString()), thresholds);
            List<Recording> recordings = new ArrayList<>();
            List<Optional<TrueStates>> truths = new ArrayList<>();
            for (Path file : files) {
                bar.at("reading", recordings.size() / (double) files.size());
                Recording recording = recordings.isEmpty() ? first : new RecordingFile(file).load();
                recordings.add(recording);
                truths.add(TrueStates.beside(file, thresholds));
                training.add(file.toString(), recording, truths.get(truths.size() - 1));
            }
            StateModel model = training.finish(mixing, seed.number(), share -> bar.at("training", share));
            StatesStudy study = new StatesStudy(model);
            for (int i = 0; i < files.size(); i++) {
                bar.at("labelling", i / (double) files.size());
                study.add(files.get(i).toString(), new StateTrack(model, files.get(i).toString(), recordings.get(i)),
                        StatesApply.body(model, recordings.get(i)), truths.get(i));
            }
            Map<String, String> provenance = new ResultProvenance(spec).of(files).entries();
            AtomicFile.write(folder.file("model.json"), StateModelFile.text(model, provenance));
            study.write(provenance, folder);
            StatesPage.write(study, provenance, folder);
            folder.publish();
            bar.close();
            List<MotionState> few = training.tooFew();
            answer.print(
                    (few.isEmpty() ? "" : "Left out, seen in fewer than " + StateTraining.FEWEST + " samples: " + few + "\n")
                            + study.summary(),
                    "Wrote " + out.file("report.html") + ", model.json, results.json, labels.csv, labels.arff, bags.arff\n",
                    out.json("results.json"));
        }
        return 0;
    }
}
