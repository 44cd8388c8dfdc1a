package wbv.diagnosis;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Library;
import wbv.diagnosis.mechanism.Mechanism;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.Priors;

/** The recording that would settle what two mechanisms leave open. */
final class Experiments {

    /** In place of a nod, where the rotation of the place is known already. */
    private static final String ARM = "Move the sensor a known way, 50 mm fore or aft, and record again: how it turns is recorded, so "
            + "what a rotation adds must change by just that arm; what crosses over from another axis stays.";
    private static final String SEAT = "Measure the force under the seat pan, or put a second sensor on the platform and swap "
            + "the two: a force on the first body, one in the link below it and a fault of the platform's sensor move all "
            + "bodies alike.";
    private static final String SCALE = "Weigh who or what is moved, or record the force under it once: forces are known only "
            + "up to the scale of the masses.";

    static final String AGAIN = "Record the same ride again, twice as long: a law comes back in every part of it, an event does not.";
    static final String CAUSE = "See that the input is the channel that drives what was measured, on the same clock, and that both have "
            + "the sign and the unit of the model; then shake harder, or record a quiet trial: what is there without the ride is not "
            + "caused by it.";

    private final Library library;

    Experiments(Library library) {
        this.library = library;
    }

    /**
     * What would settle a diagnosis: the leading name against its best rival, or the two best rivals where there is no name.
     * Where the name is beyond doubt, what would settle its size.
     *
     * @param base   the link that stands on the base, and the body on it: places that no motion tells apart
     * @param scaled whether forces are known only up to the scale of the masses
     * @param turned whether it was recorded how the person or the base turns: then nobody need shake that
     */
    String between(List<Diagnosis.Named> missing, List<Diagnosis.Named> alternatives, Set<String> base, boolean scaled, boolean turned) {
        String best = between(missing, alternatives, base, scaled);
        return turned && best.equals(Family.COUPLING.experiment()) ? ARM : best;
    }

    private String between(List<Diagnosis.Named> missing, List<Diagnosis.Named> alternatives, Set<String> base, boolean scaled) {
        List<Diagnosis.Named> leading = missing.isEmpty() ? alternatives : missing.subList(missing.size() - 1, missing.size());
        if (leading.isEmpty()) {
            return "";
        }
        Diagnosis.Named first = leading.get(0);
        boolean force = first.parameters().keySet().stream().anyMatch(MassScale::scales);
        if (!missing.isEmpty() && scaled && first.probability() >= Priors.HELD && force) {
            return SCALE;
        }
        Optional<Diagnosis.Named> second = (missing.isEmpty() ? alternatives.stream().skip(1) : alternatives.stream())
                .findFirst();
        if (second.isEmpty()) {
            return alone(library.of(first.mechanism()));
        }
        return between(first, second.get(), base);
    }

    private String between(Diagnosis.Named first, Diagnosis.Named second, Set<String> base) {
        Optional<Mechanism> one = library.of(first.mechanism());
        Optional<Mechanism> other = library.of(second.mechanism());
        boolean force = isForce(one) != isForce(other);
        if (force && base.contains(first.where()) && base.contains(second.where())) {
            return SEAT;
        }
        boolean same = first.mechanism().equals(second.mechanism());
        if (same && !first.where().equals(second.where())) {
            return "Put one more sensor between " + first.where() + " and " + second.where()
                    + ", or block what moves there: only one of the two places moves what lies between them.";
        }
        return one.flatMap(a -> other.filter(b -> !same).flatMap(b -> between(a, b))).orElseGet(() -> alone(one));
    }

    /** What either knows of the other, or else what their families say. */
    private static Optional<String> between(Mechanism one, Mechanism other) {
        return one.against(other).or(() -> other.against(one)).or(() -> Family.between(one.family(), other.family()));
    }

    private static boolean isForce(Optional<Mechanism> mechanism) {
        return mechanism.filter(it -> it.family() == Family.FORCE).isPresent();
    }

    private static String alone(Optional<Mechanism> mechanism) {
        return mechanism.map(it -> it.entry().experiment()).orElse(Family.LEVELS);
    }
}
