package wbv.fleet.flink;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.apache.flink.streaming.api.environment.StreamExecutionEnvironment;
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
 * second, both from the same file of packets, when Java has compiled both. What many seats take more than few, so that the start is in
 * neither; median of three. For docs/benchmarks.md.
 */
final class FleetTiming {

    private static final int FEW = 60;
    private static final int MANY = 240;
    private static final int SECONDS = 120;
    private static final int ROUNDS = 3;

    private FleetTiming() { }

    public static void main(String[] words) throws Exception {
        for (int size : new int[] {60, 6}) {
            embedded(MANY, size);
            flink(MANY, size);
            double[] one = new double[ROUNDS];
            double[] other = new double[ROUNDS];
            for (int k = 0; k < ROUNDS; k++) {
                one[k] = -embedded(FEW, size) + embedded(MANY, size);
                other[k] = -flink(FEW, size) + flink(MANY, size);
            }
            double samples = 60.0 * SECONDS * (MANY - FEW);
            double first = median(one) / samples;
            double second = median(other) / samples;
            System.out.printf(Locale.ROOT, "%d samples a packet: one process %.2f us, Flink %.2f us a sample: %.2f times%n", size,
                    first / 1e3, second / 1e3, second / first);
        }
        System.exit(0);
    }

    private static double median(double[] values) {
        Arrays.sort(values);
        return values[values.length / 2];
    }

    private static FleetOrder order(int seats, int size) throws IOException {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, SECONDS, 1).recording();
        Path file = Path.of("target", "timing-" + seats + "-" + size + ".packets");
        if (!Files.exists(file)) {
            new Replay(List.of(recording), recording.channels(), seats, size, false, 0).write(file);
        }
        return new FleetOrder(new SeatOrder(60, recording.channels(), Method.EKF_ADWIN, false, Optional.empty(), 600),
                new FleetSource.Packets(List.of(file)), FleetOrder.HOUR);
    }

    private static long now() {
        return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime();
    }

    private static long embedded(int seats, int size) throws IOException {
        FleetOrder order = order(seats, size);
        Path folder = Files.createTempDirectory(Path.of("target"), "fleet");
        long before = now();
        new FleetRun(order, order.follow().plan(), folder, 1, 1).run(share -> { });
        return now() - before;
    }

    private static long flink(int seats, int size) throws Exception {
        FleetOrder order = order(seats, size);
        Path folder = Files.createTempDirectory(Path.of("target"), "fleet");
        long before = now();
        try (StreamExecutionEnvironment environment = StreamExecutionEnvironment.createLocalEnvironment(1, FleetJob.settings(folder, 1000))) {
            FleetJob.build(environment, order.bytes(), folder, 1);
            environment.execute();
        }
        return now() - before;
    }
}
