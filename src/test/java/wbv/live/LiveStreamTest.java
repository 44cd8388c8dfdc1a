package wbv.live;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.function.LongPredicate;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.SeatMeter;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.state.StateModelFile;

class LiveStreamTest {

    private static final Path RIDE = Path.of("data/arff/ride-subject1.arff");
    private static final String HEADER = "t,platform.acc.z,head.acc.z,seat.acc.z\n";

    @TempDir
    private Path folder;

    /** A lively seat at 60 Hz. @param kept which samples are sent */
    private static String rows(int from, int to, double offset, DoubleUnaryOperator time, LongPredicate kept) {
        StringBuilder text = new StringBuilder();
        for (int i = from; i < to; i++) {
            if (kept.test(i)) {
                double u = Math.sin(0.45 * i) + 0.7 * Math.sin(0.21 * i * (1 + 0.0001 * i));
                text.append(String.format(Locale.ROOT, "%.6f,%.6f,%.6f,%.6f%n", time.applyAsDouble(i), u + offset,
                        1.3 * u + 0.2 * Math.sin(0.9 * i) + offset, u + 0.01 * Math.sin(1.7 * i) + offset));
            }
        }
        return text.toString();
    }

    private static String rows(int from, int to) {
        return rows(from, to, 0, i -> i / 60, i -> true);
    }

