package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.PublishedModels;
import wbv.body.simulate.RollOff;
import wbv.diagnosis.Diagnosed;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.FoundForces;
import wbv.diagnosis.Question;
import wbv.diagnosis.Rides;
import wbv.diagnosis.picture.Pictures;
import wbv.diagnosis.surrogate.Simulated;
import wbv.diagnosis.surrogate.Surrogate;
import wbv.fmi.FmuSimulation;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.recording.format.RecordingWriter;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.RowSource;
import wbv.report.diagnosis.DiagnosisReport;
import wbv.result.OutputFolder;
import wbv.study.FoldedFindings;

/** {@code wbv diagnose}: where a model and a recording differ, what physics is missing, the model with it, and the proof. */
@Command(name = "diagnose", mixinStandardHelpOptions = true,
        description = "Says where a model and a recording differ, which physics was left out, writes the model with it and shows the fit "
                + "improve on data it did not use. Writes diagnosis.json, model.json, prediction.csv, report.html and, of laws found, "
                + "force.csv.",
        footer = {"", "Examples (in data/arff/concealed/003):", "  wbv diagnose recording.csv.gz --model model.json --out out",
            "  wbv diagnose recording.csv.gz --model boileau-rakheja-1998-4dof --out out",
            "  wbv simulate --model model.json --input recording.csv.gz --out simulation.csv",
            "  wbv diagnose recording.csv.gz --simulation simulation.csv --out out",
            "  wbv diagnose ride.csv --simulation rig.fmu --out out"})
final class Diagnose implements Callable<Integer> {

