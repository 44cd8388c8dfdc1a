package wbv.fleet.flink;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import wbv.recording.AtomicFile;

/** The parts that machines wrote, as the files that one process writes: the same rows in the same order. */
final class Gathered {

    private Gathered() { }

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

    static List<Rows.Placed> rows(Path parts) throws IOException {
        List<Rows.Placed> rows = new ArrayList<>();
        if (Files.isDirectory(parts)) {
            List<Path> files;
            try (Stream<Path> all = Files.list(parts)) {
                files = all.filter(file -> !file.getFileName().toString().startsWith(".")).toList();
            }
            for (Path file : files) {
                try (Stream<String> lines = Files.lines(file)) {
                    lines.map(Rows.Placed::of).forEach(rows::add);
                }
            }
        }
        rows.sort(Rows.Placed.ORDER);
        return rows;
    }
}
