package wbv.fleet;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
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
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.filter.Method;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.rig.RigSpec;
import wbv.seat.Packet;
import wbv.seat.Seat;
import wbv.seat.SeatPlan;
import wbv.seat.SeatResult;

class FleetTest {

    private static final int SEATS = 12;
    private static final String RECORDING = "data/arff/one-dof-linear.arff";

    @TempDir
    private Path temporary;

    private static Recording recording(int seconds) {
        return RigSpec.oneDof(0.35, 5, 1, seconds, 1).recording();
    }

    private static SeatPlan plan(Recording recording) {
        return SeatPlan.usual(60, recording.channels(), Method.EKF_ADWIN, false, Optional.empty());
    }

    private static Replay replay(Recording recording, boolean disturbed) {
        return new Replay(List.of(recording), recording.channels(), SEATS, 6, disturbed, 4);
    }

    private FleetRun.Outcome run(String folder, Replay replay, SeatPlan plan, int threads) throws IOException {
        return new FleetRun(replay, plan, temporary.resolve(folder), threads, 1e9).run(share -> {});
    }

    private byte[] results(String folder) throws IOException {
        return Files.readAllBytes(temporary.resolve(folder).resolve("results.csv"));
    }

    @Test
    void resultsAreThoseOfSeatsByThemselvesInAnyNumberOfThreads() throws IOException {
        Recording recording = recording(40);
        SeatPlan plan = plan(recording);
        for (boolean disturbed : new boolean[] {false, true}) {
            Replay replay = replay(recording, disturbed);
            run("one" + disturbed, replay, plan, 1);
            FleetRun.Outcome outcome = run("three" + disturbed, replay, plan, 3);
            assertArrayEquals(results("one" + disturbed), results("three" + disturbed));
            assertEquals(SEATS, outcome.seats().size());
            for (int k = 0; k < SEATS; k++) {
                Seat alone = new Seat(replay.name(k), plan);
                for (int round = 0; round < replay.rounds(); round++) {
                    replay.packets(k, round, packet -> alone.accept(packet, each -> {}));
                }
                alone.flush(each -> {});
                assertEquals(alone.now(), outcome.seats().get(k));
            }
            assertEquals(1 + 40L * SEATS, Files.lines(temporary.resolve("one" + disturbed).resolve("results.csv")).count(), 2.0 * SEATS);
            assertFalse(Files.exists(temporary.resolve("one" + disturbed).resolve("fleet.state")));
        }
    }

    /** What a bad network did to a seat is what it lost and nothing else: the same packets in order say the same. */
    @Test
    void disturbedPacketsAreThoseThatWereNotLost() {
        Recording recording = recording(60);
        SeatPlan plan = plan(recording);
        Replay disturbed = replay(recording, true);
        Replay undisturbed = replay(recording, false);
        long lost = 0;
        long twice = 0;
        for (int k = 0; k < SEATS; k++) {
            Seat seat = new Seat(disturbed.name(k), plan);
            List<Packet> came = new ArrayList<>();
            for (int round = 0; round < disturbed.rounds(); round++) {
                disturbed.packets(k, round, packet -> {
                    came.add(packet);
                    seat.accept(packet, each -> {});
                });
            }
            seat.flush(each -> {});
            Seat inOrder = new Seat(disturbed.name(k), plan);
            for (int round = 0; round < undisturbed.rounds(); round++) {
                undisturbed.packets(k, round, packet -> {
                    if (came.contains(packet)) {
                        inOrder.accept(packet, each -> {});
                    }
                });
            }
            inOrder.flush(each -> {});
            assertEquals(inOrder.now().bodies(), seat.now().bodies());
            assertEquals(inOrder.now().exposure(), seat.now().exposure());
            SeatResult.Losses losses = seat.losses();
            assertEquals(inOrder.losses().lost(), losses.lost());
            assertEquals(inOrder.losses().samples(), losses.samples());
            assertEquals(came.size(), losses.packets() + losses.twice());
            assertEquals(0, losses.late() + losses.restarts());
            lost += losses.lost();
            twice += losses.twice();
        }
        assertEquals(0.01 * SEATS * 600, lost, 5 * Math.sqrt(0.01 * SEATS * 600));
        assertEquals(0.01 * SEATS * 600, twice, 5 * Math.sqrt(0.01 * SEATS * 600));
    }

