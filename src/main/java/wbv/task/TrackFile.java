package wbv.task;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.zip.GZIPOutputStream;
import wbv.filter.BodyEstimate;
import wbv.recording.AtomicFile;
import wbv.recording.DataFault;
import wbv.recording.TableText;

/**
 * Writes tracks, one line for each sample: natural frequency, damping ratio and prediction to a hundredth of their standard
 * deviation's leading decimal, the deviations themselves to three digits, for what is below says nothing; or exactly, for one who
 * computes on. The test that rang stands by its place in {@link wbv.filter.drift.ChangeTest}, 0 if none did. Names that end in .gz are
 * compressed. The file appears under its name when {@link #finish} is called, and not at all otherwise.
 */
public final class TrackFile implements Closeable {

    /** Names of the columns; units are part of them. */
    private static final List<String> MODE = List.of("frequency_Hz", "frequency_sd_Hz", "damping", "damping_sd");
    private static final List<String> SECOND_MODE = List.of("frequency2_Hz", "frequency2_sd_Hz", "damping2", "damping2_sd",
            "share");
    private static final List<String> REST = List.of("prediction_", "unexplained_", "nis", "heard_by", "changed", "alarm_window",
            "excited");

    private static final String ZIPPED = ".gz";
    /** How a file is written, by the end of its name. */
    private enum Format { CSV, ARFF, JSON }

    /**
     * A body whose track a file holds.
     *
     * @param name  precedes those of its columns; may be empty
     * @param modes 1 or 2
     * @param unit  of its motion, as it stands in names of columns: {@code m_s2} or {@code rad_s}
     */
    public record Body(String name, int modes, String unit) {

        private List<String> columns() {
            List<String> columns = new ArrayList<>(MODE);
            if (modes == 2) {
                columns.addAll(SECOND_MODE);
            }
            REST.forEach(column -> columns.add(column.endsWith("_") ? column + unit : column));
            return name.isEmpty() ? columns : columns.stream().map(column -> name + "." + column).toList();
        }
    }

    private final AtomicFile file;
    private final Writer out;
    private final Format format;
    private final String missing;
    private final TrackCells own;
    private final StringBuilder line = new StringBuilder();
    private boolean begun;

    private TrackFile(Path path, Format format, List<Body> bodies, Map<String, String> provenance, boolean exact) throws IOException {
        this.format = format;
        this.own = new TrackCells(exact);
        this.file = AtomicFile.begin(path);
        this.out = new BufferedWriter(new OutputStreamWriter(path.toString().toLowerCase(Locale.ROOT).endsWith(ZIPPED)
                ? new GZIPOutputStream(file.stream(), 1 << 16) : file.stream(), StandardCharsets.UTF_8));
        this.missing = switch (format) {
            case CSV -> "";
            case ARFF -> "?";
            case JSON -> "null";
        };
        List<String> columns = new ArrayList<>(List.of("t"));
        bodies.forEach(body -> columns.addAll(body.columns()));
        switch (format) {
            case CSV -> {
                for (Map.Entry<String, String> entry : provenance.entrySet()) {
                    out.write("# " + TableText.comment(entry.getKey() + ": " + entry.getValue()) + "\n");
                }
                out.write(String.join(",", columns) + "\n");
            }
            case ARFF -> {
                for (Map.Entry<String, String> entry : provenance.entrySet()) {
                    out.write("% " + (entry.getKey() + ": " + entry.getValue()).replaceAll("\\s+", " ") + "\n");
                }
                out.write("@relation tracks\n\n");
                for (String column : columns) {
                    out.write("@attribute " + column + " numeric\n");
                }
                out.write("\n@data\n");
            }
            case JSON -> {
                String origin = provenance.entrySet().stream().map(entry -> quoted(entry.getKey()) + ": "
                        + quoted(entry.getValue()))
                        .collect(Collectors.joining(", "));
                out.write("{\"provenance\": {" + origin + "},\n\"columns\": ["
                        + columns.stream().map(TrackFile::quoted).collect(Collectors.joining(", ")) + "],\n\"rows\": [");
            }
        }
    }

    private static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"").replaceAll("\\p{Cntrl}", " ") + '"';
    }

    /** Begins a file for one body, with plain column names and every number exactly. */
    public static TrackFile create(Path path) throws IOException {
        return of(path, List.of(new Body("", 1, "m_s2")), Map.of(), true);
    }

    /**
     * Begins a file for bodies of one degree of freedom.
     *
     * @param bodies names that precede those of the columns, one for each body
     */
    public static TrackFile create(Path path, List<String> bodies, Map<String, String> provenance) throws IOException {
        return of(path, bodies.stream().map(name -> new Body(name, 1, "m_s2")).toList(), provenance);
    }

    /**
     * Begins a file.
     *
     * @param path       ends in .csv, .arff or .json, and may end in .gz behind it
     * @param provenance stands before the header
     * @throws DataFault if the name ends otherwise, or its folder is missing or may not be written to
     */
    public static TrackFile of(Path path, List<Body> bodies, Map<String, String> provenance) throws IOException {
        return of(path, bodies, provenance, false);
    }

    private static TrackFile of(Path path, List<Body> bodies, Map<String, String> provenance, boolean exact) throws IOException {
        String whole = path.getFileName().toString().toLowerCase(Locale.ROOT);
        String name = whole.endsWith(ZIPPED) ? whole.substring(0, whole.length() - ZIPPED.length()) : whole;
        Format format = Arrays.stream(Format.values()).filter(f -> name.endsWith("."
                + f.name().toLowerCase(Locale.ROOT))).findFirst()
                .orElseThrow(() -> DataFault.in(path.toString(), "tracks are written as .csv or .arff, or as .json"));
        return new TrackFile(path, format, bodies, provenance, exact);
    }

    /**
     * Writes the line of a single body.
     *
     * @param time [s]
     */
    public void write(BodyEstimate track, double time) {
        begin(time);
        add(track);
        end();
    }

    /**
     * Begins a line.
     *
     * @param time [s]
     */
    public void begin(double time) {
        line.setLength(0);
        if (format == Format.JSON) {
            line.append(begun ? ",\n[" : "\n[");
        }
        begun = true;
        line.append(time);
    }

    /** Adds the next body to the line. */
    public void add(BodyEstimate track) {
        own.clear();
        own.add(track);
        add(own, 0);
    }

    /**
     * Adds the next body to the line.
     *
     * @param row of the sample among those of the cells, from 0
     */
    public void add(TrackCells cells, int row) {
        cells.appendTo(line, row, missing, format != Format.JSON);
    }

    /** Ends the line. */
    public void end() {
        try {
            out.append(line.append(format == Format.JSON ? ']' : '\n'));
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    /** Ends the file and gives it its name. */
    public void finish() throws IOException {
        if (format == Format.JSON) {
            out.write("\n]}\n");
        }
        out.close();
        file.finish();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
