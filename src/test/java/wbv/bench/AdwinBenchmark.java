package wbv.bench;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import moa.classifiers.core.driftdetection.ADWIN;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** One input of MOA's ADWIN alone: what an estimator's step is measured by. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class AdwinBenchmark {

    private final double[] values = new double[4096];
    private ADWIN adwin;
    private int next;

    @Setup
    public void draw() {
        Random random = new Random(1);
        for (int i = 0; i < values.length; i++) {
            values[i] = random.nextDouble();
        }
        adwin = new ADWIN(0.002);
    }

    @Benchmark
    public boolean input() {
        next = next + 1 & values.length - 1;
        return adwin.setInput(values[next]);
    }
}
