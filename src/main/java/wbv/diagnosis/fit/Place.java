package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Structure;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Scene;

/**
 * Where something that a model lacks enters: as a force on a body or in a link, or as an error of a sensor. Whatever it is, it reaches the
 * outputs along one known direction at each frequency.
 *
 * @param index of the body, link or output; of a device's first output
 */
public record Place(Kind kind, int index) {

    /** What it is a place of. */
    public enum Kind {
        BODY, LINK, SENSOR,
        /** All channels of a sensor of several axes at once. */
        DEVICE;

        /** {@code body}, {@code link}, {@code sensor} or {@code device}. */
        public String word() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** Where something enters along one direction. */
    public static List<Place> all(Evidence evidence) {
        List<Place> out = new ArrayList<>();
        IntStream.range(0, evidence.model().bodies().size()).forEach(b -> out.add(new Place(Kind.BODY, b)));
        IntStream.range(0, evidence.model().links().size()).forEach(l -> out.add(new Place(Kind.LINK, l)));
        IntStream.range(0, evidence.outputs().size()).forEach(o -> out.add(new Place(Kind.SENSOR, o)));
        return out;
    }

    /** The same and whole devices, where other sensors are left to tell. */
    public static List<Place> andDevices(Evidence evidence) {
        List<Place> out = new ArrayList<>(all(evidence));
        IntStream.range(0, evidence.outputs().size()).mapToObj(o -> device(evidence, o)).distinct()
                .filter(device -> device.channels(evidence).size() > 1 && !device.isAllThatMeasures(evidence)).forEach(out::add);
        return out;
    }

    /** The device that makes an output, if of that alone. */
    public static Place device(Evidence evidence, int output) {
        return new Place(Kind.DEVICE, Scene.device(evidence.outputs(), evidence.onRig(), output).get(0));
    }

    /**
     * Outputs that are late together: those of a device, which has one clock. What stands for a simulation is not quite as that in the
     * phase of each output, which a delay of its own takes.
     */
    static List<Integer> late(Evidence evidence, int output) {
        return evidence.standsForSimulation() ? List.of(output) : device(evidence, output).channels(evidence);
    }

    /** Whether it is a device that makes all outputs: no other sensor is left to tell of it. */
    public boolean isAllThatMeasures(Evidence evidence) {
        return kind == Kind.DEVICE && channels(evidence).size() == evidence.outputs().size();
    }

    /** Outputs that a sensor or a device makes. */
    public List<Integer> channels(Evidence evidence) {
        return kind == Kind.SENSOR ? List.of(index) : Scene.device(evidence.outputs(), evidence.onRig(), index);
    }

    /** What it is made of: of a device its channels, of anything else itself. */
    public List<Place> each(Evidence evidence) {
        return kind == Kind.DEVICE ? channels(evidence).stream().map(output -> new Place(Kind.SENSOR, output)).toList() : List.of(this);
    }

    /** Whether it is no place of a force. */
    public boolean isSensor() {
        return kind == Kind.SENSOR || kind == Kind.DEVICE;
    }

    /** Where a hypothesis acts. */
    public static Place of(Hypothesis hypothesis) {
        Addition first = hypothesis.additions().get(0);
        if (first instanceof Addition.InLink in) {
            return new Place(Kind.LINK, in.link());
        }
        if (first instanceof Addition.Driven driven) {
            return new Place(driven.drive().actsOnBody() ? Kind.BODY : Kind.LINK, driven.place());
        }
        if (first instanceof Addition.AtSensor at) {
            return hypothesis.additions().size() > 1 && hypothesis.additions().get(1) instanceof Addition.Alike alike
                    ? new Place(Kind.DEVICE, alike.device()) : new Place(Kind.SENSOR, at.output());
        }
        return new Place(Kind.BODY, ((Addition.Hidden) first).body());
    }

    /**
     * Where a hypothesis acts, by its plain name.
     *
     * @param on what it stands on, or is part of
     */
    public static Place plain(Hypothesis hypothesis, Candidate on) {
        return of(hypothesis).plain(on.template());
    }

