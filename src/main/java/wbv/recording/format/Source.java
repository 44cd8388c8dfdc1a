package wbv.recording.format;

import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import wbv.recording.DataFault;

/** An opened file: its bytes, decompressed where they are gzip, the first of them to look at, and how far it was read. */
final class Source implements Closeable {

    private static final int HEAD = 1 << 16;

    private final String name;
    private final Path path;
    private final long size;
    private final Counter counter;
    private final InputStream content;
    private final byte[] head;

    private Source(Path path, long size, InputStream file) throws IOException {
        this.path = path;
        this.name = path.toString();
        this.size = size;
        this.counter = new Counter(file);
        InputStream unzipped = unzip(counter);
        this.head = unzipped.readNBytes(HEAD);
        this.content = new SequenceInputStream(new ByteArrayInputStream(head), unzipped);
    }

    /**
     * Opens a file.
     *
     * @throws DataFault if there is none, it is a directory or empty, may not be read, or is damaged gzip
     */
    static Source open(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw DataFault.in(path.toString(), "is a directory; name a recording in it");
        }
        InputStream file = null;
        try {
            file = Files.newInputStream(path);
            Source source = new Source(path, Files.size(path), file);
            if (source.head.length == 0) {
                throw DataFault.in(path.toString(), "is empty; a recording has a header and rows");
            }
            return source;
        } catch (NoSuchFileException missing) {
            throw DataFault.in(path.toString(), "no such file", missing);
        } catch (AccessDeniedException denied) {
            throw DataFault.in(path.toString(), "may not be read; check its permissions", denied);
        } catch (EOFException | ZipException damaged) {
            file.close();
            throw damaged(path.toString(), damaged);
        } catch (DataFault | IOException failed) {
            if (file != null) {
                file.close();
            }
            throw failed;
        }
    }

    static DataFault damaged(String name, IOException cause) {
        return DataFault.in(name, "the gzip compression is damaged or cut off (" + cause.getMessage()
                + "); copy the file again",
                cause);
    }

    private static InputStream unzip(InputStream file) throws IOException {
        byte[] magic = file.readNBytes(2);
        InputStream whole = new SequenceInputStream(new ByteArrayInputStream(magic), file);
        boolean gzip = magic.length == 2 && magic[0] == (byte) 0x1f && magic[1] == (byte) 0x8b;
        return gzip ? new GZIPInputStream(whole, HEAD) : whole;
    }

    /** The name to use in messages. */
    String name() {
        return name;
    }

    Path path() {
        return path;
    }

    /** The first bytes of the content, up to 64 KiB. */
    byte[] head() {
        return head;
    }

    /** The first bytes as text. */
    String headText() {
        int whole = head.length;
        while (whole > 0 && head[whole - 1] < 0) { // half a character, where the beginning ends within one
            whole--;
        }
        return Head.text(head, 0, whole);
    }

    /** The content from its beginning. */
    InputStream content() {
        return content;
    }

    /** Share of the file's bytes that was read, 0 to 1; NaN where the size is unknown. */
    double fractionRead() {
        return size > 0 ? Math.min(1, (double) counter.count / size) : Double.NaN;
    }

    @Override
    public void close() throws IOException {
        counter.close();
    }

    private static final class Counter extends FilterInputStream {
        private long count;

        private Counter(InputStream in) {
            super(in);
        }

        @Override
        public int read() throws IOException {
            int value = super.read();
            count += value < 0 ? 0 : 1;
            return value;
        }

        @Override
        public int read(byte[] bytes, int offset, int length) throws IOException {
            int read = super.read(bytes, offset, length);
            count += Math.max(read, 0);
            return read;
        }
    }
}
