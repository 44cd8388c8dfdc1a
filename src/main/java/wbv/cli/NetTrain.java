package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.network.Architecture;
import wbv.network.Bodies;
import wbv.network.Imaging;
import wbv.network.LabelledRecordings;
import wbv.network.Labels;
import wbv.network.Settings;
import wbv.network.SimulatedTrials;
import wbv.network.Trainer;
import wbv.network.TrainingData;
import wbv.network.TrainingOrder;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;
import wbv.recording.format.RecordingFile;
import wbv.report.network.NetworkTrainingReport;
import wbv.result.OutputFolder;

/** {@code wbv net train}: from the virtual rig, or from recordings with labels, to a model. */
@Command(name = "train", mixinStandardHelpOptions = true,
        description = "Trains a network on simulated trials, or on recordings whose bodies are known, and writes model.safetensors with "
                + "its card, losses.csv and report.html. The same seeds give the same model.",
        footer = {"", "Examples:", "  wbv net train --bodies 1-dof --network pooled --images 2046 --members 3 --out out",
            "  wbv net train rides/*.csv --labels labels.csv --output sternum.acc.z --out out", "",
            "labels.csv says what is known, a line for each stretch; recordings named by file, times by their clock:",
            "  recording,from_s,to_s,damping,frequency_Hz",
            "  ride1.csv,0,60,0.35,4.9",
            "For two modes the last columns are damping1,frequency1_Hz,damping2,frequency2_Hz, the slower first.",
            "Recordings, not windows, are divided into those learned from and those held back."})
final class NetTrain implements Callable<Integer> {

    @Parameters(paramLabel = "RECORDING", arity = "0..*", description = "recordings at 60 Hz to learn from, with --labels")
    private List<Path> recordings = new ArrayList<>();

    @Option(names = "--labels", paramLabel = "FILE", description = "CSV that says which body the recordings are of, and when")
    private Optional<Path> labels = Optional.empty();

    @Option(names = "--input", paramLabel = "CHANNEL", description = "exciting channel of the recordings (seat.acc.z)")
    private Optional<String> input = Optional.empty();

    @Option(names = "--output", paramLabel = "CHANNEL", description = "answering channel of the recordings (head.acc.z)")
    private Optional<String> output = Optional.empty();

    @Option(names = "--hop", paramLabel = "S", description = "from one window of a recording to the next (1.83, half a window)")
    private Optional<Double> hop = Optional.empty();

    @Option(names = "--bodies", paramLabel = "KIND",
            description = "who sits on the rig: 1-dof, 2-dof, coupled (a base that moves in three axes) or people (1-dof)")
    private Optional<String> bodies = Optional.empty();

    @Option(names = "--network", paramLabel = "NAME", defaultValue = "pooled",
            description = "cnn or residual (the thesis'), pooled (ours), answer-only (ours without a sensor at the seat), "
                    + "three-axes (ours that sees x and y at the seat as well), or thesis-cnn or thesis-residual (the thesis' with its own "
                    + "images of three axes at both places; recordings only) (${DEFAULT-VALUE})")
    private String network;

    @Option(names = "--images", paramLabel = "N", description = "simulated trials, a tenth of them held back (2046)")
    private Optional<Integer> images = Optional.empty();

    @Option(names = "--members", paramLabel = "N", defaultValue = "1",
            description = "networks from other seeds that are asked together (${DEFAULT-VALUE})")
    private int members;

