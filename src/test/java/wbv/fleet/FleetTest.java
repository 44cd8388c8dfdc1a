package wbv.fleet;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
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
        return new FleetRun(replay, plan, temporary.resolve(folder), threads, 1e9).run(share -> { });
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
                    replay.packets(k, round, packet -> alone.accept(packet, each -> { }));
                }
                alone.flush(each -> { });
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
                    seat.accept(packet, each -> { });
                });
            }
            seat.flush(each -> { });
            Seat inOrder = new Seat(disturbed.name(k), plan);
            for (int round = 0; round < undisturbed.rounds(); round++) {
                undisturbed.packets(k, round, packet -> {
                    if (came.contains(packet)) {
                        inOrder.accept(packet, each -> { });
                    }
                });
            }
            inOrder.flush(each -> { });
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

    @Test
    void theStateOfAnotherRunIsNotGoneOnWith() throws IOException {
        Recording recording = recording(20);
        SeatPlan plan = plan(recording);
        Path folder = Files.createDirectories(temporary.resolve("other"));
        Seat[] seats = {new Seat("seat-00000", plan)};
        new Checkpoint("another run", 3, 100, 100, 5).write(folder, seats);
        DataFault fault = assertThrows(DataFault.class, () -> run("other", replay(recording, false), plan, 1));
        assertTrue(fault.getMessage().contains("another run stopped"), fault.getMessage());
        byte[] state = Files.readAllBytes(Checkpoint.file(folder));
        Random random = new Random(1);
        for (int i = 0; i < 300; i++) {
            byte[] bad = i % 3 == 0 ? java.util.Arrays.copyOf(state, random.nextInt(state.length)) : state.clone();
            if (bad.length == state.length) {
                bad[random.nextInt(state.length)] ^= (byte) (1 + random.nextInt(255));
            }
            Files.write(Checkpoint.file(folder), bad);
            assertThrows(DataFault.class, () -> Checkpoint.read(folder, "another run", new Seat[] {new Seat("seat-00000", plan)}));
        }
    }

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
        for (String name : List.of("results.csv", "alarms.csv")) {
            assertEquals(-1, Files.mismatch(undisturbed.resolve(name), folder.resolve(name)), name + " after " + kills + " kills");
        }
        try (var files = Files.list(folder)) {
            assertEquals(2, files.count(), "nothing else is left");
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