    private static SeatOrder follow(Recording recording) {
        return new SeatOrder(60, recording.channels(), Method.EKF_ADWIN, false, Optional.empty(), 60);
    }

    private FleetRun.Outcome filed(String folder, Recording recording, List<Path> files, int threads) throws IOException {
        FleetOrder order = new FleetOrder(follow(recording), new FleetSource.Packets(files), 10);
        return new FleetRun(order, plan(recording), temporary.resolve(folder), threads, 1e9).run(share -> {});
    }

    /** Packets of a bad network, in files, cut anywhere between two: what is known of the seats is what the replay itself gives. */
    @Test
    void packetsFromFilesAreThoseOfTheReplay() throws IOException {
        Recording recording = recording(40);
        Replay replay = replay(recording, true);
        FleetRun.Outcome replayed = run("replayed", replay, plan(recording), 1);
        Path all = temporary.resolve("all.packets");
        long count = replay.write(all);
        byte[] bytes = Files.readAllBytes(all);
        int half = 0;
        for (long k = 0; k < count / 2; k++) {
            half += Packet.frame(bytes, half, bytes.length);
        }
        List<Path> halves = List.of(temporary.resolve("1.packets"), temporary.resolve("2.packets"));
        Files.write(halves.get(0), Arrays.copyOf(bytes, half));
        Files.write(halves.get(1), Arrays.copyOfRange(bytes, half, bytes.length));
        for (int threads : new int[] {1, 3}) {
            FleetRun.Outcome outcome = filed("filed" + threads, recording, halves, threads);
            assertEquals(replayed.seats(), outcome.seats());
            assertArrayEquals(results("replayed"), results("filed" + threads));
            assertEquals(replayed.samples(), outcome.samples());
            assertFalse(outcome.unread());
            SeatResult.Losses losses = outcome.seats().get(0).losses();
            assertTrue(outcome.seats().stream().mapToLong(seat -> seat.losses().lost()).sum() > 0);
            assertTrue(outcome.seats().stream().mapToLong(seat -> seat.losses().twice()).sum() > 0);
            assertEquals(0, losses.late());
        }
    }

    /** Between whole packets lies anything: it is put aside byte for byte, and changes nothing. */
    @Test
    void whatIsNoPacketIsPutAside() throws IOException {
        Recording recording = recording(20);
        Replay replay = replay(recording, true);
        run("whole", replay, plan(recording), 1);
        Path all = temporary.resolve("all.packets");
        replay.write(all);
        byte[] bytes = Files.readAllBytes(all);
        Random random = new Random(3);
        ByteArrayOutputStream damaged = new ByteArrayOutputStream();
        ByteArrayOutputStream aside = new ByteArrayOutputStream();
        for (int at = 0; at < bytes.length;) {
            byte[] packet = Arrays.copyOfRange(bytes, at, at + Packet.frame(bytes, at, bytes.length));
            at += packet.length;
            damaged.write(packet);
            byte[] bad = new byte[0];
            if (random.nextInt(3) == 0) {
                bad = packet.clone();
                bad[random.nextInt(bad.length)] ^= (byte) (1 + random.nextInt(255));
            } else if (random.nextInt(3) == 0) {
                bad = Arrays.copyOf(packet, 1 + random.nextInt(packet.length - 1));
            } else if (random.nextInt(20) == 0) {
                bad = new byte[random.nextInt(200_000)];
                random.nextBytes(bad);
            }
            damaged.write(bad);
            aside.write(bad);
        }
        Path file = Files.write(temporary.resolve("damaged.packets"), damaged.toByteArray());
        assertTrue(filed("damaged", recording, List.of(file), 2).unread());
        assertArrayEquals(results("whole"), results("damaged"));
        ByteArrayOutputStream found = new ByteArrayOutputStream();
        List<String> rows = Files.readAllLines(temporary.resolve("damaged").resolve("unread.csv"));
        for (String row : rows.subList(1, rows.size())) {
            assertTrue(row.startsWith("\"is "), row.substring(0, 20));
            found.write(Base64.getDecoder().decode(row.substring(row.lastIndexOf(',') + 1)));
        }
        assertArrayEquals(aside.toByteArray(), found.toByteArray());
    }

