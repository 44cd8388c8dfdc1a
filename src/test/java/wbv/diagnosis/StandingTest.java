package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.learn.LawLearnerTest;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Priors;

/** What fits leave, as probabilities: by hand. */
class StandingTest {

    private static final Calibration CALIBRATION = Calibration.standard();
    private static final double POWER = CALIBRATION.forms() / 2;
    private static final double HELD = 1 - CALIBRATION.lapse();
    private static Evidence evidence;
    private static Fitter.State base;
    private static List<Hypothesis> all;

    @BeforeAll
    static void fitted() {
        evidence = new Evidence(LawLearnerTest.model(List.of()),
                LawLearnerTest.recording(new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 3e8)));
        Candidate baseline = Baseline.of(evidence);
        base = new Fitter(evidence).look(baseline, baseline.start(), evidence.fit());
        all = Library.standard()
                .hypotheses(
                        FittedScene.of(evidence, baseline.at(baseline.start()), Motion.measured(evidence, baseline.at(baseline.start()))));
    }

    /** A fit with a mechanism that leaves so much. @param at which hypothesis of the library */
    private static Fitter.State leaving(double reduced, Optional<Hypothesis> at) {
        return leaving(at.map(base.candidate()::with).orElse(base.candidate()), reduced);
    }

    private static Fitter.State leaving(Candidate candidate, double reduced) {
        return new Fitter.State(candidate, candidate.start(), base.cost(), reduced * base.frame().whitening().degrees(), base.raw(),
                base.errors(), base.slopes(), base.frame());
    }

    private static Optional<Hypothesis> mechanism(String word) {
        return all.stream().filter(hypothesis -> hypothesis.mechanism().equals(word)).findFirst();
    }

    private static Standing standing(double without, double with, double rival) {
        Fitter.State found = leaving(with, mechanism("stiffness.hardening"));
        Fitter.State plain = leaving(without, Optional.empty());
        return new Standing(
                new Fits(evidence, plain, plain, Chosen.single(found), List.of(found, leaving(rival, mechanism("friction.coulomb")))));
    }

    @Test
    void evidenceGoesAsAPowerOfWhatIsLeft() {
        // 10 without it, 0.5 with it, 1 with its rival; what is in no library leaves 2.8.
        double expected = HELD / (1 + Math.pow(0.5, POWER) + Math.pow(0.5 / 2.8, POWER) + Math.pow(0.05, POWER));
        Standing standing = standing(11, 1.5, 2);
        assertEquals(expected, standing.probability(), 1e-12);
        assertTrue(standing.reading().isName());
        assertEquals(expected * Math.pow(0.5, POWER), standing.rivals(1).get(0).probability(), 1e-12);
        assertEquals("friction.coulomb", standing.rivals(1).get(0).mechanism());
    }

    @Test
    void twoThatLeaveTheSameAreASet() {
        Standing standing = standing(11, 1.5, 1.5);
        assertEquals(0.5, standing.probability(), 0.02);
        assertEquals(2, standing.reading().names());
    }

    @Test
    void aNameThatLeavesMuchIsNoName() {
        assertEquals(List.of(Claim.UNKNOWN), standing(11, 4.5, 9).reading().claims(), "a third is left");
        assertTrue(standing(11, 2.5, 9).reading().isName(), "a seventh is left");
    }

    @Test
    void nearTheNoiseNothingIsSure() {
        Standing standing = standing(1.08, 1.02, 1.05);
        assertFalse(standing.reading().isName());
        // The noise is the same for both: what one leaves more than the other is no chance.
        assertEquals(1, standing(7.5, 1.01, 1.12).reading().names());
    }

    /** Two where one leaves 1.5 and both leave 1.1: 20 to the power of what counts, less the choice among 50. */
    @Test
    void aSecondPartPaysForItsChoice() {
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State single = leaving(3, mechanism("stiffness.hardening"));
        Candidate two = single.candidate().with(mechanism("sensor.clipping").orElseThrow());
        Fitter.State both = new Fitter.State(two, two.start(), base.cost(), 1.1 * base.frame().whitening().degrees(), base.raw(),
                base.errors(), base.slopes(), base.frame());
        double price = Math.log(50);
        Standing standing = new Standing(new Fits(evidence, plain, plain, new Chosen(both, price), List.of(single)));
        double alone = Math.pow(0.1 / 2, POWER);
        double expected = HELD / 50 / (1.0 / 50 + alone + Math.pow(0.1 / 2.8, POWER) + Math.pow(0.1 / 10, POWER));
        assertEquals(expected, standing.probability(), 1e-12);
        assertEquals(expected, standing.probability(two.last()), 1e-12);
        // That the second is not there leaves the first.
        assertEquals(expected * (1 + 50 * alone), standing.probability(single.candidate().last()), 1e-12);
        assertTrue(standing.reading().isName());
        Chosen one = Chosen.single(single);
        assertTrue(new Chosen(both, price).outweighs(1.1, one, 3));
        assertTrue(!new Chosen(both, price).outweighs(3.1, one, 3), "what does worse on data not used is no part");
        assertTrue(new Chosen(both, price).outweighs(0.98, one, 0.97), "but for noise, of which one leaves a little more by chance");
        assertTrue(new Chosen(both, price).outweighs(2.5, one, 3), "a quiet stretch shows less of it");
        assertTrue(!new Chosen(both, POWER * Math.log(20) + 1e-9).outweighs(1.1, one, 3)
                && new Chosen(both, POWER * Math.log(20) - 1e-9).outweighs(1.1, one, 3));
    }

    /** Two that were found give way to one that leaves far less, and not to one that is less likely. */
    @Test
    void twoThatAreNoPartOfTheAnswerGiveWayToOne() {
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State other = leaving(1.1, mechanism("friction.coulomb"));
        assertEquals(other, given(plain, 5, other).fits().best());
        assertEquals(2, given(plain, 1.1, leaving(2.5, mechanism("friction.coulomb"))).fits().best().candidate().added().size());
    }

    /** @param left by two together */
    private static Standing given(Fitter.State plain, double left, Fitter.State other) {
        Candidate two = base.candidate().with(mechanism("stiffness.hardening").orElseThrow())
                .with(mechanism("sensor.clipping").orElseThrow());
        Fitter.State both = new Fitter.State(two, two.start(), base.cost(), left * base.frame().whitening().degrees(), base.raw(),
                base.errors(), base.slopes(), base.frame());
        return Standing.of(new Fits(evidence, plain, plain, new Chosen(both, Math.log(50)), List.of(other)));
    }

    /** Play fits a little better than hardening, but with a spring three times as stiff as given. */
    @Test
    void theModelsNumbersDecideBetweenWhatFitsAlike() {
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State hardening = leaving(1.52, mechanism("stiffness.hardening"));
        Fitter.State straight = leaving(1.5, mechanism("contact.backlash"));
        Fitter.State play = at(straight, straight.candidate().stiffness(0).orElseThrow(), Math.log(3));
        double costs = Math.log1p(Math.pow(Math.log(3) / Priors.NUMBER, 2));
        Standing standing = Standing.of(new Fits(evidence, plain, plain, Chosen.single(play), List.of(play, hardening)));
        assertEquals(hardening, standing.fits().best());
        assertEquals(0, standing.numbers());
        assertTrue(standing.reading().isName());
        Diagnosis.Named rival = standing.rivals(1).get(0);
        assertEquals("contact.backlash", rival.mechanism());
        assertEquals(-costs, rival.numbers(), 0.05 * costs, "the data tell the stiffness well");
        assertEquals(POWER * Math.log(0.52 / 0.5) + rival.numbers(), Math.log(rival.probability() / standing.probability()), 1e-9);
        // Alike in both, it decides nothing.
        assertEquals(straight,
                Standing.of(new Fits(evidence, plain, plain, Chosen.single(straight), List.of(straight, hardening))).fits().best());
    }

    /** What the model's numbers speak for is not the answer where it foretells nothing of the data that were not used. */
    @Test
    void numbersDoNotDecideAgainstDataNotUsed() {
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State straight = leaving(1.5, mechanism("contact.backlash"));
        Fitter.State play = at(straight, straight.candidate().stiffness(0).orElseThrow(), Math.log(3));
        Fitter.State hardening = leaving(1.52, mechanism("stiffness.hardening"));
        Fitter.State wild = at(hardening, hardening.candidate().positions(hardening.candidate().last())[0], 1e6);
        Fits fits = new Fits(evidence, plain, plain, Chosen.single(play), List.of(play, wild));
        assertEquals(hardening, Standing.of(new Fits(evidence, plain, plain, Chosen.single(play), List.of(play, hardening))).fits().best());
        assertEquals(play, Standing.of(fits).fits().best());
        assertTrue(fits.isLikelier(hardening, 2) && !fits.isLikelier(hardening, -1000) && !fits.isLikelier(wild, 1000));
    }

    /** A pair whose play needs a spring three times as stiff gives way to one with hardening; what both share is as sure as both. */
    @Test
    void theModelsNumbersDecideWhatAPartOfAPairIs() {
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State straight = both("contact.backlash", 1.5);
        Fitter.State play = at(straight, straight.candidate().stiffness(0).orElseThrow(), Math.log(3));
        Fitter.State hardening = both("stiffness.hardening", 1.52);
        double price = Math.log(50);
        Standing standing = Standing.of(new Fits(evidence, plain, plain, new Chosen(play, price), List.of(hardening, play)));
        assertEquals(hardening, standing.fits().best());
        assertEquals(price, standing.fits().price());
        Diagnosis.Named rival = standing.rivals(1).get(0);
        assertEquals("contact.backlash", rival.mechanism());
        assertEquals(standing.probability() + rival.probability(), standing.probability(mechanism("sensor.clipping").orElseThrow()), 1e-12);
        assertEquals(standing.probability(), standing.probability(mechanism("stiffness.hardening").orElseThrow()), 1e-12);
        // In whatever order they were added.
        Fitter.State turned = leaving(1.5, mechanism("sensor.clipping"));
        Candidate two = turned.candidate().with(mechanism("stiffness.hardening").orElseThrow());
        assertEquals(Standing.claim(hardening), Standing.claim(leaving(two, 1.5)));
    }

    /** A second part that is bought with a spring three times as stiff, and explains little, is none; nor is the pair a rival then. */
    @Test
    void aPartStaysAloneWhereTheNumbersSpeakAgainstTheOther() {
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State alone = leaving(1.52, mechanism("stiffness.hardening"));
        Fitter.State straight = both("stiffness.hardening", 1.5);
        Fitter.State bent = at(straight, straight.candidate().stiffness(0).orElseThrow(), Math.log(3));
        Standing standing = Standing.of(new Fits(evidence, plain, plain, new Chosen(bent, 0.1), List.of(alone, bent)));
        assertEquals(alone, standing.fits().best());
        assertEquals(List.of(), standing.rivals(1));
        assertEquals(0, standing.fits().price());
    }

    private static Fitter.State both(String word, double left) {
        return leaving(base.candidate().with(mechanism(word).orElseThrow()).with(mechanism("sensor.clipping").orElseThrow()), left);
    }

    private static Fitter.State at(Fitter.State state, int number, double value) {
        double[] x = state.x().clone();
        x[number] = value;
        return new Fitter.State(state.candidate(), x, state.cost(), state.square(), state.raw(), state.errors(), state.slopes(),
                state.frame());
    }

    /** Rivals share what the first leaves them, in proportion; the found mechanism is none of them, however often it was fitted. */
    @Test
    void rivalsHoldNoMoreThanIsLeftForThem() {
        Fitter.State found = leaving(1.5, mechanism("stiffness.hardening"));
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State worse = leaving(2.5, mechanism("stiffness.hardening"));
        Standing standing = new Standing(new Fits(evidence, plain, plain, Chosen.single(found),
                List.of(found, worse, leaving(2, mechanism("friction.coulomb")), leaving(3, mechanism("damping.quadratic")))));
        List<Diagnosis.Named> free = standing.rivals(1);
        assertEquals(List.of("friction.coulomb", "damping.quadratic"), free.stream().map(Diagnosis.Named::mechanism).toList());
        double sum = free.stream().mapToDouble(Diagnosis.Named::probability).sum();
        List<Diagnosis.Named> held = standing.rivals(sum / 4);
        assertEquals(sum / 4, held.stream().mapToDouble(Diagnosis.Named::probability).sum(), 1e-12);
        assertEquals(free.get(0).probability() / 4, held.get(0).probability(), 1e-12);
        assertEquals(0.95, standing.explained(), 1e-12);
    }

    /** Neither part of a pair is a rival of the pair. */
    @Test
    void partsAreNoRivals() {
        Fitter.State plain = leaving(11, Optional.empty());
        Fitter.State hardening = leaving(3, mechanism("stiffness.hardening"));
        Fitter.State clipping = leaving(4, mechanism("sensor.clipping"));
        Candidate two = hardening.candidate().with(mechanism("sensor.clipping").orElseThrow());
        Fitter.State both = new Fitter.State(two, two.start(), base.cost(), 1.1 * base.frame().whitening().degrees(), base.raw(),
                base.errors(), base.slopes(), base.frame());
        Standing standing = new Standing(new Fits(evidence, plain, plain, new Chosen(both, 1),
                List.of(hardening, clipping, leaving(5, mechanism("friction.coulomb")))));
        assertEquals(List.of("friction.coulomb"), standing.rivals(1).stream().map(Diagnosis.Named::mechanism).toList());
    }

    /** What explains more by itself is said first; what was never fitted alone comes last. */
    @Test
    void partsAreRankedByWhatTheyExplainAlone() {
        Fitter.State hardening = leaving(3, mechanism("stiffness.hardening"));
        Fitter.State friction = leaving(4, mechanism("friction.coulomb"));
        Fitter.State plain = leaving(11, Optional.empty());
        Standing standing = new Standing(new Fits(evidence, plain, plain, Chosen.single(hardening), List.of(hardening, friction)));
        assertEquals(0, standing.rankAlone(mechanism("stiffness.hardening").orElseThrow()));
        assertEquals(1, standing.rankAlone(mechanism("friction.coulomb").orElseThrow()));
        assertEquals(2, standing.rankAlone(mechanism("damping.quadratic").orElseThrow()));
        assertEquals(0, new Standing(new Fits(evidence, plain, plain, plain, 0, List.of(hardening))).probability(), "nothing was found");
    }

    /** A part pays its own price and no more: of two pairs that cost alike only what they leave counts. */
    @Test
    void whatBothPayDoesNotCount() {
        Fitter.State single = leaving(3, mechanism("stiffness.hardening"));
        Fitter.State better = leaving(2.9, mechanism("friction.coulomb"));
        assertTrue(new Chosen(better, 5).outweighs(2.9, new Chosen(single, 5), 3));
        assertTrue(!new Chosen(better, 5).outweighs(2.9, Chosen.single(single), 3));
        assertTrue(!new Chosen(better, 0).outweighs(3, Chosen.single(single), 3), "as good on data not used is not better");
        Fits fits = new Fits(evidence, base, base, new Chosen(better, 5), List.of(single));
        assertEquals(new Chosen(better, 5), fits.chosen());
        assertEquals(single, fits.with(single).best());
    }
}
