package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.law.BumpStop;
import wbv.body.law.HertzStop;
import wbv.body.law.Law;
import wbv.body.law.MuscleReflex;
import wbv.body.law.Reflex;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Mechanism;

class PhrasesTest {

    /** Which side a stop is on no number says. */
    @ParameterizedTest
    @CsvSource({"COMPRESSION, in compression", "EXTENSION, in extension", "BOTH, in compression and in extension"})
    void aStopIsToldWithItsSide(Law.Side side, String words) {
        for (Law law : List.of(new BumpStop(1e5, 2e-3, side), new HertzStop(1e6, 2e-3, side))) {
            assertEquals("The link seat-torso hits a stop " + words, clause(law));
        }
    }

    @Test
    void aMuscleIsToldWithTheWayItPulls() {
        assertTrue(clause(new MuscleReflex(1e3, 10, 0.08, 0.05, Law.Side.EXTENSION)).contains("pulls only, as it is extended"));
        assertTrue(clause(new MuscleReflex(1e3, 10, 0.08, 0.05, Law.Side.COMPRESSION)).contains("pushes only, as it is compressed"));
        assertEquals("Something at seat-torso answers late, as a muscle does", clause(new Reflex(1e3, 10, 0.08)));
    }

    private static String clause(Law law) {
        Mechanism kind = Library.standard().of(law.mechanism()).orElseThrow();
        Hypothesis found = new Hypothesis(kind, "seat-torso", "", List.of(new Addition.InLink(1, law)), List.of(), List.of());
        return Phrases.of(Library.standard(), new Diagnosis.Named(kind.word(), found.where(), 1, Map.of(), Map.of(), 1, 0,
                kind.form(found, Map.of(), () -> Double.NaN)));
    }

    @Test
    void whatIsNotAllToATenthOfAPercentIsNotSaidToBeAll() {
        assertEquals("100 %", Phrases.percent(1));
        assertEquals("100 %", Phrases.percent(0.9997));
        assertEquals("99.6 %", Phrases.percent(0.9958));
        assertEquals("88 %", Phrases.percent(0.884));
    }
}
