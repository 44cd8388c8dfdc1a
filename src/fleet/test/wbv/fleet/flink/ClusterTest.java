package wbv.fleet.flink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import wbv.filter.Method;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetRun;
import wbv.fleet.SeatOrder;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/** A cluster of three processes against one process: the same bytes, killed workers or not. */
class ClusterTest {

    @TempDir
    private Path temporary;

    private static FleetOrder order(int seats) {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, 120, 1).recording();
        return new FleetOrder(List.of(recording), new SeatOrder(60, recording.channels(), Method.EKF_ADWIN, false, Optional.empty(), 60),
                seats, 30, Optional.of(7L));
    }

    private Path embedded(FleetOrder order) throws IOException {
        Path folder = temporary.resolve("embedded");
        new FleetRun(order.replay(), order.follow().plan(), folder, 2, 1e9).run(share -> {});
        return folder;
    }

    private static void assertSame(Path one, Path other) throws IOException {
        for (String name : List.of("results.csv", "alarms.csv", "machines.csv", "worst.csv")) {
            assertEquals(-1, Files.mismatch(one.resolve(name), other.resolve(name)), name);
        }
        try (Stream<Path> files = Files.list(other)) {
            assertEquals(4, files.count(), "nothing else is left");
        }
    }

    /** A JobManager, a worker, and then all of them with the one that started them; the same order goes on, on one worker. */
    @Test
    @Timeout(300)
    void whateverIsKilledMidwayTheBytesAreTheSame() throws IOException {
        FleetOrder order = order(300);
        Path out = temporary.resolve("cluster");
        List<String> told = new ArrayList<>();
        Kill kill = new Kill(out, told);
        assertThrows(Stopped.class, () -> new FlinkEngine().local(order, 2, 1, out, told::add, kill::look));
        assertEquals(3, kill.kills, "the job was over before a checkpoint was");
        assertTrue(told.stream().anyMatch(line -> line.contains("a worker died")), told.toString());
        assertTrue(told.stream().anyMatch(line -> line.contains("the JobManager died")), told.toString());
        DataFault refused = assertThrows(DataFault.class, () -> new FlinkEngine().local(order(5), 1, 1, out, told::add));
        assertTrue(refused.getMessage().contains("another run stopped"), refused.getMessage());
        new FlinkEngine().local(order, 1, 1, out, told::add);
        assertTrue(told.stream().anyMatch(line -> line.contains("going on where the run before stopped")), told.toString());
        Path embedded = embedded(order);
        assertSame(embedded, out);
        assertTrue(kill.rows < 0.95 * Files.readAllLines(embedded.resolve("results.csv")).size(), kill.rows + " rows before the last kill");
    }

    private static final class Stopped extends RuntimeException {}

    /**
     * Kills with -9 when results are in files, and so a checkpoint is complete, and more are on their way: the JobManager, when there
     * are more a worker, and when it was missed and there are more, everything.
     */
    private static final class Kill {

        private final Path out;
        private final List<String> told;
        private int rows;
        private int kills;

        private Kill(Path out, List<String> told) {
            this.out = out;
            this.told = told;
        }

        private void look(LocalCluster cluster) {
            int now = finished();
            boolean missed = kills < 2 || told.stream().anyMatch(line -> line.contains("a worker died"));
            if (now > rows && missed) {
                rows = now;
                switch (kills++) {
                    case 0 -> cluster.jobManagerProcess().destroyForcibly();
                    case 1 -> cluster.workers().get(1).destroyForcibly();
                    default -> throw new Stopped();
                }
            }
        }

        private int finished() {
            try {
                return Gathered.rows(out.resolve(FlinkEngine.PARTS).resolve("results")).size();
            } catch (IOException | UncheckedIOException movedJustNow) {
                return 0;
            }
        }
    }
}
