package wbv.diagnosis.learn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.LawAt;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.law.CubicSpring;
import wbv.body.law.Law;
import wbv.body.law.Learned;
import wbv.body.law.LearnedInertance;
import wbv.body.law.LearnedKnee;
import wbv.body.law.LearnedMemory;
import wbv.body.law.LearnedTable;
import wbv.body.law.LearnedTerm;
import wbv.body.law.LearnedWave;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.Search;
import wbv.diagnosis.search.Whereabouts;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/**
 * A law that no mechanism of the library is comes out as it was put in. The exam with laws from another hand is
 * {@code wbv prove --only open}.
 */
public class LawLearnerTest {

    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final Channel SWAY = Channel.parse("head.acc.x");
    private static final double RATE = 60;
    private static final double SECONDS = 60;
    private static final double NOISE = 0.02;

    static Stream<Learned> laws() {
        return Stream.of(new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 3e8),
                new LearnedTerm(Shape.SPEED, new Modulator.Measured(SWAY), 350),
                new LearnedMemory(Shape.parse("|v|v"), Shape.ONE, Modulator.NONE, 9000, 0.08),
                new LearnedKnee(Shape.SPEED, Law.Side.EXTENSION, Modulator.NONE, 700, 0.03), new LearnedInertance(4),
                new LearnedTerm(Shape.DEFLECTION, Modulator.parse("negative part of the load of link 2"), 2500),
                new Learned.Thinning(4000, 0.7, 0.005), new Learned.Thinning(8000, 1, 0.01), new Learned.Thinning(3000, 2, 0.02));
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("laws")
    void theTermThatWasPutInIsLearned(Learned law) {
        Recording recording = recording(law);
        Evidence evidence = new Evidence(model(List.of()), recording);
        Search search = new Search(evidence, (step, share) -> {});
        Candidate baseline = Baseline.of(evidence);
        Fitter.State base = search.base(baseline);
        LawLearner learner = new LawLearner(evidence, search, base, new Locator(evidence, baseline).singles(base.x()));
        List<Sentence> sentences = learner.sentences(base);
        Sentence best = learner.law(sentences, Chosen.single(base)).orElseThrow();
        String found = LearnedWords.of(evidence.model(), best.fit());
        List<Learned> terms = best.fit().candidate().at(best.fit().x()).laws().stream().map(at -> (Learned) at.law()).toList();
        assertEquals(1, terms.size(), found);
        assertEquals(law.kind() + law.modulator(), terms.get(0).kind() + terms.get(0).modulator(), found);
        assertEquals(1, terms.get(0).coefficient() / law.coefficient(), 0.15, found);
        assertEquals("platform-torso", best.fit().candidate().last().where());
    }

    @Tag("slow")
    @Test
    void whereTheLibraryHasNothingTheLawIsTheAnswer() {
        Diagnosis diagnosis = Diagnoser.diagnose(model(List.of()), recording(new LearnedWave(Shape.DEFLECTION, 9000, 14000, 0.23)),
                (step, share) -> {});
        assertEquals(Diagnosis.Verdict.LEARNED_LAW, diagnosis.verdict(), diagnosis.sentence());
        assertEquals(Learned.MECHANISM, diagnosis.missing().get(0).mechanism());
        assertEquals("platform-torso", diagnosis.missing().get(0).where());
        assertTrue(diagnosis.learned().orElseThrow().formula().contains("r × cos(2π · 0.23"), diagnosis.sentence());
        assertTrue(diagnosis.fit().heldAfter() < 1.2, "left " + diagnosis.fit().heldAfter());
        // What is written simulates.
        Model written = ModelFile.parse(ModelFile.text(diagnosis.model()), "model.json");
        assertEquals(diagnosis.learned().orElseThrow().terms(), written.links().get(0).laws());
        assertTrue(diagnosis.missing().get(0).intervals().keySet().stream().allMatch(key -> key.contains("of r × wave")),
                "" + diagnosis.missing());
    }

    /** One law at one place does what the likeliest name does not; beside a right name there is none. */
    @Tag("slow")
    @Test
    void oneLawTakesThePlaceOfTwoNames() {
        assertTrue(isOne(new LearnedWave(Shape.DEFLECTION, 9000, 14000, 0.23)));
        assertFalse(isOne(new CubicSpring(2e9)));
    }

    private static boolean isOne(Law law) {
        Evidence evidence = new Evidence(model(List.of()), recording(law));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        return LawLearner.isOne(evidence, base, search.best(base, Whereabouts.found(evidence, base)).orElseThrow());
    }

