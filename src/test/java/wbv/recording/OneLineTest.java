package wbv.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class OneLineTest {

    @Test
    void cleanTextStaysAsItIs() {
        String text = "ride.csv:7: größer als 9 m/s²; نشسته stays, and so does a zero-width joiner: می‌نشیند";
        assertSame(text, OneLine.of(text));
    }

    @Test
    void controlCharactersAreShown() {
        assertEquals("a\\nb \\u001b[31mred\\u0000 \\t c\\u2028d\\u009b", OneLine.of("a\nb \u001b[31mred\0 \t c\u2028d\u009b"));
    }

    @Test
    void longWordsAndLongLinesKeepBothEnds() {
        String word = OneLine.of("x.csv:3: '" + "[".repeat(5000) + "' is no channel");
        assertTrue(word.startsWith("x.csv:3: '[[") && word.endsWith("[' is no channel"), word);
        assertTrue(word.length() < 300, word);
        String line = OneLine.of("x.csv:3: " + "several words ".repeat(1000) + "mend it");
        assertTrue(line.startsWith("x.csv:3: several") && line.endsWith("mend it"), line);
        assertEquals(OneLine.LONGEST, line.length());
    }

    @Test
    void aFaultThatKnowsItsFileKeepsItAndOthersAreTold() {
        assertEquals("a.csv:2: wrong", DataFault.at("a.csv", 2, "wrong").of("b.csv").getMessage());
        assertEquals("b.csv: wrong", new DataFault("wrong").of("b.csv").getMessage());
        assertEquals("b.csv: wrong\\nmore", new DataFault("wrong\nmore").of("b.csv").of("c.csv").getMessage());
    }
}
