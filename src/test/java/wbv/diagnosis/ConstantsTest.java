package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Field;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import wbv.diagnosis.search.Priors;

/** Numbers on which verdicts rest stand in {@link Priors}, those that say how hard is sought in {@code Effort}, and nowhere else. */
class ConstantsTest {

    private static final Path ROOM = Path.of("src/main/java/wbv/diagnosis");

    /** Classes with numbers of their own, and what for. */
    private static final Map<String, List<String>> OTHERS = Map.of(
            "what they are for", List.of("Priors", "Effort"),
            "how findings are written, and how surely",
            List.of("Bands", "BlockScores", "Diagnosis", "DisplayedNumber", "Estimand", "FitFigures",
                    "HeldOut", "Interval", "Mismatch", "Phrases", "Profile", "Values", "VerdictWords", "WrongNumbers", "LearnedWords",
                    "LawShape"),
            "what sensors do and how recordings are put together",
            List.of("PlainFaults", "Question", "Rides", "LatentEstimator", "OddSensor"),
            "where fits start, how far they go, and what they tell apart of what they are made of",
            List.of("Heats", "InputLevel", "PartialledOut", "PlaceHeats", "Refinement", "Search", "Sentences", "TermColumns", "Trial",
                    "Yielding"),
            "the words of the grammar", List.of("Grammar", "Terms", "LinkScale"));

    private static final Pattern NUMBER = Pattern.compile("(?<![\\w.])(\\d[\\d_]*(?:\\.\\d+)?(?:e-?\\d+)?)(?![\\w.])");
    private static final Set<String> PLAIN = Set.of("0", "1", "2", "0.0", "1.0", "2.0", "0.5");
    /** Below this a number keeps two that are equal but for rounding from being told apart. */
    private static final double ROUNDING = 1e-9;

    private static List<Path> deciding() throws IOException {
        List<Path> out = new ArrayList<>();
        for (String folder : List.of("", "search", "learn")) {
            try (Stream<Path> files = Files.list(ROOM.resolve(folder))) {
                files.filter(file -> file.toString().endsWith(".java")).forEach(out::add);
            }
        }
        return out;
    }

    private static String name(Path file) {
        return file.getFileName().toString().replace(".java", "");
    }

    private static List<String> numbers(Path file) throws IOException {
        String code = Files.readString(file).replaceAll("(?s)/\\*.*?\\*/", "").replaceAll("\"(\\\\.|[^\"\\\\])*\"", "")
                .replaceAll("//.*", "")
                // How far a diagnosis has come.
                .replaceAll("accept\\([^;]*\\);", "");
        return NUMBER.matcher(code).results().map(found -> found.group(1))
                .filter(number -> !PLAIN.contains(number) && Double.parseDouble(number.replace("_", "")) > ROUNDING).toList();
    }

    @Test
    void whatDecidesHasNoNumbersOfItsOwn() throws IOException {
        Set<String> apart = new TreeSet<>();
        OTHERS.values().forEach(apart::addAll);
        Set<String> found = new TreeSet<>();
        Set<String> all = new TreeSet<>();
        for (Path file : deciding()) {
            all.add(name(file));
            List<String> numbers = numbers(file);
            if (!apart.contains(name(file)) && !numbers.isEmpty()) {
                found.add(name(file) + " " + numbers);
            }
        }
        assertEquals(Set.of(), found);
        assertTrue(all.containsAll(apart), "classes that are no more: " + apart);
    }

    /**
     * Who decides does not ask whether it is about a rig or a person, but what is known of noise, which places outputs tell apart and which
     * mechanisms there are. Faults that need no fit, forces of the other sign, how long a recording must be, weights of a person and what
     * only benches or only people do are of one or the other.
     */
    @Test
    void whatDecidesIsOneForRigsAndPeople() throws IOException {
        Set<String> asked = new TreeSet<>();
        for (Path file : deciding()) {
            if (Files.readString(file).matches("(?s).*\\b(onRig|isRig)\\(.*")) {
                asked.add(name(file));
            }
        }
        assertEquals(Set.of("PlainFaults", "ForceSign", "Diagnoser", "Grammar", "Terms"), asked);
    }

    @Test
    void noMoreThanTwentyNumbersAreBelieved() throws IllegalAccessException {
        Field[] numbers = Priors.class.getFields();
        assertTrue(numbers.length <= 20, "numbers: " + numbers.length);
        for (Field number : numbers) {
            assertTrue(number.getDouble(null) > 0, number.getName());
        }
    }

    /** Each says what it is a part or a multiple of: a number without a unit is no belief. */
    @Test
    void eachHasAUnit() throws IOException {
        String code = Files.readString(ROOM.resolve("search/Priors.java"));
        long told = Arrays.stream(code.split("public static final")).filter(before -> before.lastIndexOf("[1]") > before.lastIndexOf("/**"))
                .count();
        assertEquals(Priors.class.getFields().length, told);
    }

    @Test
    void levelsAndPartsAreInOrder() {
        assertTrue(1 < Priors.NOISE && Priors.NOISE < Priors.SILENT && Priors.SILENT < Priors.LOUD && Priors.LOUD < Priors.STRANGE
                && Priors.STRANGE < Priors.GLARING);
        assertTrue(Priors.MAJORITY < Priors.LATE && Priors.LATE < Priors.HELD && Priors.HELD < Priors.NEARLY_ALL);
        assertEquals(1.0 / 9, Priors.ODDS, 1e-12);
    }
}
