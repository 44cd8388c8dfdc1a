package wbv.diagnosis.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import wbv.body.law.Learned;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.LearnedForce;
import wbv.diagnosis.mechanism.Start;

class VocabularyTest {

    /** Closed form: all choices of one term together are one. */
    @Test
    void theProbabilitiesOfAllTermsAddUpToOne() {
        List<Hypothesis> all = Stream.of("|r|", "v^2", "sign(v)").flatMap(shape -> Stream.of(term(shape, Modulator.NONE),
                term(shape, new Modulator.Ride(1)), term(shape, new Modulator.Ride(2)))).toList();
        Vocabulary words = Vocabulary.of(35, all);
        assertEquals(3, words.plain());
        assertEquals(1, all.stream().mapToDouble(term -> Math.exp(-words.price(term))).sum(), 1e-12);
        List<Hypothesis> plain = all.stream().filter(term -> term.form().equals("|r|")).toList();
        assertEquals(0, Vocabulary.of(35, plain).price(plain), 1e-12);
    }

    /** What something else multiplies is one of many more words. */
    @Test
    void aPlainTermIsLikelier() {
        Vocabulary words = new Vocabulary(35, 84, 2000);
        assertEquals(Math.log(2000.0 / 84), words.price(term("v^2", new Modulator.Ride(1))) - words.price(term("v^2", Modulator.NONE)),
                1e-12);
        assertThrows(IllegalArgumentException.class, () -> new Vocabulary(35, 0, 3));
    }

    private static Hypothesis term(String shape, Modulator modulator) {
        Learned law = new LearnedTerm(Shape.parse(shape), modulator, 1);
        return new Hypothesis(new LearnedForce(), "platform-seat", Terms.words(law), List.of(new Addition.InLink(0, law)),
                List.of(new Hypothesis.Number("coefficient", 1, -9, 9)), List.of(Start.scaled(1)));
    }
}
