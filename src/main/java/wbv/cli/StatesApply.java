package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.learn.AdwinAlarm;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.report.states.StatesPage;
import wbv.result.OutputFolder;
import wbv.state.StateModel;
import wbv.state.StateModelFile;
import wbv.state.StateTrack;
import wbv.state.TrueStates;
import wbv.study.StatesStudy;

/** {@code wbv states apply}: labels recordings with a trained model. */
@Command(name = "apply", mixinStandardHelpOptions = true,
        description = "Labels recordings with a model of 'wbv states train'. Writes report.html, results.json, and of the first recording "
                + "labels.csv, labels.arff, bags.arff. Where the rig's truth lies beside a recording, the labels are compared with it.",
        footer = {"", "Example:", "  wbv states apply data/arff/states-other.arff --model model/model.json \\",
            "      --out out"})
final class StatesApply implements Callable<Integer> {

    @Parameters(paramLabel = "RECORDING", arity = "1..*", description = "recordings with the channels that the model was trained on")
    private List<Path> files = new ArrayList<>();

    @Option(names = "--model", paramLabel = "FILE", required = true, description = "model.json of 'wbv states train'")
    private Path model;

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        StateModel trained = StateModelFile.read(model);
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            StatesStudy study = new StatesStudy(trained);
            for (int i = 0; i < files.size(); i++) {
                bar.at("labelling", i / (double) files.size());
                Recording recording = new RecordingFile(files.get(i)).load();
                StateTrack track = new StateTrack(trained, files.get(i).toString(), recording);
                study.add(files.get(i).toString(), track, body(trained, recording), TrueStates.beside(files.get(i),
                        trained.thresholds()));
            }
            List<Path> inputs = new ArrayList<>(files);
            inputs.add(model);
            Map<String, String> provenance = new ResultProvenance(spec).of(inputs).entries();
            study.write(provenance, folder);
            StatesPage.write(study, provenance, folder);
            folder.publish();
            bar.close();
            answer.print(study.summary(), "Wrote " + out.file("report.html") + ", results.json, labels.csv, labels.arff, bags.arff\n",
                    out.json("results.json"));
        }
        return 0;
    }

    /** Natural frequency [Hz] and damping ratio from seat to head by the streaming estimator; empty where it finds no body. */
    static Optional<double[]> body(StateModel model, Recording recording) {
        Estimator estimator = EstimatorDesign.of(Method.FUSED).estimator(wbv.filter.model.Spec.at(recording.clock().rate()),
                () -> new AdwinAlarm(0.002));
        double[] seat = recording.values(model.features().seat());
        double[] head = recording.values(model.features().head());
        for (int i = 0; i < seat.length; i++) {
            estimator.step(seat[i], head[i]);
        }
        BodyEstimate track = estimator.track();
        return track.found() ? Optional.of(new double[] {track.frequency(), track.damping()}) : Optional.empty();
    }
}
