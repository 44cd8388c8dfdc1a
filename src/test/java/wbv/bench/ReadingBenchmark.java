package wbv.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import wbv.recording.RowReader;
import wbv.recording.format.RecordingFile;
import wbv.recording.format.RecordingWriter;
import weka.core.Instance;
import weka.core.Instances;
import weka.core.converters.ArffLoader;

/** Reading the shipped ride (9000 rows, 61 columns) as CSV and ARFF, beside Weka's incremental {@link ArffLoader}. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class ReadingBenchmark {

    private static final Path ARFF = Path.of("data/arff/ride-subject1.arff");

    private Path csv;

    @Setup
    public void convert() throws IOException {
        csv = Files.createTempDirectory("wbv-bench").resolve("ride.csv");
        try (RowReader reader = new RecordingFile(ARFF).open();
                RecordingWriter writer = RecordingWriter.create(csv, reader.channels(), reader.metadata())) {
            double[] row = new double[1 + reader.channels().size()];
            while (reader.read(row)) {
                writer.write(row);
            }
            writer.finish();
        }
    }

    @TearDown
    public void remove() throws IOException {
        Files.delete(csv);
        Files.delete(csv.getParent());
    }

    @Benchmark
    public double wbvCsv() throws IOException {
        return sum(csv);
    }

    @Benchmark
    public double wbvArff() throws IOException {
        return sum(ARFF);
    }

    private static double sum(Path file) throws IOException {
        double sum = 0;
        try (RowReader reader = new RecordingFile(file).open()) {
            double[] row = new double[1 + reader.channels().size()];
            while (reader.read(row)) {
                sum += row[1];
            }
        }
        return sum;
    }

    @Benchmark
    public double wekaArffLoader() throws IOException {
        ArffLoader loader = new ArffLoader();
        loader.setFile(ARFF.toFile());
        Instances structure = loader.getStructure();
        double sum = 0;
        for (Instance row = loader.getNextInstance(structure); row != null; row = loader.getNextInstance(structure)) {
            sum += row.value(1);
        }
        return sum;
    }
}
