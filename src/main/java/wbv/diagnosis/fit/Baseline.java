package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.SensorFault;
import wbv.body.Structure;

/**
 * The user's model with the numbers that may be wrong without any physics missing: stiffness, damping and masses.
 *
 * <p>The heaviest mass is held: accelerations know masses, stiffness and damping only up to a common factor. Where forces are
 * measured all masses move; on a rig the sensors' offsets do too, that of a force on what no spring holds, and how much of a given
 * simulation's force acts.
 */
public final class Baseline {

    private static final double SPRING = 2;
    /**
     * How well masses of a person are known: standard deviation of their logarithm [1], assumed. Those of a bench are known as its
     * stiffnesses are.
     */
    public static final double MASS = 0.15;
    private static final double FARTHEST = 3.2;
    /**
     * A person's segments are known better than stiffness, which a softening spring shows ten times too small: two thirds heavier at most.
     */
    private static final double FARTHEST_MASS = 0.5;

    /** Loss factor of a link, and how many times that at most where none was given. */
    static final double USUAL_LOSS = 0.2;
    private static final double MOST_LOSS = 30;
    /** Where sitters resonate [Hz]. */
    private static final double USUAL_RESONANCE = 5;

    /**
     * How many times the usual speed what no spring holds may have, and a reading be off, where nothing tells it beforehand [1]: assumed,
     * so many that the recording alone decides.
     */
    static final double ANYHOW = 100;

    private static final double[][] SHIFTS = {{1.6, 0}, {1, 0.8}, {1, -0.8}};

    private Baseline() {}

    /** The model of the evidence with these numbers free; all x 0 are the values as given. */
    public static Candidate of(Evidence evidence) {
        Model model = evidence.model();
        Assembly assembly = model.assembly();
        List<Knob> knobs = new ArrayList<>();
        Structure s = assembly.structure();
        for (int l = 0; l < model.links().size(); l++) {
            String name = model.links().get(l).name();
            String stiffness = name + " " + ModelFile.stiffnessKey(model.about(model.links().get(l)));
            String damping = name + " " + ModelFile.dampingKey(model.about(model.links().get(l)));
            add(knobs, stiffness, Slot.of(Slot.Kind.STIFFNESS, l), s.stiffness()[l], FARTHEST, SPRING);
            add(knobs, damping, Slot.of(Slot.Kind.DAMPING, l), s.damping()[l], FARTHEST, SPRING);
            if (!evidence.onRig() && s.damping()[l] == 0 && s.stiffness()[l] > 0) {   // nobody's link has none
                double usual = USUAL_LOSS * s.stiffness()[l] / (2 * Math.PI * USUAL_RESONANCE);
                knobs.add(Knob.sum(damping, Slot.of(Slot.Kind.DAMPING, l), 0, usual, 0, MOST_LOSS * usual, MOST_LOSS));
            }
        }
        if (evidence.onRig()) {
            return onRig(evidence, assembly, knobs);
        }
        int heaviest = heaviest(model);
        boolean weighed = assembly.outputs().stream().anyMatch(output -> output.reading() == Assembly.Reading.LINK_FORCE);
        for (int b = 0; b < model.bodies().size(); b++) {
            if (weighed || b != heaviest) {
                addMass(knobs, model, b, FARTHEST_MASS, MASS);
            }
        }
        return new Candidate(assembly, knobs, List.of());
    }

    /**
     * Where fits of the baseline start: the model's own values. On a rig that swings, where nothing else tells how stiff it is,
     * also a model with five times the damping, and stiffer and softer ones, since a resonance that is missed by its width
     * pulls no fit.
     */
    public static List<double[]> starts(Evidence evidence, Candidate baseline) {
        List<double[]> starts = new ArrayList<>(List.of(baseline.start()));
        for (double[] shift : !evidence.onRig() || evidence.model().driven() ? new double[0][] : SHIFTS) {
            double[] x = baseline.start();
            for (int i = 0; i < x.length; i++) {
                Knob knob = baseline.knobs().get(i);
                double by = knob.slot().kind() == Slot.Kind.DAMPING ? shift[0] : knob.slot().kind() == Slot.Kind.STIFFNESS
                        ? shift[1] : 0;
                x[i] = knob.within(x[i] + by);
            }
            starts.add(x);
        }
        return starts;
    }

    private static int heaviest(Model model) {
        List<Model.Body> bodies = model.bodies();
        int heaviest = 0;
        for (int b = 1; b < bodies.size(); b++) {
            heaviest = !bodies.get(b).turns() && (bodies.get(heaviest).turns() || bodies.get(b).mass() > bodies.get(heaviest).mass()) ? b
                    : heaviest;
        }
        return heaviest;
    }

