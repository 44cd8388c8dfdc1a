package wbv.diagnosis.search;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.law.LearnedTerm;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.learn.LawLearnerTest;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Hysteresis;

/** Motion does not show the scale of masses and forces: at any scale the same is simulated, and read. */
class MassScaleTest {

    private static final double STIFFNESS = 40000;

    private final Evidence evidence = new Evidence(LawLearnerTest.model(List.of()),
            LawLearnerTest.recording(new LearnedTerm(Shape.parse("r^2 v"), Modulator.NONE, 3e8)));

    /** Of a law of many parts that have their numbers in common, whose force may go another way than the model's. */
    @Test
    void whatIsReadIsTheSameAtAnyScale() {
        Hypothesis law = new Hysteresis().beside(0, "seat-torso", STIFFNESS, 3 * STIFFNESS, 2e-4);
        Candidate baseline = Baseline.of(evidence);
        Candidate with = baseline.with(law).withFreeWays();
        double[] x = baseline.extended(baseline.start(), with, law, law.starts().get(0).values());
        x[0] = 0.2;   // the link's own stiffness has moved, which is a part of what goes another way
        Fitter fitter = new Fitter(evidence);
        Fitter.State state = fitter.look(with, x, fitter.frame(with, x, evidence.fit()));
        assertFalse(state.failed());
        double[][] read = new Readings(evidence).of(state);
        double[][] scaled = new Readings(evidence).of(new MassScale(1.3, 0.05).applied(state));
        for (int o = 0; o < read.length; o++) {
            assertArrayEquals(read[o], scaled[o], 1e-9);
        }
        assertTrue(state.errors().length > 0, "sensors err, and ways differ");
    }

    /**
     * Of two masses given to a tenth each, whose ratio motion tells, both are taken to be wrong alike: the factor makes up for half of what
     * the ratio is off by, in logarithms; its deviation is a tenth over the root of two. On a rig as of a person.
     */
    @Test
    void twoMassesShareWhatTheirRatioIsOffBy() {
        Model truth = LawLearnerTest.model(List.of());
        double off = Math.log(1.12);
        for (Model.Subject subject : Model.Subject.values()) {
            Model given = lighterHead(truth, off).declaredAs(subject);
            Evidence own = new Evidence(given, LawLearnerTest.recording(truth));
            Fitter.State base = new Search(own, (step, share) -> {}).base(Baseline.of(own));
            MassScale scale = MassScale.of(own, new Fitter(own).lookWithSlopes(base.candidate(), base.x(), base.frame()));
            assertEquals(-off / 2, Math.log(scale.factor()), 0.01, "" + subject);
            assertEquals(Priors.MASS / Math.sqrt(2), scale.deviation(), 0.005, "" + subject);
        }
    }

    /** A torso that was weighed to a thousandth bears none of it, and sets the scale. */
    @Test
    void aMassThatWasWeighedSetsTheScale() {
        Model truth = LawLearnerTest.model(List.of());
        Evidence own = new Evidence(weighedTorso(lighterHead(truth, Math.log(1.12)), 1e-3), LawLearnerTest.recording(truth));
        Fitter.State base = new Search(own, (step, share) -> {}).base(Baseline.of(own));
        MassScale scale = MassScale.of(own, new Fitter(own).lookWithSlopes(base.candidate(), base.x(), base.frame()));
        assertEquals(1, scale.factor(), 1e-4);
        assertEquals(5e-4, scale.deviation(), 1.5e-4);
    }

    private static Model weighedTorso(Model model, double within) {
        Model.Body torso = model.bodies().get(0);
        return new Model(model.name(), Optional.empty(), model.axis(), model.base(),
                List.of(new Model.Body(torso.name(), torso.mass(), torso.sensor(), List.of(), Optional.empty(), List.of(), false, Map.of(),
                        Optional.empty(), false, Optional.empty(), OptionalDouble.of(within)), model.bodies().get(1)),
                model.links());
    }

    /** The head given lighter than it is, by so much in its logarithm. */
    private static Model lighterHead(Model truth, double off) {
        Model.Body torso = truth.bodies().get(0);
        Model.Body head = truth.bodies().get(1);
        return new Model(truth.name(), Optional.empty(), truth.axis(), truth.base(), List.of(torso,
                new Model.Body(head.name(), head.mass() * Math.exp(-off), head.sensor(), List.of(), Optional.empty(), List.of())),
                truth.links());
    }
}
