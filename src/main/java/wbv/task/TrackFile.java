package wbv.task;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import wbv.filter.Track;
import wbv.recording.DataFault;

/**
 * Writes tracks, one line for each sample, every number exactly. The file appears under its name when {@link #finish} is
 * called, and not at all otherwise.
 */
public final class TrackFile implements Closeable {

    /** Names of the columns; units are part of them. */
    private static final String[] COLUMNS = {"frequency_Hz", "frequency_sd_Hz", "damping", "damping_sd",
        "prediction_m_s2", "unexplained_m_s2", "nis", "cut", "changed", "alarm_window"};

    private final Path path;
    private final Path part;
    private final Writer out;
    private final String missing;
    private final StringBuilder line = new StringBuilder();
    private boolean finished;

    private TrackFile(Path path, boolean arff, List<String> bodies, Map<String, String> provenance) throws IOException {
        this.path = path;
        this.part = path.resolveSibling("." + path.getFileName() + "." + ProcessHandle.current().pid() + ".part");
        part.toFile().deleteOnExit(); // Ctrl-C closes nothing
        this.out = Files.newBufferedWriter(part);
        this.missing = arff ? "?" : "";
        List<String> columns = new ArrayList<>(List.of("t"));
        for (String body : bodies) {
            for (String column : COLUMNS) {
                columns.add(body.isEmpty() ? column : body + "." + column);
            }
        }
        for (Map.Entry<String, String> entry : provenance.entrySet()) {
            out.write((arff ? "% " : "# ") + (entry.getKey() + ": " + entry.getValue()).replaceAll("\\s+", " ") + "\n");
        }
        if (arff) {
            out.write("@relation tracks\n\n");
            for (String column : columns) {
                out.write("@attribute " + column + " numeric\n");
            }
            out.write("\n@data\n");
        } else {
            out.write(String.join(",", columns) + "\n");
        }
    }

    /** Begins a file for one body, with plain column names. */
    public static TrackFile create(Path path) throws IOException {
        return create(path, List.of(""), Map.of());
    }

    /**
     * Begins a file.
     *
     * @param path       ends in .csv or .arff
     * @param bodies     names that precede those of the columns, one for each body
     * @param provenance stands in comment lines before the header
     * @throws DataFault if the name ends otherwise, or its folder is missing or may not be written to
     */
    public static TrackFile create(Path path, List<String> bodies, Map<String, String> provenance) throws IOException {
        String name = path.getFileName().toString().toLowerCase(Locale.ROOT);
        if (!name.endsWith(".csv") && !name.endsWith(".arff")) {
            throw DataFault.in(path.toString(), "tracks are written as .csv or .arff");
        }
        try {
            return new TrackFile(path, name.endsWith(".arff"), bodies, provenance);
        } catch (NoSuchFileException noFolder) {
            throw new DataFault(path + ": there is no folder to write it in", noFolder);
        } catch (AccessDeniedException denied) {
            throw new DataFault(path + ": may not be written; check the folder's permissions", denied);
        }
    }

    /** Writes the line of a single body. @param time [s] */
    public void write(Track track, double time) {
        begin(time);
        add(track);
        end();
    }

    /** Begins a line. @param time [s] */
    public void begin(double time) {
        line.setLength(0);
        line.append(time);
    }

    /** Adds the next body to the line. */
    public void add(Track track) {
        number(track.frequency());
        number(track.frequencyDeviation());
        number(track.damping());
        number(track.dampingDeviation());
        number(track.prediction());
        number(track.outputNoise());
        number(track.nis());
        line.append(track.cut() ? ",1" : ",0").append(track.changed() ? ",1," : ",0,").append(track.width());
    }

    /** Ends the line. */
    public void end() {
        try {
            out.append(line.append('\n'));
        } catch (IOException failed) {
            throw new UncheckedIOException(failed);
        }
    }

    private void number(double value) {
        line.append(',');
        if (Double.isNaN(value)) {
            line.append(missing);
        } else {
            line.append(value);
        }
    }

    /** Ends the file and gives it its name. */
    public void finish() throws IOException {
        out.close();
        Files.move(part, path, StandardCopyOption.REPLACE_EXISTING);
        finished = true;
    }

    @Override
    public void close() throws IOException {
        if (!finished) {
            try {
                out.close();
            } finally {
                Files.deleteIfExists(part);
            }
        }
    }
}
