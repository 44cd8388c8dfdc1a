package wbv.rig.concealed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import wbv.recording.AtomicFile;
import wbv.recording.Recording;
import wbv.recording.RecordingWriter;

/**
 * A recording with something concealed in it.
 *
 * @param recording as the sensors sent it @param clean the verticals without noise and scatter, the sitter's own stirring
 * included
 * @param model     as a user would have written it, JSON @param key what was concealed, JSON
 * @param force     for a law that is to be learned: its force and its link's motion by row, as CSV
 */
public record ConcealedCase(Recording recording, Recording clean, String model, String key, Optional<String> force) {

    /** One whose force is of no interest. */
    ConcealedCase(Recording recording, Recording clean, String model, String key) {
        this(recording, clean, model, key, Optional.empty());
    }

    /** Writes what may be seen, {@code recording.csv.gz} and {@code model.json}, into a folder. */
    public void write(Path folder) throws IOException {
        Files.createDirectories(folder);
        RecordingWriter.write(folder.resolve("recording.csv.gz"), recording);
        AtomicFile.write(folder.resolve("model.json"), model);
    }
}
