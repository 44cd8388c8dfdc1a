package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.body.Model;
import wbv.body.law.BristleFriction;
import wbv.body.law.Law;
import wbv.body.law.Reflex;
import wbv.body.law.Saturation.PartialSaturation;
import wbv.body.law.Settling;
import wbv.body.law.StepChange;
import wbv.body.number.Numbers;
import wbv.diagnosis.fit.Augmented;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.learn.LawLearnerTest;

/** A mass that nobody sees on a spring of either kind, and softening over bends of any width, friction with bristles. */
class FurtherFormTest {

    private static final double MASS = 6;
    private static final double FREQUENCY = 4.5;
    private static final double DAMPED = 0.1;
    private static final double KNEE = 1.5e-3;

    @Test
    void aSpringThatStiffensIsFoundWithItsNumbers() {
        Model.HiddenMode found = found(30000);
        assertEquals(MASS, found.mass(), 0.1 * MASS);
        assertEquals(FREQUENCY, found.frequency(), 0.02 * FREQUENCY);
        assertEquals(DAMPED, found.dampingRatio(), 0.1 * DAMPED);
        assertEquals(30000, found.cubic(), 3000);
    }

    @Test
    void aLinearSpringStaysLinear() {
        Model.HiddenMode found = found(0);
        assertEquals(FREQUENCY, found.frequency(), 0.02 * FREQUENCY);
        assertEquals(0, found.cubic());
    }

    /** In softening of three widths, of which the plain form is the second, and of a part of the stiffness: n, b, and the knee [m]. */
    @ParameterizedTest
    @CsvSource({"1.1, 0, gradual", "2, 0, ''", "5, 0, gradual", "2, 0.5, partial", "3, 0.25, partial"})
    void softeningIsFoundInItsForm(double sharpness, double kept, String form) {
        Evidence evidence = new Evidence(LawLearnerTest.model(List.of()),
                LawLearnerTest.recording(new PartialSaturation(KNEE, sharpness, kept)));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        Fitter.State best = search
                .best(base, Whereabouts.anywhere(evidence, base.candidate()).only(hypothesis -> hypothesis.where().equals("platform-torso")
                        && hypothesis.mechanism().equals("stiffness.softening")))
                .orElseThrow();
        assertEquals(form, best.candidate().last().form());
        double[] found = Numbers.values((Record) best.candidate().at(best.x()).laws().get(0).law());
        assertEquals(KNEE, found[0], 0.1 * KNEE);
        if (found.length > 1) {
            assertEquals(sharpness, found[1], 0.15 * sharpness);
        }
        if (found.length > 2) {
            assertEquals(kept, found[2], 0.05);
        }
    }

    /** Of friction the plain form alone is sought, and that with bristles begins where it is found. */
    @Test
    void frictionThatBreaksLooseIsFoundFromPlainFriction() {
        BristleFriction truth = new BristleFriction(40, 60, 5e-3, 4e5);
        Evidence evidence = new Evidence(LawLearnerTest.model(List.of()), LawLearnerTest.recording(truth));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State best = search.best(search.base(Baseline.of(evidence)),
                Whereabouts.anywhere(evidence, Baseline.of(evidence)).only(hypothesis -> hypothesis.where().equals("platform-torso")
                        && hypothesis.mechanism().equals("friction.coulomb") && hypothesis.form().isEmpty()))
                .orElseThrow();
        BristleFriction found = assertInstanceOf(BristleFriction.class, best.candidate().at(best.x()).laws().get(0).law());
        assertEquals(truth.friction(), found.friction(), 0.1 * truth.friction());
        assertEquals(truth.bristle(), found.bristle(), 0.2 * truth.bristle());
    }

    /** Of what changes slowly a parabola over time alone is sought, and what settles begins where it is found. */
    @Test
    void whatSettlesIsFoundFromAParabola() {
        Settling truth = new Settling(-0.6, 15, 0.5);
        Settling found = assertInstanceOf(Settling.class, changed(truth, "drift.slow"));
        assertEquals(truth.change(), found.change(), 0.06);
        assertEquals(truth.settling(), found.settling(), 2);
    }

