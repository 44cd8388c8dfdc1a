package wbv.fleet.flink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.apache.flink.api.common.eventtime.WatermarkStrategy;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.configuration.Configuration;
import org.apache.flink.configuration.StateRecoveryOptions;
import org.apache.flink.core.execution.JobClient;
import org.apache.flink.core.execution.SavepointFormatType;
import org.apache.flink.streaming.api.datastream.DataStream;
import org.apache.flink.streaming.api.environment.StreamExecutionEnvironment;
import org.apache.flink.streaming.api.functions.sink.v2.DiscardingSink;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.filter.Method;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetRun;
import wbv.fleet.ResultRows;
import wbv.fleet.SeatOrder;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/** Jobs that are stopped with a savepoint and gone on with: by more and fewer tasks, and by this version of the program. */
class SavepointTest {

    /** Of the seats' form as it is, made by {@link #main}. */
    private static final Path GOLDEN = Path.of("src/test/resources/wbv/fleet/savepoint-v4");

    /** Below target and left there: jobs in this process clean up behind themselves when they have ended. */
    private final Path temporary;

    SavepointTest() throws IOException {
        temporary = Files.createTempDirectory(Files.createDirectories(Path.of("target", "jobs")).toAbsolutePath(), "job");
    }

    private static FleetOrder order(int seats, int seconds) {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, seconds, 1).recording();
        SeatOrder follow = new SeatOrder(60, recording.channels(), Method.EKF_ADWIN, false, Optional.empty(), 60);
        return new FleetOrder(List.of(recording), follow, seats, 30, Optional.of(7L));
    }

    private static List<String> embedded(FleetOrder order, Path folder) throws IOException {
        new FleetRun(order, order.follow().plan(), folder, 1, 1e9).run(share -> {});
        return Files.readAllLines(folder.resolve("results.csv"));
    }

    /** Begins the job. @param blocks of seats, one after the other @param from savepoint to go on with */
    private static JobClient begin(FleetOrder order, Path parts, int blocks, int parallelism, int pause, Optional<Path> from)
            throws Exception {
        return begin(order, parts, blocks, parallelism, pause, from, told -> FleetJob.write(told, parts));
    }

    /** @param sinks where rows go */
    private static JobClient begin(FleetOrder order, Path parts, int blocks, int parallelism, int pause, Optional<Path> from,
            Consumer<FleetJob.Told> sinks) throws Exception {
        Configuration settings = FleetJob.settings(parts, 300);
        from.ifPresent(savepoint -> settings.set(StateRecoveryOptions.SAVEPOINT_PATH, savepoint.toUri().toString()));
        settings.set(StateRecoveryOptions.SAVEPOINT_IGNORE_UNCLAIMED_STATE, true);
        StreamExecutionEnvironment environment = StreamExecutionEnvironment.createLocalEnvironment(parallelism, settings);
        DataStream<Tuple2<Long, byte[]>> packets = environment.fromSource(new ReplaySource(order.bytes(), blocks),
                WatermarkStrategy.noWatermarks(), "replay", Types.TUPLE(Types.LONG, Types.PRIMITIVE_ARRAY(Types.BYTE))).uid("replay");
        sinks.accept(FleetJob.follow(Slow.down(packets, pause), Optional.empty(), order));
        return environment.executeAsync();
    }

    private static int rows(Path parts) {
        try {
            return Gathered.rows(parts.resolve("results")).size();
        } catch (IOException | UncheckedIOException movedJustNow) {
            return 0;
        }
    }

    /** Stops the job when it has told more than so many rows. @return the savepoint */
    private static Path stop(JobClient job, Path parts, int rows, Path savepoints) throws Exception {
        while (rows(parts) <= rows) {
            assertFalse(job.getJobStatus().get().isGloballyTerminalState(), "the job was over before it could be stopped");
            Thread.sleep(20);
        }
        return savepoint(job, savepoints);
    }

    private static Path savepoint(JobClient job, Path folder) throws Exception {
        return Path.of(URI.create(job.stopWithSavepoint(false, folder.toUri().toString(), SavepointFormatType.CANONICAL)
                .get(60, TimeUnit.SECONDS)));
    }

    @Test
    void oneTaskThenFourThenTwoWriteTheSameBytes() throws Exception {
        FleetOrder order = order(16, 20);
        Path parts = temporary.resolve("parts");
        Path savepoints = temporary.resolve("savepoints");
        Path first = stop(begin(order, parts, 4, 1, 5, Optional.empty()), parts, 0, savepoints);
        int one = rows(parts);
        Path second = stop(begin(order, parts, 4, 4, 20, Optional.of(first)), parts, one, savepoints);
        int four = rows(parts);
        begin(order, parts, 4, 2, 0, Optional.of(second)).getJobExecutionResult().get(120, TimeUnit.SECONDS);
        assertTrue(one > 0 && four > one && rows(parts) > four, one + ", " + four + ", " + rows(parts));
        embedded(order, temporary.resolve("embedded"));
        Path out = Files.createDirectories(temporary.resolve("out"));
        FlinkEngine.gather(order, parts, out, line -> {});
        for (String name : List.of("results.csv", "alarms.csv", "machines.csv", "worst.csv")) {
            assertEquals(-1, Files.mismatch(temporary.resolve("embedded").resolve(name), out.resolve(name)), name);
        }
    }

    /**
     * What was kept when this form was made is gone on with: each seat tells what it had not told, with all counts what they would have
     * been, and numbers as good as the same, since their arithmetic may have become another.
     */
    // The weighting of form 1 ended at 27 Hz, that which goes on with it does not: 2.3e-3 of an r.m.s., twice that of a time. Of forms 1
    // and 2 deviations are found anew, and the input between samples was read in another way.
    @ParameterizedTest
    @CsvSource({"v4, 1e-3, false", "v2, 5e-3, true", "v1, 5e-3, true"})
    void theGoldenSavepointIsGoneOnWith(String form, double tolerance, boolean anew) throws Exception {
        Path kept = GOLDEN.resolveSibling("savepoint-" + form);
        FleetOrder order = golden();
        Path parts = temporary.resolve("parts");
        begin(order, parts, 4, 2, 0, Optional.of(kept.toAbsolutePath())).getJobExecutionResult().get(120, TimeUnit.SECONDS);
        List<String> header = List.of(new ResultRows(order.follow().plan()).header().strip().split(","));
        Map<String, List<String>> told = new TreeMap<>();
        Gathered.rows(parts.resolve("results")).forEach(row -> told.computeIfAbsent(row.seat(), name -> new ArrayList<>()).add(row.row()));
        Map<String, List<String>> whole = new TreeMap<>();
        embedded(order, temporary.resolve("embedded")).stream().skip(1)
                .forEach(row -> whole.computeIfAbsent(row.substring(0, row.indexOf(',')), name -> new ArrayList<>()).add(row));
        assertEquals(whole.keySet(), told.keySet());
        boolean within = false;
        for (String seat : whole.keySet()) {
            List<String> rest = told.get(seat);
            List<String> all = whole.get(seat);
            assertTrue(rest.size() <= all.size());
            within |= rest.size() < all.size();
            for (int k = 0; k < rest.size(); k++) {
                String[] row = rest.get(k).split(",", -1);
                String[] expected = all.get(all.size() - rest.size() + k).split(",", -1);
                for (int c = 0; c < expected.length; c++) {
                    boolean exact = c < 2 || c >= header.indexOf("packets") || expected[c].isEmpty() || row[c].isEmpty();
                    if (exact) {
                        assertEquals(expected[c], row[c], seat + " " + header.get(c));
                    } else if (anew && header.get(c).contains("deviation")) {
                        assertTrue(Double.parseDouble(row[c]) > 0, seat + " " + header.get(c));
                    } else {
                        double value = Double.parseDouble(expected[c]);
                        assertEquals(value, Double.parseDouble(row[c]), tolerance * Math.abs(value) + 1e-6, seat + " " + header.get(c));
                    }
                }
            }
        }
        assertTrue(within, "some seat was on its way when it was kept");
    }

    private static FleetOrder golden() {
        return order(4, 20);
    }

    /**
     * Makes the golden savepoint of the form as it is now. Never again under the same name. What is told goes nowhere: files have places.
     */
    public static void main(String[] words) throws Exception {
        Path parts = Files.createTempDirectory("golden");
        JobClient job = begin(golden(), parts, 1, 1, 20, Optional.empty(), told -> {
            told.results().sinkTo(new DiscardingSink<>()).uid("nowhere");
            told.machines().sinkTo(new DiscardingSink<>()).uid("nowhere either");
        });
        while (Slow.PASSED.get() < 90) {
            Thread.sleep(5);
        }
        Path made = savepoint(job, parts.resolve("savepoints"));
        Files.createDirectories(GOLDEN);
        try (var files = Files.list(made)) {
            for (Path file : files.toList()) {
                Files.copy(file, GOLDEN.resolve(file.getFileName().toString()));
            }
        }
        System.exit(0);
    }
}
