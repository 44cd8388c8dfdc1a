package wbv.fleet.flink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import wbv.filter.Method;
import wbv.fleet.FleetOrder;
import wbv.fleet.FleetRun;
import wbv.fleet.FleetSource;
import wbv.fleet.Replay;
import wbv.fleet.ResultRows;
import wbv.fleet.SeatOrder;
import wbv.recording.Recording;
import wbv.rig.RigSpec;
import wbv.seat.Packet;

/** Packets from a topic, results to topics, processes killed: what is committed is what one process writes, once. */
class KafkaTest {

    private static final int SEATS = 150;

    @TempDir
    private Path temporary;

    private final List<String> bad = new ArrayList<>();

    /** Packets of a bad network, one in fifty damaged besides, keyed by seat. */
    private void send(Broker broker, Replay replay) {
        Random random = new Random(3);
        try (KafkaProducer<byte[], byte[]> producer = broker.producer()) {
            for (int round = 0; round < replay.rounds(); round++) {
                for (int k = 0; k < SEATS; k++) {
                    replay.packets(k, round, packet -> {
                        send(producer, packet.seat(), packet.bytes());
                        if (random.nextInt(50) == 0) {
                            byte[] damaged = packet.bytes();
                            damaged[random.nextInt(damaged.length)] ^= 1;
                            send(producer, packet.seat(), damaged);
                            bad.add(Base64.getEncoder().encodeToString(damaged));
                        }
                    });
                }
            }
            byte[] foreign = new Packet("seat-00001", 3, 1, 100, 1, new double[] {1}).bytes();
            send(producer, "seat-00001", foreign);
            bad.add(Base64.getEncoder().encodeToString(foreign));
        }
    }

    private static void send(KafkaProducer<byte[], byte[]> producer, String key, byte[] value) {
        producer.send(new ProducerRecord<>("packets", key.getBytes(StandardCharsets.UTF_8), value));
    }

    @Test
    @Timeout(480)
    void killedProcessesNeitherLoseNorDoubleWhatIsCommitted() throws IOException, InterruptedException, ExecutionException {
        Recording recording = RigSpec.oneDof(0.35, 5, 1, 120, 1).recording();
        SeatOrder follow = new SeatOrder(60, recording.channels(), Method.EKF_ADWIN, false, Optional.empty(), 60);
        Replay replay = new Replay(List.of(recording), recording.channels(), SEATS, 30, true, 7);
        Path folder = Files.createDirectories(temporary.resolve("broker"));
        List<String> told = new ArrayList<>();
        int[] kills = new int[1];
        long[] before = new long[1];
        try (Broker broker = new Broker(folder)) {
            send(broker, replay);
            FleetOrder order = new FleetOrder(follow, new FleetSource.Topic(broker.address(), "packets", "fleet", true), 50);
            new FlinkEngine().local(order, 2, 1, temporary.resolve("cluster"), told::add, cluster -> {
                long now = committed(broker);
                if (kills[0] < 2 && now > before[0]) {
                    before[0] = now;
                    (kills[0]++ == 0 ? cluster.workers().get(0) : cluster.jobManagerProcess()).destroyForcibly();
                }
            });
            assertEquals(2, kills[0], "the job was over before a checkpoint was");
            assertTrue(told.stream().anyMatch(line -> line.contains("a worker died")), told.toString());
            assertTrue(told.stream().anyMatch(line -> line.contains("the JobManager died")), told.toString());

            FleetOrder embedded = new FleetOrder(follow, new FleetSource.Packets(List.of(temporary.resolve("all.packets"))), 50);
            replay.write(temporary.resolve("all.packets"));
            Path out = temporary.resolve("embedded");
            new FleetRun(embedded, follow.plan(), out, 2, 1e9).run(share -> {});
            assertEquals(bySeat(Files.readAllLines(out.resolve("results.csv"))), bySeat(rows(broker.read("fleet.results"))));
            assertEquals(bySeat(Files.readAllLines(out.resolve("alarms.csv"))), bySeat(rows(broker.read("fleet.alarms"))));
            assertEquals(bad.stream().sorted().toList(), rows(broker.read("fleet.unread")).stream().skip(1)
                    .map(row -> row.substring(row.lastIndexOf(',') + 1)).sorted().toList());
            for (String table : List.of("machines", "worst")) {
                Map<String, String> last = new LinkedHashMap<>();
                rows(broker.read("fleet." + table)).stream().skip(1)
                        .forEach(row -> last.put(String.join(",", List.of(row.split(",")).subList(0, 3)), row));
                List<String> tables = Files.readAllLines(out.resolve(table + ".csv"));
                assertEquals(tables.subList(1, tables.size()).stream().sorted().toList(), last.values().stream().sorted().toList());
            }
        }
    }

    private static long committed(Broker broker) {
        try {
            return broker.committed("fleet.results");
        } catch (InterruptedException | ExecutionException failed) {
            throw new IllegalStateException(failed);
        }
    }

    /** With a line in front, as a file has its header. */
    private static List<String> rows(List<ConsumerRecord<byte[], byte[]>> records) {
        List<String> rows = new ArrayList<>(List.of(""));
        records.forEach(record -> rows.add(new String(record.value(), StandardCharsets.UTF_8)));
        return rows;
    }

    private static Map<String, List<String>> bySeat(List<String> rows) {
        Map<String, List<String>> seats = new TreeMap<>();
        rows.stream().skip(1).forEach(row -> seats.computeIfAbsent(row.substring(0, ResultRows.firstField(row)), name -> new ArrayList<>())
                .add(row));
        return seats;
    }
}
