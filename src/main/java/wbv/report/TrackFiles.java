package wbv.report;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import wbv.filter.Track;
import wbv.recording.Channel;

/** Tracks of all outputs, sample by sample, as CSV and as ARFF with the same columns. */
final class TrackFiles implements Closeable {

    private static final List<String> COLUMNS = List.of("f0_hz", "f0_sd_hz", "zeta", "zeta_sd", "nis", "cut");

    private final BufferedWriter csv;
    private final BufferedWriter arff;
    private final StringBuilder line = new StringBuilder();

    TrackFiles(Path csvFile, Path arffFile, List<Channel> outputs, Map<String, String> provenance) throws IOException {
        csv = Files.newBufferedWriter(csvFile);
        arff = Files.newBufferedWriter(arffFile);
        StringBuilder head = new StringBuilder("t");
        StringBuilder attributes = new StringBuilder("@relation tracks\n\n@attribute t numeric\n");
        for (Channel output : outputs) {
            for (String column : COLUMNS) {
                head.append(',').append(output).append('.').append(column);
                attributes.append("@attribute ").append(output).append('.').append(column).append(" numeric\n");
            }
        }
        for (Map.Entry<String, String> entry : provenance.entrySet()) {
            String comment = (entry.getKey() + ": " + entry.getValue()).replaceAll("\\s+", " ");
            csv.write("# " + comment + "\n");
            arff.write("% " + comment + "\n");
        }
        csv.write(head.append('\n').toString());
        arff.write(attributes.append("\n@data\n").toString());
    }

    /** Begins a row. @param time [s] */
    void begin(double time) {
        line.setLength(0);
        line.append(time);
    }

    void add(Track track) {
        number(track.frequency());
        number(track.frequencyDeviation());
        number(track.damping());
        number(track.dampingDeviation());
        number(track.nis());
        line.append(track.cut() ? ",1" : ",0");
    }

    /** Ends the row. */
    void end() throws IOException {
        line.append('\n');
        csv.append(line);
        for (int i = line.indexOf(",,"); i >= 0; i = line.indexOf(",,", i)) {
            line.insert(i + 1, '?');
        }
        arff.append(line);
    }

    private void number(double value) {
        line.append(',');
        if (!Double.isNaN(value)) {
            line.append((float) value);
        }
    }

    @Override
    public void close() throws IOException {
        try (csv; arff) {
            csv.flush();
            arff.flush();
        }
    }
}
