package wbv.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import wbv.state.BaumWelch;
import wbv.state.ForwardFilter;
import wbv.state.Gaussian;
import wbv.state.HiddenMarkov;
import wbv.state.Mixture;
import wbv.state.Shape;

/** Hidden Markov models of 7 states over 18 features: one sample of the forward filter, and ten rounds of Baum-Welch on 43 200. */
@State(Scope.Thread)
@Fork(1)
public class StatesBenchmark {

    private static final int ROWS = 43_200;
    private static final int STATES = 7;
    private static final int FEATURES = 18;
    private static final int BATCH = 1000;

    @Param({"FULL", "DIAGONAL"})
    private Shape shape = Shape.FULL;

    private double[][] rows;
    private HiddenMarkov model;
    private ForwardFilter filter;
    private int next;

    @Setup
    public void make() {
        Random random = new Random(1);
        double[][] centres = new double[STATES][FEATURES];
        for (double[] centre : centres) {
            Arrays.setAll(centre, i -> 2 * random.nextGaussian());
        }
        rows = new double[ROWS][FEATURES];
        for (int t = 0; t < ROWS; t++) {
            double[] centre = centres[t / 60 % STATES];
            Arrays.setAll(rows[t], i -> centre[i] + random.nextGaussian());
        }
        double[] unit = new double[FEATURES * FEATURES];
        for (int i = 0; i < FEATURES; i++) {
            unit[i * FEATURES + i] = 4;
        }
        List<Mixture> emissions = new ArrayList<>();
        double[][] transition = new double[STATES][STATES];
        double[] initial = new double[STATES];
        for (int k = 0; k < STATES; k++) {
            emissions.add(Mixture.of(Gaussian.exact(shape, rows[random.nextInt(ROWS)], unit)));
            Arrays.fill(transition[k], 0.1 / (STATES - 1));
            transition[k][k] = 0.9;
            initial[k] = 1.0 / STATES;
        }
        model = new HiddenMarkov(initial, transition, emissions);
        filter = new ForwardFilter(model);
    }

    /** A thousand samples a call, counted one by one. */
    @Benchmark
    @BenchmarkMode(Mode.AverageTime)
    @OutputTimeUnit(TimeUnit.NANOSECONDS)
    @OperationsPerInvocation(BATCH)
    @Warmup(iterations = 3, time = 1)
    @Measurement(iterations = 5, time = 1)
    public double filterOneSample() {
        for (int i = 0; i < BATCH; i++) {
            filter.step(rows[next]);
            next = (next + 1) % ROWS;
        }
        return filter.probability(0);
    }

    @Benchmark
    @BenchmarkMode(Mode.SingleShotTime)
    @OutputTimeUnit(TimeUnit.MILLISECONDS)
    @Warmup(iterations = 2)
    @Measurement(iterations = 5)
    public HiddenMarkov tenRounds() {
        return new BaumWelch(10, 0, 0.1, shape, 1e-6).fit(model, List.<double[][]>of(rows), share -> { }).model();
    }
}
