package wbv.diagnosis.surrogate;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import wbv.body.Model;
import wbv.diagnosis.Diagnosed;
import wbv.diagnosis.Diagnoser;
import wbv.diagnosis.Question;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * The linear model that does what a simulation did of which only the outputs are known: bodies in a chain, one for each output,
 * and others where these alone do not do it, fitted to the simulation as driven by the recording's input.
 *
 * <p>What the model misses of the simulation is no error of the simulation: it is kept beside the model, as channels of the recording that
 * move the sensors too, so that both together are the simulation, whatever moved it; the model has to say only what changes where its
 * numbers do or something is added.
 *
 * <p>Accelerations know masses, stiffness and damping only up to a common factor: the mass of all bodies is assumed.
 *
 * @param model  with a sensor for every output that the recording has too, to which the recording's further channels add
 * @param errors root mean square of what the model misses of an output over that of the output, by channel of the simulation
 * @param unasked the same of outputs across the input's axis of which it misses too much: nothing is known of what a change of the
 *                simulation would do to them, and the model does not read them
 * @param recording the part of the recording that the simulation covers, with what the simulation gave beside the model
 * @param name   what messages call the simulation
 */
public record Surrogate(Model model, Map<Channel, Double> errors, Map<Channel, Double> unasked, Recording recording, String name) {

    /** A surrogate that misses a greater share of an output is none. */
    static final double MOST = 0.1;

    public Surrogate {
        errors = Collections.unmodifiableMap(new LinkedHashMap<>(errors));
        unasked = Collections.unmodifiableMap(new LinkedHashMap<>(unasked));
        if (!model.outputs().stream().allMatch(recording::has)) {
            throw new IllegalArgumentException("a surrogate reads what was recorded: " + model.outputs());
        }
    }

    /**
     * Diagnoses what a simulation leaves out of a recording. First the two are held against each other as they are; only where sensors and
     * a person who sits still do not explain the difference is a model needed that does what the simulation did.
     *
     * @param noise      standard deviation of a sample of the outputs where it is known
     * @param unitsKnown see {@link Question}
     * @param progress   told the step and the share of it that is done, 0 to 1 or NaN
     * @throws DataFault if the two have no output or no time in common, or differ and no chain does what the simulation did
     */
    public static Examined examine(Recording recording, Simulated simulated, OptionalDouble noise, boolean unitsKnown,
            BiConsumer<String, Double> progress) {
        Asked asked = asked(recording, simulated, noise, unitsKnown, progress);
        // What it was found from is not kept: of a long recording that is as much again.
        return asked.silent().orElseGet(
                () -> new Examined(asked.surrogate(), Diagnoser.examine(asked.surrogate().question(noise, unitsKnown), progress)));
    }

    /** A surrogate that is good enough to be asked what is missing, if that is asked. */
    private record Asked(Surrogate surrogate, Optional<Examined> silent) {}

    private static Asked asked(Recording recording, Simulated simulated, OptionalDouble noise, boolean unitsKnown,
            BiConsumer<String, Double> progress) {
        DrivenSimulation driven = DrivenSimulation.of(recording, simulated);
        Optional<InPlane> plane = InPlane.of(driven);
        Optional<Examined> silent = silent(driven, plane, noise, unitsKnown, progress);
        Surrogate best = silent.map(Examined::surrogate).orElseGet(() -> best(driven, plane, progress));
        if (silent.isEmpty()) {
            best.require(simulated.input());
        }
        return new Asked(best, silent);
    }

    /**
     * As {@link #examine}, where sensors and a person who sits still explain the difference; empty where they do not, and no more is looked
     * for.
     */
    public static Optional<Examined> unremarkable(Recording recording, Simulated simulated, OptionalDouble noise, boolean unitsKnown,
            BiConsumer<String, Double> progress) {
        DrivenSimulation driven = DrivenSimulation.of(recording, simulated);
        return silent(driven, InPlane.of(driven), noise, unitsKnown, progress);
    }

    private static Optional<Examined> silent(DrivenSimulation driven, Optional<InPlane> plane, OptionalDouble noise, boolean unitsKnown,
            BiConsumer<String, Double> progress) {
        Surrogate plain = plane.map(found -> driven.surrogate(found.simulated, found.plain)).filter(Surrogate::isGood)
                .orElseGet(() -> driven.surrogate(driven.plain()));
        return Diagnoser.silent(plain.question(noise, unitsKnown), progress).map(found -> new Examined(plain, found));
    }

    /** What a simulation did in a plane, and the measured bodies alone that come nearest to it. */
    private record InPlane(SimulatedPlane simulated, PlaneNet plain) {
        static Optional<InPlane> of(DrivenSimulation driven) {
            return driven.plane().map(simulated -> new InPlane(simulated, simulated.plain()));
        }
    }

    /** A surrogate and what came of the recording with it. */
    public record Examined(Surrogate surrogate, Diagnosed diagnosed) {}

    /** The best surrogate of a simulation, however good it is. */
    static Surrogate of(Recording recording, Simulated simulated, BiConsumer<String, Double> progress) {
        DrivenSimulation driven = DrivenSimulation.of(recording, simulated);
        return best(driven, InPlane.of(driven), progress);
    }

    /** Of bodies in the plane if they do what the simulation did, else of a chain. */
    private static Surrogate best(DrivenSimulation driven, Optional<InPlane> plane, BiConsumer<String, Double> progress) {
        return plane.map(found -> driven.surrogate(found.simulated, found.simulated.best(found.plain, progress))).filter(Surrogate::isGood)
                .orElseGet(() -> driven.surrogate(driven.best(progress)));
    }

    private Question question(OptionalDouble noise, boolean unitsKnown) {
        return new Question(model, recording, Optional.empty(), noise, unitsKnown);
    }

    private boolean isGood() {
        return errors.values().stream().allMatch(error -> error <= MOST);
    }

    /** Refuses where nothing can be said of what a change of the simulation would do. */
    private void require(Channel input) {
        for (Map.Entry<Channel, Double> entry : errors.entrySet()) {
            if (entry.getValue() > MOST) {
                throw DataFault.in(name,
                        text("as it is, it leaves more of the recording than sensors do, and no chain of bodies driven by %s does what it "
                                + "does: the nearest, %s, misses %.3g %% of %s, %.0f %% may be missed; is it the right input? If the "
                                + "simulation is not linear, give a model "
                                + "(--model)", input, chain(), 100 * entry.getValue(), entry.getKey(), 100 * MOST));
            }
        }
    }

    /** {@code platform-pelvis, pelvis-head}. */
    private String chain() {
        return model.links().stream().map(link -> Model.whole(link.from()) + "-" + Model.whole(link.to())).distinct()
                .collect(Collectors.joining(", "));
    }

    /** What it is and how well it does, in a line; one that misses much serves where what the simulation gave is enough by itself. */
    public String sentence() {
        return !isGood()
                ? name + " is held against the recording as it is: sensors explain what they differ by, and no model of it is needed"
                : model.source().orElse("") + ": " + chain() + "; misses " + shares(errors)
                        + (unasked.isEmpty() ? "" : "; not asked, since it misses " + shares(unasked));
    }

    private static String shares(Map<Channel, Double> missed) {
        return missed.entrySet().stream().map(entry -> percent(entry.getValue()) + " of " + entry.getKey())
                .collect(Collectors.joining(", "));
    }

    private static String percent(double share) {
        return share < 1e-4 ? "under 0.01 %" : text("%.2g %%", 100 * share);
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
