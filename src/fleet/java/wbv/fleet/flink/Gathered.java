package wbv.fleet.flink;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import wbv.recording.AtomicFile;

/** The parts that machines wrote, as the files that one process writes: the same rows in the same order. */
final class Gathered {

    private Gathered() {}

    /**
     * Writes one file.
     *
     * @param parts  folder of the parts; none is an empty one. Those that begin with a dot were never finished.
     * @param header first line, with its end
     * @return number of rows
     */
    static int write(Path parts, String header, Path file) throws IOException {
        List<Rows.Placed> rows = rows(parts);
        try (AtomicFile whole = AtomicFile.begin(file)) {
            try (Writer out = new BufferedWriter(new OutputStreamWriter(whole.stream(), StandardCharsets.UTF_8))) {
                out.write(header);
                for (Rows.Placed each : rows) {
                    out.write(each.row());
                    out.write('\n');
                }
            }
            whole.finish();
        }
        return rows.size();
    }

    /** Writes one file of tables, of each what was told last. */
    static void writeTables(Path parts, String header, Path file) throws IOException {
        Map<Long, Integer> last = new TreeMap<>();
        List<Rows.Revised> rows = new ArrayList<>();
        for (String line : lines(parts)) {
            Rows.Revised row = Rows.Revised.of(line);
            last.merge(row.number(), row.revision(), Math::max);
            rows.add(row);
        }
        rows.removeIf(row -> row.revision() < last.get(row.number()));
        rows.sort(Comparator.comparingLong(Rows.Revised::number).thenComparingInt(Rows.Revised::place));
        StringBuilder text = new StringBuilder(header);
        rows.forEach(row -> text.append(row.row()).append('\n'));
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    static List<Rows.Placed> rows(Path parts) throws IOException {
        List<Rows.Placed> rows = new ArrayList<>();
        lines(parts).forEach(line -> rows.add(Rows.Placed.of(line)));
        rows.sort(Rows.Placed.ORDER);
        return rows;
    }

    private static List<String> lines(Path parts) throws IOException {
        List<String> rows = new ArrayList<>();
        if (Files.isDirectory(parts)) {
            List<Path> files;
            try (Stream<Path> all = Files.list(parts)) {
                files = all.filter(file -> !file.getFileName().toString().startsWith(".")).toList();
            }
            for (Path file : files) {
                try (Stream<String> lines = Files.lines(file)) {
                    lines.forEach(rows::add);
                }
            }
        }
        return rows;
    }
}
