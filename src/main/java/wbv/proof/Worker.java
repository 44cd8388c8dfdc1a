package wbv.proof;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.RecordingFile;

/**
 * The process that diagnoses. It is told folders, one a line, in which lie a recording and a model and nothing else, and puts
 * {@code answer.json} beside them.
 */
public final class Worker {

    private Worker() { }

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

    static Answer answer(Path folder) {
        long start = System.nanoTime();
        Path model = folder.resolve("model.json");
        Path recording = folder.resolve("recording.csv.gz");
        try {
            if (!Files.isRegularFile(model) || !Files.isRegularFile(recording)) {
                throw new NoSuchFileException(folder.toString()); // a case that is not there was not refused
            }
            Model own = ModelFile.read(model);
            Recording recorded = new RecordingFile(recording).load();
            Diagnosis diagnosis = Diagnoser.diagnose(own, recorded, (step, share) -> { });
            double seconds = (System.nanoTime() - start) / 1e9;
            return Answer.of(diagnosis, seconds, LawForce.of(diagnosis, own, recorded));
        } catch (DataFault refusal) {
            return Answer.refused(refusal.getMessage(), (System.nanoTime() - start) / 1e9);
        } catch (IOException | RuntimeException | StackOverflowError fault) {
            StackTraceElement[] at = fault.getStackTrace();
            return Answer.failed(fault + (at.length == 0 ? "" : " at " + at[0]), (System.nanoTime() - start) / 1e9);
        }
    }
}
