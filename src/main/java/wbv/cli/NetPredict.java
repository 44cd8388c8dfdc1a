package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.network.Imaging;
import wbv.network.NetworkReadings;
import wbv.network.Reader;
import wbv.network.TrainedNetwork;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.report.network.NetworkReadingReport;
import wbv.result.OutputFolder;

/** {@code wbv net predict}: what a network reads from a recording. */
@Command(name = "predict", mixinStandardHelpOptions = true,
        description = "Reads damping ratio and natural frequency from every 3.65 s of a recording at 60 Hz. Writes readings.csv, "
                + "results.json and report.html.",
        footer = {"", "Example:", "  wbv net predict data/arff/one-dof-linear.arff --input platform.acc.z \\",
            "      --output head.acc.z --out out"})
final class NetPredict implements Callable<Integer> {

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--model", paramLabel = "FILE", description = "model of 'wbv net train' (the one that comes with wbv)")
    private Optional<Path> file = Optional.empty();

    @Option(names = "--modes", paramLabel = "N", defaultValue = "1",
            description = "modes of the body, 1 or 2, where no model is named (${DEFAULT-VALUE})")
    private int modes;

    @Option(names = "--input", paramLabel = "CHANNEL", description = "exciting channel (the one that the model was trained on)")
    private Optional<String> input = Optional.empty();

    @Option(names = "--output", paramLabel = "CHANNEL", description = "answering channel (the one that the model was trained on)")
    private Optional<String> output = Optional.empty();

    @Option(names = "--hop", paramLabel = "S", defaultValue = "0.5",
            description = "from one window to the next (${DEFAULT-VALUE})")
    private double hop;

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (!(hop >= 1 / Imaging.RATE && hop <= 3600) || modes < 1 || modes > 2) {
            throw new ParameterException(spec.commandLine(), "--hop must be 0.0167 to 3600 s, --modes 1 or 2: " + hop + ", "
                    + modes);
        }
        TrainedNetwork model = file.isPresent() ? TrainedNetwork.read(file.get()) : TrainedNetwork.shipped(modes);
        Channel from = input.map(name -> Usage.channel(spec, name)).orElse(model.channels().get(0));
        Channel to = output.map(name -> Usage.channel(spec, name)).orElse(model.channels().get(1));
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress(); Reader reader = reader(model)) {
            bar.at("reading windows", Double.NaN);
            NetworkReadings readings = NetworkReadings.of(reader, recording.title(), recording.source().load(), from, to,
                    Math.max(1, (int) Math.round(hop * Imaging.RATE)));
            List<Path> inputs = new ArrayList<>(recording.inputs());
            file.ifPresent(inputs::add);
            NetworkReadingReport report = new NetworkReadingReport(recording.title(), from + " to " + to, model, readings,
                    new ResultProvenance(spec).of(inputs).entries());
            report.write(folder);
            folder.publish();
            bar.close();
            answer.print(report.summary(), "Wrote " + out.file("report.html") + ", readings.csv, results.json\n", out.json("results.json"));
        }
        return 0;
    }

    private Reader reader(TrainedNetwork model) {
        try {
            return new Reader(model);
        } catch (DataFault unlike) {
            throw file.map(path -> unlike.of(path.toString())).orElse(unlike);
        }
    }
}
