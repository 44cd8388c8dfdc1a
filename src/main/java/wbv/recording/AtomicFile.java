package wbv.recording;

import java.io.Closeable;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A file that appears whole or not at all: written beside its place, then renamed onto it.
 *
 * <pre>{@code
 * try (AtomicFile file = AtomicFile.begin(Path.of("table.csv"))) {
 *     file.stream().write(bytes);
 *     file.finish();
 * }
 * }</pre>
 */
public final class AtomicFile implements Closeable {

    private final Path file;
    private final Unfinished unfinished;
    private final OutputStream stream;

    private AtomicFile(Path file, Unfinished unfinished, OutputStream stream) {
        this.file = file;
        this.unfinished = unfinished;
        this.stream = new Named(stream, file);
    }

    /**
     * Begins a file; one that is there stays until the end.
     *
     * @throws DataFault naming the file, if its folder is missing or takes no file
     * @throws FileSystemException naming the file, if it is something else than a file
     */
    public static AtomicFile begin(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new FileSystemException(file.toString(), null, "is no plain file; choose another name");
        }
        Unfinished unfinished = beside(file);
        try {
            return new AtomicFile(file, unfinished, Files.newOutputStream(unfinished.path()));
        } catch (IOException e) {
            unfinished.close();
            throw e;
        }
    }

    /** The hidden name is nobody's business: what is wrong with it is told of the file. */
    private static Unfinished beside(Path file) throws IOException {
        Path folder = file.toAbsolutePath().getParent();
        try {
            return Unfinished.in(folder);
        } catch (AccessDeniedException denied) {
            throw DataFault.in(file.toString(), "may not be written; check the folder's permissions", denied);
        } catch (FileSystemException wrong) {
            throw DataFault.in(file.toString(), Files.isDirectory(folder) ? "cannot be written: " + Unfinished.why(wrong)
                    : "there is no folder to write it in", wrong);
        }
    }

    /**
     * Writes a file, over one that is there.
     *
     * @param bytes all of it. Not modified.
     */
    public static void write(Path file, byte[] bytes) throws IOException {
        try (AtomicFile whole = begin(file)) {
            whole.stream.write(bytes);
            whole.finish();
        }
    }

    /** Writes a file of text, over one that is there. */
    public static void write(Path file, CharSequence text) throws IOException {
        write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** Takes what the file will hold, unbuffered; a write that fails names the file. */
    public OutputStream stream() {
        return stream;
    }

    /** Ends the file and gives it its name. What lies in buffers over {@link #stream} must have been flushed. */
    public void finish() throws IOException {
        stream.close();
        unfinished.become(file);
    }

    /** Lets go. Without {@link #finish} nothing is left behind, and what was there before is untouched. */
    @Override
    public void close() throws IOException {
        try (unfinished; stream) {
            // Closing is all: the stream first.
        }
    }

    /** Says which file a failure concerns: a full disk's own words do not. */
    private static final class Named extends FilterOutputStream {

        private final Path file;

        Named(OutputStream out, Path file) {
            super(out);
            this.file = file;
        }

        @Override
        public void write(int b) throws IOException {
            write(new byte[] {(byte) b}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int from, int length) throws IOException {
            try {
                out.write(bytes, from, length);
            } catch (IOException failed) {
                throw named(failed);
            }
        }

        @Override
        public void close() throws IOException {
            try {
                out.close();
            } catch (IOException failed) {
                throw named(failed);
            }
        }

        private IOException named(IOException failed) {
            FileSystemException named = new FileSystemException(file.toString(), null, "cannot be written: " + failed.getMessage());
            named.initCause(failed);
            return named;
        }
    }
}