    private static Candidate onRig(Evidence evidence, Assembly assembly, List<Knob> knobs) {
        Model model = evidence.model();
        boolean weighed = !model.inputs().isEmpty()
                || assembly.outputs().stream().anyMatch(output -> output.reading() == Assembly.Reading.LINK_FORCE);
        int heaviest = heaviest(model);
        for (int b = 0; b < model.bodies().size() && !model.driven(); b++) {
            if (!weighed && b == heaviest) {   // motion alone knows no mass
                continue;
            }
            addMass(knobs, model, b, FARTHEST, SPRING);
        }
        boolean[] unheld = assembly.structure().unheld();
        // Where springs hold all bodies a force's offset moves where they rest, which sensors that are off tell nothing of. Begun from rest
        // it makes a start that nobody saw, which passes for a part of what is missing.
        boolean seen = IntStream.range(0, unheld.length).anyMatch(body -> unheld[body]);
        for (int d = 0; d < assembly.drives().size(); d++) {
            if (assembly.drives().get(d).drive() instanceof Drive.Given given) {
                knobs.add(Knob.sum(given.channel() + " share", new Slot(Slot.Kind.DRIVE, d, 0, 0), given.share(), 1, -1, 3,
                        Double.POSITIVE_INFINITY));
            } else if (seen && assembly.drives().get(d).drive() instanceof Drive.Measured force) {
                double size = Motion.rms(evidence.series(force.channel()), evidence.fit().length());
                knobs.add(Knob.sum(force.channel() + " offset_N", new Slot(Slot.Kind.DRIVE, d, 0, 0), force.offset(),
                        0.3 * Math.max(size, 1e-12),
                        -10 * size - 1e-9, 10 * size + 1e-9, 1));
            }
        }
        List<Assembly.DriveAt> drives = new ArrayList<>(assembly.drives());
        for (int b = 0; b < unheld.length && !model.driven(); b++) {
            if (unheld[b]) {   // it may well have been moving when the recording began
                double speed = speed(evidence);
                knobs.add(Knob.sum(model.bodies().get(b).name() + " velocity_m_per_s", Slot.of(Slot.Kind.DRIVE, drives.size(), 0), 0, speed,
                        -ANYHOW * speed, ANYHOW * speed, Double.POSITIVE_INFINITY));
                drives.add(new Assembly.DriveAt(b, new Drive.Launch(0)));
            }
        }
        // A link's force may well be offset by its preload, and where an encoder counts from is anybody's choice; another motion sensor's
        // reading hardly is.
        List<Assembly.Output> outputs = new ArrayList<>();
        for (int o = 0; o < assembly.outputs().size(); o++) {
            Assembly.Output output = assembly.outputs().get(o);
            List<SensorFault> faults = new ArrayList<>(output.faults());
            double size = Motion.rms(evidence.measured(o), evidence.fit().length());
            double offset = model.driven() || output.reading() == Assembly.Reading.POSITION ? 10 : 0.1;
            knobs.add(Knob.sum(evidence.outputs().get(o) + " bias", new Slot(Slot.Kind.FAULT, o, faults.size(), 0), 0,
                    Math.max(0.1 * size, 1e-12),
                    -offset * size - 1e-9, offset * size + 1e-9, Double.POSITIVE_INFINITY));
            faults.add(new SensorFault.Bias(0));
            outputs.add(output.with(faults));
        }
        return new Candidate(new Assembly(assembly.structure(), assembly.laws(), drives, outputs), knobs, List.of());
    }

    /** A speed such as bodies have: what the measured forces, root mean square, give the lightest of them in a tenth of a second [m/s]. */
    static double speed(Evidence evidence) {
        double lightest = java.util.Arrays.stream(evidence.model().assembly().structure().mass()).min().orElse(1);
        return evidence.model().inputs().stream().mapToDouble(input -> Motion.rms(evidence.series(input.sensor()), evidence.fit().length()))
                .max().orElse(0) / lightest * 0.1 + 1e-12;
    }

    /** The mass of a body, unless it is another's too. */
    private static void addMass(List<Knob> knobs, Model model, int body, double farthest, double deviation) {
        Model.Body own = model.bodies().get(body);
        double known = Math.min(own.within().orElse(Double.POSITIVE_INFINITY) / 2, deviation);
        model.massKey(own).ifPresent(key -> add(knobs, own.name() + " " + key, Slot.of(Slot.Kind.MASS, body), own.mass(), farthest, known));
    }

    private static void add(List<Knob> knobs, String name, Slot slot, double value, double farthest, double deviation) {
        if (value > 0) {
            knobs.add(new Knob(name, slot, value, 0, -farthest, farthest, deviation));
        }
    }
}
