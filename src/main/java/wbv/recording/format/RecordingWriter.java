package wbv.recording.format;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.GZIPOutputStream;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Header;
import wbv.recording.Metadata;
import wbv.recording.Provenance;
import wbv.recording.Recording;
import wbv.recording.TableText;
import wbv.recording.signals.SampledColumns;
import wbv.recording.signals.SignalKind;

/**
 * Writes a recording row by row; as CSV, ARFF, MAT, Parquet and binary UFF exactly: every double reads back as the same double. The file
 * appears under its name only when {@link #finish} is called; until then, and after a failure, what was there before stays untouched.
 */
public final class RecordingWriter implements Closeable {

    private final Path path;
    private final Metadata metadata;
    /** Empty where rows go to a writer that is not ours. */
    private final Optional<AtomicFile> file;
    private final OutputStream out;
    private final Writer table;
    private final String missing;
    private final int width;
    private final StringBuilder line = new StringBuilder();
    private final Optional<SampledColumns> signals;
    private long rows;

    /** Of signals that are written one after the other. */
    private RecordingWriter(Path path, List<Channel> channels, Metadata metadata, SignalKind kind) throws IOException {
        this.path = path;
        this.metadata = metadata;
        AtomicFile whole = AtomicFile.begin(path);
        this.file = Optional.of(whole);
        this.out = new BufferedOutputStream(whole.stream(), 1 << 16);
        this.table = Writer.nullWriter();
        this.missing = "";
        this.width = 1 + channels.size();
        this.signals = Optional.of(new SampledColumns(kind, path.toString(), channels, metadata.rate()));
    }

    private RecordingWriter(Path path, List<Channel> channels, Metadata metadata, boolean arff, boolean gzip) throws IOException {
        this.path = path;
        this.metadata = metadata;
        AtomicFile begun = AtomicFile.begin(path);
        this.file = Optional.of(begun);
        OutputStream whole = new BufferedOutputStream(begun.stream(), 1 << 16);
        this.out = gzip ? new BufferedOutputStream(new GZIPOutputStream(whole), 1 << 16) : whole;
        this.table = new OutputStreamWriter(out, StandardCharsets.UTF_8);
        this.missing = arff ? "?" : "";
        this.width = 1 + channels.size();
        this.signals = Optional.empty();
        head(channels, arff);
    }

    private RecordingWriter(Writer table, List<Channel> channels, Metadata metadata) throws IOException {
        this.path = Path.of("-");
        this.metadata = metadata;
        this.file = Optional.empty();
        this.out = OutputStream.nullOutputStream();
        this.table = table;
        this.missing = "";
        this.width = 1 + channels.size();
        this.signals = Optional.empty();
        head(channels, false);
    }

    /** Begins a recording as CSV on a writer, which stays open: row by row, with nothing beside it. */
    public static RecordingWriter csv(Writer table, List<Channel> channels, Metadata metadata) throws IOException {
        return new RecordingWriter(table, channels, metadata);
    }

    private void head(List<Channel> channels, boolean arff) throws IOException {
        for (String comment : Provenance.lines(metadata)) {
            line.append(arff ? "% " + comment : "# " + TableText.comment(comment)).append('\n');
        }
        if (arff) {
            arffHeader(channels);
        } else {
            csvHeader(channels);
        }
        flushLine();
    }

    /**
     * Begins a file in the format that its name ends in: {@code .arff}, {@code .csv}, {@code .csv.gz}, {@code .arff.gz}, which are written
     * row by row, or {@code .uff} (binary), {@code .unv} (text), {@code .mat}, {@code .h5}, {@code .parquet}, {@code .wav}, which are held
     * in memory until the end.
     *
     * @param metadata stands in comment lines before the header of a table
     * @throws DataFault if the name ends otherwise, or the folder is missing or may not be written to
     */
    public static RecordingWriter create(Path path, List<Channel> channels, Metadata metadata) throws IOException {
        if (channels.isEmpty()) {
            throw new IllegalArgumentException("a recording needs at least one channel");
        }
        String name = path.getFileName().toString().toLowerCase(Locale.ROOT);
        boolean gzip = name.endsWith(".gz");
        String bare = gzip ? name.substring(0, name.length() - 3) : name;
        Optional<SignalKind> kind = SignalKind.named(path);
        if (!bare.endsWith(".csv") && !bare.endsWith(".arff") && kind.isEmpty()) {
            throw DataFault.in(path.toString(), "a recording is written as .csv, .csv.gz, .arff, .uff, .unv, .mat, .h5, .parquet or .wav");
        }
        if (Files.isDirectory(path)) {
            throw DataFault.in(path.toString(), "is a directory; name a file");
        }
        return kind.isPresent() ? new RecordingWriter(path, channels, metadata, kind.get())
                : new RecordingWriter(path, channels, metadata, bare.endsWith(".arff"), gzip);
    }

