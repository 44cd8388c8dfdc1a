package wbv.diagnosis.search;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * What else either part of a pair may be. Each was found while whatever acts at the other place was ignored, or on top of a first that had
 * bent the model to make up for what was missing still; which law it is, play or a stop, shows only beside the other.
 */
public final class PairRivals {

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;

    /**
     * Of pairs that were found on this evidence.
     *
     * @param base the model without any mechanism, fitted
     */
    public PairRivals(Evidence evidence, Search search, Fitter.State base) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
    }

    /**
     * A pair, and the same with another mechanism in the place of one of its parts, or with a form of it that has fewer numbers, fitted;
     * none that stands at a bound that nothing real has. Nothing of what is no pair.
     */
    public List<Fitter.State> with(Fitter.State pair) {
        List<Hypothesis> parts = pair.candidate().added();
        return parts.size() != 2 ? List.of()
                : Stream.of(Stream.of(pair), inPlace(parts.get(0), parts.get(1), pair), inPlace(parts.get(1), parts.get(0), pair))
                        .flatMap(fits -> fits).toList();
    }

    /**
     * The likeliest of a pair and its rivals by what they leave. What the choice of a second costs is the same for all; of two forms of the
     * same laws the one of more numbers has to pay for them.
     *
     * @param fits the pair and its rivals, see {@link #with}; none where it is no pair. Not modified
     */
    public Chosen likeliest(Chosen pair, List<Fitter.State> fits) {
        return fits.stream().map(fit -> new Chosen(fit, pair.price())).reduce((best, other) -> isLikelier(other, best) ? other : best)
                .orElse(pair);
    }

    private boolean isLikelier(Chosen one, Chosen other) {
        Refinement refinement = search.refinement();
        int more = one.fit().candidate().knobs().size() - other.fit().candidate().knobs().size();
        if (more == 0 || !claims(one).equals(claims(other))) {
            return refinement.outweighs(one, other);
        }
        return more > 0 ? refinement.pays(one.fit(), other.fit(), more) : !refinement.pays(other.fit(), one.fit(), -more);
    }

    private static Set<String> claims(Chosen pair) {
        return pair.fit().candidate().added().stream().map(Hypothesis::claim).collect(Collectors.toSet());
    }

    private Stream<Fitter.State> inPlace(Hypothesis part, Hypothesis other, Fitter.State pair) {
        Candidate left = base.candidate().with(other);
        double[] x = PlacePairs.without(pair, other, left);
        Fitter.State without = search.fitter().lookWithSlopes(left, x, pair.frame());
        Whereabouts there = Whereabouts.among(evidence, left, Map.of(Place.plain(part, left), x))
                .only(hypothesis -> !hypothesis.claim().equals(part.claim()) || hypothesis.numbers().size() < part.numbers().size());
        return search.leaders(without, Effort.SECONDS, there).stream().filter(fit -> !Search.extreme(fit));
    }
}
