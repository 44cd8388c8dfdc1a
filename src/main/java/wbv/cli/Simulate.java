package wbv.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import wbv.body.Model;
import wbv.body.PublishedModels;
import wbv.fmi.FmuSimulation;
import wbv.recording.Recording;
import wbv.recording.format.ColumnMap;
import wbv.recording.format.ReadOptions;
import wbv.recording.format.RecordingFile;
import wbv.recording.format.RecordingWriter;
import wbv.result.ResultsJson;
import wbv.rig.RigFiles;
import wbv.rig.RigSpec;
import wbv.rig.Shipped;

/** {@code wbv simulate}: the virtual experiment as a recording, with the truth beside it. */
@Command(name = "simulate", mixinStandardHelpOptions = true,
        description = "Plays an experiment of the virtual rig (shaken platform, simulated sitter, inertial sensors) into a recording, "
                + "with the truth beside it; or runs a model on the input of a recording.",
        footer = {"", "Words of an experiment (each has a default):",
            "  sitter=person|one-dof|two-dof  subject=1..4|random:SEED  mass=KG  posture=slouched|normal|erect",
            "  regime=0..8 (Table 3-3 of the thesis)  seconds=120  seed=1  rate=60  channels=all,seat.force.z,head.mag.x  "
                    + "effects=usual,loss",
            "  zeta=0.35  f0=5  step=1.25@60  excitation=random:z:0.5-12:1",
            "  cross=0.3,-0.2 lets the base's x and y push a one-dof up: excitation=random:z:0.5-12:1,random:x:0.5-12:1",
            "  excitation=ride:4 is a ride with rests, jolts and rocking at times that stand in its truth",
            "", "Examples:", "  wbv simulate subject=2 regime=4 seconds=120 seed=7 --out ride.csv.gz",
            "  wbv simulate sitter=one-dof zeta=0.35 f0=5 seconds=60 --out body.arff",
            "  wbv simulate --model out/model.json --input ride.csv --out simulated.csv",
            "  wbv simulate --fmu rig.fmu --input ride.csv --out simulated.csv",
            "  wbv simulate --models",
            "  wbv simulate --model wei-griffin-1998-1dof --input ride.csv --out sim.csv"})
final class Simulate implements Callable<Integer> {

    @Parameters(paramLabel = "WORD=VALUE", arity = "0..*", description = "the experiment, see below")
    private List<String> words = new ArrayList<>();

    @Option(names = "--out", paramLabel = "FILE", description = "name of the recording, ending in .csv, .csv.gz or .arff")
    private Optional<Path> out = Optional.empty();

    @Option(names = "--full-truth", description = "also write states and noise-free outputs as truth")
    private boolean full;

    @Option(names = "--shipped", paramLabel = "DIR", description = "write the recordings that come with wbv into this folder instead")
    private Optional<Path> shipped = Optional.empty();

    @Option(names = "--model", paramLabel = "MODEL",
            description = "run this model, a JSON file or the name of a published one, on a recording's input instead of the rig")
    private Optional<String> model = Optional.empty();

    @Option(names = "--fmu", paramLabel = "FILE.fmu",
            description = "run this functional mock-up unit (FMI 2.0 or 3.0) on a recording's channels instead")
    private Optional<Path> fmu = Optional.empty();

    @Mixin
    private UnitOptions variables;

    @Option(names = "--models", description = "list the published models instead")
    private boolean models;

    @Option(names = "--map", paramLabel = "FILE", description = "JSON that says which column of a foreign CSV is which channel of --input")
    private Optional<Path> map = Optional.empty();

    @Option(names = "--input", paramLabel = "RECORDING", description = "recording whose input the model is run on")
    private Optional<Path> input = Optional.empty();

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (models) {
            list();
            return 0;
        }
        if (out.isPresent() == shipped.isPresent()) {
            throw wrong("say where to write: either --out FILE or --shipped DIR");
        }
        if (shipped.isEmpty() && ((model.isPresent() || fmu.isPresent()) != input.isPresent() || model.isPresent() && fmu.isPresent())) {
            throw wrong("--input goes with one of --model and --fmu");
        }
        if (shipped.isEmpty() && variables.given() && fmu.isEmpty()) {
            throw wrong("--map-input and --map-output are about the variables of --fmu");
        }
        StringBuilder notes = new StringBuilder();
        List<List<Path>> written = new ArrayList<>();
        try (ProgressBar bar = answer.progress()) {
            bar.at("simulating", Double.NaN);
            if (shipped.isPresent()) {
                Files.createDirectories(shipped.get());
                for (Shipped each : Shipped.values()) {
                    bar.at("simulating " + each.fileName(), each.ordinal() / (double) Shipped.values().length);
                    written.add(RigFiles.write(each.spec(), shipped.get().resolve(each.fileName()), each.full()));
                }
            } else if (fmu.isPresent()) {
                try (FmuSimulation unit = variables.open(fmu.get(), recording())) {
                    RecordingWriter.write(out.get(), unit.run(Map.of()));
                    unit.notes().forEach(note -> notes.append(note).append('\n'));
                }
                written.add(List.of(out.get()));
            } else if (model.isPresent()) {
                Recording driving = recording();
                Prediction.write(PublishedModels.find(model.get()), driving, 0, driving.length(), out.get());
                written.add(List.of(out.get()));
            } else {
                written.add(RigFiles.write(experiment(), out.get(), full));
            }
        }
        List<List<String>> names = written.stream().map(files -> files.stream().map(Path::toString).toList()).toList();
        answer.print(notes.toString(),
                names.stream().map(files -> "Wrote " + String.join(", ", files) + "\n").collect(Collectors.joining()),
                () -> ResultsJson.render(new Answer.Written(names.stream().flatMap(List::stream).toList())));
        return 0;
    }

    private RigSpec experiment() {
        try {
            return RigSpec.parse(String.join(" ", words));
        } catch (IllegalArgumentException e) {
            throw wrong(e.getMessage());
        }
    }

    /** A published model for machines. */
    private record Published(String name, int bodies, double mass_kg, String source) {}

    private void list() throws IOException {
        List<Published> all = new ArrayList<>();
        StringBuilder text = new StringBuilder();
        for (String name : PublishedModels.names()) {
            Model each = PublishedModels.open(name);
            all.add(new Published(name, each.bodies().size(), each.mass(), each.source().orElse("")));
            text.append(String.format(Locale.ROOT, "%-26s %d %s, %.1f kg. %s%n", name, each.bodies().size(),
                    each.bodies().size() == 1 ? "body" : "bodies", each.mass(), each.source().orElse("")));
        }
        answer.print(text.toString(), "", () -> ResultsJson.render(all));
    }

    private Recording recording() throws IOException {
        return new RecordingFile(input.orElseThrow(),
                new ReadOptions(map.isPresent() ? Optional.of(ColumnMap.read(map.get())) : Optional.empty(),
                        OptionalDouble.empty(), Map.of()))
                .load();
    }

    private ParameterException wrong(String message) {
        return new ParameterException(spec.commandLine(), message);
    }
}
