package wbv.bench;

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
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/** One sample of one channel through each estimator; with {@code -prof gc} what that allocates. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class EstimatorBenchmark {

    /** A name of an estimator, and how many particles. */
    @Param({"ekf", "ekf-adwin", "constrained", "ukf", "particle 1000", "particle 10000", "fused"})
    public String estimated;

    private double[] u;
    private double[] y;
    private Estimator estimator;
    private int next;

    @Setup
    public void record() {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, 120, 1).recording();
        u = recording.values(Channel.parse("platform.acc.z"));
        y = recording.values(Channel.parse("head.acc.z"));
        String[] words = estimated.split(" ");
        estimator = EstimatorDesign.of(Method.named(words[0]).orElseThrow())
                .withParticles(words.length > 1 ? Integer.parseInt(words[1]) : EstimatorDesign.USUAL_PARTICLES)
                .estimator(Spec.at(60), () -> new AdwinAlarm(0.002));
    }

    @Benchmark
    public double step() {
        next = next + 1 == u.length ? 0 : next + 1;
        return estimator.step(u[next], y[next]).frequency();
    }
}
