package wbv.cli;

import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
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

    @Mixin
    private CommonOptions.Body body;

    @Mixin
    private ResultFolder out;

    @Option(names = "--gz", description = "compress the tracks: tracks.csv.gz, tracks.arff.gz")
    private boolean compressed;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        AnalysisRequest request = new AnalysisRequest(recording.source(), recording.title(), recording.map(), body.input(), body.outputs(),
                body.startFrequency(), body.startDamping(),
                new ResultProvenance(spec).of(recording.inputs()).entries());
        String ending = compressed ? ".gz" : "";
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            Analysis analysis = Analysis.run(request, folder, ending, bar::at);
            AnalysisResults results = analysis.finish(folder);
            AnalysisPage.write(analysis, folder);
            folder.publish();
            bar.close();
            answer.print(analysis.summary(),
                    "Wrote " + out.file("report.html") + ", results.json, tracks.csv" + ending + ", tracks.arff" + ending + "\n",
                    () -> ResultsJson.render(results));
        }
        return 0;
    }
}
