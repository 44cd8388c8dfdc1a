package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.learn.LawLearnerTest;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/** What sentences say beside their numbers. */
class VerdictWordsTest {

    private static Evidence evidence;
    private static Fitter.State plain;

    @BeforeAll
    static void fitted() {
        evidence = new Evidence(LawLearnerTest.model(List.of()),
                LawLearnerTest.recording(new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 2e8)));
        Candidate baseline = Baseline.of(evidence);
        Fitter fitter = new Fitter(evidence);
        plain = fitter.lookWithSlopes(baseline, baseline.start(), fitter.look(baseline, baseline.start(), evidence.fit()).frame());
    }

    /** The base, as if it left so much. */
    private static Fits fits(double reduced) {
        Fitter.State base = new Fitter.State(plain.candidate(), plain.x(), plain.cost(), reduced * plain.frame().whitening().degrees(),
                plain.raw(), plain.errors(), plain.slopes(), plain.frame());
        return new Fits(evidence, base, base, Chosen.single(base), List.of());
    }

    private static Diagnosis.Named named(String mechanism, double probability, double reduced) {
        return new Diagnosis.Named(mechanism, "a-b", probability, Map.of(), Map.of(), reduced);
    }

    private static String ambiguous(double base, Diagnosis.Named... rivals) {
        return new VerdictWords(fits(base), base, new MassScale(1, 0)).sentence(Diagnosis.Verdict.AMBIGUOUS,
                List.of(named("stiffness.softening", 0.5, 2)), List.of(rivals), ".", false);
    }

    @Test
    void theRivalThatExplainsAboutAsMuchIsTheOther() {
        assertTrue(ambiguous(21, named("hysteresis", 0.4, 3)).endsWith(". The recording does not tell the two apart."));
    }

    @Test
    void aRivalThatExplainsNothingIsNotHeldAgainstIt() {
        String sentence = ambiguous(21, named("contact.bumpstop", 0.3, 20.95));
        assertFalse(sentence.contains("two apart"), sentence);
        assertTrue(sentence.endsWith("No other name explains any of it, and this one leaves too much to be sure."), sentence);
    }

    /** Nor is an experiment advised against it: the first level again, for a change in time that takes 0 % of the mismatch. */
    @Test
    void nothingNeedSettleARivalThatExplainsNothing() {
        Diagnosis.Named drift = named("drift.slow", 0.01, 20.95);
        Diagnosis.Named yielding = named("hysteresis", 0.01, 6);
        VerdictWords loud = new VerdictWords(fits(21), 21, new MassScale(1, 0));
        assertEquals(List.of(yielding), loud.shown(List.of(drift, yielding)).toList());
        assertFalse(advised(loud, drift).contains("A-B-A"));
        VerdictWords quiet = new VerdictWords(fits(1.02), 1, new MassScale(1, 0));
        assertTrue(advised(quiet, drift).contains("A-B-A"), "where noise is all that is left nobody explains any");
    }

    private static String advised(VerdictWords words, Diagnosis.Named rival) {
        return new Experiments(Library.standard()).between(List.of(named("stiffness.softening", 0.99, 2)),
                words.shown(List.of(rival)).toList(), Set.of(), false, false);
    }

    @Test
    void theNearestRivalIsNamedWithWhatItExplains() {
        String sentence = ambiguous(21, named("contact.bumpstop", 0.3, 20.95), named("hysteresis", 0.2, 6));
        assertTrue(sentence.endsWith("The recording does not tell it from hysteresis at a-b, which explains 75 %."), sentence);
    }

    @Test
    void anUnlikelyRivalIsNone() {
        String sentence = ambiguous(21, named("contact.bumpstop", 0.3, 20.95), named("hysteresis", 1e-4, 6));
        assertFalse(sentence.contains("hysteresis"), sentence);
    }

    /** How a sentence ends beside a rival of so much probability whose numbers lie so much nearer to what was given [nat]. */
    private static String ending(double probability, double nearer) {
        Diagnosis.Named rival = new Diagnosis.Named("hysteresis", "a-b", probability, Map.of(), Map.of(), 6, nearer - 20);
        return new VerdictWords(fits(21), 21, new MassScale(1, 0)).ending(0.9, -20, List.of(rival));
    }

    @Test
    void whatTheNumbersSayOfARivalIsToldWhereItDecides() {
        String beside = "; explains 90 % of the mismatch; next best hysteresis at a-b, 75 %";
        assertEquals(beside + ", with stiffness or damping nearer to what was given.", ending(0.45, 10));
        assertEquals(beside + ", with stiffness or damping far from what was given.", ending(1e-4, -10));
        assertEquals(beside + ".", ending(1e-4, 10));
        assertEquals(beside + ".", ending(0.45, 1));
    }

    @Test
    void aFormThatTakesNothingIsNotTold() {
        Fits fits = fits(21);
        Refinement refinement = new Search(evidence, (step, share) -> {}).refinement();
        double held = refinement.heldOut(fits.best());
        Diagnosis bare = new Diagnosis(Diagnosis.Verdict.MISSING_PHYSICS, "It softens.", List.of(),
                List.of(named("stiffness.softening", 1, 2)),
                List.of(), "", new Diagnosis.Fit(21, 21, 2, 21, 2, new double[] {1, 2}, List.of(), List.of(), Map.of()), List.of(),
                evidence.model(), Optional.empty());
        assertEquals(Optional.empty(), new LearnedVerdict(fits, 21, refinement).corrected(bare, held, List.of()));
    }

    @Test
    void noiseIsNoMoreThanWhatIsLeft() {
        Diagnosis.Ranged before = new Diagnosis.Ranged(0.2, Double.NaN, Double.NaN);
        Diagnosis.Ranged after = new Diagnosis.Ranged(0.011, Double.NaN, Double.NaN);
        assertEquals("at most 1.1 % is noise",
                new Diagnosis.Proof("a.acc.z", new double[] {0, 50}, 1, before, after, 0.021, after).noise());
        assertEquals("  0.9 % is noise", new Diagnosis.Proof("a.acc.z", new double[] {0, 50}, 1, before, after, 0.009, after).noise());
    }
}