    /** Writes a whole recording, and its sidecar beside it unless nothing is known and none is there. */
    public static void write(Path path, Recording recording) throws IOException {
        try (RecordingWriter writer = create(path, recording.channels(), recording.metadata())) {
            double[][] columns = recording.channels().stream().map(recording::values).toArray(double[][]::new);
            double[] row = new double[1 + columns.length];
            for (int i = 0; i < recording.length(); i++) {
                row[0] = recording.clock().time(i);
                for (int j = 0; j < columns.length; j++) {
                    row[1 + j] = columns[j][i];
                }
                writer.write(row);
            }
            writer.finishWithSidecar();
        }
    }

    private void csvHeader(List<Channel> channels) {
        line.append(Header.TIME);
        for (Channel channel : channels) {
            line.append(',').append(channel);
        }
        line.append('\n');
    }

    private void arffHeader(List<Channel> channels) {
        line.append("@relation recording\n\n@attribute ").append(Header.TIME).append(" numeric\n");
        for (Channel channel : channels) {
            line.append("@attribute ").append(channel).append(" numeric\n");
        }
        line.append("\n@data\n");
    }

    /**
     * Writes a row.
     *
     * @param row time [s], then the channels in SI units, one more than channels long; NaN where missing. Not modified.
     * @throws IllegalArgumentException if a value is infinite, or the time is missing
     */
    public void write(double[] row) throws IOException {
        if (row.length != width) {
            throw new IllegalArgumentException("a row must have " + width + " values: " + row.length);
        }
        if (Double.isNaN(row[0])) {
            throw new IllegalArgumentException("a row needs a time");
        }
        for (int i = 0; i < width; i++) {
            if (Double.isInfinite(row[i])) {
                throw new IllegalArgumentException("a value must be finite or missing: " + row[i] + " in row " + (rows + 1));
            }
        }
        if (signals.isPresent()) {
            signals.get().add(row);
            return;
        }
        for (int i = 0; i < width; i++) {
            line.append(i > 0 ? "," : "");
            number(row[i]);
        }
        line.append('\n');
        rows++;
        flushLine();
    }

    /** The shortest decimal that reads back as the same double; whole numbers without a point, but for -0. */
    private void number(double value) {
        if (Double.isNaN(value)) {
            line.append(missing);
        } else if (value == (int) value && Double.doubleToRawLongBits(value) != Long.MIN_VALUE) {
            line.append((int) value);
        } else {
            line.append(value);
        }
    }

    private void flushLine() throws IOException {
        table.append(line);
        line.setLength(0);
    }

    /**
     * Ends the file and gives it its name.
     *
     * @throws DataFault if the format cannot hold what was written
     */
    public void finish() throws IOException {
        end();
        if (file.isPresent()) {
            file.get().finish();
        }
    }

    /**
     * The same with its sidecar beside it, unless nothing is known and none is there. The sidecar comes first, but after the last
     * byte of the recording: a full disk leaves neither, and no recording is without what its columns cannot hold.
     */
    public void finishWithSidecar() throws IOException {
        end();
        if (file.isPresent()) {
            Sidecar.writeBeside(path, metadata);
            file.get().finish();
        }
    }

    private void end() throws IOException {
        if (signals.isPresent()) {
            signals.get().write(out);
        }
        table.flush();
        out.close();
    }

    /** Lets go. Without {@link #finish} nothing is left behind. */
    @Override
    public void close() throws IOException {
        if (file.isPresent()) {
            file.get().close(); // not its buffers, which would only be thrown away
        }
    }
}
