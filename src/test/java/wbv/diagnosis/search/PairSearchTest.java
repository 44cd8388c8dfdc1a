package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.diagnosis.Bench;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.recording.Channel;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;

/**
 * Two things are missing at two places: both are named, and nothing beside them. A diagnosis of two takes long; what is tagged is asked
 * apart.
 */
class PairSearchTest {

    @TempDir
    private Path folder;

    @Tag("exam")
    @Test
    void bothAreNamed() throws Exception {
        bothAreNamed(folder, List.of("damping.quadratic", "sensor.mount"), 1);
    }

    /** A drift of one link does not show in the loudest half minute beside the play of another. */
    @Tag("exam")
    @Test
    void whatAPartOfTheDataHidesIsFoundOnAll() throws Exception {
        bothAreNamed(folder, List.of("contact.backlash", "drift.slow"), -4547603284373387860L);
    }

    /** Before a link changes, any second fits that part of the data beside the first as well as the change does. */
    @Tag("exam")
    @Test
    void whatGoesByTheClockRacesOnAllData() throws Exception {
        bothAreNamed(folder, List.of("coupling.axis", "drift.step"), -5357398452274761350L);
    }

    /** A reflex shows where the other link is ignored; the other link's law only on top of the reflex, since it bends all numbers. */
    @Tag("exam")
    @Test
    void aLawIsFoundOnTopOfWhatShowsWithoutIt() throws Exception {
        bothAreNamed(folder, List.of("stiffness.asymmetric", "muscle.reflex"), -1149208355661134141L);
    }

    /** A push of a hundred times the noise leaves twice the noise: that is its own level, and no sensor late beside it. */
    @Tag("slow")
    @Test
    void whatAPushLeavesIsNoSecondOne() throws Exception {
        allIsNamed(folder,
                new ConcealedSpec("push", List.of("input.unmeasured", "sensor.bias"), 1, Setting.ROTATION, false, -2485435436505517239L));
    }

    /** Of two outputs one has a wrong gain; the model has bent itself for a spring six times as stiff in compression. */
    @Tag("exam")
    @Test
    void aLawStrongerThanItsSpringIsFoundBesideAFalseGain() throws Exception {
        allIsNamed(folder, new ConcealedSpec("strong", List.of("stiffness.asymmetric", "sensor.gain"), 1, Setting.FIELD, false,
                5354934170498379370L));
    }

    /** A sensor turned by 27° passed for a tilt of as many standard deviations, beside which any law explained the rest. */
    @Tag("exam")
    @Test
    void aTurnedSensorIsNoSmallError() throws Exception {
        allIsNamed(folder, new ConcealedSpec("turned", List.of("stiffness.asymmetric", "sensor.misalignment"), 1, Setting.RIG, false,
                -7284787616749009755L));
    }

    /** Where the model had bent itself for both, the mass passed for 1.2 N of the sitter's own; beside the gain it is 7.7 N in step. */
    @Tag("exam")
    @Test
    void aSwingingMassIsNoForceOfWhoSitsStill() throws Exception {
        allIsNamed(folder, new ConcealedSpec("swings", List.of("mode.hidden", "sensor.gain"), 1, Setting.FIELD, false,
                2640715440873448179L));
    }

    /** What enters at the head, its sensor or its neck looks alike beside a second place; the rotation shows beside the neck alone. */
    @Tag("exam")
    @Test
    void ofPlacesThatLookAlikeTheOneIsTakenBesideWhichAMechanismShows() throws Exception {
        allIsNamed(folder, new ConcealedSpec("alike", List.of("coupling.rotation", "muscle.reflex"), 1, Setting.ROTATION, false,
                8505340972418430530L));
    }

    /**
     * However much of two the first explains, more than noise shows elsewhere; beside the only one nothing does but what a sitter does by
     * himself.
     */
    @Tag("slow")
    @Test
    void whatShowsElsewhereIsNotTheFirstsForm() throws Exception {
        assertTrue(showsBesideFriction(List.of("friction.coulomb", "sensor.mount"), 3));
        assertFalse(showsBesideFriction(List.of("friction.coulomb"), 2));
    }

    /** A spring that softens by another formula than the library's, 7 million times the noise: the name leaves 400 times, and no second. */
    @Test
    void toOneOutputWhatALawLeavesMayBeItsForm() {
        Random random = new Random(1);
        DoubleUnaryOperator push = Bench.tones(40, 1, 0.5, 4, random);
        double reach = 1.5e-3;
        Bench bench = new Bench(200, 20, 40, 5).run((t, x, v, out) -> out[0] = push.applyAsDouble(t)
                - 20000 * reach * Math.tanh(x[0] / reach) - 60 * v[0]);
        double[] position = bench.sampled(bench.position(0));
        Evidence evidence = new Evidence(Bench.oscillator(5, 20000, 60, Channel.parse("mass.pos.z")),
                bench.recording("mass.force.z", bench.sampled(push), "mass.pos.z",
                        Bench.noisy(position, 1e-4 * Bench.rms(position), random)));
        List<String> asked = new ArrayList<>();
        Search search = new Search(evidence, (step, share) -> asked.add(step));
        Fitter.State base = search.base(Baseline.of(evidence));
        List<Fitter.State> leaders = search.leaders(base, 1,
                Whereabouts.anywhere(evidence, base.candidate()).only(h -> h.mechanism().equals("stiffness.softening")));
        Fitter.State softening = leaders.get(0);
        assertTrue(softening.reduced() > 100 && softening.reduced() < Refinement.form(base), softening.reduced() + " of " + base.reduced());
        asked.clear();
        assertSame(softening, new PairSearch(evidence, search, base, (step, share) -> asked.add(step)).best(softening, leaders).fit());
        assertEquals(List.of(), asked, "none is sought");
    }

