package wbv.fleet;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import wbv.recording.DataFault;

/** A file of results that grows under another name until it is whole. */
final class GrowingFile implements Closeable {

    private static final String UNFINISHED = ".unfinished";

    private final Path growing;
    private final FileChannel channel;

    /**
     * Opens the file.
     *
     * @param length what is to be kept of it, 0 to begin anew; what was written behind it by a run that was killed is cut off
     * @throws DataFault if less than that is there, or another process writes it
     */
    GrowingFile(Path whole, long length) throws IOException {
        this.growing = whole.resolveSibling(whole.getFileName() + UNFINISHED);
        if (length > 0 && (!Files.exists(growing) || Files.size(growing) < length)) {
            throw DataFault.in(growing.toString(), "is shorter than when its run stopped, or gone; delete fleet.state to begin anew");
        }
        this.channel = FileChannel.open(growing, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        if (channel.tryLock() == null) {
            channel.close();
            throw DataFault.in(growing.toString(), "is being written by another run; choose another --out, or wait for its end");
        }
        channel.truncate(length);
        channel.position(length);
    }

    void write(CharSequence text) throws IOException {
        ByteBuffer bytes = StandardCharsets.UTF_8.encode(CharBuffer.wrap(text));
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    /**
     * Everything written is on the disk when this returns.
     *
     * @return how many bytes that is
     */
    long force() throws IOException {
        channel.force(true);
        return channel.position();
    }

    /** A file that nothing was to be written to is not left. */
    static void forget(Path whole) throws IOException {
        Files.deleteIfExists(whole.resolveSibling(whole.getFileName() + UNFINISHED));
    }

    /** A file is whole: it gets its own name, unless it has that already. */
    static void finish(Path whole) throws IOException {
        Path growing = whole.resolveSibling(whole.getFileName() + UNFINISHED);
        if (Files.exists(growing)) {
            Files.move(growing, whole, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
