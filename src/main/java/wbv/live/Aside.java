package wbv.live;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** The file that lines are put aside in which cannot be read, as they came; up to a gigabyte. */
public final class Aside implements Closeable {

    /** Nowhere; closing it does nothing. */
    public static final Aside NONE = new Aside(new OutputStream() {
        @Override
        public void write(int one) {}

        @Override
        public void write(byte[] bytes, int from, int length) {}
    }, Long.MAX_VALUE);
    private static final long MOST = 1 << 30;

    private final OutputStream out;
    private long left;

    private Aside(OutputStream out, long most) {
        this.out = out;
        this.left = most;
    }

    /** Appends to a file. */
    public static Aside in(Path file) throws IOException {
        long there = Files.exists(file) ? Files.size(file) : 0;
        return new Aside(new BufferedOutputStream(Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND)),
                MOST - there);
    }

    void put(byte[] text, int from, int to) {
        if (to - from + 1 > left) {
            return;
        }
        left -= to - from + 1;
        try {
            out.write(text, from, to - from);
            out.write('\n');
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    void flush() {
        try {
            out.flush();
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    @Override
    public void close() throws IOException {
        out.close();
    }
}
