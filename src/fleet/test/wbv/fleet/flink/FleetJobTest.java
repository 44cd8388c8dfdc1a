package wbv.fleet.flink;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.apache.flink.api.common.eventtime.Watermark;
import org.apache.flink.api.common.eventtime.WatermarkGenerator;
import org.apache.flink.api.common.eventtime.WatermarkOutput;
import org.apache.flink.api.common.eventtime.WatermarkStrategy;
import org.apache.flink.api.common.typeinfo.Types;
import org.apache.flink.api.java.tuple.Tuple2;
import org.apache.flink.api.java.tuple.Tuple3;
import org.apache.flink.core.execution.JobClient;
import org.apache.flink.streaming.api.TimerService;
import org.apache.flink.streaming.api.datastream.DataStream;
import org.apache.flink.streaming.api.environment.StreamExecutionEnvironment;
import org.junit.jupiter.api.Test;
import wbv.filter.Method;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetRun;
import wbv.fleet.FleetSource;
import wbv.fleet.Replay;
import wbv.fleet.ResultRows;
import wbv.fleet.SeatOrder;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.ReadOptions;
import wbv.recording.format.RecordingFile;
import wbv.rig.RigSpec;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;
import wbv.state.StateModel;
import wbv.state.StateModelFile;

/** The job in this process. */
class FleetJobTest {

    /** Below target and left there: jobs in this process clean up behind themselves when they have ended. */
    private final Path temporary;

    FleetJobTest() throws IOException {
        temporary = Files.createTempDirectory(Files.createDirectories(Path.of("target", "jobs")).toAbsolutePath(), "job");
    }

