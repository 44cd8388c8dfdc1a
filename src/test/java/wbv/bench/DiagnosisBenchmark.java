package wbv.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/**
 * A whole diagnosis of a recording, whole bank, all cores: of nothing missing, of one mechanism of each kind, and of a law that has to be
 * learned. A pair or a refusal is any folder that {@code wbv prove} made: {@code -p folder=/path/cases/017}.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3)
@Measurement(iterations = 5)
@Fork(1)
public class DiagnosisBenchmark {

    /** Below data/arff, or with a path of its own. */
    @Param({"concealed/001", "concealed/003", "concealed/004", "concealed/006", "concealed/009", "learned"})
    public String folder;

    private Model model;
    private Recording recording;

    @Setup
    public void read() throws IOException {
        Path from = Path.of("data/arff").resolve(folder);
        model = ModelFile.read(from.resolve("model.json"));
        recording = new RecordingFile(from.resolve("recording.csv.gz")).load();
    }

    @Benchmark
    public Diagnosis diagnosis() {
        return Diagnoser.diagnose(model, recording, (step, share) -> {});
    }
}