    @Option(names = "--data-seed", paramLabel = "N", defaultValue = "1",
            description = "seed of the trials, or of the division of recordings (${DEFAULT-VALUE})")
    private long dataSeed;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "seed of the training (${DEFAULT-VALUE})")
    private int seed;

    @Option(names = "--epochs", paramLabel = "N", description = "times that every image is shown (the network's own)")
    private Optional<Integer> epochs = Optional.empty();

    @Option(names = "--batch", paramLabel = "N", description = "images at a step")
    private Optional<Integer> batch = Optional.empty();

    @Option(names = "--rate", paramLabel = "RATE", description = "learning rate")
    private Optional<Double> rate = Optional.empty();

    @Option(names = "--drop-period", paramLabel = "N",
            description = "epochs after which the learning rate drops: one reading of the thesis' \"Dropout Frequency 20\"")
    private Optional<Integer> dropPeriod = Optional.empty();

    @Option(names = "--drop-factor", paramLabel = "FACTOR", description = "by which it is multiplied then")
    private Optional<Double> dropFactor = Optional.empty();

    @Option(names = "--dropout", paramLabel = "SHARE",
            description = "units left out at each step: the other reading")
    private Optional<Double> dropout = Optional.empty();

    @Option(names = "--checkpoint", paramLabel = "FILE",
            description = "keeps the state after every epoch; where the file is there already, training goes on from it")
    private Optional<Path> checkpoint = Optional.empty();

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        requireOneKind();
        Optional<TrainingData> labelled = labels.isPresent() ? Optional.of(labelled(labels.get())) : Optional.empty();
        TrainingOrder order = order(labelled);
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            Trainer trainer = new Trainer(order, checkpoint, bar::at);
            Trainer.Result result = trainer.train();
            NetworkTrainingReport report = new NetworkTrainingReport(order, result, provenance());
            AtomicFile.write(folder.file("model.safetensors"), result.model().bytes());
            report.write(folder);
            folder.publish();
            trainer.forget();
            bar.close();
            answer.print(report.summary(), "Wrote " + out.file("model.safetensors") + ", losses.csv, report.html\n", report::json);
        }
        return 0;
    }

    private void requireOneKind() {
        String wrong = recordings.isEmpty() != labels.isEmpty() ? "recordings and --labels go together"
                : labels.isPresent() && (bodies.isPresent() || images.isPresent()) ? "--bodies and --images are for simulated trials; "
                        + "recordings have the bodies of their --labels"
                        : labels.isEmpty() && (input.isPresent() || output.isPresent() || hop.isPresent())
                                ? "--input, --output and --hop are for recordings with --labels"
                                : hop.isPresent() && !(hop.get() >= 1 / Imaging.RATE && hop.get() <= 3600)
                                        ? "--hop must be 0.0167 to 3600 s: " + hop.get() : "";
        if (!wrong.isEmpty()) {
            throw new ParameterException(spec.commandLine(), wrong);
        }
    }

    private TrainingOrder order(Optional<TrainingData> labelled) {
        try {
            Settings usual = architecture().settings();
            Settings settings = new Settings(epochs.orElse(usual.epochs()), batch.orElse(usual.batch()), usual.method(),
                    rate.orElse(usual.rate()), dropPeriod.orElse(usual.dropPeriod()), dropFactor.orElse(usual.dropFactor()),
                    dropout.orElse(usual.dropout()), seed);
            TrainingData data = labelled.isPresent() ? labelled.get()
                    : new SimulatedTrials(kind(bodies.orElse("1-dof")), images.orElse(2046), dataSeed);
            return new TrainingOrder(data, architecture(), settings, members);
        } catch (IllegalArgumentException wrong) {
            throw new ParameterException(spec.commandLine(), wrong.getMessage());
        }
    }

    private Architecture architecture() {
        return Architecture.named(network).orElseThrow(() -> new ParameterException(spec.commandLine(),
                "--network must be one of " + String.join(", ", Architecture.words()) + ": " + network));
    }

    private TrainingData labelled(Path file) throws IOException {
        Labels all = Labels.read(file);
        for (Labels.Label label : all.list()) {
            long named = recordings.stream().filter(recording -> all.of(recording).list().contains(label)).count();
            if (named != 1) {
                throw DataFault.at(file.toString(), label.line(), "'" + label.recording() + "' is "
                        + (named == 0 ? "none of the recordings; name it, or take the line out"
                                : "more than one of the recordings; give more of its path"));
            }
        }
        LabelledRecordings.Gathering gathering = new LabelledRecordings.Gathering(architecture(),
                Usage.channel(spec, input.orElse("seat.acc.z")), Usage.channel(spec, output.orElse("head.acc.z")), all.modes(),
                (int) Math.max(1, Math.round(hop.orElse(Imaging.SAMPLES / 2 / Imaging.RATE)
                        * Imaging.RATE)));
        for (Path recording : recordings) {
            Labels own = all.of(recording);
            if (own.list().isEmpty()) {
                throw DataFault.in(recording.toString(), "has no line in " + file);
            }
            gathering.add(recording.toString(), new RecordingFile(recording).load(), own);
        }
        return gathering.finish(dataSeed);
    }

    private Map<String, String> provenance() throws IOException {
        List<Path> files = new ArrayList<>(recordings);
        labels.ifPresent(files::add);
        return new ResultProvenance(spec).of(files).entries();
    }

    static Bodies kind(String word) {
        return Arrays.stream(Bodies.values()).filter(each -> each.word().equals(word)).findFirst()
                .orElseThrow(() -> new IllegalArgumentException("--bodies must be one of "
                        + String.join(", ", Arrays.stream(Bodies.values()).map(Bodies::word).toList()) + ": " + word));
    }
}