    /** Ignoring where a spring softens leaves noise at the other of two outputs: what a spring that yields leaves of that is no second. */
    @Tag("slow")
    @Test
    void twoOutputsTellThatAllEntersAtOnePlace() {
        Random random = new Random(2);
        DoubleUnaryOperator push = Bench.tones(40, 1, 0.5, 4, random);
        double reach = 1.5e-3;
        Bench bench = new Bench(200, 20, 40, 5, 3).run((t, x, v, out) -> {
            double softening = 12000 * reach * Math.tanh((x[1] - x[0]) / reach) + 40 * (v[1] - v[0]);
            out[0] = push.applyAsDouble(t) - 20000 * x[0] - 60 * v[0] + softening;
            out[1] = -softening;
        });
        double[] mass = bench.sampled(bench.position(0));
        double[] load = bench.sampled(bench.position(1));
        Model model = new Model("bench", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(Bench.body("mass", 5, Optional.of(Channel.parse("mass.pos.z"))),
                        Bench.body("load", 3, Optional.of(Channel.parse("load.pos.z")))),
                List.of(Bench.link("ground", "mass", 20000, 60, Optional.empty()),
                        Bench.link("mass", "load", 12000, 40, Optional.empty())),
                List.of(new Model.Input("mass", Channel.parse("mass.force.z"))));
        Evidence evidence = new Evidence(model, bench.recording("mass.force.z", bench.sampled(push), "mass.pos.z",
                Bench.noisyBy(1e-4, mass, random), "load.pos.z", Bench.noisyBy(1e-4, load, random)));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        Fitter.State yielding = search.best(base,
                Whereabouts.anywhere(evidence, base.candidate()).only(h -> h.mechanism().equals("hysteresis"))).orElseThrow();
        assertTrue(yielding.reduced() > Priors.GLARING, yielding.reduced() + " of " + base.reduced());
        List<String> asked = new ArrayList<>();
        Fitter.State found = new PairSearch(evidence, search, base, (step, share) -> asked.add(step)).best(yielding, List.of(yielding))
                .fit();
        assertFalse(asked.contains("pairs"), asked.toString());
        assertEquals(Set.of("mass-load"), found.candidate().added().stream().map(Hypothesis::where).collect(Collectors.toSet()));
    }

    private boolean showsBesideFriction(List<String> words, long seed) throws Exception {
        ConcealedCase made = Concealer.make(new ConcealedSpec("elsewhere", words, 1, Setting.RIG, false, seed));
        Evidence measured = new Evidence(
                ModelFile.read(Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8)), made.recording());
        Fitter.State bent = new Search(measured, (step, share) -> {}).base(Baseline.of(measured));
        // What a sitter does by himself shows elsewhere too.
        Evidence evidence = Whereabouts.found(measured, bent).ownForce().map(measured::with).orElse(measured);
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        String where = new ObjectMapper().readTree(made.key()).path("mechanisms").get(0).path("where").asText();
        Fitter.State friction = search.best(base,
                Whereabouts.anywhere(evidence, base.candidate()).only(h -> h.mechanism().equals(words.get(0)) && h.where().equals(where)))
                .orElseThrow();
        return new PairSearch(evidence, search, base, (step, share) -> {}).showsElsewhere(friction);
    }

    static void bothAreNamed(Path folder, List<String> words, long seed) throws Exception {
        allIsNamed(folder, new ConcealedSpec("pair", words, 1, Setting.RIG, false, seed));
    }

    /** What is concealed is named where it is, and nothing beside it. */
    static void allIsNamed(Path folder, ConcealedSpec spec) throws Exception {
        ConcealedCase made = Concealer.make(spec);
        Path model = Files.writeString(folder.resolve("model.json"), made.model(), StandardCharsets.UTF_8);
        Diagnosis diagnosis = Diagnoser.diagnose(ModelFile.read(model), made.recording(), (step, share) -> {});
        Set<String> truth = new TreeSet<>();
        for (JsonNode each : new ObjectMapper().readTree(made.key()).path("mechanisms")) {
            truth.add(each.path("mechanism").asText() + " at " + each.path("where").asText());
        }
        assertEquals(truth, diagnosis.missing().stream().map(found -> found.mechanism() + " at " + found.where())
                .collect(Collectors.toCollection(TreeSet::new)), diagnosis.sentence());
    }
}