    private static final Channel DRIVER = Channel.parse("platform.acc.z");

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--model", paramLabel = "MODEL",
            description = "the linear model: a JSON file, or the name of a published one (wbv simulate --models lists them)")
    private Optional<String> model = Optional.empty();

    @Option(names = "--simulation", paramLabel = "CHANNEL|FILE",
            description = "what a simulation gave. Beside --model, the channel of the recording that holds it; what it leaves out "
                    + "is diagnosed. Without --model, a CSV of its outputs, named as the recording's channels and on its clock: a "
                    + "linear model that does the same is identified first; or an FMU (FMI 2.0 or 3.0), which is run on the recording")
    private Optional<String> simulation = Optional.empty();

    @Option(names = "--input", paramLabel = "CHANNEL",
            description = "without --model: the channel that drove the simulation (platform.acc.z; of an FMU the vertical acceleration "
                    + "that it takes)")
    private Optional<String> input = Optional.empty();

    @Option(names = "--subject", paramLabel = "person|rig",
            description = "what the simulation is one of, or the model in place of what it says itself: a person, who is taken at 60 Hz "
                    + "at most and may move by himself, or a rig, at the rate that was recorded (of a simulation: a person if a place on a "
                    + "seat or a sitter is among its channels)")
    private Optional<String> subject = Optional.empty();

    @Option(names = "--mass", paramLabel = "KG", description = "without --model: the mass of all that the simulation's input moves, to "
            + "which forces that are found are in proportion (55 kg)")
    private Optional<Double> mass = Optional.empty();

    @Option(names = "--with", paramLabel = "RECORDING",
            description = "another recording of the same subject and sensors, fitted together with the first; "
                    + "levels that differ tell what depends on amplitude")
    private List<Path> others = new ArrayList<>();

    @Option(names = "--prove", paramLabel = "RECORDING",
            description = "recording that takes no part in the fit and proves it, in place of the last 30 %% of what is fitted")
    private Optional<Path> proof = Optional.empty();

    @Mixin
    private UnitOptions variables;

    @Option(names = "--noise", paramLabel = "SD", description = "standard deviation of a sample of the outputs, in "
            + "their unit, where it is known; of a sitter's also that of the base's sensor, if it is of their kind")
    private Optional<Double> noise = Optional.empty();

    @Mixin
    private ResultFolder out;

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (model.isEmpty() && simulation.isEmpty()) {
            throw wrong("say what the recording is held against: --model MODEL, or --simulation FILE");
        }
        if (noise.isPresent() && !(noise.get() > 0 && noise.get() < Double.POSITIVE_INFINITY)) {
            throw wrong("--noise must be > 0 in the outputs' unit: " + noise.get());
        }
        if (mass.isPresent() && (model.isPresent() || !(mass.get() > 0 && mass.get() < Double.POSITIVE_INFINITY))) {
            throw wrong(model.isPresent() ? "--mass goes with --simulation; a model has its masses"
                    : "--mass must be > 0 kg: " + mass.get());
        }
        Optional<Model> given = model.isEmpty() ? Optional.empty() : Optional.of(declared(PublishedModels.find(model.get())));
        Optional<Channel> column = given.flatMap(beside -> simulation.map(name -> channel("--simulation", name,
                "; beside --model it names a channel of the recording, a file goes without --model")));
        if (given.isEmpty() && (proof.isPresent() || !others.isEmpty())) {
            throw wrong("--with and --prove go with --model; a simulation's outputs belong to one recording");
        }
        Optional<Channel> driver = input.map(name -> channel("--input", name, ""));
        boolean unit = model.isEmpty() && FmuSimulation.isNamed(simulation.orElseThrow());
        if (variables.given() && !unit) {
            throw wrong("--map-input and --map-output are about the variables of --simulation FILE.fmu");
        }
        RowSource source = recording.source();
        try (OutputFolder folder = out.open(); ProgressBar bar = answer.progress()) {
            Inspection inspection = source.inspect(share -> bar.at("reading", share));
            List<String> notes = new ArrayList<>();
            Optional<Model> measured = given.map(whole -> measured(whole, inspection, notes));
            measured.flatMap(Model::guess).ifPresent(notes::add);
            measured.ifPresent(each -> require(each, inspection));
            Recording loaded = source.load(inspection);
            damage(inspection, measured, "").forEach(notes::add);
            Rides rides = rides(loaded, measured, notes, bar);
            OptionalDouble known = noise.map(OptionalDouble::of).orElseGet(OptionalDouble::empty);
            Diagnosed diagnosed = measured.isEmpty() ? held(loaded, driver, known, folder, notes, bar)
                    : Diagnoser.examine(new Question(measured.get(), rides.recording(), column, known, recording.map().isPresent())
                            .proved(rides.provedFrom()), bar::at);
            Diagnosis diagnosis = diagnosed.diagnosis();
            AtomicFile.write(folder.file("model.json"), ModelFile.text(behindFilter(diagnosed)));
            Prediction.write(diagnosed.predicted().earlier(rides.moved()), folder.file("prediction.csv"));
            Optional<FoundForces> forces = diagnosed.forces();
            if (forces.isPresent()) {
                Prediction.write(forces.get(), folder.file("force.csv"));
            }
            DiagnosisReport.write(diagnosis, Pictures.of(diagnosed), provenance(notes).entries(), folder);
            folder.publish();
            bar.close();
            answer.print(notes.stream().map(note -> note + "\n").collect(Collectors.joining()) + diagnosis.summary(),
                    wrote(forces.isPresent()), out.json("diagnosis.json"));
        }
        return 0;
    }

    /** The completed model with the filter of the sensors behind which it was fitted: by itself it does the same then. */
    private static Model behindFilter(Diagnosed diagnosed) {
        Model found = diagnosed.diagnosis().model();
        return found.behind(RollOff.of(found, diagnosed.evidence.recording()));
    }

    private Model declared(Model read) {
        return kind().map(read::declaredAs).orElse(read);
    }

    private Optional<Model.Subject> kind() {
        return subject.map(word -> Arrays.stream(Model.Subject.values()).filter(each -> each.word().equals(word)).findFirst()
                .orElseThrow(() -> wrong("--subject must be person or rig: " + word)));
    }

    /** The recording, those beside it and the one that proves. */
    private Rides rides(Recording first, Optional<Model> model, List<String> notes, ProgressBar bar) throws IOException {
        if (others.isEmpty() && proof.isEmpty()) {
            return Rides.of(first);
        }
        Map<String, Recording> fitted = new LinkedHashMap<>(Map.of(recording.title(), first));
        for (Path path : others) {
            if (fitted.put(path.toString(), another(path, model, notes, bar)) != null) {
                throw wrong("--with " + path + " is named twice");
            }
        }
        Optional<Map.Entry<String, Recording>> last = proof.isEmpty() ? Optional.empty()
                : Optional.of(Map.entry("proof " + proof.get(), another(proof.get(), model, notes, bar)));
        notes.add("fitted to " + String.join(", ", fitted.keySet())
                + (proof.isPresent() ? "; proven on " + proof.get() + ", which took no part" : "; proven on the end of the last"));
        return Rides.of(fitted, last);
    }

    private Recording another(Path path, Optional<Model> model, List<String> notes, ProgressBar bar) throws IOException {
        RowSource source = recording.another(path);
        Inspection inspection = source.inspect(share -> bar.at("reading", share));
        model.ifPresent(each -> require(each, inspection));
        damage(inspection, model, path + ": ").forEach(notes::add);
        return source.load(inspection);
    }

    /** What a recording lacks or holds falsely of what is used of it, one line a kind. */
    private static List<String> damage(Inspection inspection, Optional<Model> model, String whose) {
        Set<Channel> used = model
                .map(each -> Set.copyOf(each.channels()))
                .orElse(inspection.summaries().keySet());
        return FoldedFindings.damage(inspection, used).stream().map(line -> line.severity() + ": " + whose + line.message()).toList();
    }

    /** Refuses a recording that lacks what a model is moved by or predicts. */
    private static void require(Model model, Inspection inspection) {
        model.excitations().forEach(inspection::require);
        model.outputs().forEach(inspection::require);
    }

    /** A published model is everybody's: of its sensors those count that the recording has. */
    private Model measured(Model given, Inspection inspection, List<String> notes) {
        Model measured = given.seenBy(inspection.summaries().keySet());
        if (!PublishedModels.named(model.orElseThrow()) || measured.outputs().isEmpty() || measured.equals(given)) {
            return given;
        }
        List<Channel> absent = new ArrayList<>(given.outputs());
        absent.removeAll(measured.outputs());
        notes.add(model.get() + " has sensors that the recording lacks, which are left out: " + absent);
        return measured;
    }

    /** The recording held against a simulation of which only the outputs are given. */
    private Diagnosed held(Recording loaded, Optional<Channel> driver, OptionalDouble known, OutputFolder folder, List<String> notes,
            ProgressBar bar)
            throws IOException {
        Path file = Path.of(simulation.orElseThrow());
        OptionalDouble weight = mass.map(OptionalDouble::of).orElseGet(OptionalDouble::empty);
        Surrogate.Examined examined;
        if (FmuSimulation.isNamed(file.toString())) {
            try (FmuSimulation unit = variables.open(file, loaded)) {
                examined = new HeldUnit(unit, file.toString(), kind(), weight, loaded, known, recording.map().isPresent()).examined(driver,
                        folder, notes, bar::at);
            }
        } else {
            examined = Surrogate.examine(loaded,
                    new Simulated(new RecordingFile(file).load(), file.toString(), driver.orElse(DRIVER), kind(), weight), known,
                    recording.map().isPresent(), bar::at);
        }
        AtomicFile.write(folder.file("surrogate.json"), ModelFile.text(examined.surrogate().model()));
        RecordingWriter.write(folder.file("beside.csv"), examined.surrogate().recording());
        notes.add(examined.surrogate().sentence());
        return examined.diagnosed();
    }

    private ResultProvenance provenance(List<String> notes) throws IOException {
        List<Path> inputs = new ArrayList<>(recording.inputs());
        inputs.add(Path.of(model.or(() -> simulation).orElseThrow()));
        inputs.addAll(others);
        proof.ifPresent(inputs::add);
        ResultProvenance provenance = new ResultProvenance(spec);
        if (!notes.isEmpty()) {
            provenance.with("model", String.join(" ", notes));
        }
        return provenance.of(inputs);
    }

    private Channel channel(String option, String name, String advice) {
        try {
            return Channel.parse(name);
        } catch (IllegalArgumentException e) {
            throw wrong(option + ": " + e.getMessage() + advice);
        }
    }

    private ParameterException wrong(String usage) {
        return new ParameterException(spec.commandLine(), usage);
    }

    private String wrote(boolean forces) {
        return "Wrote " + out.file("report.html") + ", diagnosis.json, model.json, prediction.csv" + (forces ? ", force.csv" : "")
                + (model.isEmpty() ? ", surrogate.json, beside.csv\n" : "\n");
    }
}