    /** The estimator and the exposure are those of the same recording read from its file. */
    @Test
    void aStreamGivesWhatItsRecordingGives() throws IOException {
        LiveSettings usual = LiveSettings.usual();
        Told told = new Told(
                new LiveSettings(usual.reading(), usual.columns(), usual.method(), usual.input(), usual.outputs(), usual.place(), false,
                        Optional.of(StateModelFile.shipped()), 1, 5))
                .stream(Files.readAllBytes(RIDE)).finish();
        List<JsonNode> results = told.of("result");
        assertEquals(150, results.size());
        Recording recording = new RecordingFile(RIDE).load();
        Estimator estimator = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(60), () -> new AdwinAlarm(0.002));
        double[] u = recording.values(Channel.parse("platform.acc.z"));
        double[] y = recording.values(Channel.parse("head.acc.z"));
        for (int i = 0; i < u.length; i++) {
            BodyEstimate track = estimator.step(u[i], y[i]);
            if ((i + 1) % 60 == 0) {
                JsonNode mode = results.get(i / 60).get("bodies").get(0).get("modes").get(0);
                assertEquals(track.frequency(), mode.get("natural_frequency_hz").asDouble(), 5e-6 * track.frequency(), "sample " + i);
                assertEquals(track.frequencyDeviation(), mode.get("natural_frequency_deviation_hz").asDouble(),
                        5e-6 * track.frequencyDeviation());
                assertEquals(track.damping(), mode.get("damping_ratio").asDouble(), 5e-6 * track.damping());
            }
        }
        SeatMeasurement measured = SeatMeter.measure(new RecordingFile(RIDE),
                new SeatMeter.Setup(Optional.of("seat"), Optional.empty(), false), share -> {});
        JsonNode exposure = results.get(149).get("exposure");
        for (SeatAxis axis : SeatAxis.values()) {
            JsonNode one = exposure.get("axes").get(axis.ordinal());
            assertEquals(measured.axes().get(axis).rms(), one.get("a_w_m_s2").asDouble(), 0.006 * measured.axes().get(axis).rms(),
                    axis.toString());
            assertEquals(axis.factor() * measured.axes().get(axis).vdv(), one.get("vdv_m_s1.75").asDouble(),
                    0.006 * axis.factor() * measured.axes().get(axis).vdv());
        }
        double seconds = exposure.get("seconds").asDouble();
        assertEquals(exposure.get("axes").get(2).get("a_w_m_s2").asDouble() * Math.sqrt(seconds / 28800),
                exposure.get("a8_m_s2").asDouble(), 1e-5);
        assertEquals(List.of(9000L, 0L, 1L), List.of(told.live.rows(), told.live.unreadable(), (long) told.live.seats()));
        assertTrue(results.get(149).get("state").get("name").asText().equals("riding"), results.get(149).toString());
    }

    @Test
    void compressedInputIsTheSame() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream zip = new GZIPOutputStream(packed)) {
            zip.write((HEADER + rows(0, 600)).getBytes(StandardCharsets.UTF_8));
        }
        assertEquals(Told.usual().send(HEADER + rows(0, 600)).finish().of("result"),
                Told.usual().stream(packed.toByteArray()).finish().of("result"));
    }

    @Test
    void seatsAreFollowedApart() {
        StringBuilder text = new StringBuilder("t,seat,platform.acc.z,head.acc.z,seat.acc.z\n");
        String[] one = rows(0, 600).split("\\R");
        for (String row : one) {
            String[] cells = row.split(",", 2);
            text.append(cells[0]).append(",truck 7,").append(cells[1]).append('\n').append(cells[0]).append(",\"8, old\",").append(cells[1])
                    .append('\n');
        }
        Told told = Told.usual().send(text.toString()).finish();
        Told alone = Told.usual().send(HEADER + rows(0, 600)).finish();
        for (String seat : List.of("truck 7", "8, old")) {
            List<JsonNode> own = told.of("result").stream().filter(node -> node.get("seat").asText().equals(seat)).toList();
            assertEquals(alone.of("result").stream().map(node -> node.get("bodies")).toList(),
                    own.stream().map(node -> node.get("bodies")).toList());
        }
    }

    @Test
    void sensorsThatSendApartAreJoinedByTheirTimes() {
        StringBuilder apart = new StringBuilder();
        for (String row : rows(0, 900).split("\\R")) {
            String[] cells = row.split(",");
            apart.append("{\"t\":").append(cells[0]).append(",\"platform.acc.z\":").append(cells[1]).append(",\"seat.acc.z\":")
                    .append(cells[3]).append("}\n")
                    .append("{\"t\":").append(cells[0]).append(",\"head.acc.z\":").append(cells[2]).append("}\n");
        }
        Told told = Told.usual().send(apart.toString()).finish();
        List<JsonNode> whole = Told.usual().send(HEADER + rows(0, 900)).finish().of("result");
        assertEquals(whole.stream().map(node -> node.get("bodies")).toList(),
                told.of("result").stream().map(node -> node.get("bodies")).toList());
        assertEquals(0, told.of("result").get(14).get("losses").get("values").asInt());
    }

    @Test
    void aChannelThatFailsIsToldAndSoIsItsEnd() {
        String[] rows = rows(0, 1200).split("\\R");
        for (int i = 300; i < 500; i++) {
            String[] cells = rows[i].split(",");
            rows[i] = String.join(",", cells[0], cells[1], i < 400 ? "0.25" : "", cells[3]);
        }
        Told told = Told.usual().send(HEADER + String.join("\n", rows)).finish();
        assertEquals(List.of("stuck", "missing", "-missing", "-stuck"),
                told.alarms().stream().filter(kind -> kind.matches("-?(stuck|missing)")).toList());
        JsonNode stuck = told.of("alarm").get(0);
        assertEquals("head.acc.z stands still at 0.25", stuck.get("reason").asText());
        assertEquals(330 / 60.0, stuck.get("t_s").asDouble(), 0.1);
    }

    @Test
    void lossesAndAClockThatBeginsAgainAreCounted() {
        String lossy = rows(0, 1200, 0, i -> i / 60, i -> i < 300 || i % 10 != 0);
        String again = rows(1200, 1800, 0, i -> (i - 1200) / 60, i -> true);
        Told told = Told.usual().send(HEADER + lossy + again).finish();
        assertTrue(told.alarms().containsAll(List.of("losses", "sensor-restarted")), told.alarms().toString());
        LiveSeat seat = told.live.seat(LiveStream.ONLY).orElseThrow();
        assertEquals(List.of(90L, 2L, 1L), List.of(seat.missing(), seat.late(), seat.restarts()));
        List<JsonNode> results = told.of("result");
        assertEquals(1, results.get(results.size() - 1).get("losses").get("restarts").asInt());
    }

    @Test
    void whatIsOddWithValuesIsToldOnce() {
        StringBuilder text = new StringBuilder(HEADER);
        for (String row : rows(0, 1800, 9.81, i -> i / 60, i -> true).split("\\R")) {
            String[] cells = row.split(",");
            text.append(String.join(",", cells[0], cells[1], cells[2], Double.toString(Math.min(10.2, Double.parseDouble(cells[3])))))
                    .append('\n');
        }
        Told told = Told.usual().send(text.toString()).finish();
        assertEquals(1, told.alarms().stream().filter("clipped"::equals).count(), told.alarms().toString());
        assertEquals(3, told.alarms().stream().filter("gravity"::equals).count(), told.alarms().toString());
    }

    @Test
    void silenceIsToldAndItsEnd() {
        Told told = Told.usual().send(HEADER + rows(0, 120)).pass(2);
        assertFalse(told.alarms().contains("silent"));
        told.pass(2).pass(2).send(rows(120, 130));
        assertEquals(List.of("silent", "-silent"), told.alarms());
    }

    /** What cannot be read is put aside as it came; the rest is followed as if it had never been. */
    @Test
    void whatCannotBeReadIsPutAside() throws IOException {
        String bad = "1.0,x,1,1\nnonsense\n{\"t\": \n";
        Path file = folder.resolve("aside.txt");
        List<String> lines = new ArrayList<>();
        try (Aside aside = Aside.in(file)) {
            LiveStream live = new LiveStream(LiveSettings.usual(), lines::add, aside, () -> 0);
            String text = HEADER + rows(0, 100) + bad + rows(100, 600);
            new StreamSource("test", new java.io.ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))).run(live);
            live.finish();
            assertEquals(3, live.unreadable());
        }
        assertEquals(bad, Files.readString(file));
        List<String> whole = new ArrayList<>();
        LiveStream live = new LiveStream(LiveSettings.usual(), whole::add, Aside.NONE, () -> 0);
        new StreamSource("test", new java.io.ByteArrayInputStream((HEADER + rows(0, 600)).getBytes(StandardCharsets.UTF_8))).run(live);
        assertEquals(whole.stream().filter(line -> line.contains("\"result\"")).toList(),
                lines.stream().filter(line -> line.contains("\"result\"")).toList());
    }

    @Test
    void aLineWithoutAnEndIsPutAside() {
        byte[] text = (HEADER + "x".repeat(300_000) + "\n" + rows(0, 120)).getBytes(StandardCharsets.UTF_8);
        Told told = Told.usual().stream(text).finish();
        assertEquals(List.of(1L, 120L), List.of(told.live.unreadable(), told.live.rows()));
    }

    @Test
    void namesMadeUpBySendersDoNotFillTheMemory() {
        LiveSettings usual = LiveSettings.usual();
        Told told = new Told(
                new LiveSettings(usual.reading(), usual.columns(), usual.method(), usual.input(), usual.outputs(), usual.place(), false,
                        usual.states(), 1, 5));
        for (int i = 0; i < 2000; i++) {
            told.sendFrom("sender " + i, "{\"seat\":\"s" + i + "\",\"t\":" + i + ",\"seat.acc.z\":1,\"c" + i + ".acc.x\":1}");
        }
        assertEquals(List.of(5L, 1995L), List.of((long) told.live.seats(), told.live.refused()));
        assertTrue(told.of("alarm").size() < 20);
    }

    @Test
    void aSeatOfWhichNothingCanBeSaidIsRefusedInWords() {
        Told told = Told.usual().send("t,oil.temp.s\n" + rows(0, 200).replaceAll("(?m)^([^,]*),([^,]*),.*$", "$1,$2")).finish();
        assertEquals(List.of("refused"), told.alarms());
        assertTrue(told.of("alarm").get(0).get("reason").asText().contains("nor any acceleration"), told.of("alarm").toString());
    }

    @Tag("slow")
    @Test
    void mutatedLinesHarmNothing() {
        mutated(20_000, 20);
    }

    /** Goal of the security rules: a hundred thousand of them. */
    @Test
    @Tag("exam")
    void aHundredThousandMutatedLinesHarmNothing() {
        mutated(100_000, 20_01);
        System.gc();
        long before = Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
        mutated(100_000, 20_02);
        System.gc();
        long after = Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
        assertTrue(after - before < 20_000_000, before + " and " + after + " bytes");
    }

    /** Rows of all forms with bytes changed, cut, doubled and joined: none escapes, and good rows of another sender come through. */
    private static void mutated(int count, long seed) {
        Random random = new Random(seed);
        LiveSettings usual = LiveSettings.usual();
        Told told = new Told(
                new LiveSettings(usual.reading(), usual.columns(), Method.EKF, usual.input(), usual.outputs(), usual.place(), false,
                        usual.states(), 1, 50));
        List<String> forms = List.of("t,seat,platform.acc.z,head.acc.z", "%f,7,0.5,0.25",
                "{\"seat\":\"7\",\"t\":%f,\"platform.acc.z\":0.5,\"head.acc.z\":0.25}",
                "{\"t\":[%f,2.5],\"seat.acc.z\":[1,2]}", "PacketCounter,SampleTimeFine,FreeAcc_Z,Gyr_X", "12,%f,0.5,0.25",
                "@attribute seat.acc.z numeric", "@data");
        String[] good = (HEADER.replace("\n", System.lineSeparator()) + rows(0, count / 4 - 1)).split("\\R");
        for (int i = 0; i < count; i++) {
            byte[] line = String.format(Locale.ROOT, forms.get(random.nextInt(forms.size())), i / 60.0).getBytes(StandardCharsets.UTF_8);
            for (int k = random.nextInt(4); k >= 0; k--) {
                int at = random.nextInt(line.length);
                switch (random.nextInt(4)) {
                    case 0 -> line[at] = (byte) random.nextInt(256);
                    case 1 -> line = java.util.Arrays.copyOf(line, Math.max(1, at));
                    case 2 -> line[at] ^= (byte) (1 << random.nextInt(8));
                    default -> System.arraycopy(line, 0, line, at, line.length - at);
                }
            }
            told.live.line("bad " + random.nextInt(3), "", line, 0, line.length);
            if (i % 4 == 0) {
                told.sendFrom("good", good[i / 4]);
            }
        }
        told.finish();
        assertTrue(told.live.unreadable() > count / 3, told.live.unreadable() + " put aside");
        assertTrue(told.of("alarm").size() < 3000 && told.live.seats() <= 50, told.of("alarm").size() + " alarms");
        assertFalse(told.of("result").isEmpty());
    }

    @Test
    void historyHoldsTheWholeShiftInLittleMemory() {
        History history = new History(2);
        for (int i = 0; i < 100_000; i++) {
            history.accept(i, 2 * i);
        }
        assertTrue(history.held() > History.MOST / 2 && history.held() <= History.MOST);
        double step = history.value(0, 1) - history.value(0, 0);
        for (int i = 0; i < history.held(); i++) {
            assertEquals(i * step, history.value(0, i));
            assertEquals(2 * i * step, history.value(1, i));
        }
        assertTrue(history.value(0, history.held() - 1) >= 100_000 - 2 * step);
    }
}
