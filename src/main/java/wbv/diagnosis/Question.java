package wbv.diagnosis;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.SensorFault;
import wbv.diagnosis.convention.Meant;
import wbv.diagnosis.fit.Augmented;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.measured.Excerpts;
import wbv.diagnosis.mechanism.Library;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * What is asked of a diagnosis.
 *
 * @param simulation channel of the recording that holds what a simulation gave, where the model's own values are not what is in question
 * @param noise      standard deviation of a sample of the outputs where it is known, in their unit
 * @param unitsKnown whether somebody said the units of the recording, so that they are not doubted
 * @param provedFrom time from which on the recording serves for the proof only [s], see {@link Rides}; empty for its last part
 * @param library    what may be missing
 */
public record Question(Model model, Recording recording, Optional<Channel> simulation, OptionalDouble noise, boolean unitsKnown,
        OptionalDouble provedFrom, Library library) {

    public Question {
        if (noise.isPresent() && !(noise.getAsDouble() > 0)) {
            throw new IllegalArgumentException("noise must be > 0 in the outputs' unit: " + noise.getAsDouble());
        }
        simulation.filter(channel -> !recording.has(channel)).ifPresent(channel -> {
            throw new DataFault("the recording lacks the simulation " + channel + "; it has " + recording.channels());
        });
    }

    /** About mechanisms that wbv knows. */
    public Question(Model model, Recording recording, Optional<Channel> simulation, OptionalDouble noise, boolean unitsKnown) {
        this(model, recording, simulation, noise, unitsKnown, OptionalDouble.empty(), Library.standard());
    }

    /** With units that nobody said. */
    public Question(Model model, Recording recording, Optional<Channel> simulation, OptionalDouble noise) {
        this(model, recording, simulation, noise, false);
    }

    /** A model and a recording, nothing else known. */
    public static Question of(Model model, Recording recording) {
        return new Question(model, recording, Optional.empty(), OptionalDouble.empty());
    }

    /** The same, of other mechanisms. */
    public Question with(Library other) {
        return new Question(model, recording, simulation, noise, unitsKnown, provedFrom, other);
    }

    /**
     * The same, proven on what comes from a time on.
     *
     * @param time see {@link Rides#provedFrom}
     */
    public Question proved(OptionalDouble time) {
        return new Question(model, recording, simulation, noise, unitsKnown, time, library);
    }

    /** What is judged of a long recording; empty of one that is judged whole. */
    Optional<Excerpts> pieces() {
        return Excerpts.of(model, recording, provedFrom);
    }

    /** The same of pieces of the recording, where there are any. */
    Question of(Optional<Excerpts> pieces) {
        return pieces.map(some -> new Question(model, some.recording(), simulation, noise, unitsKnown, some.provedFrom(), library))
                .orElse(this);
    }

    /** The same of another recording. */
    Question with(Recording other) {
        return new Question(model, other, simulation, noise, unitsKnown, provedFrom, library);
    }

    /** Whether the numbers of the model are its user's, and none that a simulation has been fitted by. */
    boolean isOfGivenNumbers() {
        return simulation.isEmpty() && model.assembly().outputs().stream().flatMap(output -> output.faults().stream())
                .noneMatch(SensorFault.Beside.class::isInstance);
    }

    /** The same of a recording and a model as they are meant. */
    Question meant(Meant meant) {
        return new Question(meant.model().apply(model), meant.recording(), simulation, noise, unitsKnown, provedFrom, library);
    }

    /**
     * The model that stands for the simulation: driven links carry the given force; any other model is fitted to what the
     * simulation gave, so that it is the simulation's linear surrogate.
     */
    Model asked() {
        if (simulation.isEmpty()) {
            return model;
        }
        return model.driven() ? carrying(simulation.get()) : surrogate(simulation.get());
    }

    private Model carrying(Channel given) {
        if (given.quantity() != Quantity.FORCE) {
            throw new DataFault("the simulation of a driven link must be a force: " + given);
        }
        List<Model.Link> links = new ArrayList<>();
        for (Model.Link link : model.links()) {
            List<Drive> drives = new ArrayList<>(link.drives());
            link.sensor().ifPresent(sensor -> drives.add(new Drive.Given(given, 1)));
            links.add(link.completed(link.stiffness(), link.damping(), link.laws(), drives, link.faults()));
        }
        return model.with(model.bodies(), links);
    }

    private Model surrogate(Channel given) {
        List<Channel> alike = model.outputs().stream()
                .filter(output -> output.quantity() == given.quantity() && output.axis() == given.axis()).toList();
        if (alike.size() != 1) {
            throw new DataFault("the simulation " + given + " could stand for " + alike.size() + " of the model's outputs "
                    + model.outputs()
                    + "; it must be the only one of its quantity and axis");
        }
        Map<Channel, double[]> simulated = new HashMap<>();
        for (Channel channel : recording.channels()) {
            simulated.put(channel, recording.values(channel.equals(alike.get(0)) ? given : channel));
        }
        Evidence evidence = Evidence.computed(model, recording.with(simulated), noise);
        Candidate baseline = Baseline.of(evidence);
        Fitter fitter = new Fitter(evidence);
        Fitter.State fit = fitter.fit(baseline, baseline.start(), fitter.frame(baseline, baseline.start(), evidence.fit()), 20,
                1e-5);
        return Augmented.of(model, baseline.at(fit.x()));
    }
}
