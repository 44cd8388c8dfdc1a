package wbv.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.recording.Inspection;
import wbv.recording.Recording;
import wbv.recording.RowSource;
import wbv.report.OutputFolder;

/** {@code wbv diagnose}: where a model and a recording differ, what physics is missing, the model with it, and the proof. */
@Command(name = "diagnose", mixinStandardHelpOptions = true,
        description = "Says where a model and a recording differ, which physics was left out, writes the model with it and shows the fit improve "
                + "on data it did not use. Writes diagnosis.json, model.json, prediction.csv and report.html.",
        footer = {"", "Example:", "  wbv diagnose data/arff/concealed/003/recording.csv.gz --model data/arff/concealed/003/model.json --out out"})
final class Diagnose implements Callable<Integer> {

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--model", paramLabel = "FILE", required = true, description = "the linear model, as JSON")
    private Path model;

    @Option(names = "--out", paramLabel = "DIR", defaultValue = "out", description = "folder for the results (${DEFAULT-VALUE})")
    private Path out;

    @Option(names = "--json", description = "print diagnosis.json instead of a summary")
    private boolean json;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        Model given = ModelFile.read(model);
        RowSource source = recording.source();
        try (OutputFolder folder = OutputFolder.at(out); ProgressBar bar = new ProgressBar()) {
            Inspection inspection = source.inspect(share -> bar.at("reading", share));
            given.base().sensor().ifPresent(inspection::require);
            given.outputs().forEach(inspection::require);
            Recording loaded = source.load(inspection);
            Diagnosis diagnosis = Diagnoser.diagnose(given, loaded, bar::at);
            Files.writeString(folder.file("model.json"), ModelFile.text(diagnosis.model()));
            Prediction.write(diagnosis, loaded, folder.file("prediction.csv"));
            List<Path> inputs = new ArrayList<>(recording.inputs());
            inputs.add(model);
            folder.publish();
            bar.close();
            print(diagnosis);
        }
        return 0;
    }

    private void print(Diagnosis diagnosis) {
        var printer = spec.commandLine().getOut();
        printer.println(diagnosis.verdict().word() + ": " + diagnosis.sentence());
        diagnosis.fit().nrmseAfter().forEach((channel, after) -> printer.printf(java.util.Locale.ROOT,
                "  %-18s held-out error %5.1f %% before, %5.1f %% after, %5.1f %% is noise%n", channel,
                100 * diagnosis.fit().nrmseBefore().get(channel), 100 * after, 100 * diagnosis.fit().nrmseFloor().get(channel)));
        if (!diagnosis.nextExperiment().isEmpty()) {
            printer.println("  To settle it: " + diagnosis.nextExperiment());
        }
        printer.println("Wrote " + out.resolve("report.html") + ", diagnosis.json, model.json, prediction.csv");
    }
}
