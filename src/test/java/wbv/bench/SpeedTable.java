package wbv.bench;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import moa.classifiers.core.driftdetection.ADWIN;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * Every estimator beside the C loop and beside MOA's ADWIN, in processor time, which other work on the machine disturbs less than
 * the clock on the wall; turn and turn about, the median of {@value #TURNS}. Prints a table for {@code docs/benchmarks.md},
 * of the rows that are named or of all.
 */
public final class SpeedTable {

    private static final int TURNS = 5;
    private static final int SECONDS = 120;
    private static final double TURN = 0.5;
    private static final List<String> ROWS = List.of("ekf", "ekf-adwin", "constrained", "ukf", "particle 1000", "particle 10000",
            "fused");

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final double[] u;
    private final double[] y;
    private double sink;

    private SpeedTable() {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, SECONDS, 1).recording();
        u = recording.values(Channel.parse("platform.acc.z"));
        y = recording.values(Channel.parse("head.acc.z"));
    }

    public static void main(String[] words) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("peer");
        SpeedTable table = new SpeedTable();
        Optional<CompiledPeer> peer = CompiledPeer.in(folder, table.u, table.y);
        System.out.println("| estimator | µs a sample | channels at 60 Hz on one core | beside the C loop | MOA's ADWIN inputs "
                + "| bytes a sample |\n|---|---|---|---|---|---|");
        for (String row : words.length == 0 ? ROWS : List.of(words)) {
            table.print(row, peer);
        }
        System.err.println(table.sink);
    }

    private void print(String row, Optional<CompiledPeer> peer) throws IOException, InterruptedException {
        String[] parts = row.split(" ");
        Method method = Method.named(parts[0]).orElseThrow();
        int particles = parts.length > 1 ? Integer.parseInt(parts[1]) : EstimatorDesign.USUAL_PARTICLES;
        Estimator estimator = EstimatorDesign.of(method).withParticles(particles).estimator(Spec.at(60), () -> new AdwinAlarm(0.002));
        String loop = switch (method) {
            case EKF, EKF_ADWIN, CONSTRAINED -> "ekf";
            case UNSCENTED -> "ukf";
            case PARTICLE -> "particle";
            case FUSED -> "";
        };
        feed(estimator, 2 * TURN);
        double[] own = new double[TURNS];
        double[] compiled = new double[TURNS];
        double[] adwin = new double[TURNS];
        double bytes = 0;
        for (int turn = 0; turn < TURNS; turn++) {
            long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
            long[] samples = new long[1];
            own[turn] = feed(estimator, TURN, samples);
            bytes += (threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before) / (double) samples[0] / TURNS;
            int rounds = (int) Math.max(1, Math.round(TURN * 1e9 / (own[turn] * u.length)));
            compiled[turn] = peer.isPresent() && !loop.isEmpty() ? peer.get().run(loop, rounds, particles).nanoseconds()
                    : Double.NaN;
            adwin[turn] = adwin();
        }
        double[] ratios = new double[TURNS];
        Arrays.setAll(ratios, i -> own[i] / compiled[i]);
        double ns = median(own);
        System.out.printf(Locale.ROOT, "| %s | %.3g | %.0f | %s | %.1f | %.2f |%n", row, ns / 1000, 1e9 / 60 / ns,
                Double.isNaN(ratios[0]) ? "" : String.format(Locale.ROOT, "%.2f of `%s` (%.3g µs)", median(ratios), loop,
                        median(compiled) / 1000),
                ns / median(adwin), bytes);
    }

    private double feed(Estimator estimator, double seconds) {
        return feed(estimator, seconds, new long[1]);
    }

    /** Nanoseconds a sample. @param samples their number. Modified. */
    private double feed(Estimator estimator, double seconds, long[] samples) {
        long before = threads.getCurrentThreadCpuTime();
        long now = before;
        while (now - before < seconds * 1e9) {
            for (int i = 0; i < u.length && now - before < seconds * 1e9; i++) {
                sink += estimator.step(u[i], y[i]).frequency();
                samples[0]++;
                if (i % 64 == 0) {
                    now = threads.getCurrentThreadCpuTime();
                }
            }
            now = threads.getCurrentThreadCpuTime();
        }
        return (now - before) / (double) samples[0];
    }

    private double adwin() {
        ADWIN adwin = new ADWIN(0.002);
        long before = threads.getCurrentThreadCpuTime();
        int rounds = 20;
        for (int round = 0; round < rounds; round++) {
            for (double value : u) {
                sink += adwin.setInput(0.5 + 0.1 * Math.min(4, Math.abs(value))) ? 1 : 0;
            }
        }
        return (threads.getCurrentThreadCpuTime() - before) / (double) rounds / u.length;
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
