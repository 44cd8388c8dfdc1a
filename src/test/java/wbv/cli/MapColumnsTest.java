package wbv.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MapColumnsTest {

    private static final Path TABLES = Path.of("src/test/resources/map");

    @TempDir
    private Path room;

    /** What is drafted can be used as it is, questions and all. */
    @ParameterizedTest
    @ValueSource(strings = {"phyphox.csv", "arduino.csv", "dewesoft.txt", "pulse.txt"})
    void draftIsAMap(String name) throws IOException {
        Path table = Files.copy(TABLES.resolve(name), room.resolve(name));
        Run drafted = Run.of("map", table.toString());
        assertEquals(0, drafted.code(), drafted.err());
        Path map = room.resolve(name.replaceFirst("\\..*", ".map.json"));
        assertTrue(drafted.out().contains("Wrote " + map), drafted.out());
        Run used = Run.of("exposure", table.toString(), "--map", map.toString(), "--out", room.resolve("out").toString());
        assertEquals(0, used.code(), used.err());
        assertTrue(used.out().contains("A(8) is "), used.out());
    }

    /** Every question that is printed stands in the map. */
    @Test
    void questionsAreMarkedInTheMap() throws IOException {
        Path map = room.resolve("m.json");
        Run drafted = Run.of("map", TABLES.resolve("bare.csv").toString(), "--out", map.toString());
        long asked = drafted.out().lines().filter(line -> line.startsWith("QUESTION: "))
                .peek(line -> assertTrue(contains(map, line.substring(10)),
                        line))
                .count();
        assertEquals(3, asked, drafted.out());
    }

    private static boolean contains(Path file, String text) {
        try {
            return Files.readString(file).replace("\\\"", "\"").contains(text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void mapThatIsThereIsNotWrittenOver() throws IOException {
        Path table = Files.copy(TABLES.resolve("phyphox.csv"), room.resolve("phone.csv"));
        Files.writeString(room.resolve("phone.map.json"), "mine");
        Run refused = Run.of("map", table.toString());
        assertEquals(1, refused.code());
        assertTrue(refused.err().contains("phone.map.json: is there already"), refused.err());
        assertEquals("mine", Files.readString(room.resolve("phone.map.json")));
    }

    @Test
    void whatNeedsNoMapGetsNone() throws IOException {
        Run told = Run.of("map", "src/test/resources/signals/scipy-7.mat");
        assertEquals(0, told.code(), told.err());
        assertTrue(told.out().endsWith("needs no map; its channels are seat.acc.z, head.acc.z, head.gyr.y\n"), told.out());
        assertFalse(Files.exists(Path.of("src/test/resources/signals/scipy-7.map.json")));
    }
}
