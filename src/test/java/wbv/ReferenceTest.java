package wbv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Drive;
import wbv.body.ModelFile;
import wbv.body.SensorFault;
import wbv.body.law.Law;
import wbv.body.number.Key;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Mechanism;
import wbv.recording.Quantity;
import wbv.recording.Unit;
import wbv.recording.format.ColumnMap;
import wbv.recording.format.Sidecar;
import wbv.study.DiagnosisJson;

/**
 * The reference of formats, docs/reference, lists what the program reads and writes: every law, fault, quantity, unit, mechanism and key.
 */
class ReferenceTest {

    private static final Path FOLDER = Path.of("docs/reference");
    private static final Pattern EXAMPLE = Pattern.compile("^```json\n(.*?)^```", Pattern.MULTILINE | Pattern.DOTALL);
    private static final Pattern WORD = Pattern.compile("`([^`]+)`");

    private static List<String> examples(String page) throws IOException {
        return EXAMPLE.matcher(Files.readString(FOLDER.resolve(page))).results().map(match -> match.group(1)).toList();
    }

    /** The words in code of a cell of each row of a page's tables. */
    private static List<Set<String>> cells(String page, int column) throws IOException {
        List<Set<String>> cells = new ArrayList<>();
        for (String line : Files.readAllLines(FOLDER.resolve(page))) {
            if (line.startsWith("| `")) {
                String cell = line.split("(?<!\\\\)\\|", -1)[column];
                cells.add(WORD.matcher(cell).results().map(word -> word.group(1)).collect(Collectors.toCollection(TreeSet::new)));
            }
        }
        return cells;
    }

    private static List<String> words(String page) throws IOException {
        return cells(page, 1).stream().flatMap(Set::stream).toList();
    }

    @Test
    void modelsThatAreShownAreRead() throws IOException {
        List<String> models = examples("model.md");
        assertEquals(3, models.size());
        models.forEach(model -> assertTrue(!ModelFile.parse(model, "model.md").bodies().isEmpty()));
    }

    @Test
    void sidecarAndColumnMapThatAreShownAreRead(@TempDir Path room) throws IOException {
        List<String> shown = examples("recording.md");
        assertEquals(Optional.of("haul road, loaded"),
                Sidecar.read(Files.writeString(room.resolve("ride.json"), shown.get(0))).metadata().task());
        assertEquals(1, ColumnMap.read(Files.writeString(room.resolve("map.json"), shown.get(1))).patterns().size());
    }

    @ParameterizedTest
    @ValueSource(classes = {Law.class, Drive.class, SensorFault.class})
    void everyLawDriveAndFaultHasARowWithItsKeys(Class<?> family) throws IOException {
        List<Set<String>> rows = cells("model.md", 2);
        List<Class<?>> records = records(family).toList();
        assertTrue(records.size() > 8);
        for (Class<?> each : records) {
            Set<String> keys = Arrays.stream(each.getRecordComponents()).map(part -> part.getAnnotation(Key.class).value())
                    .collect(Collectors.toCollection(TreeSet::new));
            assertTrue(rows.contains(keys), "no row of docs/reference/model.md has the keys of " + each.getSimpleName() + ": " + keys);
        }
    }

    private static Stream<Class<?>> records(Class<?> family) {
        return Arrays.stream(family.getPermittedSubclasses()).flatMap(type -> type.isRecord() ? Stream.of(type) : records(type));
    }

    /** Held to a model with each law: what is exported is all that there is. */
    @Test
    void lawsStandUnderTheirWords() throws IOException {
        Set<String> words = new TreeSet<>(words("model.md"));
        List<MatchResult> used = Pattern.compile("\"(?:law|fault|force)\": *\"([^\"]+)\"")
                .matcher(Files.readString(Path.of("src/test/resources/export/models.json"))).results().toList();
        assertTrue(used.size() > 50);
        used.forEach(word -> assertTrue(words.contains(word.group(1)), word.group(1)));
    }

    @Test
    void quantitiesAndUnitsAreThoseThatAreKnown() throws IOException {
        String page = Files.readString(FOLDER.resolve("recording.md"));
        List<String> words = words("recording.md");
        for (Quantity quantity : Quantity.values()) {
            assertTrue(words.contains(quantity.symbol()), quantity.symbol());
        }
        Stream<String> units = Stream.concat(Stream.of("s"), Arrays.stream(Quantity.values()).map(Quantity::unit)).distinct();
        units.filter(unit -> !Unit.symbols(unit).isEmpty() && !unit.equals("1") && !unit.equals("a.u."))
                .forEach(unit -> assertTrue(page.contains("\n- " + unit + ": `" + Unit.symbols(unit).replace(", ", "`, `") + "`\n"), unit));
    }

    @Test
    void verdictsMechanismsAndKeysOfADiagnosisAreThoseThatAreWritten() throws IOException {
        String page = Files.readString(FOLDER.resolve("diagnosis.md"));
        Arrays.stream(Diagnosis.Verdict.values()).forEach(verdict -> assertTrue(page.contains("`" + verdict.word() + "`"), verdict.word()));
        List<String> words = words("diagnosis.md");
        Library.standard().mechanisms().stream().map(Mechanism::word).forEach(word -> assertTrue(words.contains(word), word));
        List<String> keys = new ArrayList<>(keys(DiagnosisJson.class));
        Arrays.stream(DiagnosisJson.class.getDeclaredClasses()).filter(Class::isRecord).forEach(part -> keys.addAll(keys(part)));
        assertTrue(keys.size() > 50);
        keys.forEach(key -> assertTrue(page.contains("`" + key + "`"), key));
    }

    @Test
    void classesThatAreNamedForJavaExist() throws IOException {
        List<String> named = Pattern.compile("`(wbv[.\\w]*\\.[A-Z]\\w*)`").matcher(Files.readString(FOLDER.resolve("java.md"))).results()
                .map(name -> name.group(1)).toList();
        assertTrue(named.size() > 10);
        named.forEach(name -> assertTrue(Files.exists(Path.of("src/main/java", name.replace('.', '/') + ".java")), name));
    }

    private static List<String> keys(Class<?> record) {
        return Arrays.stream(record.getRecordComponents()).map(ReferenceTest::key).toList();
    }

    private static String key(RecordComponent part) {
        JsonProperty named = part.getAccessor().getAnnotation(JsonProperty.class);
        return named == null ? part.getName() : named.value();
    }
}
