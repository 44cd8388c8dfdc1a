package wbv.recording.format;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.inspect.RowClock;

/**
 * Rows of a stream that can be read once and need not end: standard input, a pipe. They are laid on an even clock as they come, by
 * a {@link RowClock} that learns the rate from the first of them; samples that are missing are rows of NaN, rows that come twice or
 * late are left out. One recording at a time: all rows have the columns of the first header.
 */
public final class PipedReader implements RowReader {

    private static final int LONGEST = 1 << 24;

    private final String name;
    private final InputStream in;
    private final RowLines lines;
    private final RowClock clock;
    private final Deque<double[]> waiting = new ArrayDeque<>();
    private final Deque<double[]> read = new ArrayDeque<>();
    private List<Channel> channels = List.of();
    private byte[] line = new byte[1 << 12];
    private double start = Double.NaN;
    private long sample;
    private boolean ended;

    /**
     * Reads as far as the rate is known.
     *
     * @param name for messages
     * @param stream gzip or not
     * @throws DataFault if it is no stream of rows, or has fewer than two
     */
    public PipedReader(String name, InputStream stream, ReadOptions options) throws IOException {
        this.name = name;
        this.in = unzipped(stream);
        this.lines = new RowLines(name, options);
        this.clock = new RowClock(options.rate());
        boolean known = false;
        while (!known && more()) {
            double[] row = read.pollFirst();
            waiting.add(row);
            known = clock.learn(row[0]);
        }
        if (!known && !clock.learnNow()) {
            throw DataFault.in(name, "has " + (waiting.isEmpty() ? "no row" : "1 row") + "; a recording needs at least two samples");
        }
        read.addAll(waiting);
        waiting.clear();
    }

    private static InputStream unzipped(InputStream stream) throws IOException {
        BufferedInputStream ahead = new BufferedInputStream(stream, 1 << 16);
        ahead.mark(2);
        boolean gzip = ahead.read() == 0x1f && ahead.read() == 0x8b;
        ahead.reset();
        return gzip ? new BufferedInputStream(new GZIPInputStream(ahead, 1 << 16), 1 << 16) : ahead;
    }

    /**
     * Reads lines until there is a row.
     *
     * @return false at the end
     */
    private boolean more() throws IOException {
        while (read.isEmpty() && !ended) {
            int length = 0;
            int next = in.read();
            for (; next >= 0 && next != '\n'; next = in.read()) {
                if (length == LONGEST) {
                    throw DataFault.at(name, lines.line() + 1, "is longer than 16 MiB; this is not a table of numbers");
                }
                if (length == line.length) {
                    line = Arrays.copyOf(line, 2 * length);
                }
                line[length++] = (byte) next;
            }
            ended = next < 0;
            if (length > 0) {
                lines.accept(line, 0, length, this::take);
            }
        }
        return !read.isEmpty();
    }

    private void take(String seat, List<Channel> of, double[] row) {
        if (channels.isEmpty()) {
            channels = List.copyOf(of);
        } else if (!channels.equals(of)) {
            throw DataFault.at(name, lines.line(), "the columns change; a recording has the same throughout");
        }
        read.add(row.clone());
    }

    @Override
    public List<Channel> channels() {
        return channels;
    }

    @Override
    public Metadata metadata() {
        return Metadata.NONE.withRate(OptionalDouble.of(clock.rate()));
    }

    @Override
    public boolean read(double[] row) throws IOException {
        while (waiting.isEmpty()) {
            if (!more()) {
                return false;
            }
            place(read.pollFirst());
        }
        System.arraycopy(waiting.pollFirst(), 0, row, 0, row.length);
        return true;
    }

    private void place(double[] row) {
        switch (clock.place(row[0])) {
            case REPEATED, LATE -> {}
            case RESTARTED -> {
                start = row[0];
                sample = 0;
                give(row);
            }
            default -> {
                start = Double.isNaN(start) ? row[0] : start;
                for (long i = 0; i < clock.missing(); i++) {
                    double[] nothing = new double[row.length];
                    Arrays.fill(nothing, Double.NaN);
                    give(nothing);
                }
                give(row);
            }
        }
    }

    private void give(double[] row) {
        row[0] = new Clock(start, clock.rate()).time(sample++);
        waiting.add(row);
    }

    @Override
    public long line() {
        return lines.line();
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
