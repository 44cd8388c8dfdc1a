package wbv.diagnosis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The recording that would settle what two mechanisms leave open (DIAGNOSIS 7). */
final class Experiments {

    private static final String LEVELS = "Repeat the ride at three or more levels, at least 1 : 4 apart: the effects grow "
            + "differently with amplitude.";
    private static final String WEIGHT = "Repeat the ride with a weight added: it shifts a stop, a gap or a preload, and leaves "
            + "a spring's law as it is. Three levels, 1 : 4 apart, tell the rest.";
    private static final String BACK = "Repeat the first level at the end (A-B-A): what depends on the level comes back, a "
            + "change stays.";
    private static final String RELAXED = "Record the same sitter relaxed and tensed, or a dummy: a muscle changes, a material "
            + "does not.";
    private static final String HOLD = "Load the link with a step and hold it for minutes: a memory creeps, a mass does not. Or "
            + "put a third sensor on the torso (abdomen beside sternum).";
    private static final String STATIC = "Press the link with a known weight and see how far it gives: a memory leaves the slow "
            + "stiffness where the model has it, a wrong number does not.";
    private static final String ABDOMEN = "Put a third sensor on the torso (abdomen beside sternum), or record relaxed and "
            + "tensed.";
    private static final String CREEP = "Record a very low level (0.05 to 0.1 m/s²), where friction sticks, and a slow sine at "
            + "0.3 Hz.";
    private static final String POSE = "Hold a static pose: a tilted sensor splits gravity, nothing else does.";
    private static final String TAP = "Tap the rig once at the start and once at the end: all sensors see the same instant, and "
            + "only a late one does not.";
    private static final String GRAMS = "Add 20 g to the sensor, or tape a second, light one beside it: a mount's resonance "
            + "falls, all else stays.";
    private static final String NOD = "Shake one axis at a time: pure pitch (a nod for the head), then pure fore-aft, with the "
            + "gyroscope on.";
    /** In place of a nod, where the rotation of the place is known already. */
    private static final String ARM = "Move the sensor a known way, 50 mm fore or aft, and record again: how it turns is recorded, so what a "
            + "rotation adds must change by just that arm; what crosses over from another axis stays.";
    private static final String QUIET = "Record a quiet trial: a force of its own stays, what answers the ride goes.";
    private static final String SEAT = "Measure the force under the seat pan, or put a second sensor on the platform and swap "
            + "the two: a force on the first body, one in the link below it and a fault of the platform's sensor move all "
            + "bodies alike.";
    private static final String SCALE = "Weigh the person, or record the seat's force once: forces are known only up to the "
            + "scale of the masses.";

    static final String AGAIN = "Record the same ride again, twice as long: a law comes back in every part of it, an event does not.";
    static final String CAUSE = "See that the input is the sensor under the person, on the same clock, and shake harder, or record a quiet trial: "
            + "what is there without the ride is not caused by it.";

    private static final Set<String> SPRINGS = Set.of("stiffness.softening", "stiffness.hardening", "stiffness.asymmetric");
    private static final Set<String> CONTACTS = Set.of("contact.bumpstop", "contact.loss", "contact.backlash");
    private static final Set<String> LOSSES = Set.of("damping.quadratic", "friction.coulomb", "hysteresis");
    private static final Set<String> DRIFTS = Set.of("drift.step", "drift.slow");
    private static final Set<String> COUPLINGS = Set.of("coupling.axis", "coupling.rotation");
    private static final Set<String> LINEAR = Set.of("memory.viscoelastic", "muscle.reflex", "mode.hidden");

    /** What settles any of the ones against any of the others. */
    private record Pair(Set<String> ones, Set<String> others, String experiment) {
        boolean holds(String a, String b) {
            return ones.contains(a) && others.contains(b) || ones.contains(b) && others.contains(a);
        }
    }

