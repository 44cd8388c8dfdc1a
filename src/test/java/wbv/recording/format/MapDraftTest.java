package wbv.recording.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.RowReader;
import wbv.recording.Unit;
import wbv.recording.signals.Label;

/** Maps drafted of tables in the layouts of several programs, which all hold the same ride: what is read by the drafts must agree. */
class MapDraftTest {

    private static final Path TABLES = Path.of("src/test/resources/map");
    private static final Path SIGNALS = Path.of("src/test/resources/signals");

    @TempDir
    private Path room;

    private List<double[]> read(Path file, Channel channel) throws IOException {
        Path map = Files.writeString(room.resolve("map.json"), MapDraft.of(file).json("file"));
        try (RowReader reader = new RecordingFile(file, new ReadOptions(Optional.of(ColumnMap.read(map)), OptionalDouble.empty(), Map.of()))
                .open()) {
            int column = 1 + reader.channels().indexOf(channel);
            assertTrue(column > 0, channel + " is not among " + reader.channels());
            return Samples.rows(reader).stream().map(row -> new double[] {row[0], row[column]}).toList();
        }
    }

    @ParameterizedTest
    @CsvSource({"phyphox.csv, seat.accg.z, 1e-8, 1e-8", "arduino.csv, seat.accg.z, 4e-4, 6e-4", "dewesoft.txt, seat.acc.z, 1e-6, 1e-6"})
    void allDraftsReadTheSameRide(String name, String channel, double resolution, double time) throws IOException {
        List<double[]> pulse = read(TABLES.resolve("pulse.txt"), Channel.parse("seat.acc.z"));
        List<double[]> rows = read(TABLES.resolve(name), Channel.parse(channel));
        assertEquals(400, rows.size());
        double gravity = channel.contains("accg") ? Unit.STANDARD_GRAVITY : 0;
        for (int i = 0; i < 400; i++) {
            assertEquals(pulse.get(i)[0] - pulse.get(0)[0], rows.get(i)[0] - rows.get(0)[0], 2 * time);
            assertEquals(pulse.get(i)[1], rows.get(i)[1] - gravity, resolution + 1e-6);
        }
    }

    private static List<String> questions(Path file) throws IOException {
        return MapDraft.of(file).questions();
    }

    /** What can be known is not asked; what cannot is. */
    @Test
    void whatCannotBeKnownIsAsked() throws IOException {
        assertEquals(List.of(), questions(TABLES.resolve("dewesoft.txt")));
        assertEquals(List.of(), questions(TABLES.resolve("pulse.txt")));
        assertEquals(1, questions(TABLES.resolve("phyphox.csv")).size());
        assertTrue(questions(TABLES.resolve("phyphox.csv")).get(0).startsWith("Where was the sensor of 'Acceleration x (m/s^2)'"));
        List<String> counts = questions(TABLES.resolve("arduino.csv"));
        assertTrue(
                counts.stream().anyMatch(each -> each.startsWith("Are 16384 counts"))
                        && counts.stream().anyMatch(each -> each.contains("one deg/s")),
                counts.toString());
        List<String> bare = questions(TABLES.resolve("bare.csv"));
        assertTrue(bare.stream().anyMatch(each -> each.startsWith("How many samples a second"))
                && bare.stream().anyMatch(each -> each.startsWith("In which unit")),
                bare.toString());
        assertTrue(questions(SIGNALS.resolve("scipy-16.wav")).get(0).startsWith("What is full scale"));
        assertEquals(1, questions(SIGNALS.resolve("pyuff-no-direction.uff")).size());
    }

    /** A draft without a rate is no map until it is answered. */
    @Test
    void unansweredRateIsRefusedWithItsField() {
        DataFault fault = assertThrows(DataFault.class, () -> read(TABLES.resolve("bare.csv"), Channel.parse("seat.acc.z")));
        assertTrue(fault.getMessage().contains("'time'") && fault.getMessage().contains("rate_hz"), fault.getMessage());
    }