    /** The tables against a plain count of what the seats told. */
    @Test
    void tablesSayWhatSeatsToldLastInEachPeriod() throws IOException {
        Recording recording = recording(35);
        double rate = 60;
        List<Packet> packets = new ArrayList<>();
        Replay replay = new Replay(List.of(recording), recording.channels(), 6, 30, true, 4);
        for (int round = 0; round < replay.rounds(); round++) {
            for (int k = 0; k < 6; k++) {
                String name = (k < 4 ? "truck, " + k / 2 + "/" : "") + "seat \"" + k + "\"";
                replay.packets(k, round, packet -> packets.add(new Packet(name, packet.counter(), packet.time(), rate, 2,
                        Arrays.stream(packet.values()).map(value -> value * (1 + name.hashCode() % 7)).toArray())));
            }
        }
        Path file = temporary.resolve("trucks.packets");
        try (var out = Files.newOutputStream(file)) {
            for (Packet packet : packets) {
                out.write(packet.bytes());
            }
        }
        FleetRun.Outcome outcome = filed("trucks", recording, List.of(file), 1);
        Map<String, Map<Integer, SeatResult>> last = new TreeMap<>();
        Map<String, Seat> seats = new TreeMap<>();
        for (Packet packet : packets) {
            seats.computeIfAbsent(packet.seat(), name -> new Seat(name, plan(recording))).accept(packet,
                    result -> last.computeIfAbsent(result.seat(), name -> new TreeMap<>()).put((int) (result.time() / 10), result));
        }
        seats.values().forEach(seat -> seat.flush(result -> last.get(result.seat()).put((int) (result.time() / 10), result)));
        List<String> machines = Files.readAllLines(temporary.resolve("trucks").resolve("machines.csv"));
        assertEquals(1 + 4 * 4, machines.size(), "four machines in four periods");
        for (int period = 0; period < 4; period++) {
            double before = Double.POSITIVE_INFINITY;
            for (String row : machines.subList(1 + 4 * period, 5 + 4 * period)) {
                assertTrue(row.startsWith(10.0 * period + "," + 10.0 * (period + 1) + ","), row);
                String machine = row.replaceAll("^[^,]*,[^,]*,(\"(?:[^\"]|\"\")*\"),.*", "$1");
                String name = machine.substring(1, machine.length() - 1).replace("\"\"", "\"");
                List<SeatResult> its = new ArrayList<>();
                for (String seat : last.keySet()) {
                    if (seat.equals(name) || seat.startsWith(name + "/")) {
                        its.add(last.get(seat).get(period));
                    }
                }
                String[] fields = row.substring(row.indexOf(machine) + machine.length() + 1).split(",");
                assertEquals(its.size(), Integer.parseInt(fields[0]));
                double worst = its.stream().mapToDouble(seat -> seat.exposure().orElseThrow().a8()).max().orElseThrow();
                assertEquals((float) worst, Float.parseFloat(fields[1]));
                assertTrue(worst <= before, "the worst first");
                before = worst;
                double lost = its.stream().mapToDouble(seat -> seat.losses().samples() / rate / 60).sum();
                assertEquals(lost, Double.parseDouble(fields[fields.length - 1]), 1e-6 * (1 + lost));
            }
        }
        assertEquals(1 + 6 * 4, Files.readAllLines(temporary.resolve("trucks").resolve("worst.csv")).size());
        assertEquals(6, outcome.seats().size());
    }

