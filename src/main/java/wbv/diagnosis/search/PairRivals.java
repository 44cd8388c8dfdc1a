package wbv.diagnosis.search;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
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
     * none that stands at a bound that nothing real has, and no form whose further numbers do not pay. Nothing of what is no pair.
     */
    public List<Fitter.State> with(Fitter.State pair) {
        List<Hypothesis> parts = pair.candidate().added();
        List<Fitter.State> all = parts.size() != 2 ? List.of()
                : Stream.of(Stream.of(pair), inPlace(parts.get(0), parts.get(1), pair), inPlace(parts.get(1), parts.get(0), pair))
                        .flatMap(fits -> fits).toList();
        return all.stream().filter(fit -> all.stream().noneMatch(simpler -> isEnough(simpler, fit))).toList();
    }

    /** Whether a form of fewer numbers of the same laws does as well as another. */
    private boolean isEnough(Fitter.State simpler, Fitter.State fit) {
        int more = free(fit) - free(simpler);
        return more > 0 && claims(fit).equals(claims(simpler)) && !search.refinement().pays(fit, simpler, more);
    }

    /**
     * The likeliest of a pair and its rivals by what they leave. What the choice of a second costs is the same for all.
     *
     * @param fits the pair and its rivals, see {@link #with}; none where it is no pair. Not modified
     */
    public Chosen likeliest(Chosen pair, List<Fitter.State> fits) {
        Calibration calibration = Calibration.standard();
        double least = fits.stream().mapToDouble(Fitter.State::reduced).min().orElse(Double.POSITIVE_INFINITY);
        double open = calibration.evidence(least, least) - Effort.NEGLIGIBLE;
        List<Fitter.State> near = fits.stream().filter(fit -> calibration.evidence(fit.reduced(), least) > open).toList();
        Parallel.map(near, search.refinement()::heldOut);   // each is asked for below
        return near.stream().map(fit -> new Chosen(fit, pair.price()))
                .reduce((best, other) -> search.refinement().outweighs(other, best) ? other : best).orElse(pair);
    }

    private static int free(Fitter.State pair) {
        return pair.candidate().added().stream().mapToInt(Hypothesis::free).sum();
    }

    private static Set<String> claims(Fitter.State pair) {
        return pair.candidate().added().stream().map(Hypothesis::claim).collect(Collectors.toSet());
    }

    private Stream<Fitter.State> inPlace(Hypothesis part, Hypothesis other, Fitter.State pair) {
        Rest left = rest(other, pair);
        Place there = Place.plain(part, left.on());
        Stream<Fitter.State> others = there.equals(Place.plain(other, left.on())) ? beside(left, there, part, pair)
                : apart(there, part, other, pair);
        return Stream.of(simpler(left, part, pair), further(left, part, pair), others).flatMap(fits -> fits).filter(PairRivals::isReal);
    }

    /** Of two at one place: whatever is sought there beside the other. */
    private Stream<Fitter.State> beside(Rest left, Place there, Hypothesis part, Fitter.State pair) {
        return search.leaders(search.fitter().lookWithSlopes(left.on(), left.x(), pair.frame()), Effort.SECONDS,
                Whereabouts.among(evidence, left.on(), Map.of(there, left.x())).only(rival -> !rival.claim().equals(part.claim())))
                .stream();
    }

    /**
     * Of two apart: whatever fits best at the part's place, other forms of it among them, and what does at any other, as the pair moves.
     */
    private Stream<Fitter.State> apart(Place there, Hypothesis part, Hypothesis other, Fitter.State pair) {
        return Stream.concat(heats(part, other, pair, there::equals).best(Effort.LEADERS).stream(),
                replaced(pair, part, other).filter(fit -> !Place.ofLast(fit).equals(there)).stream());
    }

    /** What may stand in place of a part of a pair, at some places, beside the other, as the pair moves. */
    private MeasuredHeats heats(Hypothesis part, Hypothesis other, Fitter.State pair, Predicate<Place> places) {
        Rest left = rest(other, pair);
        List<Hypothesis> rivals = search.hypotheses(base, places).stream().filter(rival -> !rival.name().equals(part.name())).toList();
        return new MeasuredHeats(evidence, search.fitter().lookWithSlopes(left.on(), left.x(), pair.frame()),
                Motion.simulated(evidence, pair.candidate().at(pair.x())), rivals);
    }

    /**
     * A pair with either part in turn replaced by what fits best beside the other at any other place, as the pair moves, as long as that
     * leaves less, and more than the forms of laws do: the nearer a pair comes to what is missing, the nearer it moves to the truth, and
     * the better that tells the rest.
     */
    Fitter.State inTurn(Fitter.State pair) {
        Fitter.State best = pair;
        int part = 0;
        int kept = 0;
        while (kept < best.candidate().added().size() && !(best.reduced() < Refinement.form(base))) {
            List<Hypothesis> parts = best.candidate().added();
            double most = (1 - Effort.ROUGH) * best.reduced();
            Optional<Fitter.State> next = replaced(best, parts.get(part), parts.get(1 - part)).filter(fit -> fit.reduced() < most);
            best = next.orElse(best);
            // What is new comes last, and fits best beside the other.
            part = next.isPresent() ? 0 : 1 - part;
            kept = next.isPresent() ? 1 : kept + 1;
        }
        return best;
    }

    /** A pair of which each part has taken the further forms that pay beside the other, as a single mechanism has before it is compared. */
    Fitter.State formed(Fitter.State pair) {
        Fitter.State best = pair;
        for (Hypothesis part : pair.candidate().added()) {
            Fitter.State known = best;
            Hypothesis other = known.candidate().added().stream().filter(each -> each != part).findFirst().orElseThrow();
            best = Stream.concat(Stream.of(known), further(rest(other, known), part, known).filter(PairRivals::isReal))
                    .min(Comparator.comparingDouble(Fitter.State::reduced)).orElse(known);
        }
        return best;
    }

    /** The model with one part of a pair, as the pair has it. */
    private record Rest(Candidate on, double[] x) {}

    private Rest rest(Hypothesis part, Fitter.State pair) {
        Candidate on = base.candidate().with(part);
        return new Rest(on, base.candidate().alone(pair.candidate(), pair.x(), on, part));
    }

    private static boolean isReal(Fitter.State fit) {
        return !fit.failed() && !Refinement.extreme(fit);
    }

    private record Without(Fitter.State pair, Hypothesis part) implements Known.Question<Optional<Fitter.State>> {}

    private Optional<Fitter.State> replaced(Fitter.State pair, Hypothesis part, Hypothesis other) {
        return evidence.known().once(new Without(pair, part), () -> {
            Place apart = Place.plain(other, base.candidate().with(other));
            return heats(part, other, pair, place -> !place.equals(apart)).first();
        });
    }

    private record Further(Fitter.State pair, Hypothesis part) implements Known.Question<List<Fitter.State>> {}

    /** The further forms of a part that pay, as for a single mechanism, and what yields for what sticks; none where noise is left. */
    private Stream<Fitter.State> further(Rest left, Hypothesis part, Fitter.State pair) {
        return Refinement.excess(pair.reduced()) <= PairSearch.QUIET ? Stream.empty()
                : evidence.known().once(new Further(pair, part), () -> furtherForms(left, part, pair)).stream();
    }

    private List<Fitter.State> furtherForms(Rest left, Hypothesis part, Fitter.State pair) {
        Fitter.State without = search.fitter().look(left.on(), left.x(), pair.frame());
        Candidate with = left.on().with(part);
        Fitter.State last = search.fitter().look(with,
                left.on().extended(left.x(), with, part, pair.candidate().values(part, pair.x())), pair.frame());
        List<Hypothesis> all = search.hypotheses(base);
        return Stream.concat(new Yielding(search.refinement(), all, without).rivals(last).stream(),
                new FurtherForm(search.refinement(), without, all).rivals(last).stream()).toList();
    }

    /**
     * The forms of a part that do without some of its numbers, begun where it stands: a form with more of them hides its plain one where
     * only the best of a name is kept.
     */
    private Stream<Fitter.State> simpler(Rest left, Hypothesis part, Fitter.State pair) {
        double[] values = pair.candidate().values(part, pair.x());
        List<String> keys = part.keys();
        return search.hypotheses(base).stream()
                .filter(form -> form.claim().equals(part.claim()) && form.free() < part.free() && keys.containsAll(form.keys()))
                .flatMap(form -> search.refinement().polished(left.on(), form, left.x(), pair.frame(),
                        List.of(form.keys().stream().mapToDouble(key -> values[keys.indexOf(key)]).toArray())).stream());
    }
}
