package wbv.bench;

import java.util.Collections;
import java.util.List;
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
import wbv.network.Bodies;
import wbv.network.Estimate;
import wbv.network.Reader;
import wbv.network.Reading;
import wbv.network.RigTrials;
import wbv.network.TrainedNetwork;

/** One reading of the model that ships, and 128 at once; with the image from the samples and the fit. One thread. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class NetworkBenchmark {

    private static final int BATCH = 128;

    private double[][] motion;
    private List<double[][]> motions;
    private Reader reader;

    @Setup
    public void load() {
        motion = RigTrials.of(Bodies.ONE_DOF, 1, 1, share -> {}).get(0).motion();
        motions = Collections.nCopies(BATCH, motion);
        reader = new Reader(TrainedNetwork.shipped(1));
    }

    @TearDown
    public void close() {
        reader.close();
    }

    @Benchmark
    public List<Estimate> oneNetworkAlone() {
        return reader.ask(List.<double[][]>of(motion));
    }

    @Benchmark
    public List<Estimate> batchNetworkAlone() {
        return reader.ask(motions);
    }

    @Benchmark
    public Reading one() {
        return reader.read(motion);
    }

    @Benchmark
    public List<Reading> batch() {
        return reader.readAll(motions);
    }
}
