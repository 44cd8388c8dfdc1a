package wbv.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.body.law.LearnedInertance;
import wbv.recording.DataFault;

/** What the texts hold that no simulator is needed to see. */
class TextsTest {

    private static final Pattern DECLARATION = Pattern.compile("  (parameter |input |output )?Real (\\w+).*;");
    private static final Set<String> KNOWN = Set.of("der", "if", "then", "else", "time", "abs", "min", "max", "exp", "log", "sqrt", "sin",
            "cos", "tan", "tanh", "delay", "floor");

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "x < 0 ? -k * x : exp(x) | -k * x if x < 0 else math.exp(x) | x < 0 ? -k * x : exp(x) | if x < 0 then (-k) * x else exp(x)",
        "(a + b) * -c - (d - e) | (a + b) * (-c) - (d - e) | (a + b) * (-c) - (d - e) | (a + b) * (-c) - (d - e)",
        "2 * (x > 1 ? pow(x, 1.5) : 1e-5) | 2 * (math.pow(x, 1.5) if x > 1 else 1e-5) | 2 * (x > 1 ? pow(x, 1.5) : 1e-5) "
                + "| 2 * (if x > 1 then (x) ^ (1.5) else 1e-5)",
        "a / b / (c / d) | a / b / (c / d) | a / b / (c / d) | a / b / (c / d)"})
    void arithmeticIsTheSameInEveryLanguage(String text, String python, String c, String modelica) {
        Expression expression = Expression.parse(text);
        assertEquals(List.of(python, c, modelica),
                List.of(Language.PYTHON.of(expression), Language.C.of(expression), Language.MODELICA.of(expression)));
    }

    @Test
    void arithmeticThatCannotBeReadIsRefused() {
        for (String text : List.of("a +", "(a", "a b", "exp(a", "a ? b")) {
            assertThrows(IllegalArgumentException.class, () -> Expression.parse(text), text);
        }
    }

    /** As many equations as unknowns, every word declared once, every equation's words declared. */
    @Test
    void modelicaIsBalanced() throws IOException {
        for (Model model : Cases.models()) {
            if (model.assembly().drives().stream().anyMatch(at -> at.drive() instanceof Drive.Late || at.drive() instanceof Drive.Swings)) {
                DataFault fault = assertThrows(DataFault.class, () -> ModelicaText.of(model), model.name());
                assertTrue(fault.getMessage().contains("--to python"), fault.getMessage());
                continue;
            }
            String text = ModelicaText.of(model);
            String[] parts = text.split("\nequation\n");
            String[] declarations = parts[0].split("\ninitial equation\n");
            Set<String> declared = new HashSet<>();
            int unknowns = 0;
            for (String line : declarations[0].split("\n")) {
                Matcher matcher = DECLARATION.matcher(line);
                if (matcher.matches()) {
                    assertTrue(declared.add(matcher.group(2)), model.name() + " declares twice: " + line);
                    unknowns += matcher.group(1) == null || matcher.group(1).equals("output ") ? 1 : 0;
                } else {
                    assertTrue(line.startsWith("model "), model.name() + ": " + line);
                }
            }
            List<String> equations = parts[1].lines().filter(line -> line.startsWith("  ")).toList();
            assertEquals(unknowns, equations.size(), model.name());
            List<String> initial = Arrays.stream(declarations).skip(1).flatMap(String::lines).toList();
            assertEquals(declarations[0].split("fixed = false", -1).length - 1, initial.size(), model.name());
            for (String equation : Stream.concat(initial.stream(), equations.stream()).toList()) {
                assertEquals(equation.chars().filter(c -> c == '(').count(), equation.chars().filter(c -> c == ')').count(), equation);
                for (String word : equation.split("[^A-Za-z0-9_.]+")) {
                    if (!word.isEmpty() && !Character.isDigit(word.charAt(0)) && !word.startsWith(".")) {
                        assertTrue(KNOWN.contains(word) || declared.contains(word),
                                model.name() + ": " + word + " is not declared in " + equation);
                    }
                }
            }
        }
    }

    @Test
    void mujocoHasTheModelsBodiesLinksAndSensors() throws Exception {
        for (Model model : Cases.models()) {
            Structure structure = model.assembly().structure();
            boolean inertance = model.assembly().laws().stream().anyMatch(at -> at.law() instanceof LearnedInertance);
            if (structure.held() || inertance) {
                DataFault fault = assertThrows(DataFault.class, () -> new MujocoText(model), model.name());
                assertTrue(fault.getMessage().contains("--to python"), fault.getMessage());
                continue;
            }
            Document xml = DocumentBuilderFactory.newInstance().newDocumentBuilder()
                    .parse(new ByteArrayInputStream(new MujocoText(model).xml().getBytes(StandardCharsets.UTF_8)));
            for (int b = 0; b < structure.bodies(); b++) {
                assertEquals(structure.mass()[b], number(xml, "inertial", b, "mass"), model.name());
            }
            for (int l = 0; l < structure.links(); l++) {
                assertEquals(structure.stiffness()[l], number(xml, "fixed", l, "stiffness"), model.name());
                assertEquals(structure.damping()[l], number(xml, "fixed", l, "damping"), model.name());
                Element tendon = (Element) xml.getElementsByTagName("fixed").item(l);
                assertEquals(structure.from()[l] < 0 ? 1 : 2, tendon.getElementsByTagName("joint").getLength(), model.name());
            }
            long moved = model.bodies().stream().filter(body -> body.sensor().isPresent()).count();
            assertEquals(moved, List.of("accelerometer", "jointvel", "jointpos").stream()
                    .mapToInt(tag -> xml.getElementsByTagName(tag).getLength()).sum());
        }
    }

    private static double number(Document xml, String tag, int index, String attribute) {
        return Double.parseDouble(((Element) xml.getElementsByTagName(tag).item(index)).getAttribute(attribute));
    }
}