    /** Beside a right name no term promises anything; beside one that only looks like the law, to first order, the law does. */
    @Test
    void besideARightNameNothingIsPromised() {
        assertFalse(promises(new CubicSpring(2e9), "stiffness.hardening"));
        assertTrue(promises(new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 3e8), "damping.quadratic"));
    }

    private static boolean promises(Law law, String name) {
        Evidence evidence = new Evidence(model(List.of()), recording(law));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        Fitter.State named = search.best(base, Whereabouts.anywhere(evidence, base.candidate())
                .only(hypothesis -> hypothesis.where().equals("platform-torso") && hypothesis.mechanism().equals(name))).orElseThrow();
        return new LawLearner(evidence, search, named, List.of()).promises();
    }

    /** The library has damping that grows with speed, which looks like damping that grows with deflection and leaves much of it. */
    @Tag("slow")
    @Test
    void aNameThatLeavesMuchGivesWayToALaw() {
        Diagnosis diagnosis = Diagnoser.diagnose(model(List.of()), recording(new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 3e8)),
                (step, share) -> {});
        assertEquals(Diagnosis.Verdict.LEARNED_LAW, diagnosis.verdict(), diagnosis.sentence());
        assertTrue(diagnosis.learned().orElseThrow().formula().endsWith("r^2 v"), diagnosis.sentence());
        // What it was taken for at first is a rival, no likelier than what is left.
        double rest = 1 - diagnosis.missing().get(0).probability();
        assertTrue(diagnosis.alternatives().stream().allMatch(rival -> rival.probability() <= rest + 1e-12), "" + diagnosis.alternatives());
    }

    /**
     * A bench whose spring hardens as the library says, and whose damping grows beyond a speed, which the library does not know beside it.
     */
    @Tag("slow")
    @Test
    void whatANamedLawLeavesIsLearnedBesideIt() {
        Recording recording = recording(
                List.of(new CubicSpring(2e9), new LearnedKnee(Shape.SPEED, Law.Side.EXTENSION, Modulator.NONE, 700, 0.03)));
        Evidence evidence = new Evidence(model(List.of()), recording);
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        Fitter.State named = search.best(base, Whereabouts.anywhere(evidence, base.candidate())
                .only(hypothesis -> hypothesis.mechanism().equals("stiffness.hardening"))).orElseThrow();
        assertTrue(LawProof.lacks(new Fits(evidence, base, base, Chosen.single(named), List.of(named))), "left " + named.reduced());
        LawLearner learner = new LawLearner(evidence, search, named, List.of());
        Sentence best = learner.law(learner.sentences(named), Chosen.single(named)).orElseThrow();
        String found = LearnedWords.of(evidence.model(), best.fit());
        assertEquals(1, best.terms().size(), found);
        List<LearnedKnee> knees = best.fit().candidate().at(best.fit().x()).laws().stream().map(LawAt::law)
                .filter(LearnedKnee.class::isInstance).map(LearnedKnee.class::cast).toList();
        assertEquals(0.03, knees.get(0).knee(), 0.001, found);
        assertEquals(700, knees.get(0).coefficient(), 20, found);
        assertTrue(named.reduced() > 20 && best.fit().reduced() < 1.1, named.reduced() + " before, left " + best.fit().reduced());
        assertEquals("stiffness.hardening", best.fit().candidate().added().get(0).mechanism());
    }

    /** What a law does that goes up and down with deflection stands in a table, force by force. */
    @Tag("slow")
    @Test
    void whatHasNoFormulaIsTabled() {
        LearnedTable law = new LearnedTable(Shape.DEFLECTION, 2e-3, -60, 25, -50, 55, -20, 70);
        Evidence evidence = new Evidence(model(List.of()), recording(law));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        LawLearner learner = new LawLearner(evidence, search, base, List.of());
        Sentence best = learner.law(learner.tables(), Chosen.single(base)).orElseThrow();
        assertEquals("table over r", best.terms().get(0).form());
        assertEquals("platform-torso", best.terms().get(0).where());
        assertTrue(best.fit().reduced() < 0.2 * base.reduced(), base.reduced() + " before, left " + best.fit().reduced());
    }

    public static Model model(List<Law> laws) {
        return new Model("sitter", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)),
                List.of(body("torso", 45, "sternum.acc.z"), body("head", 6, "head.acc.z")),
                List.of(new Model.Link("platform", "torso", 50000, 900, Optional.empty(), laws, List.of(), List.of()),
                        new Model.Link("torso", "head", 22000, 160, Optional.empty(), List.of(), List.of(), List.of())));
    }

    private static Model.Body body(String name, double mass, String sensor) {
        return new Model.Body(name, mass, Optional.of(Channel.parse(sensor)), List.of(), Optional.empty(), List.of());
    }

    /** A ride of three levels in turn, the same each time, with noise on every sensor. */
    public static Recording recording(Law law) {
        return recording(List.of(law));
    }

    private static Recording recording(List<Law> laws) {
        return recording(model(laws));
    }

    /** The same of what it is made of. */
    public static Recording recording(Model model) {
        int n = (int) (SECONDS * RATE);
        Random random = new Random(11);
        double[] base = new double[n];
        double[] sway = new double[n];
        double[] slow = new double[2];
        for (int i = 0; i < n; i++) {
            slow[0] += 0.5 * (random.nextGaussian() - slow[0]);
            slow[1] += 0.1 * (random.nextGaussian() - slow[1]);
            double edge = Math.min(1, Math.min(i, n - 1 - i) / (2 * RATE));
            base[i] = edge * new double[] {1, 2, 3.5}[(int) (i / RATE / 7) % 3] * slow[0];
            sway[i] = 4 * slow[1];
        }
        // A steady acceleration would shift where a link rests, and an accelerometer does not tell it from its own offset.
        double mean = Arrays.stream(base).average().orElseThrow();
        Arrays.setAll(base, i -> base[i] - mean);
        Map<Channel, double[]> channels = new LinkedHashMap<>();
        double[][] outputs = new Simulator(new Excitation(RATE, base, Map.of(SWAY, sway))).outputs(model.assembly());
        channels.put(BASE, noisy(base, random));
        channels.put(SWAY, sway);
        for (int o = 0; o < outputs.length; o++) {
            channels.put(model.outputs().get(o), noisy(outputs[o], random));
        }
        return new Recording(new Clock(0, RATE), channels, Metadata.NONE);
    }

    private static double[] noisy(double[] x, Random random) {
        double[] out = x.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] += NOISE * random.nextGaussian();
        }
        return out;
    }
}
