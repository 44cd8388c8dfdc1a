package wbv.cli;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.report.analysis.AnalysisPage;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;
import wbv.study.Analysis;
import wbv.study.AnalysisRequest;
import wbv.study.AnalysisResults;

/** {@code wbv analyze}: everything for one recording, in one report. */
@Command(name = "analyze", mixinStandardHelpOptions = true,
        description = "Looks at one recording: what is wrong with it, transmissibility, body parameters over time. Writes report.html, "
                + "results.json, tracks.csv and tracks.arff.",
        footer = {"", "Examples:", "  wbv analyze data/arff/ride-subject1.arff --out out",
            "  wbv analyze car.csv --map data/maps/wobble.json \\", "      --input axle_pass.acc.z --output knuckle_pass.acc.z",
            "  zcat ride.csv.gz | wbv analyze - --json"})
final class Analyze implements Callable<Integer> {

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--input", paramLabel = "CHANNEL", description = "exciting channel (platform.acc.z, floor.acc.z or seat.acc.z if there is one)")
    private Optional<String> input = Optional.empty();

    @Option(names = "--output", paramLabel = "CHANNEL", split = ",",
            description = "answering channels (all others of the input's quantity and axis)")
    private List<String> outputs = new ArrayList<>();

    @Option(names = "--start-frequency", paramLabel = "HZ", defaultValue = "5", description = "natural frequency to start from (${DEFAULT-VALUE})")
    private double frequency;

    @Option(names = "--start-damping", paramLabel = "RATIO", defaultValue = "0.4", description = "damping ratio to start from (${DEFAULT-VALUE})")
    private double damping;

    @Mixin
    private ResultFolder out = new ResultFolder();

    @Option(names = "--gz", description = "compress the tracks: tracks.csv.gz, tracks.arff.gz")
    private boolean compressed;

    @Mixin
    private Answer answer = new Answer();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        AnalysisRequest request = new AnalysisRequest(recording.source(), recording.title(), recording.map(), NamedChannels.of(spec, input.stream().toList()), NamedChannels.of(spec, outputs),
                checked("--start-frequency", frequency, wbv.filter.model.Spec.LEAST_FREQUENCY, wbv.filter.model.Spec.MOST_FREQUENCY, "Hz"),
                checked("--start-damping", damping, wbv.filter.model.Spec.LEAST_DAMPING, wbv.filter.model.Spec.MOST_DAMPING, ""),
                new ResultProvenance(spec).of(recording.inputs()).entries());
        String ending = compressed ? ".gz" : "";
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            Analysis analysis = Analysis.run(request, folder, ending, bar::at);
            AnalysisResults results = analysis.finish(folder);
            AnalysisPage.write(analysis, folder);
            folder.publish();
            bar.close();
            answer.print(analysis.summary(), "Wrote " + out.file("report.html") + ", results.json, tracks.csv" + ending + ", tracks.arff" + ending + "\n",
                    () -> ResultsJson.render(results));
        }
        return 0;
    }

    private double checked(String option, double value, double low, double high, String unit) {
        if (!(value >= low && value <= high)) {
            throw new ParameterException(spec.commandLine(), String.format(Locale.ROOT, "%s must be %s to %s %s: %s", option, low, high, unit, value));
        }
        return value;
    }
}
