package wbv.live;

import java.io.IOException;
import java.io.InputStream;
import java.io.PushbackInputStream;
import java.util.zip.GZIPInputStream;

/** Lines of a stream of bytes: standard input, a file, a named pipe, a serial line; gzip or not. */
public final class StreamSource implements LineSource {

    /** A line of more bytes is none. */
    public static final int LONGEST = 1 << 16;

    private final String name;
    private final InputStream stream;
    private volatile boolean closed;

    /**
     * Reads nothing before it is run.
     *
     * @param name for messages
     * @param stream closed by {@link #close}
     */
    public StreamSource(String name, InputStream stream) {
        this.name = name;
        this.stream = stream;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public void run(Receiver receiver) throws IOException {
        InputStream in = unzipped();
        byte[] buffer = new byte[LONGEST + 1];
        int held = 0;
        boolean skipping = false;
        while (!closed) {
            int read = in.read(buffer, held, buffer.length - held);
            if (read < 0) {
                break;
            }
            int end = held + read;
            int from = 0;
            for (int i = held; i < end; i++) {
                if (buffer[i] == '\n') {
                    if (!skipping) {
                        receiver.line(name, "", buffer, from, i > from && buffer[i - 1] == '\r' ? i - 1 : i);
                    }
                    skipping = false;
                    from = i + 1;
                }
            }
            held = end - from;
            System.arraycopy(buffer, from, buffer, 0, held);
            if (held == buffer.length) {
                if (!skipping) {
                    receiver.tooLong(name, buffer, held);
                }
                skipping = true;
                held = 0;
            }
            receiver.idle();
        }
        if (held > 0 && !skipping && !closed) {
            receiver.line(name, "", buffer, 0, held);
        }
        receiver.idle();
    }

    private InputStream unzipped() throws IOException {
        PushbackInputStream ahead = new PushbackInputStream(stream, 2);
        int first = ahead.read();
        if (first < 0) {
            return ahead;
        }
        if (first != 0x1f) {
            ahead.unread(first);
            return ahead;
        }
        int second = ahead.read();
        if (second >= 0) {
            ahead.unread(second);
        }
        ahead.unread(first);
        return second == 0x8b ? new GZIPInputStream(ahead, 1 << 16) : ahead;
    }

    @Override
    public void close() throws IOException {
        closed = true;
        stream.close();
    }
}
