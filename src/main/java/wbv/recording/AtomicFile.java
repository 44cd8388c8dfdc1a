package wbv.recording;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/** A file that appears whole or not at all: written beside its place, then renamed onto it. */
public final class AtomicFile {

    private AtomicFile() { }

    /** Writes a file, over one that is there. @param bytes all of it. Not modified. */
    public static void write(Path file, byte[] bytes) throws IOException {
        // Not createTempFile: the file would keep its private permissions.
        Path partial = file.resolveSibling("." + file.getFileName() + "." + ProcessHandle.current().pid() + ".part");
        partial.toFile().deleteOnExit(); // Ctrl-C closes nothing
        try {
            Files.write(partial, bytes, StandardOpenOption.CREATE_NEW);
            Files.move(partial, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(partial);
        }
    }
}
