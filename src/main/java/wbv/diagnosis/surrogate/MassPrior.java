package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import wbv.body.Model;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Slot;

/**
 * How masses are expected to be: about as usual, against that of the heaviest body.
 *
 * <p>What a base's motion does to bodies tells their masses ill, once a chain is not all that there is: one that misses 2 % may put a third
 * of a person into the seat, and then carries a force in a link wrongly by a half. So a segment's mass is expected to be about what such a
 * segment weighs, and the more so, the more the arrangement misses; where it misses nothing the masses are the data's.
 *
 * @param spread standard deviation of a mass' natural logarithm about that of the usual one [1]; infinite for masses that are free
 */
record MassPrior(double spread) {

    /**
     * By what natural logarithm such a mass differs from one person, seat and cut through the body to the next: a factor of 1.5, assumed.
     */
    static final double USUAL_SPREAD = 0.4;
    /** Where the search for it ends: what so wide a spread leaves out is one in fifteen thousand. */
    private static final double FARTHEST = 4 * USUAL_SPREAD;

    /** Nothing is expected: masses are the data's. */
    static final MassPrior FREE = new MassPrior(Double.POSITIVE_INFINITY);

    MassPrior {
        if (!(spread > 0)) {
            throw new IllegalArgumentException("the spread of masses must be > 0: " + spread);
        }
    }

    /**
     * The prior beside an arrangement that is not the right one, which errs once by output, not by line.
     *
     * @param missed what it misses
     */
    static MassPrior beside(FittedChain missed) {
        return new MassPrior(USUAL_SPREAD * Math.sqrt(missed.errors().size() / missed.square()));
    }

    /**
     * A candidate with masses that are expected so.
     *
     * @param model that its knobs go by
     */
    Candidate of(Candidate baseline, Model model) {
        Model.Body heaviest = model.bodies().stream().max(Comparator.comparingDouble(Model.Body::mass)).orElseThrow();
        Optional<Segment> most = Segment.at(heaviest.name());
        if (Double.isInfinite(spread) || most.isEmpty()) {
            return baseline;
        }
        List<Knob> knobs = new ArrayList<>();
        for (Knob knob : baseline.knobs()) {
            Optional<Segment> segment = knob.slot().kind() == Slot.Kind.MASS ? Segment.at(model.bodies().get(knob.slot().at()).name())
                    : Optional.empty();
            knobs.add(segment.map(own -> expected(knob, heaviest.mass() * own.mass() / most.get().mass())).orElse(knob));
        }
        return new Candidate(baseline.template(), knobs, List.of());
    }

    private Knob expected(Knob knob, double usual) {
        double far = Math.max(FARTHEST, Math.abs(Math.log(knob.reference() / usual)) + USUAL_SPREAD);
        return new Knob(knob.name(), knob.slot(), usual, 0, -far, far, spread);
    }
}