    @ParameterizedTest
    @CsvSource({
        "Acceleration x (m/s^2), '', ACCELERATION, x, m/s^2", "Linear Acceleration z (m/s^2), '', ACCELERATION, z, m/s^2",
        "Gyroscope y (rad/s), '', ANGULAR_RATE, y, rad/s",
        "ax, '', ACCELERATION, x, ''", "gz, '', ANGULAR_RATE, z, ''", "AccX, '', ACCELERATION, x, ''",
        "head_acc_x_m_s2, head, ACCELERATION, x, m/s2",
        "seat_gyroZ_dps, seat, ANGULAR_RATE, z, dps", "Seat vertical [g], seat, ACCELERATION, z, g", "Load cell (kN), cell, FORCE, '', kN",
        "mag.x, '', MAGNETIC_FIELD, x, ''",
        "seat.acc.x[0], seat, ACCELERATION, x, ''", "Wheel speed (km/h), wheel, VELOCITY, '', km/h"})
    void namesSayWhatTheyMean(String name, String place, Quantity quantity, String axis, String unit) {
        Label label = NameWords
                .of(new Label(name, Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), 1), Optional.empty()).label();
        assertEquals(Optional.of(place).filter(word -> !word.isEmpty()), label.place());
        assertEquals(Optional.of(quantity), label.quantity());
        assertEquals(axis, label.axis().map(String::valueOf).orElse(""));
        assertEquals(unit, label.unit().orElse(""));
    }

    @Test
    void accelerationsOfKnownUnitTellWhetherGravityIsInThem() throws IOException {
        Path rest = Samples.file(room, "rest.csv", "time;ax (g);ay (g);az "
                + "(g)\n0,0;0,01;0,02;1,01\n0,01;0,01;0,02;0,99\n0,02;0;0,02;1,0\n0,03;0;0,02;1,0\n0,04;0;0,02;1\n");
        assertTrue(MapDraft.of(rest).json("").contains("seat.accg.z"));
        Path moved = Samples.file(room, "moved.csv", "time;ax (g);ay (g);az "
                + "(g)\n0,0;0,01;0,02;0,1\n0,01;0,01;0,02;-0,1\n0,02;0;0,02;0,1\n0,03;0;0,02;-0,1\n0,04;0;0,02;1\n");
        assertTrue(MapDraft.of(moved).json("").contains("seat.acc.z"));
    }

    /** One that reads an eighth less than a g at rest has it in it all the same; that its scale is off is for its user to know. */
    @Test
    void aScaleThatIsOffTakesNoGravityAway() throws IOException {
        Path off = Samples.file(room, "off.csv", "t_s,ax_m_s2,ay_m_s2,az_m_s2\n0,-1.2,0.4,8.5\n0.01,-1.1,0.4,8.4\n0.02,-1.2,0.5,8.5\n"
                + "0.03,-1.2,0.4,8.5\n0.04,-1.2,0.4,8.4\n");
        MapDraft draft = MapDraft.of(off);
        assertTrue(draft.json("").contains("seat.accg.z"));
        assertTrue(draft.questions().stream().anyMatch(question -> question.startsWith("Is gravity in 'ax_m_s2'")), "" + draft.questions());
    }

    /** What no name and no number says stays open in the draft, and no command takes it before it is answered. */
    @ParameterizedTest
    @ValueSource(strings = {"t_ms;floor_x;floor_z;seat_z;rpm", "Time [ms];Boden X;Boden Z;Sitz Z;Temp [degC]"})
    void axesAloneAreDraftedWithTheirUnitOpen(String header) throws IOException {
        Path table = Samples.file(room, "axes.csv",
                header + "\n0;0,1;0,3;0,2;20\n5;-0,1;0,2;0,4;20\n10;0,2;0;-0,3;20\n15;0,1;0,1;0,1;20\n20;0;0;0;20\n");
        MapDraft draft = MapDraft.of(table);
        String place = header.contains("Boden") ? "boden" : "floor";
        Channel floor = Channel.parse(place + ".acc.z");
        assertTrue(draft.drafted().contains(floor), draft.drafted().toString());
        assertTrue(draft.questions().stream().anyMatch(question -> question.startsWith("What do "))
                && draft.questions().stream().anyMatch(question -> question.startsWith("In which unit")), draft.questions().toString());
        String told = assertThrows(DataFault.class, () -> read(table, floor)).getMessage();
        assertTrue(told.contains(place + ".acc.x.unit' is still to be answered: write one of m/s2"), told);
        Path map = Files.writeString(room.resolve("map.json"), draft.json("axes.csv").replace("\"?\"", "\"g\""));
        try (RowReader reader = new RecordingFile(table,
                new ReadOptions(Optional.of(ColumnMap.read(map)), OptionalDouble.empty(), Map.of())).open()) {
            int column = 1 + reader.channels().indexOf(floor);
            assertEquals(0.3 * Unit.STANDARD_GRAVITY, Samples.rows(reader).get(0)[column], 1e-12);
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"one line of words|holds no table", "1,2,3\\n4,5,6\\n7,8,9\\n1,2,3|names of its 3 columns",
        "p;q\\n1;2\\n3;4\\n5;6\\n7;8|no column's name says"})
    void whatIsNoTableIsRefusedInOneLine(String text, String words) throws IOException {
        Path file = Samples.file(room, "x.csv", text.replace("\\n", "\n"));
        String message = assertThrows(DataFault.class, () -> MapDraft.of(file)).getMessage();
        assertTrue(message.startsWith(file.toString()) && message.contains(words) && !message.contains("\n"), message);
    }
}
