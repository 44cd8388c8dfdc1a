package wbv.result;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;
import wbv.recording.DataFault;
import wbv.recording.Unfinished;

/**
 * A folder of results that appears whole or not at all.
 *
 * <p>Files are written to a hidden folder on the same disk and moved at the end, by {@link #publish}. A target that does not
 * exist yet appears by one rename. In one that does, files of the same name are replaced one by one, each whole, and nothing else
 * is touched. Without {@code publish}, {@link #close} leaves no trace, and what a killed run left is removed by the next.
 *
 * <pre>{@code
 * try (OutputFolder out = OutputFolder.at(Path.of("out"))) {
 *     HtmlWriter.write(page, out.file("report.html"));
 *     out.publish();
 * }
 * }</pre>
 */
public final class OutputFolder implements Closeable {

    private final Path target;
    private final Unfinished staging;

    private OutputFolder(Path target, Unfinished staging) {
        this.target = target;
        this.staging = staging;
    }

    /**
     * Begins a folder; its parents need not exist yet.
     *
     * @throws DataFault if the target is a file, lies below one, or cannot be written to
     */
    public static OutputFolder at(Path target) {
        Path place = target.toAbsolutePath().normalize();
        Path existing = place;
        while (!Files.exists(existing, LinkOption.NOFOLLOW_LINKS) && existing.getParent() != null) {
            existing = existing.getParent();
        }
        if (!Files.isDirectory(existing)) {
            throw DataFault.in(existing.toString(), "is a file; results need a folder");
        }
        try {
            // Inside an existing target, else in its nearest existing parent: a rename then never leaves the disk.
            Unfinished staging = Unfinished.in(existing);
            try {
                Files.createDirectory(staging.path());
            } catch (IOException e) {
                staging.close();
                throw e;
            }
            return new OutputFolder(place, staging);
        } catch (AccessDeniedException e) {
            throw DataFault.in(existing.toString(), "no permission to write here; choose another folder for the results", e);
        } catch (IOException e) {
            String why = e instanceof FileSystemException file ? Unfinished.why(file) : e.getMessage();
            throw DataFault.in(existing.toString(), "cannot be written to (" + why + "); choose another folder for the results", e);
        }
    }

    /** The folder that results will be in. */
    public Path target() {
        return target;
    }

    /**
     * Where to write a file of this name.
     *
     * @throws IllegalArgumentException if the name is not one plain file name
     */
    public Path file(String name) {
        Path file = staging.path().resolve(name).normalize();
        if (name.isEmpty() || !staging.path().equals(file.getParent())) {
            throw new IllegalArgumentException("a result has a plain file name: '" + name + "'");
        }
        file.toFile().deleteOnExit();
        return file;
    }

    /**
     * Moves the files to the target.
     *
     * @throws DataFault if a folder in the target has the name of a file; nothing is moved then
     */
    public void publish() throws IOException {
        if (!Files.exists(target)) {
            Files.createDirectories(target.getParent());
            staging.become(target);
            return;
        }
        List<Path> files;
        try (Stream<Path> list = Files.list(staging.path())) {
            files = list.sorted().toList();
        }
        for (Path file : files) {
            if (Files.isDirectory(target.resolve(file.getFileName()))) {
                throw DataFault.in(target.resolve(file.getFileName()).toString(), "is a folder; a result has this name");
            }
        }
        for (Path file : files) {
            Files.move(file, target.resolve(file.getFileName()), StandardCopyOption.ATOMIC_MOVE,
                    StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Removes what was not published. */
    @Override
    public void close() throws IOException {
        staging.close();
    }
}
