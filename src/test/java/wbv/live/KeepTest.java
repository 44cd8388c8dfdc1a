package wbv.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.recording.DataFault;

/** A program that ends without a word and is started again. */
class KeepTest {

    private static final String HEADER = "t,seat,platform.acc.z,head.acc.z,seat.acc.z";

    @TempDir
    private Path folder;

    private static List<String> rows(int samples) {
        List<String> rows = new ArrayList<>();
        for (int i = 0; i < samples; i++) {
            double u = Math.sin(0.45 * i) + 0.7 * Math.sin(0.21 * i * (1 + 0.0001 * i));
            for (String seat : List.of("a", "b")) {
                rows.add(String.format(Locale.ROOT, "%.6f,%s,%.6f,%.6f,%.6f", i / 60.0, seat, u, 1.3 * u + 0.2 * Math.sin(0.9 * i),
                        u * (seat.equals("a") ? 1 : 5)));
            }
        }
        return rows;
    }

    private static void send(LiveStream live, String line) {
        byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
        live.line("test", "", bytes, 0, bytes.length);
    }

    private static List<String> results(List<String> told) {
        return told.stream().filter(line -> line.startsWith("{\"type\":\"result\"")).toList();
    }

    private static List<String> undisturbed(List<String> rows) {
        List<String> told = new ArrayList<>();
        LiveStream live = new LiveStream(LiveSettings.usual(), told::add, Aside.NONE, () -> 0);
        send(live, HEADER);
        rows.forEach(row -> send(live, row));
        live.finish();
        return results(told);
    }

    /**
     * Ended at random moments, the sender repeating the last rows, as one does whose rows were not acknowledged: every result is told once,
     * the same.
     */
    @Tag("slow")
    @Test
    void nothingIsLostAndNothingCountsTwice() throws IOException {
        List<String> rows = rows(1800);
        List<String> expected = undisturbed(rows);
        for (int seed = 0; seed < 12; seed++) {
            Random random = new Random(seed);
            Path state = folder.resolve("state-of-" + seed);
            List<String> told = new ArrayList<>();
            int at = 0;
            while (at < rows.size()) {
                long[] now = {0};
                Keep keep = new Keep(state);
                LiveStream live = new LiveStream(LiveSettings.usual(), told::add, Aside.NONE, Optional.of(keep), () -> now[0]);
                live.resume();
                send(live, HEADER);
                int end = Math.min(rows.size(), at + 200 + random.nextInt(900));
                for (int i = Math.max(0, at - 200); i < end; i++) { // what waited for a packet's end or for the rate is sent again
                    now[0] += 50_000_000L;
                    send(live, rows.get(i));
                    if (i % 50 == 0) {
                        live.idle();
                    }
                }
                at = end;
                if (at == rows.size()) {
                    live.finish();
                }
                keep.close(); // no farewell: what the journal has is all that is left
                if (random.nextBoolean()) {
                    cut(state, random);
                }
            }
            assertEquals(expected.stream().sorted().toList(), results(told).stream().distinct().sorted().toList(), "seed " + seed);
            assertTrue(results(told).size() <= expected.size() + 40, "told again " + (results(told).size() - expected.size()));
            try (Stream<Path> files = Files.list(state)) {
                assertEquals(2, files.count());
            }
        }
    }

    /** The system had taken a part of the last entry when the program ended. */
    private static void cut(Path state, Random random) throws IOException {
        try (Stream<Path> files = Files.list(state)) {
            Path journal = files.filter(file -> file.getFileName().toString().startsWith("journal")).findFirst().orElseThrow();
            byte[] all = Files.readAllBytes(journal);
            Files.write(journal, java.util.Arrays.copyOf(all, Math.max(0, all.length - random.nextInt(40))));
        }
    }

    @Test
    void whatWasKeptDamagedOrWithOtherOptionsIsRefusedInOneLine() throws IOException {
        Path state = folder.resolve("state");
        try (Keep keep = new Keep(state)) {
            LiveStream live = new LiveStream(LiveSettings.usual(), line -> {}, Aside.NONE, Optional.of(keep), () -> 0);
            live.resume();
            send(live, HEADER);
            rows(300).forEach(row -> send(live, row));
            live.finish();
        }
        LiveSettings usual = LiveSettings.usual();
        LiveSettings others = new LiveSettings(usual.reading(), usual.columns(), wbv.filter.Method.EKF, usual.input(), usual.outputs(),
                usual.place(), false, usual.states(), 1, 5);
        try (Keep keep = new Keep(state)) {
            DataFault fault = assertThrows(DataFault.class,
                    () -> new LiveStream(others, line -> {}, Aside.NONE, Optional.of(keep), () -> 0).resume());
            assertTrue(fault.getMessage().contains("other options") && fault.getMessage().lines().count() == 1, fault.getMessage());
        }
        Path file;
        try (Stream<Path> files = Files.list(state)) {
            file = files.filter(each -> each.getFileName().toString().startsWith("state-")).findFirst().orElseThrow();
        }
        byte[] all = Files.readAllBytes(file);
        for (int seed = 0; seed < 200; seed++) {
            Random random = new Random(seed);
            byte[] bad = random.nextBoolean() ? all.clone() : java.util.Arrays.copyOf(all, random.nextInt(all.length));
            if (bad.length == all.length) {
                bad[random.nextInt(bad.length)] ^= (byte) (1 << random.nextInt(8));
            }
            Files.write(file, bad);
            try (Keep keep = new Keep(state)) {
                DataFault fault = assertThrows(DataFault.class,
                        () -> new LiveStream(usual, line -> {}, Aside.NONE, Optional.of(keep), () -> 0).resume());
                assertTrue(fault.getMessage().lines().count() == 1, fault.getMessage());
            }
        }
    }
}
