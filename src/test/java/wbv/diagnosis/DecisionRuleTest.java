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
            case 'v' -> Claim.VALUES;
            case 'e' -> Claim.UNKNOWN;
            default -> Claim.named(word);
        };
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            v 0.6 e 0.4 | v
            v 0.5 f 0.5 | v
            v 0.49 f 0.51 | f,v
            f 0.9 e 0.1 | f
            f 0.899 h 0.101 | f,h
            f 0.5 h 0.4 s 0.1 | f,h
            f 0.4 h 0.3 s 0.2 q 0.1 | f,h,s
            e 0.5 f 0.5 | e
            f 0.55 e 0.45 | f,e
            f 0.8 a 0.05 b 0.05 c 0.05 d 0.05 | f
            f 0.6 h 0.2 a 0.06 b 0.06 c 0.04 d 0.04 | f,h
            e 0.97 f 0.03 | e
            f+h 0.95 f 0.05 | f+h
            """)
    void aPosteriorIsReadAsItStands(String posterior, String claims) {
        Map<Claim, Double> all = new LinkedHashMap<>();
        String[] words = posterior.trim().split(" ");
        for (int i = 0; i < words.length; i += 2) {
            all.put(claim(words[i]), Double.parseDouble(words[i + 1]));
        }
        DecisionRule.Reading reading = DecisionRule.read(new Posterior(all));
        assertEquals(java.util.Arrays.stream(claims.split(",")).map(DecisionRuleTest::claim).toList(), reading.claims());
    }

    @Test
    void evidenceTurnsThePrior() {
        Claim friction = claim("f");
        List<Posterior.Weighed> weighed = List.of(new Posterior.Weighed(Claim.VALUES, 0.5, -100),
                new Posterior.Weighed(friction, 0.02, -94),
                new Posterior.Weighed(friction, 0.02, -94), new Posterior.Weighed(claim("e"), 0, 1000));
        double plain = 0.04 * Math.exp(6) / (0.5 + 0.04 * Math.exp(6));
        assertEquals(plain, Posterior.of(weighed).of(friction), 1e-12);
        assertEquals(0, Posterior.of(weighed).of(claim("e")));
        assertThrows(IllegalArgumentException.class, () -> new Posterior(Map.of(friction, 0.9)));
    }

    @Test
    void aReadingKnowsHowManyOfItsClaimsAreNames() {
        DecisionRule.Reading mixed = DecisionRule.read(new Posterior(Map.of(claim("f"), 0.55, claim("e"), 0.45)));
        assertEquals(1, mixed.names());
        assertEquals(false, mixed.isUnknown());
        assertEquals(false, mixed.isName());
        assertEquals(true, DecisionRule.read(new Posterior(Map.of(claim("f"), 0.9, claim("e"), 0.1))).isName());
        assertEquals(false, DecisionRule.read(new Posterior(Map.of(claim("v"), 1.0))).isName());
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
