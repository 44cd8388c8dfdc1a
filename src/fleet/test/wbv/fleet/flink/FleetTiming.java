package wbv.fleet.flink;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.apache.flink.api.common.eventtime.WatermarkStrategy;
import org.apache.flink.api.common.functions.FilterFunction;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.streaming.api.environment.StreamExecutionEnvironment;
import org.apache.flink.streaming.api.functions.sink.v2.DiscardingSink;
import wbv.filter.Method;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetRun;
import wbv.fleet.FleetSource;
import wbv.fleet.Replay;
import wbv.fleet.SeatOrder;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * Processor time of the whole process a sample, in one process and through Flink with one task of each kind, checkpoints every
 * second, both from the same file of packets: from the sixth result of each seat to its eleventh, so that neither the start nor the
 * end is in it, nor most of Java's compiler. Argument: samples of a packet. For docs/benchmarks.md.
 */
final class FleetTiming {

    private static final int SEATS = 600;
    private static final int SECONDS = 120;
    private static final int RESULTS = 12;
    private static final int FROM = 6;
    private static final int TO = 11;

    private static final AtomicLong TOLD = new AtomicLong();
    private static volatile long from;
    private static volatile long to;

    private FleetTiming() {}

    public static void main(String[] words) throws Exception {
        int size = Integer.parseInt(words[0]);
        for (int round = 0; round < 3; round++) {
            double one = embedded(size);
            double other = flink(size);
            System.out.printf(Locale.ROOT, "%d samples a packet: one process %.2f us, Flink %.2f us a sample: %.2f times%n", size, one,
                    other, other / one);
        }
        System.exit(0);
    }

    private static FleetOrder order(int size) throws IOException {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, SECONDS, 1).recording();
        Path file = Path.of("target", "timing-" + size + ".packets");
        if (!Files.exists(file)) {
            new Replay(List.of(recording), recording.channels(), SEATS, size, false, 0).write(file);
        }
        return new FleetOrder(new SeatOrder(60, recording.channels(), Method.EKF_ADWIN, false, Optional.empty(), 60 * SECONDS / RESULTS),
                new FleetSource.Packets(List.of(file)), FleetOrder.HOUR);
    }

    private static long now() {
        return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime();
    }

    /** @return time a sample [µs] */
    private static double taken() {
        return (to - from) / 1e3 / (60.0 * SECONDS * SEATS * (TO - FROM) / RESULTS);
    }

    private static double embedded(int size) throws IOException {
        FleetOrder order = order(size);
        from = 0;
        to = 0;
        new FleetRun(order, order.follow().plan(), Files.createTempDirectory(Path.of("target"), "fleet"), 1, 1).run(share -> {
            from = from == 0 && share >= (double) FROM / RESULTS ? now() : from;
            to = to == 0 && share >= (double) TO / RESULTS ? now() : to;
        });
        return taken();
    }

    private static double flink(int size) throws Exception {
        FleetOrder order = order(size);
        Path folder = Files.createTempDirectory(Path.of("target"), "fleet");
        TOLD.set(0);
        try (StreamExecutionEnvironment environment = StreamExecutionEnvironment.createLocalEnvironment(1,
                FleetJob.settings(folder, 1000))) {
            FleetJob.Told told = FleetJob.follow(
                    environment.fromSource(new PacketFileSource(((FleetSource.Packets) order.source()).files()),
                            WatermarkStrategy.noWatermarks(), "files", Types.TUPLE(Types.LONG, Types.PRIMITIVE_ARRAY(Types.BYTE)))
                            .uid("files"),
                    Optional.empty(), order);
            FleetJob.write(told, folder);
            told.results().filter(new Count()).uid("count").sinkTo(new DiscardingSink<>()).uid("counted");
            environment.execute();
        }
        return taken();
    }

    /** Counts results. */
    private static final class Count implements FilterFunction<String> {

        private static final long serialVersionUID = 1;

        @Override
        public boolean filter(String row) {
            long count = TOLD.incrementAndGet();
            if (count == (long) SEATS * FROM) {
                from = now();
            } else if (count == (long) SEATS * TO) {
                to = now();
            }
            return false;
        }
    }
}
