package wbv.diagnosis;

import java.util.List;
import java.util.Map;
import java.util.Set;

/** The recording that would settle what two mechanisms leave open (DIAGNOSIS 7). */
final class Experiments {

    private static final String LEVELS = "Repeat the ride at three or more levels, at least 1 : 4 apart: the effects grow differently with amplitude.";

    private static final Map<Set<String>, String> PAIRS = Map.ofEntries(
            Map.entry(Set.of("memory.viscoelastic", "muscle.reflex"), "Record the same sitter relaxed and tensed, or a dummy: a muscle changes, a material does not."),
            Map.entry(Set.of("mode.hidden", "muscle.reflex"), "Put a third sensor on the torso (abdomen beside sternum), or record relaxed and tensed."),
            Map.entry(Set.of("mode.hidden", "memory.viscoelastic"), "Put a third sensor on the torso (abdomen beside sternum)."),
            Map.entry(Set.of("friction.coulomb", "hysteresis"), "Record a very low level (0.05 to 0.1 m/s²), where friction sticks, and a slow sine at 0.3 Hz."),
            Map.entry(Set.of("stiffness.asymmetric", "contact.bumpstop"), "Add a static weight: it shifts the stop and leaves an asymmetric spring as it is."),
            Map.entry(Set.of("stiffness.softening", "drift.step"), "Repeat the first level at the end (A-B-A): softening comes back, a change stays."),
            Map.entry(Set.of("drift.step", "drift.slow"), "Record longer at one level and look at blocks of ten seconds."),
            Map.entry(Set.of("coupling.axis", "coupling.rotation"), "Shake one axis at a time: pure pitch, then pure fore-aft."),
            Map.entry(Set.of("sensor.delay", "sensor.mount"), "Tap the rig once at the start and once at the end: all sensors see the same instant."),
            Map.entry(Set.of("sensor.misalignment", "coupling.rotation"), "Hold a static pose: a tilted sensor splits gravity, a lever arm does not."),
            Map.entry(Set.of("input.unmeasured", "mode.hidden"), "Record a quiet trial: a force stays, a resonance goes."));

    private static final Map<String, String> SINGLE = Map.of(
            "stiffness.softening", LEVELS, "stiffness.hardening", LEVELS, "contact.bumpstop", LEVELS, "damping.quadratic", LEVELS,
            "drift.step", "Repeat the first minute's ride at the end.", "input.unmeasured", "Record a quiet trial: the force must stay.",
            "sensor.mount", "Add 20 g to the sensor: the mount's resonance must fall.",
            "sensor.delay", "Tap the rig once: all sensors see the same instant.");

    private Experiments() { }

    static String between(List<Diagnosis.Named> missing, List<Diagnosis.Named> alternatives) {
        if (missing.isEmpty()) {
            return "";
        }
        String first = missing.get(missing.size() - 1).mechanism();
        String second = alternatives.isEmpty() ? "" : alternatives.get(0).mechanism();
        if (!second.isEmpty() && !second.equals(first) && PAIRS.containsKey(Set.of(first, second))) {
            return PAIRS.get(Set.of(first, second));
        }
        return SINGLE.getOrDefault(first, LEVELS);
    }
}
