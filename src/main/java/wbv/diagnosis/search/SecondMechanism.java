package wbv.diagnosis.search;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import wbv.body.Assembly;
import wbv.body.law.Reflex;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Entering;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A second mechanism beside one that leaves little: too little to be seen before the first was named. Either a number of the model still
 * has to be far off, which a memory would spare it, or what is left goes with one more hypothesis, on data not used as well.
 */
public final class SecondMechanism {

    /** What is left of the mean square that is worth a search. */
    private static final double WORTH = 1.25;
    private static final double LEAST_DROP = 0.1;
    /** The same where the model's own numbers speak for it. */
    private static final double LEAST_PART = 0.04;
    /** How much more than a mechanism a simpler one may leave that is preferred to it, in units of what that one leaves. */
    private static final double NEARLY = 0.5;

    /** How many times the excess that the likeliest place leaves another may leave and still be where it comes from. */
    private static final double NEAR = 2;
    /** Part of what cannot come from the first one's place that has to come from another, to be more than scatter. */
    private static final double CLEARLY = 0.2;

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

    /**
     * The fit with a second mechanism; empty where nothing asks for one.
     *
     * @param searched whether a second one was looked for already
     */
    public Optional<Chosen> of(Fitter.State single, boolean searched) {
        if (evidence.onRig()) {
            return Optional.empty();
        }
        Optional<Chosen> odd = byNumber(single).map(Chosen::single);
        return odd.isPresent() || searched ? odd : byWhatIsLeft(single);
    }

    /** Where another link's stiffness is odd, what spares it that. */
    private Optional<Fitter.State> byNumber(Fitter.State single) {
        Optional<OddLink> odd = evidence.standsForSimulation() ? Optional.empty()
                : OddLink.in(search.fitter().lookWithSlopes(single.candidate(), single.x(), single.frame()));
        return odd.filter(link -> !Place.ofLast(single).equals(new Place(Place.Kind.LINK, link.link())))
                .flatMap(link -> search.best(single, h -> link.isMemory(h)).map(fit -> link.held(search.fitter(), fit))
                        .filter(link::cameBack))
                .filter(fit -> single.reduced() - fit.reduced() > LEAST_PART * (single.reduced() - 1)
                        && carriesOver(single, fit));
    }

    private boolean carriesOver(Fitter.State single, Fitter.State fit) {
        double held = refinement.heldOut(single);
        return held - refinement.heldOut(fit) > LEAST_PART * (held - 1);
    }

    private Optional<Chosen> byWhatIsLeft(Fitter.State single) {
        Set<Place> elsewhere = Math.min(single.reduced(), refinement.heldOut(single)) < WORTH ? Set.of() : elsewhere(single);
        return elsewhere.isEmpty() ? Optional.empty() : search.best(single, h -> elsewhere.contains(Place.plain(h, single.candidate())))
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
        double clearly = own - CLEARLY * Math.max(own - 1, LEAST_DROP);
        double near = 1 + NEAR * Refinement.excess(left.values().stream().mapToDouble(Double::doubleValue).min().orElseThrow());
        return left.keySet().stream().filter(place -> left.get(place) < clearly && left.get(place) <= near)
                .map(place -> place.plain(single.candidate().template()))
                .collect(Collectors.toSet());
    }

    /** The fit, or one with a memory in place of a reflex, which imitates it, where that does nearly as well. */
    private Fitter.State simplest(Fitter.State single, Fitter.State fit) {
        Hypothesis found = fit.candidate().last();
        if (!(found.additions().get(0) instanceof Addition.InLink in && in.law() instanceof Reflex)) {
            return fit;
        }
        double enough = fit.reduced() + NEARLY * Math.max(fit.reduced() - 1, LEAST_DROP);
        return search.best(single, h -> found.kind().yieldsTo(h) && h.where().equals(found.where()))
                .filter(other -> other.reduced() < enough).orElse(fit);
    }
}
