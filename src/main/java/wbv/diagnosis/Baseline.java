package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.Structure;

/**
 * The user's model with the numbers that may be wrong without any physics missing: stiffness, damping and masses.
 *
 * <p>The heaviest mass is held: accelerations know masses, stiffness and damping only up to a common factor.
 */
final class Baseline {

    private static final double SPRING = 2;
    private static final double MASS = 0.15;
    private static final double FARTHEST = 3.2;
    private static final double FARTHEST_MASS = 1.2;

    private Baseline() { }

    static Candidate of(Evidence evidence) {
        Model model = evidence.model();
        Assembly assembly = model.assembly();
        List<Knob> knobs = new ArrayList<>();
        Structure s = assembly.structure();
        for (int l = 0; l < model.links().size(); l++) {
            String name = model.links().get(l).name();
            add(knobs, name + " stiffness_N_per_m", Slot.of(Slot.Kind.STIFFNESS, l), s.stiffness()[l], FARTHEST, SPRING);
            add(knobs, name + " damping_Ns_per_m", Slot.of(Slot.Kind.DAMPING, l), s.damping()[l], FARTHEST, SPRING);
        }
        int heaviest = 0;
        for (int b = 1; b < model.bodies().size(); b++) {
            heaviest = s.mass()[b] > s.mass()[heaviest] ? b : heaviest;
        }
        for (int b = 0; b < model.bodies().size(); b++) {
            if (b != heaviest) {
                add(knobs, model.bodies().get(b).name() + " mass_kg", Slot.of(Slot.Kind.MASS, b), s.mass()[b], FARTHEST_MASS, MASS);
            }
        }
        return new Candidate(assembly, knobs, List.of());
    }

    private static void add(List<Knob> knobs, String name, Slot slot, double value, double farthest, double deviation) {
        if (value > 0) {
            knobs.add(new Knob(name, slot, value, 0, -farthest, farthest, deviation));
        }
    }
}
