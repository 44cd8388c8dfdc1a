package wbv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** docs/equations.md has a row for every numbered equation of the thesis, and what its rows name exists and says so. */
class EquationsTest {

    /** How many each chapter numbers; chapters 3 and 8 number none. */
    private static final Map<Integer, Integer> NUMBERED = new TreeMap<>(Map.of(2, 44, 4, 25, 5, 15, 6, 10, 7, 6));
    private static final String NOT_IMPLEMENTED = "not implemented, because ";
    private static final Pattern NAME = Pattern.compile("`(wbv\\.[\\w.]+)(?:#(\\w+))?`");
    private static final Pattern RANGE = Pattern.compile("(\\d)-(\\d+)(?: to \\1-(\\d+))?");
    private static final Pattern JAVADOC = Pattern.compile("/\\*\\*(.*?)\\*/([^;{]*[;{])", Pattern.DOTALL);

    /** @param code where it is computed, or why it is not @param erratum what is wrong in print; may be empty @param test that holds it */
    private record Row(String number, String what, String code, String erratum, String test) {}

    private static List<Row> rows() throws IOException {
        return Files.readAllLines(Path.of("docs/equations.md")).stream().filter(line -> line.matches("\\| \\d-\\d+ \\|.*"))
                .map(line -> line.split(" ?\\| ?", -1)).map(cells -> new Row(cells[1], cells[2], cells[3], cells[4], cells[5])).toList();
    }

    @Test
    void everyNumberedEquationHasOneRow() throws IOException {
        List<String> wanted = NUMBERED.entrySet().stream().flatMap(chapter -> Stream.iterate(1, n -> n <= chapter.getValue(), n -> n + 1)
                .map(n -> chapter.getKey() + "-" + n)).toList();
        assertEquals(wanted, rows().stream().map(Row::number).toList());
        assertEquals(100, wanted.size());
    }

    @TestFactory
    Stream<DynamicTest> everythingNamedExists() throws IOException {
        return rows().stream().map(row -> DynamicTest.dynamicTest(row.number(), () -> {
            assertTrue(!row.what().isBlank(), "what it is");
            if (row.code().startsWith(NOT_IMPLEMENTED)) {
                assertTrue(row.code().length() > NOT_IMPLEMENTED.length() + 10, "say why");
                return;
            }
            List<MatchResult> named = NAME.matcher(row.code()).results().toList();
            assertTrue(!named.isEmpty(), "a class, or '" + NOT_IMPLEMENTED + "…'");
            for (MatchResult name : named) {
                member(name);
                assertTrue(says(name.group(1), name.group(2), row.number()),
                        "the Javadoc of " + name.group() + " does not say 'Eq. " + row.number() + "'");
            }
            List<MatchResult> tests = NAME.matcher(row.test()).results().toList();
            assertTrue(!tests.isEmpty(), "a test");
            for (MatchResult test : tests) {
                Method method = member(test);
                assertTrue(Arrays.stream(method.getAnnotations())
                        .anyMatch(each -> each.annotationType().getSimpleName().matches("Test|ParameterizedTest|"
                                + "TestFactory|RepeatedTest")),
                        test.group() + " is no test");
            }
        }));
    }

    /** The method, or null where a class alone is named. */
    private static Method member(MatchResult name) throws ClassNotFoundException {
        Class<?> type = Class.forName(name.group(1), false, EquationsTest.class.getClassLoader());
        if (name.group(2) == null) {
            return null;
        }
        return Arrays.stream(type.getDeclaredMethods()).filter(method -> method.getName().equals(name.group(2)) && !method.isSynthetic())
                .findFirst()
                .orElseThrow(() -> new AssertionError(name.group(1) + " has no method " + name.group(2)));
    }

    /** Whether the Javadoc of a class, or of one of its methods of a name, gives the number. */
    private static boolean says(String type, String method, String number) throws IOException {
        String simple = type.substring(type.lastIndexOf('.') + 1);
        Pattern declared = Pattern.compile(method == null ? "\\b(class|record|interface|enum) " + simple + "\\b" : "\\b" + method + "\\(");
        String source = Files.readString(Path.of("src/main/java", type.replace('.', '/') + ".java"));
        return JAVADOC.matcher(source).results().filter(doc -> declared.matcher(doc.group(2)).find())
                .anyMatch(doc -> doc.group(1).contains("Eq.") && numbers(doc.group(1)).contains(number));
    }

    private static TreeSet<String> numbers(String text) {
        TreeSet<String> all = new TreeSet<>();
        RANGE.matcher(text).results().forEach(range -> {
            int last = Integer.parseInt(range.group(range.group(3) == null ? 2 : 3));
            for (int n = Integer.parseInt(range.group(2)); n <= last; n++) {
                all.add(range.group(1) + "-" + n);
            }
        });
        return all;
    }
}