    /** Where the last hypothesis of a fit acts, by its plain name. */
    public static Place ofLast(Fitter.State fit) {
        return plain(fit.candidate().last(), fit.candidate());
    }

    /** As people know it: a body's name, a link's ends, a channel, a device's location. */
    public String name(Evidence evidence) {
        return switch (kind) {
            case BODY -> evidence.model().bodies().get(index).name();
            case LINK -> evidence.model().links().get(index).name();
            case SENSOR -> evidence.outputs().get(index).toString();
            case DEVICE -> evidence.outputs().get(index).location();
        };
    }

    /** The same place by another name: a body on the base feels what acts on it and what acts in its link to the base alike. */
    public Place plain(Assembly assembly) {
        return kind != Kind.BODY ? this : IntStream.range(0, assembly.structure().links())
                .filter(l -> assembly.structure().standsOnBase(l, index))
                .mapToObj(l -> new Place(Kind.LINK, l)).findFirst().orElse(this);
    }

    /** Whether what enters at another place hardly shows where this sensor is ignored: on the body that it sits on, and in its links. */
    public boolean hides(Place other, Assembly assembly) {
        if (kind != Kind.SENSOR || assembly.outputs().get(index).reads().at().length != 1) {
            return false;
        }
        int body = assembly.outputs().get(index).place();
        return switch (other.kind) {
            case BODY -> other.index == body;
            case LINK -> Arrays.stream(assembly.structure().stretch(other.index).at()).anyMatch(at -> at == body);
            default -> false;
        };
    }

    /**
     * A fit, as coordinates [1], one a knob, in which this place was ignored, with the place's own numbers as the user gave them, since
     * nothing told them: a link's, a body's mass, and that of a body on the base, on which a force in its link acts.
     *
     * @param x coordinates [1], one a knob. Not modified.
     */
    public double[] asGiven(Candidate baseline, double[] x) {
        double[] out = x.clone();
        double[] given = baseline.start();
        for (int i = 0; i < given.length; i++) {
            Slot slot = baseline.knobs().get(i).slot();
            boolean own = slot.kind() == Slot.Kind.MASS ? new Place(Kind.BODY, slot.at()).plain(baseline.template()).equals(this)
                    : kind == Kind.LINK && slot.at() == index && (slot.kind() == Slot.Kind.STIFFNESS || slot.kind() == Slot.Kind.DAMPING);
            out[i] = own ? given[i] : out[i];
        }
        return out;
    }

    /**
     * A unit force here, as it acts on bodies: on their coordinates, [1] or in a turn's lever arm [m], one a body.
     *
     * @throws IllegalStateException if it is a sensor's
     */
    public double[] onBodies(Structure structure) {
        if (isSensor()) {
            throw new IllegalStateException("no force acts at a sensor");
        }
        double[] out = new double[structure.bodies()];
        if (kind == Kind.BODY) {
            out[index] = 1;
        } else {
            Arrays.setAll(out, body -> -structure.incidence(body, index));
        }
        return out;
    }

    /**
     * What a unit of anything that enters here does to each output at every line of an excitation, spectra by output; of a device each
     * channel does that by itself.
     */
    public double[][] direction(Excitation excitation, Assembly assembly) {
        return direction(() -> new Simulator(excitation).linearised(assembly), assembly.outputs().size(), excitation.omega().length);
    }

    /**
     * The same, of a model that was linearised already.
     *
     * @param linear asked for forces only
     * @param lines of the excitation
     */
    public double[][] direction(Supplier<Simulator.Linearised> linear, int outputs, int lines) {
        if (!isSensor()) {
            return kind == Kind.BODY ? linear.get().ofBodyForce(index) : linear.get().ofLinkForce(index);
        }
        double[][] out = new double[outputs][2 * lines];
        for (int k = 0; k < out[index].length; k += 2) {
            out[index][k] = 1;
        }
        return out;
    }
}
