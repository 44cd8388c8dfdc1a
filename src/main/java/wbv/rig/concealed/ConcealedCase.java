package wbv.rig.concealed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import wbv.recording.AtomicFile;
import wbv.recording.Recording;
import wbv.recording.format.RecordingWriter;

/**
 * A recording with something concealed in it.
 *
 * @param recording as the sensors sent it
 * @param clean the verticals without noise and scatter, the sitter's own stirring included
 * @param model     as a user would have written it, JSON
 * @param key what was concealed, JSON
 * @param beside    what else may be seen, by file name: {@link #WITH}, {@link #PROOF}, {@link #SIMULATION}
 * @param force     for a law that is to be learned: its force and its link's motion by row, as CSV
 */
public record ConcealedCase(Recording recording, Recording clean, String model, String key, Optional<String> force,
        Map<String, Recording> beside) {

    /** Of several recordings that are fitted together, the second. */
    public static final String WITH = "with.csv.gz";
    /** The one that takes no part in the fit and proves it. */
    public static final String PROOF = "proof.csv.gz";
    /** What the user's own simulator gave for the recorded platform. */
    public static final String SIMULATION = "simulation.csv.gz";

    public ConcealedCase {
        beside = Map.copyOf(beside);
    }

    /** One of a single recording. */
    ConcealedCase(Recording recording, Recording clean, String model, String key, Optional<String> force) {
        this(recording, clean, model, key, force, Map.of());
    }

    /** One whose force is of no interest. */
    ConcealedCase(Recording recording, Recording clean, String model, String key) {
        this(recording, clean, model, key, Optional.empty());
    }

    /** Writes what may be seen, {@code recording.csv.gz}, {@code model.json} and what is beside them, into a folder. */
    public void write(Path folder) throws IOException {
        Files.createDirectories(folder);
        RecordingWriter.write(folder.resolve("recording.csv.gz"), recording);
        AtomicFile.write(folder.resolve("model.json"), model);
        for (Map.Entry<String, Recording> each : beside.entrySet()) {
            RecordingWriter.write(folder.resolve(each.getKey()), each.getValue());
        }
    }
}
