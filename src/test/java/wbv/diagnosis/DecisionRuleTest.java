package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Posteriors made by hand, and what is read off them. */
class DecisionRuleTest {

    private static Claim claim(String word) {
        return switch (word.charAt(0)) {
            case 'n' -> Claim.NOTHING;
            case 'v' -> Claim.VALUES;
            case 'e' -> Claim.elseAt(word, "");
            default -> Claim.named(word);
        };
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            n 0.6 v 0.4                        | NOTHING_MISSING | n          | 1.0
            v 0.5 f 0.5                        | PARAMETERS_ONLY | v          | 0.5
            n 0.3 v 0.25 f 0.45                | NOTHING_MISSING | n          | 0.55
            n 0.25 v 0.24 f 0.51               | AMBIGUOUS       | f,n,v      | 1.0
            f 0.9 e1 0.1                       | MISSING_PHYSICS | f          | 0.9
            f 0.899 h 0.101                    | AMBIGUOUS       | f,h        | 1.0
            f 0.5 h 0.4 s 0.1                  | AMBIGUOUS       | f,h        | 0.9
            f 0.4 h 0.3 s 0.2 q 0.1            | AMBIGUOUS       | f,h,s      | 0.9
            e1 0.3 e2 0.2 f 0.5                | SOMETHING_ELSE  | e1,e2      | 0.5
            f 0.55 e1 0.45                     | AMBIGUOUS       | f,e1       | 1.0
            f 0.8 a 0.05 b 0.05 c 0.05 d 0.05  | MISSING_PHYSICS | f          | 0.8
            f 0.6 h 0.2 a 0.06 b 0.06 c 0.04 d 0.04 | AMBIGUOUS  | f,h        | 0.8
            e1 0.97 f 0.03                     | SOMETHING_ELSE  | e1         | 0.97
            f+h 0.95 f 0.05                    | MISSING_PHYSICS | f+h        | 0.95
            """)
    void aPosteriorIsReadAsItStands(String posterior, DecisionRule.Verdict verdict, String claims, double probability) {
        Map<Claim, Double> all = new LinkedHashMap<>();
        String[] words = posterior.trim().split(" ");
        for (int i = 0; i < words.length; i += 2) {
            all.put(claim(words[i]), Double.parseDouble(words[i + 1]));
        }
        DecisionRule.Reading reading = DecisionRule.read(new Posterior(all));
        assertEquals(verdict, reading.verdict());
        assertEquals(java.util.Arrays.stream(claims.split(",")).map(DecisionRuleTest::claim).toList(), reading.claims());
        assertEquals(probability, reading.probability(), 1e-12);
    }

    @Test
    void evidenceTurnsThePriorAndTemperatureCoolsIt() {
        Claim friction = claim("f");
        List<Posterior.Weighed> weighed = List.of(new Posterior.Weighed(Claim.VALUES, 0.5, -100),
                new Posterior.Weighed(friction, 0.02, -94),
                new Posterior.Weighed(friction, 0.02, -94), new Posterior.Weighed(claim("e"), 0, 1000));
        double plain = 0.04 * Math.exp(6) / (0.5 + 0.04 * Math.exp(6));
        double cooled = 0.04 * Math.exp(2) / (0.5 + 0.04 * Math.exp(2));
        assertEquals(plain, Posterior.of(weighed, 1).of(friction), 1e-12);
        assertEquals(cooled, Posterior.of(weighed, 3).of(friction), 1e-12);
        assertEquals(0, Posterior.of(weighed, 1).of(claim("e")));
        assertThrows(IllegalArgumentException.class, () -> Posterior.of(weighed, 0));
        assertThrows(IllegalArgumentException.class, () -> new Posterior(Map.of(friction, 0.9)));
    }

    @Test
    void aReadingKnowsHowManyOfItsClaimsAreNames() {
        DecisionRule.Reading mixed = DecisionRule.read(new Posterior(Map.of(claim("f"), 0.55, claim("e"), 0.45)));
        assertEquals(1, mixed.names());
        assertEquals(false, mixed.isUnknown());
        assertEquals(true, DecisionRule.read(new Posterior(Map.of(claim("e"), 1.0))).isUnknown());
    }

    /** Claims that are as likely stand in one order, whatever the order in which they were weighed. */
    @Test
    void whatIsAsLikelyStandsInOneOrder() {
        Map<Claim, Double> one = new LinkedHashMap<>();
        List.of("f", "h", "s", "v").forEach(word -> one.put(claim(word), 0.25));
        Map<Claim, Double> other = new LinkedHashMap<>();
        List.of("s", "v", "h", "f").forEach(word -> other.put(claim(word), 0.25));
        assertEquals(List.of(Claim.VALUES, claim("f"), claim("h"), claim("s")), new Posterior(one).ranked());
        assertEquals(new Posterior(one).ranked(), new Posterior(other).ranked());
    }

    @Test
    void aPartMayBelongToOneClaimWhateverTheEvidence() {
        Posterior all = new Posterior(Map.of(claim("f"), 0.9, claim("e"), 0.1)).but(0.2, claim("e"));
        assertEquals(0.72, all.of(claim("f")), 1e-12);
        assertEquals(0.28, all.of(claim("e")), 1e-12);
    }
}
