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
import wbv.recording.RecordingFile;

/** A whole diagnosis of a shipped recording, whole bank, all cores: of nothing missing, and of one mechanism of each kind. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3)
@Measurement(iterations = 5)
@Fork(1)
public class DiagnosisBenchmark {

    @Param({"001", "003", "004", "006", "009"})
    public String concealed;

    private Model model;
    private Recording recording;

    @Setup
    public void read() throws IOException {
        Path folder = Path.of("data/arff/concealed", concealed);
        model = ModelFile.read(folder.resolve("model.json"));
        recording = new RecordingFile(folder.resolve("recording.csv.gz")).load();
    }

    @Benchmark
    public Diagnosis diagnosis() {
        return Diagnoser.diagnose(model, recording, (step, share) -> { });
    }
}
