package wbv.diagnosis.search;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import wbv.body.Assembly;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Entering;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A second mechanism beside one that leaves little: too little to be seen before the first was named. What is left has to come from another
 * place and to go with one more hypothesis, on data not used as well.
 */
public final class SecondMechanism {

    private final Evidence evidence;
    private final Search search;
    private final Supplier<PairSearch> pairs;
    private final Refinement refinement;

    /**
     * Beside mechanisms that were found on this evidence.
     *
     * @param pairs compares what is found
     */
    public SecondMechanism(Evidence evidence, Search search, Supplier<PairSearch> pairs) {
        this.evidence = evidence;
        this.pairs = pairs;
        this.search = search;
        this.refinement = search.refinement();
    }

    /** The fit with a second mechanism; empty where nothing asks for one. */
    public Optional<Chosen> of(Fitter.State single) {
        boolean asked = Math.min(single.reduced(), refinement.heldOut(single)) > Priors.SILENT;
        Set<Place> elsewhere = asked ? elsewhere(single) : Set.of();
        return elsewhere.isEmpty() ? Optional.empty() : raced(single, h -> elsewhere.contains(Place.plain(h, single.candidate())))
                .map(fit -> pairs.get().beside(single, simplest(single, fit), elsewhere));
    }

    /**
     * The likeliest places of those from which what is left comes clearly more likely than from where the first mechanism acts, whose form
     * is never the last word.
     */
    private Set<Place> elsewhere(Fitter.State single) {
        Simulator simulator = new Simulator(evidence.excitation());
        Assembly assembly = simulator.equivalent(single.candidate().at(single.x()));
        Map<Place, Double> left = new HashMap<>();
        Place.all(evidence)
                .forEach(place -> left.put(place, Entering.left(evidence, single, place.direction(evidence.excitation(), assembly))));
        // Of a device, whose channels may all err, the least that one of them leaves.
        Place first = Place.ofLast(single);
        double own = first.isSensor()
                ? first.channels(evidence).stream().mapToDouble(o -> left.get(new Place(Place.Kind.SENSOR, o))).min().orElseThrow()
                : left.get(first);
        double near = 1 + Effort.ALIKE * Refinement.excess(left.values().stream().mapToDouble(Double::doubleValue).min().orElseThrow());
        return left.keySet().stream().filter(place -> !Calibration.standard().isAsLikely(own, left.get(place)) && left.get(place) <= near)
                .map(place -> place.plain(single.candidate().template()))
                // A body on the base feels what its link does: the same place by another name.
                .filter(place -> !place.equals(first.plain(single.candidate().template())))
                .collect(Collectors.toSet());
    }

    /** The fit, or one with a simpler law at its place, as a memory in that of a reflex, where that is as likely. */
    private Fitter.State simplest(Fitter.State single, Fitter.State fit) {
        Hypothesis found = fit.candidate().last();
        return raced(single, found::yieldsTo).filter(other -> Calibration.standard().isAsLikely(other.reduced(), fit.reduced()))
                .orElse(fit);
    }

    private Optional<Fitter.State> raced(Fitter.State single, Predicate<Hypothesis> open) {
        return search.racedAsMoved(single.candidate(), single.x(), single.frame(),
                search.hypotheses(single).stream().filter(open).toList());
    }
}