    /** The first that holds counts. */
    private static final List<Pair> PAIRS = List.of(
            new Pair(Set.of("parameters"), Set.of("memory.viscoelastic", "muscle.reflex", "mode.hidden"), STATIC),
            new Pair(Set.of("memory.viscoelastic"), Set.of("muscle.reflex"), RELAXED),
            new Pair(Set.of("mode.hidden"), Set.of("muscle.reflex"), ABDOMEN),
            new Pair(Set.of("mode.hidden"), Set.of("memory.viscoelastic"), HOLD),
            new Pair(Set.of("friction.coulomb"), Set.of("hysteresis"), CREEP),
            new Pair(DRIFTS, DRIFTS,
                    "Record longer at one level and look at blocks of ten seconds: a step has a moment, a drift has none."),
            new Pair(COUPLINGS, COUPLINGS, NOD),
            new Pair(Set.of("sensor.misalignment"), Set.of("sensor.delay", "sensor.mount", "sensor.gain", "coupling.rotation",
                    "coupling.axis"), POSE),
            new Pair(Set.of("sensor.delay"), Set.of("sensor.mount", "sensor.gain", "coupling.rotation", "coupling.axis"), TAP),
            new Pair(Set.of("sensor.mount"), Set.of("coupling.rotation", "coupling.axis", "sensor.gain", "mode.hidden",
                    "memory.viscoelastic", "muscle.reflex"), GRAMS),
            new Pair(Set.of("input.unmeasured"), Set.of("mode.hidden", "memory.viscoelastic", "muscle.reflex", "drift.step",
                    "drift.slow", "coupling.axis", "coupling.rotation"), QUIET),
            new Pair(DRIFTS, SPRINGS, BACK), new Pair(DRIFTS, CONTACTS, BACK), new Pair(DRIFTS, LOSSES, BACK),
            new Pair(DRIFTS, LINEAR, BACK),
            new Pair(CONTACTS, SPRINGS, WEIGHT), new Pair(CONTACTS, CONTACTS, WEIGHT), new Pair(CONTACTS, LOSSES, LEVELS),
            new Pair(SPRINGS, SPRINGS, LEVELS), new Pair(SPRINGS, LOSSES, LEVELS), new Pair(LOSSES, LOSSES, LEVELS),
            new Pair(LINEAR, SPRINGS, LEVELS), new Pair(LINEAR, CONTACTS, LEVELS), new Pair(LINEAR, LOSSES, LEVELS),
            new Pair(Set.of("sensor.clipping"), SPRINGS, LEVELS), new Pair(Set.of("sensor.clipping"), CONTACTS, LEVELS));

    /** What each of them calls for by itself. */
    private static final Map<String, String> SINGLE = Map.ofEntries(
            Map.entry("memory.viscoelastic", RELAXED), Map.entry("muscle.reflex", RELAXED), Map.entry("mode.hidden", ABDOMEN),
            Map.entry("friction.coulomb", CREEP), Map.entry("hysteresis", CREEP), Map.entry("drift.step", BACK),
            Map.entry("drift.slow", BACK),
            Map.entry("input.unmeasured", QUIET), Map.entry("coupling.axis", NOD), Map.entry("coupling.rotation", NOD),
            Map.entry("contact.bumpstop", WEIGHT), Map.entry("contact.loss", WEIGHT), Map.entry("contact.backlash", WEIGHT),
            Map.entry("sensor.mount", GRAMS), Map.entry("sensor.delay", TAP), Map.entry("sensor.misalignment", POSE),
            Map.entry("sensor.gain", "Tape a second sensor beside it: the two must read alike."),
            Map.entry("sensor.bias", POSE),
            Map.entry("sensor.clipping", "Repeat at a third of the level: what clips must vanish."),
            Map.entry("sensor.rectifying", "Turn the sensor upside down: a sign must change."),
            Map.entry("sensor.dropouts", "Bring the receiver nearer and record again: what drops must vanish."));

    /** From this probability on no rival has to be told apart any more, and the numbers are next. */
    private static final double SETTLED = 0.95;

    private Experiments() { }

    /**
     * What would settle a diagnosis: the leading name against its best rival, or the two best rivals where there is no name.
     * Where the name is beyond doubt, what would settle its size.
     *
     * @param base   the link that stands on the base, and the body on it: places that no motion tells apart
     * @param scaled whether forces are known only up to the scale of the masses
     * @param turned whether it was recorded how the person or the base turns: then nobody need shake that
     */
    static String between(List<Diagnosis.Named> missing, List<Diagnosis.Named> alternatives, Set<String> base, boolean scaled, boolean turned) {
        String best = between(missing, alternatives, base, scaled);
        return turned && best.equals(NOD) ? ARM : best;
    }

    private static String between(List<Diagnosis.Named> missing, List<Diagnosis.Named> alternatives, Set<String> base, boolean scaled) {
        List<Diagnosis.Named> leading = missing.isEmpty() ? alternatives : missing.subList(missing.size() - 1, missing.size());
        if (leading.isEmpty()) {
            return "";
        }
        Diagnosis.Named first = leading.get(0);
        boolean force = first.parameters().keySet().stream().anyMatch(MassScale::scales);
        if (!missing.isEmpty() && scaled && first.probability() >= SETTLED && force) {
            return SCALE;
        }
        Optional<Diagnosis.Named> second = (missing.isEmpty() ? alternatives.stream().skip(1) : alternatives.stream())
                .findFirst();
        if (second.isEmpty()) {
            return SINGLE.getOrDefault(first.mechanism(), LEVELS);
        }
        return between(first, second.get(), base);
    }

    private static String between(Diagnosis.Named first, Diagnosis.Named second, Set<String> base) {
        String a = first.mechanism();
        String b = second.mechanism();
        boolean force = a.equals("input.unmeasured") != b.equals("input.unmeasured");
        if (force && base.contains(first.where()) && base.contains(second.where())) {
            return SEAT;
        }
        if (a.equals(b) && !first.where().equals(second.where())) {
            return "Put one more sensor between " + first.where() + " and " + second.where()
                    + ", or block what moves there: only one of the two places moves what lies between them.";
        }
        return PAIRS.stream().filter(pair -> !a.equals(b) && pair.holds(a, b)).map(Pair::experiment).findFirst()
                .orElseGet(() -> SINGLE.getOrDefault(a, LEVELS));
    }
}
