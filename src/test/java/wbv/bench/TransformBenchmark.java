package wbv.bench;

import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
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
import wbv.signal.RealDft;

/** A Fourier transform of two minutes at 60 and at 240 Hz with silence after them, and of a power of two beside that of Commons Math. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class TransformBenchmark {

    @Param({"7500", "30000", "32768"})
    private int length;

    private RealDft dft;
    private double[] sequence;
    private double[] spectrum;

    @Setup
    public void draw() {
        dft = new RealDft(length);
        sequence = new Random(1).doubles(length, -1, 1).toArray();
        spectrum = dft.forward(sequence);
    }

    @Benchmark
    public double[] forward() {
        return dft.forward(sequence);
    }

    @Benchmark
    public double[] inverse() {
        return dft.inverse(spectrum);
    }

    /** What it is measured by; of powers of two alone. */
    @Benchmark
    public Complex[] commonsMath() {
        int power = Integer.highestOneBit(length);
        double[] cut = length == power ? sequence : Arrays.copyOf(sequence, power);
        return new FastFourierTransformer(DftNormalization.STANDARD).transform(cut, TransformType.FORWARD);
    }
}
