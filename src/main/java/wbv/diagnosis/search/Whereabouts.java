package wbv.diagnosis.search;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * Where a mismatch can enter at all, found before any mechanism is tried: what a place leaves that is ignored, no mechanism there explains
 * either. What it leaves shows the person's own force, which no hypothesis has bent yet; and the numbers of the model that fit then are not
 * bent by the lack of a mechanism.
 */
public final class Whereabouts {

    private final Evidence evidence;
    private final Candidate baseline;
    private final Places places;
    private final Predicate<Hypothesis> likely;

    /**
     * Places where the mismatch may enter, likeliest first, as they were found.
     *
     * @param inPart whether a part of the data may show what all of them do, for all that is known
     */
    private record Places(List<Known.Ignoring> found, boolean inPart) {}

    private Whereabouts(Evidence evidence, Candidate baseline, Places places, Predicate<Hypothesis> likely) {
        this.evidence = evidence;
        this.baseline = baseline;
        this.places = places;
        this.likely = likely;
    }

    /**
     * Nothing is known.
     *
     * @param baseline what may explain a part of the mismatch already
     */
    public static Whereabouts anywhere(Evidence evidence, Candidate baseline) {
        return new Whereabouts(evidence, baseline, new Places(List.of(), true), hypothesis -> true);
    }

    /**
     * It is known to be one of some.
     *
     * @param places by their plain names, likeliest first, with the model's numbers as they fit beside each
     */
    static Whereabouts among(Evidence evidence, Candidate baseline, Map<Place, double[]> places) {
        List<Known.Ignoring> found = places.keySet().stream()
                .map(place -> new Known.Ignoring(List.of(place), places.get(place), Double.NaN)).toList();
        return new Whereabouts(evidence, baseline, new Places(found, true),
                hypothesis -> places.containsKey(Place.plain(hypothesis, baseline)));
    }

    /**
     * What ignoring one place after the other shows. Every place will do where the outputs do not tell, or where a person's own force,
     * which nobody knows yet, may be what makes one body look better than all other places.
     *
     * @param base what was fitted, and may explain a part of the mismatch already. Kept and not modified.
     */
    public static Whereabouts found(Evidence evidence, Fitter.State base) {
        Candidate baseline = base.candidate();
        boolean byTheClock = baseline.added().stream().anyMatch(Hypothesis::byTheClock);
        Optional<Evidence> part = byTheClock ? Optional.empty() : evidence.brief();
        return part.filter(brief -> shows(brief, base))
                .map(brief -> beside(evidence, baseline, new Places(new Locator(brief, baseline).singles(base.x()), true)))
                .filter(Whereabouts::hold)
                .orElseGet(() -> beside(evidence, baseline, new Places(new Locator(evidence, baseline).singles(base.x()), part.isEmpty())));
    }

    /**
     * Whether the model fitted to a part of the data leaves there about as much as it does of all: what changes at a moment need not be in
     * it, and then every place would do.
     */
    private static boolean shows(Evidence part, Fitter.State base) {
        return Refinement.excess(base.reduced()) < Effort.ALIKE * Refinement.excess(fitted(part, base.candidate(), base.x()).reduced());
    }

    private static Whereabouts beside(Evidence evidence, Candidate baseline, Places places) {
        Set<Place> near = near(baseline, places.found(), Priors.STRANGE - 1);
        boolean told = !places.found().isEmpty()
                && (evidence.acting().any() || plain(baseline, places.found().get(0)).kind() != Place.Kind.BODY);
        return new Whereabouts(evidence, baseline, places, hypothesis -> !told || near.contains(Place.plain(hypothesis, baseline)));
    }

    /**
     * Whether all data show no more beside the likeliest place than those do on which the places were found; true where outputs tell none.
     */
    private boolean hold() {
        if (places.found().isEmpty()) {
            return true;
        }
        Known.Ignoring first = places.found().get(0);
        return Refinement.excess(whole(first).fit().reduced()) < Effort.ALIKE * Refinement.excess(first.reduced());
    }

    /** The fit on all data beside a place. */
    private VariableProjection.Turn whole(Known.Ignoring place) {
        return new Locator(evidence, baseline).beside(place);
    }

