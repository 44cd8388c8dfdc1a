package wbv.bench;

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
import wbv.filter.BodyEstimator;
import wbv.filter.Spec;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/** One step of the estimator for one output channel, beside one input of MOA's ADWIN alone. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class EstimatorBenchmark {

    private double[] u;
    private double[] y;
    private BodyEstimator estimator;
    private ADWIN adwin;
    private int next;

    @Setup
    public void record() {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, 120, 1).recording();
        u = recording.values(Channel.parse("platform.acc.z"));
        y = recording.values(Channel.parse("head.acc.z"));
        estimator = new BodyEstimator(Spec.at(60), new AdwinAlarm(0.002));
        adwin = new ADWIN(0.002);
    }

    @Benchmark
    public double estimatorStep() {
        next = next + 1 == u.length ? 0 : next + 1;
        return estimator.step(u[next], y[next]).frequency();
    }

    @Benchmark
    public boolean adwinInput() {
        next = next + 1 == u.length ? 0 : next + 1;
        return adwin.setInput(0.5 + 0.1 * Math.min(4, Math.abs(u[next])));
    }
}
