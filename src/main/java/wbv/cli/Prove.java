package wbv.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.diagnosis.search.Calibration;
import wbv.proof.Proof;
import wbv.proof.SealedCase;
import wbv.proof.Suite;
import wbv.proof.Tables;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;

/** {@code wbv prove}: conceals effects in simulated recordings, lets the diagnosis find them, opens the keys and marks it. */
@Command(name = "prove", mixinStandardHelpOptions = true,
        description = "Conceals effects in simulated recordings, diagnoses them in a process that cannot read the keys, then opens the "
                + "keys and marks every answer. Run again with the same folder it goes on where it stopped.",
        footer = {"", "Examples:", "  wbv prove --quick --out proof", "  wbv prove --out proof --seed 7 --only friction.coulomb",
            "  wbv prove --out proof-rigs --only rig,planar,levels", "  wbv prove --unrelated --out proof-unrelated",
            "  wbv prove --open data/arff/concealed/003"})
final class Prove implements Callable<Integer> {

    @Option(names = "--quick",
            description = "eleven cases, about two minutes on two cores; the full proof has over five hundred")
    private boolean quick;

    @Option(names = "--unrelated",
            description = "the negative control instead: 100 recordings of 15 to 60 s whose outputs have nothing to do with their input")
    private boolean unrelated;

    @Mixin
    private CommonOptions.Seed seed;

    @Option(names = "--cases", paramLabel = "N", description = "only the first N cases")
    private int cases = Integer.MAX_VALUE;

    @Option(names = "--from", paramLabel = "N", description = "not those before the Nth case")
    private int from = 1;

    @Option(names = "--only", paramLabel = "WORD",
            description = "only cases of this mechanism or open law, or of: nothing, unlisted, pair, "
                    + "open (laws to be learned), rig (benches), planar (a multibody person beside a simulation), jointed (with a model "
                    + "of his joints), levels (three recordings); several with commas")
    private String only = "";

    @Option(names = "--out", paramLabel = "DIR",
            description = "folder for cases, keys, answers and tables (default: ${DEFAULT-VALUE})")
    private Path out = Path.of("proof");

    @Option(names = "--calibrate",
            description = "also write calibration.json: how probable the diagnosis should hold its names, going by these answers")
    private boolean calibrate;

    @Option(names = "--open", paramLabel = "CASE",
            description = "print the key of a concealed recording that comes with wbv, and check it against its published hash")
    private Optional<Path> open = Optional.empty();

    @Mixin
    private Answer answer;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        if (open.isPresent()) {
            spec.commandLine().getOut().println(SealedCase.open(open.get()).stripTrailing());
            return 0;
        }
        if (quick && unrelated) {
            throw new ParameterException(spec.commandLine(), "--quick and --unrelated are two different sets of cases: name one");
        }
        Suite suite = unrelated ? Suite.unrelated(seed.number()) : quick ? Suite.quick(seed.number()) : Suite.full(seed.number());
        if (!only.isEmpty()) {
            suite = suite.only(only);
        }
        suite = suite.part(from, cases);
        if (suite.questions().isEmpty()) {
            throw new ParameterException(spec.commandLine(), "no case from " + from + " to " + cases + " has '" + only
                    + "'; there are the mechanisms of the vocabulary, the open laws (open.inerter and so on), "
                    + "and nothing, unlisted, pair, open, rig, planar, jointed, levels");
        }
        Files.createDirectories(out);
        Tables tables;
        try (ProgressBar bar = answer.progress()) {
            tables = new Proof(suite, seed.number(), out, new ResultProvenance(spec).entries(), bar::at).run();
        }
        String wrote = "All tables: " + out.resolve("proof.md") + "\n";
        if (calibrate) {
            Calibration calibration = tables.calibration().orElseThrow(
                    () -> new DataFault("no answer of these cases names a single mechanism: ask more of them"));
            AtomicFile.write(out.resolve("calibration.json"),
                    new ObjectMapper().writerWithDefaultPrettyPrinter().writeValueAsString(calibration) + "\n");
            wrote += "Calibration: " + out.resolve("calibration.json") + "\n";
        }
        answer.print(tables.summary(), wrote, tables::json);
        return 0;
    }
}
