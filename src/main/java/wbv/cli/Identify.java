package wbv.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.recording.Channel;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.study.Identification;

/** {@code wbv identify}: linear models of a path, with their poles. */
@Command(name = "identify", mixinStandardHelpOptions = true,
        description = "Identifies linear models from inputs to an output: ARMAX by prediction error, its orders chosen by Schwarz's "
                + "criterion, and a model in continuous time by refined instruments; natural frequencies and damping ratios of "
                + "their poles with ±2σ. Writes identification.json.",
        footer = {"", "Examples:", "  wbv identify data/arff/two-dof.arff --input platform.acc.z \\", "      --output head.acc.z --out out",
            "  wbv identify ride.csv --output head.acc.z --poles 4 \\", "      --input platform.acc.z,platform.acc.x,platform.gyr.y"})
final class Identify implements Callable<Integer> {

    private static final int LEAST = 2;
    private static final int MOST = 20;

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--input", paramLabel = "CHANNEL", split = ",", required = true, description = "exciting channels")
    private List<String> inputs = new ArrayList<>();

    @Option(names = "--output", paramLabel = "CHANNEL", required = true, description = "answering channel")
    private String output;

    @Option(names = "--poles", paramLabel = "N", split = ",", description = "numbers of poles to choose among, 2 to 20 (2,3,4,5,6,7,8)")
    private List<Integer> poles = new ArrayList<>();

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        List<Integer> candidates = poles.isEmpty() ? IntStream.rangeClosed(LEAST, 8).boxed().toList() : poles.stream().distinct().toList();
        if (candidates.stream().anyMatch(n -> n < LEAST || n > MOST)) {
            throw new ParameterException(spec.commandLine(), "--poles must be " + LEAST + " to " + MOST + ": " + candidates);
        }
        List<Channel> in = Usage.channels(spec, inputs);
        Channel answering = Usage.channel(spec, output);
        if (in.stream().distinct().count() < in.size() || in.contains(answering)) {
            throw new ParameterException(spec.commandLine(), "inputs and the output must be different channels: " + in + ", " + answering);
        }
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            bar.at("identifying", Double.NaN);
            Identification found = Identification.of(recording.title(), recording.source().load(), in, answering, candidates,
                    new ResultProvenance(spec).of(recording.inputs()).entries());
            ResultsJson.write(found, folder.file("identification.json"));
            folder.publish();
            bar.close();
            answer.print(found.summary(), "Wrote " + out.file("identification.json") + "\n", () -> ResultsJson.render(found));
        }
        return 0;
    }
}
