package wbv.recording.format;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Assumptions;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.RowReader;
import wbv.recording.inspect.Finding;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Inspector;

/** Small recordings for tests. */
public final class Samples {

    public static final Channel HEAD = Channel.parse("head.acc.z");

    private Samples() {}

    /** A file with this text. */
    public static Path file(Path folder, String name, String text) throws IOException {
        return Files.write(folder.resolve(name), text.getBytes(StandardCharsets.UTF_8));
    }

    public static RecordingFile recording(Path folder, String name, String text) throws IOException {
        return new RecordingFile(file(folder, name, text));
    }

    /** What an inspector says about one channel with these times and values. */
    public static Inspection inspect(double[] times, DoubleUnaryOperator value, OptionalDouble nominal) {
        Inspector inspector = new Inspector("test", List.of(HEAD), Metadata.NONE.withRate(nominal), Optional.empty());
        for (int i = 0; i < times.length; i++) {
            inspector.accept(new double[] {times[i], value.applyAsDouble(i)}, i + 2);
        }
        return inspector.finish();
    }

    /** An inspection of a lively signal, of which only the times are of interest. */
    public static Inspection inspect(double[] times) {
        return inspect(times, i -> Math.sin(0.7 * i) + 0.01 * Math.sin(11.3 * i * i), OptionalDouble.empty());
    }

    /** All rows of a reader. */
    public static List<double[]> rows(RowReader reader) throws IOException {
        List<double[]> rows = new ArrayList<>();
        double[] row = new double[1 + reader.channels().size()];
        while (reader.read(row)) {
            rows.add(row.clone());
        }
        reader.close();
        return rows;
    }

    /** A folder of measured recordings beside the project; the test is skipped where it is missing. */
    static Path shared(String folder) {
        Path path = Path.of("../shared", folder);
        Assumptions.assumeTrue(Files.isDirectory(path), () -> "skipped: there is no " + path);
        return path;
    }

    public static <F extends Finding> Optional<F> find(Inspection inspection, Class<F> type) {
        return inspection.findings().stream().filter(type::isInstance).map(type::cast).findFirst();
    }

    /** Rounds to so many significant digits, as the practice recordings do with their times. */
    public static double significant(double value, int digits) {
        return Double.parseDouble(String.format(Locale.ROOT, "%." + (digits - 1) + "e", value));
    }
}
