package wbv.recording;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;

/**
 * A hidden name for what is being written, in the folder where it will stand, until it is whole and gets its own.
 *
 * <p>A locked file beside it tells it from what a killed run left behind: the system lets the lock go when the process ends,
 * however it ends. A process number would not do, since containers that share a folder number their processes alike. Whoever
 * begins something in a folder removes what nobody holds any more.
 */
public final class Unfinished implements Closeable {

    private static final String MARK = ".wbv-";
    private static final String LOCK = ".lock";
    /** What this process begins. Its own locks are never tried: closing a second channel to one would let it go (POSIX). */
    private static final String OURS = MARK + UUID.randomUUID() + "-";

    private final Path path;
    private final Path lock;
    private final FileChannel held;

    private Unfinished(Path path, Path lock, FileChannel held) {
        this.path = path;
        this.lock = lock;
        this.held = held;
        lock.toFile().deleteOnExit(); // Ctrl-C closes nothing; what is registered last is deleted first
        path.toFile().deleteOnExit();
    }

    /**
     * Takes a new name in a folder, and removes what killed runs left there.
     *
     * @throws IOException if nothing can be written there
     */
    public static Unfinished in(Path folder) throws IOException {
        sweep(folder);
        while (true) {
            String name = OURS + Long.toHexString(System.nanoTime());
            Path lock = folder.resolve(name + LOCK);
            FileChannel channel;
            try {
                channel = FileChannel.open(lock, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            } catch (FileAlreadyExistsException taken) {
                continue;
            }
            if (locked(channel) && Files.exists(lock)) { // another run's sweep may have been between
                return new Unfinished(folder.resolve(name), lock, channel);
            }
            channel.close();
            Files.deleteIfExists(lock);
        }
    }

    private static boolean locked(FileChannel channel) {
        try {
            return channel.tryLock() != null;
        } catch (IOException noLocksHere) {
            return true; // nobody else gets one either, and what cannot be locked is not swept
        }
    }

    private static void sweep(Path folder) {
        try (DirectoryStream<Path> locks = Files.newDirectoryStream(folder, MARK + "*" + LOCK)) {
            for (Path lock : locks) {
                if (!lock.getFileName().toString().startsWith(OURS)) {
                    removeIfDead(lock);
                }
            }
        } catch (IOException | DirectoryIteratorException unseen) {
            // What cannot be listed cannot be cleaned; whether it can be written to is asked next.
        }
    }

    private static void removeIfDead(Path lock) {
        try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE); FileLock ours = channel.tryLock()) {
            if (ours != null) {
                String name = lock.getFileName().toString();
                remove(lock.resolveSibling(name.substring(0, name.length() - LOCK.length())));
                Files.deleteIfExists(lock);
            }
        } catch (IOException | OverlappingFileLockException alive) {
            // It is somebody's, or may not be touched.
        }
    }

    /** Removes a file, or a folder with the files in it; of a link, the link. */
    private static void remove(Path path) throws IOException {
        if (Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)) {
            try (DirectoryStream<Path> files = Files.newDirectoryStream(path)) {
                for (Path file : files) {
                    Files.delete(file);
                }
            }
        }
        Files.deleteIfExists(path);
    }

    /** Whether a path leads through such a name, which nobody who reads a message knows. */
    public static boolean isIn(Path path) {
        for (Path name : path) {
            if (name.toString().startsWith(MARK)) {
                return true;
            }
        }
        return false;
    }

    /** Why nothing could be begun in a folder, without the name that was tried. */
    public static String why(FileSystemException wrong) {
        return wrong.getReason() == null ? "its folder takes no files" : wrong.getReason();
    }

    /** Where to write. Nothing is there yet. */
    public Path path() {
        return path;
    }

    /** Gives what was written its name, over a file that has it already. */
    public void become(Path name) throws IOException {
        Files.move(path, name, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    /** Removes what did not get a name. */
    @Override
    public void close() throws IOException {
        try (held) {
            remove(path);
            Files.deleteIfExists(lock);
        }
    }
}
