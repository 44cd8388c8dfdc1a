package wbv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The examples of wbv as a library: compiled without a warning, run, and held to what they set out to show. */
class ExamplesTest {

    @TempDir
    private static Path classes;

    @BeforeAll
    static void compile() throws Exception {
        List<String> words = new ArrayList<>(
                List.of("-Xlint:all,-processing,-classfile,-path", "-Werror", "-proc:none", "-d", classes.toString(), "-cp",
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"))));
        try (Stream<Path> files = Files.list(Path.of("examples"))) {
            files.map(Path::toString).filter(name -> name.endsWith(".java")).sorted().forEach(words::add);
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        assertEquals(0, compiler.run(null, said, said, words.toArray(String[]::new)), said.toString(StandardCharsets.UTF_8));
    }

    private static String run(String name, String... arguments) throws Exception {
        PrintStream before = System.out;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        try (URLClassLoader loader = new URLClassLoader(new URL[] {classes.toUri().toURL()}, ExamplesTest.class.getClassLoader())) {
            System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
            loader.loadClass(name).getMethod("main", String[].class).invoke(null, (Object) arguments);
        } finally {
            System.setOut(before);
        }
        return printed.toString(StandardCharsets.UTF_8);
    }

    private static List<Double> numbers(String pattern, String text) {
        Matcher found = Pattern.compile(pattern).matcher(text);
        List<Double> numbers = new ArrayList<>();
        while (found.find()) {
            numbers.add(Double.parseDouble(found.group(1)));
        }
        return numbers;
    }

    /** The stiffness steps by a quarter after 60 s: √1.25 times the natural frequency of 4.5 Hz. */
    @Test
    void aStreamIsFollowedThroughItsStep() throws Exception {
        String text = run("FollowAStream");
        List<Double> frequencies = numbers("natural frequency (\\d+\\.\\d+)", text);
        assertEquals(4, frequencies.size(), text);
        assertEquals(4.5, frequencies.get(1), 0.05);
        assertEquals(4.5 * Math.sqrt(1.25), frequencies.get(3), 0.05);
        List<Double> changes = numbers("(\\d+\\.\\d+) s: the body has changed", text);
        assertTrue(changes.size() == 1 && changes.get(0) > 60 && changes.get(0) < 61, text);
    }

    /** The ride begins, and its regime changes after 50 s. */
    @Test
    void aDetectorOfOnesOwnHearsTheRegimesChange() throws Exception {
        String text = run("OwnDetector");
        assertTrue(numbers("(\\d+\\.\\d+) s: halves heard", text).stream().anyMatch(t -> t > 50 && t < 60), text);
        assertTrue(numbers("(\\d+\\.\\d+) s: halves heard", text).stream().noneMatch(t -> t > 12 && t < 50), text);
    }

    @Test
    void aDiagnosisOfWhatLacksNothingIsSilent() throws Exception {
        String text = run("DiagnoseARecording", "data/arff/concealed/001");
        assertTrue(text.startsWith("nothing-missing: ") && text.endsWith("has 0 laws in its links\n"), text);
    }

    @Tag("slow")
    @Test
    void aDiagnosisNamesTheConcealedLaw() throws Exception {
        String text = run("DiagnoseARecording");
        assertTrue(text.startsWith("missing-physics: ") && text.contains("stiffness.softening at platform-pelvis")
                && text.endsWith("has 1 laws in its links\n"), text);
    }

    @Tag("slow")
    @Test
    void aLawOfOnesOwnIsNamedInItsOwnWords() throws Exception {
        String text = run("OwnLaw");
        assertTrue(text.startsWith("The cushion seat-torso grips as it is bent (") && text.contains("cushion.gripping at seat-torso"),
                text);
        assertEquals(1.5e9, numbers("coefficient_N=([0-9.E]+)", text).get(0), 0.05 * 1.5e9);
    }
}
