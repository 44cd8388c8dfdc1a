package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Mechanism;

class ExperimentsTest {

    private static final Experiments EXPERIMENTS = new Experiments(Library.standard());
    private static final Set<String> BASE = Set.of("platform-seat", "seat");

    /** Pairs that one recording does not tell apart, and a word of what is said to separate them. */
    @ParameterizedTest
    @CsvSource({
        "memory.viscoelastic, muscle.reflex, relaxed", "mode.hidden, muscle.reflex, abdomen",
        "mode.hidden, memory.viscoelastic, third sensor", "stiffness.hardening, damping.quadratic, three or more levels",
        "stiffness.softening, hysteresis, three or more levels", "damping.quadratic, hysteresis, three or more levels",
        "stiffness.hardening, contact.bumpstop, weight", "stiffness.asymmetric, contact.loss, weight",
        "stiffness.softening, drift.step, A-B-A", "stiffness.hardening, drift.slow, A-B-A",
        "friction.coulomb, hysteresis, 0.3 Hz", "sensor.misalignment, coupling.rotation, static pose",
        "sensor.misalignment, sensor.delay, static pose", "sensor.misalignment, sensor.mount, static pose",
        "sensor.delay, sensor.mount, Tap", "sensor.delay, coupling.rotation, Tap", "sensor.mount, coupling.rotation, 20 g",
        "sensor.mount, memory.viscoelastic, 20 g", "coupling.axis, coupling.rotation, pitch",
        "input.unmeasured, mode.hidden, quiet", "drift.step, drift.slow, one level"})
    void everyConfoundedPairHasItsExperiment(String one, String other, String word) {
        for (List<String> order : List.of(List.of(one, other), List.of(other, one))) {
            String text = between(named(order.get(0), "pelvis-torso", 0.6), named(order.get(1), "pelvis-torso", 0.3));
            assertTrue(text.contains(word), text);
        }
    }

    @Test
    void placesThatMoveAllBodiesAlikeAskForAForce() {
        assertTrue(between(named("input.unmeasured", "seat", 0.6),
                named("friction.coulomb", "platform-seat", 0.3)).contains("seat pan"));
        assertFalse(between(named("input.unmeasured", "torso", 0.6),
                named("friction.coulomb", "platform-seat", 0.3)).contains("seat pan"));
    }

    @Test
    void oneMechanismAtTwoPlacesAsksForASensorBetweenThem() {
        String text = between(named("friction.coulomb", "seat-torso", 0.6), named("friction.coulomb", "torso-head", 0.3));
        assertTrue(text.contains("between seat-torso and torso-head"), text);
    }

    @Test
    void whereTheNameIsBeyondDoubtItsSizeIsNext() {
        Diagnosis.Named sure = new Diagnosis.Named("friction.coulomb", "seat-torso", 0.98, Map.of("friction_N", 30.0), Map.of(),
                1);
        assertTrue(EXPERIMENTS.between(List.of(sure), List.of(named("hysteresis", "seat-torso", 0.01)),
                BASE, true, false).startsWith("Weigh who or what is moved"));
        String rig = EXPERIMENTS.between(List.of(sure), List.of(named("hysteresis", "seat-torso", 0.01)), BASE, false, false);
        assertTrue(rig.contains("0.3 Hz"), "where forces were measured there is nothing to weigh: " + rig);
    }

    @Test
    void withoutANameTheTwoBestRivalsAreToldApart() {
        String text = EXPERIMENTS.between(List.of(),
                List.of(named("friction.coulomb", "seat-torso", 0.1), named("hysteresis", "seat-torso", 0.1)), BASE, true, false);
        assertTrue(text.contains("0.3 Hz"), text);
        assertEquals("", EXPERIMENTS.between(List.of(), List.of(), BASE, true, false));
    }

    @Test
    void whoseRotationIsRecordedNeedNotBeShakenAboutIt() {
        List<Diagnosis.Named> named = List.of(named("coupling.rotation", "seat-torso", 0.6));
        List<Diagnosis.Named> rival = List.of(named("coupling.axis", "seat-torso", 0.3));
        assertTrue(EXPERIMENTS.between(named, rival, BASE, false, false).contains("pure pitch"));
        String recorded = EXPERIMENTS.between(named, rival, BASE, false, true);
        assertFalse(recorded.contains("hake"), recorded);
        assertTrue(recorded.contains("50 mm"), recorded);
    }

    /** What a mechanism knows of its rivals counts, from either side; what it does not know, its family does. */
    @Test
    void aMechanismOfItsOwnSaysWhatSettlesIt() {
        Experiments own = new Experiments(Library.standard().with(new Cushion()));
        Diagnosis.Named cushion = named("toy.cushion", "seat-torso", 0.6);
        Diagnosis.Named hardening = named("stiffness.hardening", "seat-torso", 0.6);
        assertEquals("Take the cushion away.", own.between(List.of(cushion), List.of(hardening), BASE, false, false));
        assertEquals("Take the cushion away.", own.between(List.of(hardening), List.of(cushion), BASE, false, false));
        String stop = own.between(List.of(cushion), List.of(named("contact.bumpstop", "seat-torso", 0.3)), BASE, false, false);
        assertTrue(stop.contains("weight"), stop);
        assertEquals(Family.LEVELS, EXPERIMENTS.between(List.of(cushion), List.of(hardening), BASE, false, false),
                "a word that nobody knows");
    }

    private record Cushion() implements Mechanism.Custom {
        @Override
        public Entry entry() {
            return new Entry("toy.cushion", Family.SPRING, "The cushion %s bulges");
        }

        @Override
        public Optional<String> against(Mechanism rival) {
            return rival.word().equals("stiffness.hardening") ? Optional.of("Take the cushion away.") : Optional.empty();
        }
    }

    private static String between(Diagnosis.Named first, Diagnosis.Named second) {
        return EXPERIMENTS.between(List.of(first), List.of(second), BASE, true, false);
    }

    private static Diagnosis.Named named(String mechanism, String where, double probability) {
        return new Diagnosis.Named(mechanism, where, probability, Map.of(), Map.of(), 1);
    }
}
