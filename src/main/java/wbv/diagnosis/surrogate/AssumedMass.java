package wbv.diagnosis.surrogate;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.body.Model;
import wbv.recording.Metadata;

/**
 * The mass that is taken to sit, or to be moved: accelerations know masses, stiffness and damping only up to a common factor.
 *
 * @param sitting [kg], &gt; 0
 * @param why     it is taken, to follow "its mass of so many kg"
 */
record AssumedMass(double sitting, String why) {

    /** What sits of a person of whom nothing is known [kg], and of one whose mass is [1]. */
    private static final double USUAL = 55;
    private static final double SHARE = 0.73;

    AssumedMass {
        if (!(sitting > 0)) {
            throw new IllegalArgumentException("what sits must have a mass > 0: " + sitting + " kg");
        }
    }

    /**
     * By what is known.
     *
     * @param moved by the input, as a user says [kg]
     * @param known of the subject
     */
    static AssumedMass of(OptionalDouble moved, Metadata known) {
        OptionalDouble person = known.subject().map(Metadata.Subject::mass).orElseGet(OptionalDouble::empty);
        return moved.isPresent() ? new AssumedMass(moved.getAsDouble(), "is given")
                : person.isPresent()
                        ? new AssumedMass(SHARE * person.getAsDouble(), "is assumed for a person of " + person.getAsDouble() + " kg")
                        : new AssumedMass(USUAL, "is assumed");
    }

    /** A model along one axis with that mass in all, and stiffness and damping to match. */
    Model given(Model model) {
        double factor = sitting / model.mass();
        List<Model.Body> bodies = model.bodies().stream()
                .map(body -> body.completed(factor * body.mass(), body.faults(), body.hidden(), body.forces())).toList();
        List<Model.Link> links = model.links().stream().map(
                link -> link.completed(factor * link.stiffness(), factor * link.damping(), link.laws(), link.drives(), link.faults()))
                .toList();
        return model.with(bodies, links);
    }

    /**
     * A model that says what it stands for and that its mass is assumed.
     *
     * @param name of the simulation
     * @param how  it stands for it, to follow the name
     */
    Model told(Model model, String name, String how) {
        String source = String.format(Locale.ROOT, "linear surrogate of %s%s, identified by wbv%s; its mass of %.1f kg %s", name,
                how, model.isRig() ? " as a rig" : "", sitting, why);
        return new Model("surrogate of " + name, Optional.of(source), model.axis(), model.base(), model.bodies(), model.links(),
                model.inputs(), model.declared(), model.sensors());
    }
}