    @Test
    void theStateOfAnotherRunIsNotGoneOnWith() throws IOException {
        Recording recording = recording(20);
        SeatPlan plan = plan(recording);
        Path folder = Files.createDirectories(temporary.resolve("other"));
        new Checkpoint("another run", new Feed.Place(5, 3, 0, 0), false, 100, 100, 100, 5).write(folder,
                List.of(new Seat("seat-00000", plan)));
        DataFault fault = assertThrows(DataFault.class, () -> run("other", replay(recording, false), plan, 1));
        assertTrue(fault.getMessage().contains("another run stopped"), fault.getMessage());
        byte[] state = Files.readAllBytes(Checkpoint.file(folder));
        Random random = new Random(1);
        for (int i = 0; i < 300; i++) {
            byte[] bad = i % 3 == 0 ? Arrays.copyOf(state, random.nextInt(state.length)) : state.clone();
            if (bad.length == state.length) {
                bad[random.nextInt(state.length)] ^= (byte) (1 + random.nextInt(255));
            }
            Files.write(Checkpoint.file(folder), bad);
            assertThrows(DataFault.class, () -> Checkpoint.read(folder, "another run", name -> new Seat(name, plan)));
        }
    }

    @Tag("slow")
    @Test
    void aKilledRunComesOutAsIfNothingHadHappened() throws IOException, InterruptedException {
        assertTrue(killed(3, 1) > 0, "killed at least once");
    }

    @Test
    @Tag("exam")
    void fiftyKillsChangeNothing() throws IOException, InterruptedException {
        int kills = 0;
        for (long seed = 10; kills < 50; seed++) {
            kills += killed(5, seed);
        }
    }

    /**
     * Kills a child so many times, each at a random moment after its state was kept anew, then lets it come to its end.
     *
     * @return how often it was killed; it may come to its end before
     */
    private int killed(int times, long seed) throws IOException, InterruptedException {
        Path undisturbed = temporary.resolve("undisturbed" + seed);
        assertEquals(0, child(undisturbed).waitFor());
        Path folder = temporary.resolve("killed" + seed);
        Path state = Checkpoint.file(folder);
        Random random = new Random(seed);
        int kills = 0;
        long kept = 0;
        while (kills < times) {
            Process child = child(folder);
            while (child.isAlive() && !(Files.exists(state) && modified(state) > kept)) {
                Thread.sleep(1);
            }
            child.waitFor((long) (random.nextDouble() * 150_000), TimeUnit.MICROSECONDS);
            boolean running = child.isAlive();
            child.destroyForcibly().waitFor();
            if (!running) {
                break; // it was faster than we are
            }
            kept = Files.exists(state) ? modified(state) : kept;
            kills++;
        }
        assertEquals(0, child(folder).waitFor());
        for (String name : List.of("results.csv", "alarms.csv", "machines.csv", "worst.csv")) {
            assertEquals(-1, Files.mismatch(undisturbed.resolve(name), folder.resolve(name)), name + " after " + kills + " kills");
        }
        try (var files = Files.list(folder)) {
            assertEquals(4, files.count(), "nothing else is left");
        }
        return kills;
    }

    private static long modified(Path file) {
        try {
            return Files.getLastModifiedTime(file).to(TimeUnit.MICROSECONDS);
        } catch (IOException replacedJustNow) {
            return 0;
        }
    }

    private static Process child(Path folder) throws IOException {
        List<String> words = List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx256m", "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), "wbv.cli.Main", "fleet", RECORDING, "--seats",
                "60", "--packet", "30", "--every", "1", "--keep", "0", "--threads", "1", "--disturb", "7", "--out", folder.toString());
        return new ProcessBuilder(words).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start();
    }
}
