package wbv.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnosed;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Question;
import wbv.recording.Channel;
import wbv.recording.Inspection;
import wbv.recording.Recording;
import wbv.recording.RowSource;
import wbv.report.DiagnosisReport;
import wbv.report.OutputFolder;

/** {@code wbv diagnose}: where a model and a recording differ, what physics is missing, the model with it, and the proof. */
@Command(name = "diagnose", mixinStandardHelpOptions = true,
        description = "Says where a model and a recording differ, which physics was left out, writes the model with it and shows the fit improve "
                + "on data it did not use. Writes diagnosis.json, model.json, prediction.csv and report.html.",
        footer = {"", "Example (in data/arff/concealed/003):", "  wbv diagnose recording.csv.gz --model model.json --out out"})
final class Diagnose implements Callable<Integer> {

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--model", paramLabel = "FILE", required = true, description = "the linear model, as JSON")
    private Path model;

    @Option(names = "--simulation", paramLabel = "CHANNEL",
            description = "channel of the recording that holds what a simulation gave; what it leaves out is diagnosed")
    private Optional<String> simulation = Optional.empty();

    @Option(names = "--noise", paramLabel = "SD", description = "standard deviation of a sample of the outputs, in their unit, where it is known")
    private Optional<Double> noise = Optional.empty();

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
            given.excitations().forEach(inspection::require);
            given.outputs().forEach(inspection::require);
            Recording loaded = source.load(inspection);
            Diagnosed diagnosed = Diagnoser.examine(new Question(given, loaded, channel(), noise.map(OptionalDouble::of)
                    .orElseGet(OptionalDouble::empty)), bar::at);
            Diagnosis diagnosis = diagnosed.diagnosis();
            Files.writeString(folder.file("model.json"), ModelFile.text(diagnosis.model()));
            Prediction.write(diagnosis, loaded, folder.file("prediction.csv"));
            List<Path> inputs = new ArrayList<>(recording.inputs());
            inputs.add(model);
            List<String> words = new ArrayList<>(List.of("diagnose"));
            words.addAll(recording.words());
            words.addAll(List.of("--model", model.toString()));
            simulation.ifPresent(name -> words.addAll(List.of("--simulation", name)));
            noise.ifPresent(sd -> words.addAll(List.of("--noise", sd.toString())));
            DiagnosisReport.write(diagnosis, diagnosed.pictures(), new Provenance(words).of(inputs).entries(), folder);
            String text = json ? Files.readString(folder.file("diagnosis.json")) : summary(diagnosis);
            folder.publish();
            bar.close();
            spec.commandLine().getOut().print(text);
            spec.commandLine().getOut().flush();
        }
        return 0;
    }

    private Optional<Channel> channel() {
        try {
            return simulation.map(Channel::parse);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--simulation: " + e.getMessage());
        }
    }

    private String summary(Diagnosis diagnosis) {
        StringBuilder text = new StringBuilder(diagnosis.verdict().word() + ": " + diagnosis.sentence() + "\n");
        diagnosis.fit().nrmseAfter().forEach((channel, after) -> text.append(String.format(Locale.ROOT,
                "  %-18s held-out error %5.1f %% before, %5.1f %% after, %5.1f %% is noise%n", channel,
                100 * diagnosis.fit().nrmseBefore().get(channel), 100 * after, 100 * diagnosis.fit().nrmseFloor().get(channel))));
        if (!diagnosis.nextExperiment().isEmpty()) {
            text.append("  To settle it: ").append(diagnosis.nextExperiment()).append('\n');
        }
        return text.append("Wrote ").append(out.resolve("report.html")).append(", diagnosis.json, model.json, prediction.csv\n").toString();
    }
}
