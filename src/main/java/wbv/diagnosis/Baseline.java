package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * The user's model with everything that may be a little wrong without any physics missing: stiffness, damping and masses of its
 * bodies, and the small errors that every sensor has (gain, clock, tilt, place), each with what is known of it beforehand.
 *
 * <p>The heaviest mass is held: accelerations know masses, stiffness and damping only up to a common factor.
 */
final class Baseline {

    /** Standard deviation of a sensor's gain [1]. */
    static final double GAIN = 0.01;
    /** Standard deviation of a sensor's delay, in samples. */
    static final double DELAY = 0.15;
    /** Standard deviation of a sensor's tilt [rad]: one degree. */
    static final double TILT = Math.toRadians(1);
    /** Standard deviation of a sensor's place [m]. */
    static final double ARM = 0.005;

    private static final double SPRING = 2;
    private static final double MASS = 0.15;
    private static final double FARTHEST = 3.2;
    private static final double FARTHEST_MASS = 1.2;
    private static final double ERRORS = 3;

    private Baseline() { }

    static Candidate of(Evidence evidence) {
        Model model = evidence.model();
        Assembly plain = model.assembly();
        List<Assembly.Output> outputs = new ArrayList<>();
        for (int o = 0; o < plain.outputs().size(); o++) {
            Assembly.Output output = plain.outputs().get(o);
            List<SensorFault> faults = new ArrayList<>(output.faults());
            faults.addAll(errors(evidence, evidence.outputs().get(o)));
            outputs.add(new Assembly.Output(output.place(), output.reading(), faults));
        }
        Assembly assembly = new Assembly(plain.structure(), plain.laws(), plain.drives(), outputs);
        List<Knob> knobs = new ArrayList<>();
        addStructure(model, assembly.structure(), knobs);
        for (int o = 0; o < outputs.size(); o++) {
            String channel = evidence.outputs().get(o).toString();
            int own = plain.outputs().get(o).faults().size();
            for (int f = own; f < outputs.get(o).faults().size(); f++) {
                addError(channel, outputs.get(o).faults().get(f), o, f, evidence.recording().clock().step(), knobs);
            }
        }
        return new Candidate(assembly, knobs, List.of());
    }

    private static void addStructure(Model model, Structure s, List<Knob> knobs) {
        double[] values = s.values();
        int links = model.links().size();
        for (int l = 0; l < links; l++) {
            String name = model.links().get(l).name();
            if (values[l] > 0) {
                knobs.add(new Knob(name + " stiffness_N_per_m", Slot.of(Slot.Kind.STIFFNESS, l), values[l], 0, -FARTHEST, FARTHEST, SPRING));
            }
            if (values[s.links() + l] > 0) {
                knobs.add(new Knob(name + " damping_Ns_per_m", Slot.of(Slot.Kind.DAMPING, l), values[s.links() + l], 0, -FARTHEST, FARTHEST, SPRING));
            }
        }
        int heaviest = 0;
        for (int b = 1; b < model.bodies().size(); b++) {
            heaviest = s.mass()[b] > s.mass()[heaviest] ? b : heaviest;
        }
        for (int b = 0; b < model.bodies().size(); b++) {
            if (b != heaviest) {
                knobs.add(new Knob(model.bodies().get(b).name() + " mass_kg", Slot.of(Slot.Kind.MASS, b), s.mass()[b], 0, -FARTHEST_MASS, FARTHEST_MASS, MASS));
            }
        }
    }

    /** The small errors of an acceleration sensor, all at nothing. */
    private static List<SensorFault> errors(Evidence evidence, Channel channel) {
        if (channel.quantity() != Quantity.ACCELERATION) {
            return List.of();
        }
        List<SensorFault> out = new ArrayList<>();
        for (Channel rate : evidence.companions(channel.location(), Quantity.ANGULAR_RATE)) {
            out.add(new SensorFault.LeverArm(rate, 0));
        }
        List<Channel> across = evidence.companions(channel.location(), Quantity.ACCELERATION);
        if (across.size() == 2) {
            out.add(new SensorFault.Misalignment(across.get(0), across.get(1), 0, 0));
        }
        out.add(new SensorFault.Gain(1));
        out.add(new SensorFault.Delay(0, 0));
        return out;
    }

    private static void addError(String channel, SensorFault fault, int output, int place, double step, List<Knob> knobs) {
        if (fault instanceof SensorFault.LeverArm lever) {
            knobs.add(error(channel + " arm on " + lever.rate(), output, place, 0, 0, ARM));
        } else if (fault instanceof SensorFault.Misalignment) {
            knobs.add(error(channel + " towards_x_rad", output, place, 0, 0, TILT));
            knobs.add(error(channel + " towards_y_rad", output, place, 1, 0, TILT));
        } else if (fault instanceof SensorFault.Gain) {
            knobs.add(error(channel + " factor", output, place, 0, 1, GAIN));
        } else {
            knobs.add(error(channel + " delay_s", output, place, 0, 0, DELAY * step));
        }
    }

    /** An error that may be a few of its standard deviations, no more: what is larger has to be named. */
    private static Knob error(String name, int output, int fault, int component, double reference, double deviation) {
        return new Knob(name, new Slot(Slot.Kind.FAULT, output, fault, component), reference, deviation, -ERRORS, ERRORS, 1);
    }
}