    /** Among the packets of a fleet come as many damaged ones: those are put aside whole, and nothing else is different. */
    @Test
    void packetsThatCannotBeReadAreKeptBesideAndChangeNothing() throws Exception {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, 20, 1).recording();
        SeatOrder follow = new SeatOrder(60, recording.channels(), Method.EKF, false, Optional.empty(), 60);
        FleetOrder order = new FleetOrder(List.of(recording), follow, 4, 30, Optional.of(3L));
        Replay replay = order.replay();
        Random random = new Random(8);
        List<Tuple2<Long, byte[]>> sent = new ArrayList<>();
        List<String> damaged = new ArrayList<>();
        for (int round = 0; round < replay.rounds(); round++) {
            for (int seat = 0; seat < replay.seats(); seat++) {
                List<Packet> packets = new ArrayList<>();
                replay.packets(seat, round, packets::add);
                for (int k = 0; k < packets.size(); k++) {
                    byte[] bytes = packets.get(k).bytes();
                    sent.add(Tuple2.of(Rows.place(round, k), bytes));
                    byte[] bad = random.nextBoolean() ? Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes.clone();
                    if (bad.length == bytes.length) {
                        bad[random.nextInt(bad.length)] ^= (byte) (1 + random.nextInt(255));
                    }
                    sent.add(Tuple2.of(Rows.place(round, k), bad));
                    damaged.add(Base64.getEncoder().encodeToString(bad));
                }
            }
        }
        byte[] foreign = new Packet("seat-00001", 3, 1, 100, 1, new double[] {1}).bytes();
        sent.add(Tuple2.of(Rows.place(replay.rounds(), 0), foreign));
        damaged.add(Base64.getEncoder().encodeToString(foreign));
        Path parts = temporary.resolve("parts");
        try (StreamExecutionEnvironment environment = StreamExecutionEnvironment.createLocalEnvironment(2, FleetJob.settings(parts, 500))) {
            FleetJob.write(FleetJob.follow(environment.fromData(sent,
                    Types.TUPLE(Types.LONG, Types.PRIMITIVE_ARRAY(Types.BYTE))).setParallelism(1).uid("packets"), Optional.empty(), order),
                    parts);
            environment.execute();
        }
        List<Rows.Placed> unread = Gathered.rows(parts.resolve("unread"));
        assertEquals(damaged.stream().sorted().toList(),
                unread.stream().map(each -> each.row().substring(each.row().lastIndexOf(',') + 1)).sorted().toList());
        assertTrue(unread.stream().allMatch(each -> each.row().startsWith("\"")), "with the reason");
        Path embedded = temporary.resolve("embedded");
        new FleetRun(replay, follow.plan(), embedded, 1, 1e9).run(share -> {});
        Gathered.write(parts.resolve("results"), new ResultRows(follow.plan()).header(), temporary.resolve("results.csv"));
        assertArrayEquals(Files.readAllBytes(embedded.resolve("results.csv")), Files.readAllBytes(temporary.resolve("results.csv")));
    }

    private static FleetOrder filed(Recording recording, List<Path> files, double period) {
        SeatOrder follow = new SeatOrder(60, recording.channels(), Method.EKF, false, Optional.empty(), 60);
        return new FleetOrder(follow, new FleetSource.Packets(files), period);
    }

    private void job(FleetOrder order, Path parts, int parallelism) throws Exception {
        try (StreamExecutionEnvironment environment = StreamExecutionEnvironment.createLocalEnvironment(parallelism,
                FleetJob.settings(parts, 500))) {
            FleetJob.build(environment, order.bytes(), parts, parallelism);
            environment.execute();
        }
    }

    private void assertSame(FleetOrder order, Path parts) throws Exception {
        Path embedded = temporary.resolve("embedded-" + parts.getFileName());
        new FleetRun(order, order.follow().plan(), embedded, 1, 1e9).run(share -> {});
        Path out = Files.createDirectories(temporary.resolve("out-" + parts.getFileName()));
        FlinkEngine.gather(order, parts, out, line -> {});
        try (Stream<Path> files = Files.list(embedded)) {
            for (Path file : files.toList()) {
                assertEquals(-1, Files.mismatch(file, out.resolve(file.getFileName())), file.toString());
            }
        }
    }

    /** Packets of a bad network in two files, damaged ones between: all files are those of one process, whatever the parallelism. */
    @Test
    void packetsFromFilesGiveTheBytesOfOneProcess() throws Exception {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, 20, 1).recording();
        List<Path> files = List.of(temporary.resolve("1.packets"), temporary.resolve("2.packets"));
        new Replay(List.of(recording), recording.channels(), 9, 6, true, 4).write(files.get(0));
        byte[] bytes = Files.readAllBytes(files.get(0));
        Random random = new Random(5);
        for (int k = 0; k < 40; k++) {
            bytes[random.nextInt(bytes.length)] ^= 5;
        }
        Files.write(files.get(0), Arrays.copyOf(bytes, bytes.length / 3));
        Files.write(files.get(1), Arrays.copyOfRange(bytes, bytes.length / 3, bytes.length));
        FleetOrder order = filed(recording, files, 6);
        for (int parallelism : new int[] {1, 3}) {
            Path parts = temporary.resolve("files-" + parallelism);
            job(order, parts, parallelism);
            assertSame(order, parts);
            assertTrue(Gathered.rows(parts.resolve("unread")).size() >= 35, "damaged packets are put aside");
        }
    }

    /**
     * A model of states that comes while the job runs holds from its time on, a job that fails midway included; bodies and exposure go
     * on. One that does not go with the packets is put aside.
     */
    @Test
    void anotherModelOfStatesHoldsFromItsTimeOn() throws Exception {
        StateModel first = StateModelFile.shipped();
        StateModel second = new StateModel(first.features(), first.thresholds(), first.mixture(), first.chain(), first.activities(),
                first.names(), first.shares(), 5 * first.error(), List.of("another"), first.rows());
        Recording recording = new RecordingFile(Path.of("data/arff/ride-subject1.arff"), ReadOptions.DEFAULT).load();
        List<Channel> channels = SeatPlan.usual(60, recording.channels(), Method.EKF, false, Optional.of(first)).needed();
        SeatOrder follow = new SeatOrder(60, channels, Method.EKF, false, Optional.of(first), 60);
        FleetOrder order = new FleetOrder(List.of(recording), follow, 3, 60, Optional.of(2L));
        double from = 60;
        Replay replay = order.replay();
        List<Tuple2<Long, byte[]>> sent = new ArrayList<>();
        List<String> expected = new ArrayList<>();
        List<String> without = new ArrayList<>();
        SeatPlan plan = follow.plan();
        SeatPlan other = new SeatOrder(60, channels, Method.EKF, false, Optional.of(second), 60).plan();
        for (int k = 0; k < 3; k++) {
            Seat plain = new Seat(replay.name(k), plan);
            Seat[] seat = {new Seat(replay.name(k), plan)};
            boolean[] changed = new boolean[1];
            for (int round = 0; round < replay.rounds(); round++) {
                List<Packet> packets = new ArrayList<>();
                replay.packets(k, round, packets::add);
                for (int p = 0; p < packets.size(); p++) {
                    Packet packet = packets.get(p);
                    sent.add(Tuple2.of(Rows.place(round, p), packet.bytes()));
                    plain.accept(packet, result -> without.add(row(plan, result)));
                    if (!changed[0] && packet.time() >= from) {
                        seat[0] = seat[0].under(other);
                        changed[0] = true;
                    }
                    seat[0].accept(packet, result -> expected.add(row(plan, result)));
                }
            }
            seat[0].flush(result -> expected.add(row(plan, result)));
            plain.flush(result -> without.add(row(plan, result)));
        }
        int state = List.of(new ResultRows(plan).header().split(",")).indexOf("state");
        assertNotEquals(without, expected, "the models differ");
        assertEquals(without.stream().map(row -> bodies(row, state)).toList(), expected.stream().map(row -> bodies(row, state)).toList());
        Path parts = temporary.resolve("models");
        Slow.FAIL.set(false);
        try (StreamExecutionEnvironment environment = StreamExecutionEnvironment.createLocalEnvironment(2, FleetJob.settings(parts, 200))) {
            DataStream<
                    Tuple2<Long, byte[]>> packets = environment.fromData(sent, Types.TUPLE(Types.LONG, Types.PRIMITIVE_ARRAY(Types.BYTE)))
                            .setParallelism(1).uid("packets");
            DataStream<Tuple3<Long, Double, String>> models = environment.fromData(List.of(
                    Tuple3.of(0L, from, StateModelFile.text(second, Map.of())), Tuple3.of(1L, 0.0, "no model")),
                    Types.TUPLE(Types.LONG, Types.DOUBLE, Types.STRING)).setParallelism(1).uid("models");
            FleetJob.write(FleetJob.follow(Slow.down(packets, 20), Optional.of(models), order), parts);
            JobClient job = environment.executeAsync();
            while (Gathered.rows(parts.resolve("results")).stream()
                    .noneMatch(row -> Double.parseDouble(row.row().split(",")[1]) > from + 10)) {
                Thread.sleep(50);
            }
            Slow.FAIL.set(true);
            job.getJobExecutionResult().get();
        }
        assertFalse(Slow.FAIL.get(), "the job failed midway");
        assertEquals(expected.stream().sorted().toList(),
                Gathered.rows(parts.resolve("results")).stream().map(row -> row.row()).sorted().toList());
        assertEquals(1, Gathered.rows(parts.resolve("unread")).size());
    }

    private static String row(SeatPlan plan, SeatResult result) {
        StringBuilder text = new StringBuilder();
        new ResultRows(plan).write(result, text);
        return text.toString().strip();
    }

    private static List<String> bodies(String row, int state) {
        return List.of(row.split(",")).subList(0, state);
    }

    /** A period is told when the clock has passed it, again when a seat that was behind tells of it, and no more when it is long past. */
    @Test
    void tablesAreToldAgainForWhoeverIsBehind() throws Exception {
        String header = "seat,t_s,a8_m_per_s2,vdv_m_per_s1.75,minutes_to_action,minutes_to_limit,lost_samples\n";
        List<Tuple3<Long, Long, String>> sent = List.of(told("a", 1, 0.3), told("a", 8, 0.4), told("b", 21, 0.2), told("c", 5, 0.5),
                told("b", 75, 0.3), told("a", 900, 0.6), told("d", 3, 0.9), told("a", 905, 0.7));
        List<String> tables = new ArrayList<>();
        Path folder = temporary.resolve("tables");
        try (StreamExecutionEnvironment environment = StreamExecutionEnvironment.createLocalEnvironment(1,
                FleetJob.settings(folder, 60_000))) {
            var machines = environment.fromData(sent, Types.TUPLE(Types.LONG, Types.LONG, Types.STRING)).uid("told")
                    .assignTimestampsAndWatermarks(WatermarkStrategy.<Tuple3<Long, Long, String>>forGenerator(context -> new AtEach())
                            .withTimestampAssigner((each, before) -> each.f1))
                    .uid("clock")
                    .keyBy(each -> each.f0, Types.LONG).process(new TablesOfPeriods(header, 10, 60, 200_000), Types.STRING).uid("tables");
            try (var rows = machines.executeAndCollect()) {
                rows.forEachRemaining(tables::add);
            }
        }
        assertEquals(List.of("0,0,0,0.0,10.0,a,1,0.4,1,2,a,0.0", "2,0,0,20.0,30.0,b,1,0.2,1,2,b,0.0",
                "0,1,0,0.0,10.0,c,1,0.5,1,2,c,0.0", "0,1,1,0.0,10.0,a,1,0.4,1,2,a,0.0", "7,0,0,70.0,80.0,b,1,0.3,1,2,b,0.0",
                "90,0,0,900.0,910.0,a,1,0.7,1,2,a,0.0").stream().sorted().toList(), tables.stream().sorted().toList());
    }

    private static Tuple3<Long, Long, String> told(String seat, int second, double a8) {
        return Tuple3.of(second / 10L, 1000L * second, seat + "," + second + "," + a8 + ",0,1,2,0");
    }

    /** The clock is at whatever came last. */
    private static final class AtEach implements WatermarkGenerator<Tuple3<Long, Long, String>> {

        @Override
        public void onEvent(Tuple3<Long, Long, String> event, long time, WatermarkOutput out) {
            out.emitWatermark(new Watermark(time));
        }

        @Override
        public void onPeriodicEmit(WatermarkOutput out) {}
    }

    /** A timer of the wall's clock would make a replay another run; and Flink is a door, not a room. */
    @Test
    void flinkStaysWhereItBelongsAndKnowsNoClockOnTheWall() {
        JavaClasses main = new ClassFileImporter().withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS).importPackages("wbv");
        noClasses().that().resideOutsideOfPackage("wbv.fleet.flink..")
                .should().dependOnClassesThat().resideInAnyPackage("org.apache.flink..", "org.apache.kafka..", "wbv.fleet.flink..")
                .check(main);
        noClasses().should().callMethod(TimerService.class, "registerProcessingTimeTimer", long.class).check(main);
        noClasses().that().resideInAPackage("wbv.fleet.flink..").should().dependOnClassesThat().resideInAnyPackage("wbv.cli..",
                "wbv.learn..", "wbv.stream..", "wbv.report..", "wbv.proof..", "moa..").check(main);
    }
}
