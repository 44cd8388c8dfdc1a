package wbv.proof;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Question;
import wbv.diagnosis.Rides;
import wbv.diagnosis.surrogate.Simulated;
import wbv.diagnosis.surrogate.Surrogate;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.rig.concealed.ConcealedCase;

/**
 * The process that diagnoses. It is told folders, one a line, in which lie a recording, a model, perhaps other recordings or a simulation
 * of it, and nothing else, and puts
 * {@code answer.json} beside them.
 */
public final class Worker {

    private static final Channel DRIVER = Channel.parse("platform.acc.z");

    private Worker() {}

    public static void main(String[] none) throws IOException {
        // Nobody reads the answers of one whose asker is gone.
        ProcessHandle.current().parent().ifPresent(asker -> asker.onExit().thenRun(() -> Runtime.getRuntime().halt(1)));
        // Whatever else is printed must not be taken for an answer.
        PrintStream answers = System.out;
        System.setOut(System.err);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            Path folder = Path.of(line);
            AtomicFile.write(folder.resolve("answer.json"), answer(folder).json());
            answers.println(line);
            answers.flush();
        }
    }

    /** The recording held against a user's own simulator, of which only what it gave is known. */
    private static ProofAnswer beside(Recording recorded, Recording simulation, long start) {
        Surrogate.Examined examined = Surrogate.examine(recorded, Simulated.of(simulation, "the simulation", DRIVER),
                OptionalDouble.empty(), false,
                (step, share) -> {});
        double seconds = (System.nanoTime() - start) / 1e9;
        return ProofAnswer.of(examined.diagnosed().diagnosis(), seconds,
                LawForce.of(examined.diagnosed().diagnosis(), examined.surrogate().model(), examined.surrogate().recording()));
    }

    private static ProofAnswer of(Model own, Rides rides, long start) {
        Question question = Question.of(own, rides.recording()).proved(rides.provedFrom());
        Diagnosis diagnosis = Diagnoser.diagnose(question, (step, share) -> {});
        double seconds = (System.nanoTime() - start) / 1e9;
        return ProofAnswer.of(diagnosis, seconds, LawForce.of(diagnosis, own, rides.recording()));
    }

    /** With what lies beside it to be fitted together, and to prove. */
    private static Rides rides(Path folder, Recording recorded) throws IOException {
        Path other = folder.resolve(ConcealedCase.WITH);
        if (!Files.isRegularFile(other)) {
            return Rides.of(recorded);
        }
        Map<String, Recording> fitted = new LinkedHashMap<>();
        fitted.put("recording", recorded);
        fitted.put("with", new RecordingFile(other).load());
        return Rides.of(fitted, Optional.of(Map.entry("proof", new RecordingFile(folder.resolve(ConcealedCase.PROOF)).load())));
    }

    static ProofAnswer answer(Path folder) {
        long start = System.nanoTime();
        Path model = folder.resolve("model.json");
        Path recording = folder.resolve("recording.csv.gz");
        try {
            if (!Files.isRegularFile(model) || !Files.isRegularFile(recording)) {
                throw new NoSuchFileException(folder.toString()); // a case that is not there was not refused
            }
            Recording recorded = new RecordingFile(recording).load();
            Path simulation = folder.resolve(ConcealedCase.SIMULATION);
            return Files.isRegularFile(simulation) ? beside(recorded, new RecordingFile(simulation).load(), start)
                    : of(ModelFile.read(model), rides(folder, recorded), start);
        } catch (DataFault refusal) {
            return ProofAnswer.refused(refusal.getMessage(), (System.nanoTime() - start) / 1e9);
        } catch (IOException | RuntimeException | StackOverflowError fault) {
            StackTraceElement[] at = fault.getStackTrace();
            return ProofAnswer.failed(fault + (at.length == 0 ? "" : " at " + at[0]), (System.nanoTime() - start) / 1e9);
        }
    }
}