    /** A change that takes two seconds, found from one at once; one at once stays that. */
    @Test
    void aChangeTellsHowLongItTakes() {
        StepChange.Gradual truth = new StepChange.Gradual(14, 0.7, 1, 2);
        StepChange.Gradual found = assertInstanceOf(StepChange.Gradual.class, changed(truth, "drift.step"));
        assertEquals(truth.time(), found.time(), 0.1);
        assertEquals(truth.duration(), found.duration(), 0.4);
        assertEquals(truth.stiffnessFactor(), found.stiffnessFactor(), 0.01);
        assertInstanceOf(StepChange.class, changed(new StepChange(14, 0.7, 1), "drift.step"));
    }

    /** The best law of a change in the first link, begun in its plain form. */
    private static Law changed(Law truth, String mechanism) {
        Evidence evidence = new Evidence(LawLearnerTest.model(List.of()), LawLearnerTest.recording(truth));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State best = search.best(search.base(Baseline.of(evidence)),
                Whereabouts.anywhere(evidence, Baseline.of(evidence)).only(hypothesis -> hypothesis.where().equals("platform-torso")
                        && hypothesis.mechanism().equals(mechanism) && hypothesis.form().isEmpty()))
                .orElseThrow();
        return best.candidate().at(best.x()).laws().get(0).law();
    }

    /**
     * Stretch and speed together are one lead, a reflex of either alone one of another delay: what is not there is not told. Commands
     * [N/m, N s/m], delay [s].
     */
    @ParameterizedTest
    @CsvSource({"15000, 0, 0.073, stretch", "0, 500, 0.11, speed", "12000, 500, 0.09, ''"})
    void aReflexIsToldByWhatItFollows(double stretch, double speed, double delay, String form) {
        Evidence evidence = new Evidence(LawLearnerTest.model(List.of()), LawLearnerTest.recording(new Reflex(stretch, speed, delay)));
        Search search = new Search(evidence, (step, share) -> {});
        List<Fitter.State> fits = search.leaders(search.base(Baseline.of(evidence)), 2,
                Whereabouts.anywhere(evidence, Baseline.of(evidence)).only(hypothesis -> hypothesis.where().equals("platform-torso")
                        && hypothesis.mechanism().equals("muscle.reflex")));
        Fitter.State told = fits.stream().filter(fit -> fit.reduced() < Priors.LOUD)
                .min(Comparator.comparingInt(fit -> fit.candidate().last().free())).orElseThrow();
        assertEquals(form, told.candidate().last().form());
        Reflex found = assertInstanceOf(Reflex.class, told.candidate().at(told.x()).laws().get(0).law());
        assertEquals(delay, found.delay(), 0.003);
        assertEquals(stretch, found.stiffness(), 1 + 0.15 * stretch);
        assertEquals(speed, found.damping(), 1 + 0.2 * speed);
    }

    private static Model.HiddenMode found(double cubic) {
        Model model = LawLearnerTest.model(List.of());
        Evidence evidence = new Evidence(model, LawLearnerTest.recording(riding(model, cubic)));
        Search search = new Search(evidence, (step, share) -> {});
        Fitter.State base = search.base(Baseline.of(evidence));
        Fitter.State best = search
                .best(base,
                        Whereabouts.anywhere(evidence, base.candidate()).only(hypothesis -> hypothesis.mechanism().equals("mode.hidden")))
                .orElseThrow();
        Model completed = Augmented.of(model, best.candidate().at(best.x()));
        return completed.bodies().get(0).hidden().orElseThrow();
    }

    private static Model riding(Model model, double cubic) {
        List<Model.Body> bodies = new ArrayList<>(model.bodies());
        Model.Body torso = bodies.get(0);
        bodies.set(0, torso.completed(torso.mass(), torso.faults(), Optional.of(new Model.HiddenMode(MASS, FREQUENCY, DAMPED, cubic)),
                torso.forces()));
        return new Model(model.name(), Optional.empty(), model.axis(), model.base(), bodies, model.links());
    }
}
