package wbv.bench;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import wbv.exposure.Cascade;
import wbv.exposure.Meter;
import wbv.exposure.Weighting;

/**
 * A minute of 30 channels: weighted as a stream with all running statistics, weighted exactly as a recording, and the biquads
 * alone at their working rate of 840 Hz. What SciPy takes for the same is measured by {@code bench/exposure_scipy.py}.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class ExposureBenchmark {

    private static final int CHANNELS = 30;
    private static final double RATE = 60;
    private static final int WORKING = 14;

    private final double[][] samples = minutes(60 * (int) RATE);
    private final double[][] raised = minutes(60 * (int) RATE * WORKING);

    private static double[][] minutes(int length) {
        double[][] all = new double[CHANNELS][];
        Random random = new Random(1);
        for (int i = 0; i < CHANNELS; i++) {
            all[i] = random.doubles(length, -1, 1).toArray();
        }
        return all;
    }

    @Benchmark
    public double streams() {
        double sum = 0;
        for (double[] channel : samples) {
            sum += run(Meter.stream(Weighting.WK.filter(), RATE, false), channel);
        }
        return sum;
    }

    @Benchmark
    public double recordings() {
        double sum = 0;
        for (double[] channel : samples) {
            sum += run(Meter.exact(Weighting.WK.filter(), RATE, 0, false), channel);
        }
        return sum;
    }

    private static double run(Meter meter, double[] channel) {
        for (double sample : channel) {
            meter.accept(sample);
        }
        meter.finish();
        return meter.vibration().rms();
    }

    @Benchmark
    public double biquadsAlone() {
        double sum = 0;
        for (double[] channel : raised) {
            Cascade cascade = Weighting.WK.filter().cascade(RATE * WORKING);
            for (double sample : channel) {
                sum += cascade.step(sample);
            }
        }
        return sum;
    }
}