    /**
     * Where the mismatch may enter if not where it is likeliest to, at a sensor whose faults do not explain it: a sensor has no law of its
     * own that could be none of the library's. Empty where that is not so, or nowhere else.
     *
     * @param most excess [1] that an arbitrary signal there may leave
     */
    public Optional<Whereabouts> besideSensor(double most) {
        Set<Place> near = near(baseline, places.found(), Priors.STRANGE - 1);
        Set<Place> farther = places.found().stream().filter(found -> found.reduced() - 1 <= most).map(found -> plain(baseline, found))
                .filter(place -> !near.contains(place)).collect(Collectors.toSet());
        return near.isEmpty() || farther.isEmpty() || !near.stream().allMatch(Place::isSensor) ? Optional.empty()
                : Optional.of(new Whereabouts(evidence, baseline, places, h -> farther.contains(Place.plain(h, baseline))));
    }

    /** The same for some hypotheses only. */
    public Whereabouts only(Predicate<Hypothesis> open) {
        return new Whereabouts(evidence, baseline, places, likely.and(open));
    }

    /** Whether a part of the data may show what all of them do, for all that is known. */
    boolean inPart() {
        return places.inPart();
    }

    /** Whether a hypothesis acts where the mismatch can enter. */
    boolean likely(Hypothesis hypothesis) {
        return likely.test(hypothesis);
    }

    /**
     * What a fit leaves, as a mean square of the whitened residual, that no other leaves much less than wherever it acts; what cannot be
     * noise where nothing is known of places.
     */
    double reach() {
        return places.found().isEmpty() || Double.isNaN(places.found().get(0).reduced()) ? Priors.STRANGE
                : Locator.reach(places.found(), Effort.BEHIND);
    }

    /** The model's numbers as they fit beside whatever enters where a hypothesis acts. */
    Optional<double[]> unbent(Hypothesis hypothesis) {
        Place place = Place.plain(hypothesis, baseline);
        return places.found().stream().filter(found -> plain(baseline, found).equals(place))
                .map(found -> place.asGiven(baseline, found.x())).findFirst();
    }

    /** The same beside whatever enters at the likeliest place. */
    Optional<double[]> unbent() {
        return places.found().stream().map(found -> plain(baseline, found).asGiven(baseline, found.x())).findFirst();
    }

    /**
     * What a person does who sits still, told apart from the mismatch by ignoring where that enters; empty where it cannot be. What goes
     * with the base is something else that is missing: no law is left whose form it could be.
     */
    public Optional<BodyForce> ownForce() {
        return force(BodyForce::aboveBase, force -> force.ordinary(evidence) && !force.coherent());
    }

    /** A force of more than that which does not follow the ride either, and shows where the rest of the mismatch is ignored. */
    public Optional<BodyForce> push() {
        return force(BodyForce::onAnyBody, force -> force.following().isSteady() && !force.coherent() && !force.ordinary(evidence));
    }

    private Optional<BodyForce> force(BiFunction<Evidence, Fitter.State, Optional<BodyForce>> sought, Predicate<BodyForce> kind) {
        if (evidence.outputs().size() < Locator.FEWEST_OUTPUTS) {
            return Optional.empty();
        }
        Set<Place> near = near(baseline, places.found(), 0);
        List<Known.Ignoring> asked = places.found().stream().filter(found -> near.remove(plain(baseline, found))).limit(Effort.PLACES)
                .toList();
        for (Known.Ignoring found : asked) {
            Evidence blind = whole(found).evidence();
            Fitter.State without = whole(found).fit();
            if (without.reduced() < Priors.NOISE) {
                return Optional.empty();
            }
            Optional<BodyForce> force = sought.apply(blind, without).filter(kind);
            if (force.isPresent()
                    && fitted(blind.with(force.get()), baseline, without.x()).reduced() - 1 < Priors.MAJORITY * (without.reduced() - 1)) {
                return force;
            }
        }
        return Optional.empty();
    }

    /** @param least excess that is near in any case */
    private static Set<Place> near(Candidate baseline, List<Known.Ignoring> places, double least) {
        double most = Math.max(1 + least, Locator.reach(places, Effort.ALIKE));
        return places.stream().filter(found -> found.reduced() <= most).map(found -> plain(baseline, found))
                .collect(Collectors.toCollection(HashSet::new));
    }

    private static Place plain(Candidate baseline, Known.Ignoring found) {
        return found.places().get(0).plain(baseline.template());
    }

    private static Fitter.State fitted(Evidence seen, Candidate baseline, double[] start) {
        return new Search(seen, (step, share) -> {}).base(baseline, start);
    }
}
