package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * The search for two mechanisms at once. Each hides the other: with one of them missing, the fit bends the model to make up for it. So
 * two places are looked for that explain together what is left, and each mechanism is found while whatever acts at the other place is
 * ignored. Where sensors are too few for that, a second is added to the best first ones.
 */
final class PairSearch {

    private static final int FIRSTS = 2;
    /** Part of the whole mismatch that each of two mechanisms has to carry beside the other. */
    private static final double OWN_PART = 0.08;
    private static final double NEARLY_ALL = 0.9;
    private static final double MOST = 0.6;
    private static final double WORTH = 0.35;
    /** What a pair may leave of what the single one does so that no better one is sought. */
    private static final double ALL = 0.05;
    /** How many times the excess of the best pair of places another may leave and still be the pair. */
    private static final double ALIKE = 2;
    private static final int PAIRS = 3;
    /** How many times what two places have to leave a pair may leave because its laws have another form. */
    private static final double FORM = 4;
    private static final double SILENT = 1.2;
    /** Part of what one place leaves from which on another explains nothing beside it. */
    private static final double NEEDLESS = 0.5;
    /** Part of the excess that two places must not leave; the acceptance asks for less, but what is left is measured on a part of the data. */
    private static final double HOPELESS = 0.5;

    private final Evidence evidence;
    private final BiConsumer<String, Double> progress;
    private final Search search;
    private final Refinement refinement;

    PairSearch(Evidence evidence, Search search, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.progress = progress;
        this.search = search;
        this.refinement = search.refinement();
    }

    /**
     * The best pair if it removes most of what the best single one leaves and neither does alone; else the single one.
     *
     * @param leaders single hypotheses on top of base, best first
     */
    Fitter.State pair(Fitter.State base, Fitter.State single, List<Fitter.State> leaders) {
        Locator part = new Locator(evidence.brief().orElse(evidence), base.candidate());
        List<Locator.Found> places = part.pairs(base.x());
        Place own = Place.ofLast(single);
        if (!places.isEmpty() && suffices(own, part, places, base)) {
            // What the single one leaves is the form of its law, or another mechanism at its side.
            return oneByOne(base, single, List.of(single), first -> hypothesis -> Place.plain(hypothesis, base.candidate()).equals(own));
        }
        Optional<Fitter.State> apart = apart(base, places, leaders).filter(pair -> pair.reduced() < single.reduced()
                && refinement.heldOut(pair) < refinement.heldOut(single));
        if (apart.isPresent() && Refinement.excess(apart.get().reduced()) < FORM * Refinement.excess(places.get(0).reduced())) {
            return apart.get();
        }
        double enough = 1 + HOPELESS * (single.reduced() - 1);
        Fitter.State added = oneByOne(base, single, leaders, first -> partners(first, places, enough));
        return apart.filter(pair -> pair.reduced() < added.reduced()).orElse(added);
    }

    /** Whether a second place explains little beside one: on a part of the data, of which the whole shows no more than it does. */
    private boolean suffices(Place own, Locator part, List<Locator.Found> pairs, Fitter.State base) {
        double alone = Refinement.excess(part.left(own, base.x()));
        double least = pairs.stream().filter(pair -> pair.places().contains(own)).mapToDouble(Locator.Found::reduced).min()
                .orElse(Double.NEGATIVE_INFINITY);
        return Refinement.excess(least) > NEEDLESS * alone && Refinement.excess(new Locator(evidence, base.candidate()).left(own, base.x())) < ALIKE * alone;
    }

    /**
     * A pair at two places of which each mechanism shows while whatever acts at the other's place is ignored.
     *
     * @param places pairs of places, best first @param leaders single hypotheses fitted with nothing ignored
     */
    private Optional<Fitter.State> apart(Fitter.State base, List<Locator.Found> places, List<Fitter.State> leaders) {
        Candidate baseline = base.candidate();
        double reach = places.isEmpty() ? 0 : 1 + ALIKE * Refinement.excess(places.get(0).reduced());
        List<Locator.Found> pairs = places.stream().filter(found -> found.reduced() < reach).limit(PAIRS).toList();
        Map<Place, Set<Place>> partners = new LinkedHashMap<>();
        for (Locator.Found pair : pairs) {
            Place one = pair.places().get(0);
            Place other = pair.places().get(1);
            partners.computeIfAbsent(one, place -> new HashSet<>()).add(other);
            partners.computeIfAbsent(other, place -> new HashSet<>()).add(one);
        }
        List<Fitter.State> shown = new ArrayList<>();
        Map<Place, List<Fitter.State>> beside = new HashMap<>();
        partners.forEach((ignored, others) -> beside.put(ignored, shown(base, ignored, others)));
        for (Locator.Found pair : pairs) {
            Place one = pair.places().get(0);
            Place other = pair.places().get(1);
            Optional<Fitter.State> first = at(one, beside.get(other));
            Optional<Fitter.State> second = at(other, beside.get(one));
            if (first.isPresent() && second.isPresent()) {
                for (Fitter.State a : forms(first.get(), leaders)) {
                    for (Fitter.State b : forms(second.get(), leaders)) {
                        shown.add(joined(base, a, b));
                    }
                }
            }
        }
        return shown.stream().filter(fit -> !fit.failed()).min(Comparator.comparingDouble(Fitter.State::reduced));
    }

    /** The mechanisms at some places that show where another place is ignored, most credible first. */
    private List<Fitter.State> shown(Fitter.State base, Place ignored, Set<Place> places) {
        Candidate baseline = base.candidate();
        Search blind = new Search(evidence.ignoring(ignored), progress);
        Fitter.State without = blind.base(baseline, base.x());
        if (without.reduced() < SILENT) {
            return List.of();
        }
        List<Fitter.State> fits = blind.leaders(without, Search.LEADERS, h -> places.contains(Place.plain(h, baseline)));
        // Not asked to hold on other data: a law answers to the motion, of which what is ignored makes a part.
        return blind.credible(fits).stream().filter(fit -> !Search.extreme(fit) && Verdicts.explained(without, fit) > MOST).toList();
    }

    private static Optional<Fitter.State> at(Place place, List<Fitter.State> fits) {
        return fits.stream().filter(fit -> Place.ofLast(fit).equals(place)).findFirst();
    }

    /** A mechanism as it was found with another place ignored, and as it was found with none ignored, if it was. */
    private static List<Fitter.State> forms(Fitter.State found, List<Fitter.State> leaders) {
        Hypothesis own = found.candidate().last();
        List<Fitter.State> out = new ArrayList<>(List.of(found));
        leaders.stream().filter(fit -> fit.candidate().last().mechanism().equals(own.mechanism())
                && fit.candidate().last().where().equals(own.where())).findFirst().ifPresent(out::add);
        return out;
    }

    /** Both mechanisms in one model. */
    private Fitter.State joined(Fitter.State base, Fitter.State first, Fitter.State second) {
        Hypothesis one = first.candidate().last();
        Hypothesis other = second.candidate().last();
        Candidate both = base.candidate().with(one).with(other);
        double[] x = new double[both.knobs().size()];
        for (int i = 0; i < base.x().length; i++) {
            x[i] = (first.x()[i] + second.x()[i]) / 2;
        }
        copy(one, first, both, x);
        copy(other, second, both, x);
        return refinement.polish(both, x);
    }

    /** Carries the numbers of a hypothesis over from a fit. @param x filled in */
    private static void copy(Hypothesis hypothesis, Fitter.State from, Candidate to, double[] x) {
        int[] source = hypothesis.positions(from.candidate());
        int[] target = hypothesis.positions(to);
        for (int i = 0; i < source.length; i++) {
            x[target[i]] = from.x()[source[i]];
        }
    }

    /** A second mechanism on top of each of the best firsts. @param partners what may stand beside a first */
    private Fitter.State oneByOne(Fitter.State base, Fitter.State single, List<Fitter.State> leaders,
                                  Function<Fitter.State, Predicate<Hypothesis>> partners) {
        double all = 1 + ALL * (single.reduced() - 1);
        Fitter.State best = single;
        for (Fitter.State first : leaders.subList(0, Math.min(FIRSTS, leaders.size()))) {
            if (best.reduced() > all && (first == single || first.cost() < 0.9 * base.cost())) {
                best = better(best, search.best(first, partners.apply(first)));
            }
        }
        if (best != single && best.reduced() > all) {
            // The first was chosen while the second was still missing: once more, the other way round.
            Fitter.State second = alone(best.candidate().last(), best, base);
            best = better(best, search.best(second, partners.apply(second)));
        }
        if (best == single || best.reduced() - 1 > WORTH * (single.reduced() - 1) || refinement.heldOut(best) > refinement.heldOut(single)) {
            return single;
        }
        return necessary(best, base);
    }

    private static Fitter.State better(Fitter.State best, Optional<Fitter.State> other) {
        return other.filter(fit -> fit.reduced() < best.reduced()).orElse(best);
    }

    /**
     * Hypotheses that may make a pair with the one of a fit: where whatever enters at two places leaves much, no two mechanisms there will do.
     *
     * @param places pairs of places that were looked at @param enough what they may leave
     */
    private static Predicate<Hypothesis> partners(Fitter.State first, List<Locator.Found> places, double enough) {
        Place own = Place.ofLast(first);
        Set<Place> hopeless = new HashSet<>();
        for (Locator.Found pair : places) {
            if (pair.places().contains(own) && pair.reduced() > enough) {
                hopeless.addAll(pair.places());
            }
        }
        hopeless.remove(own);
        return hypothesis -> !hopeless.contains(Place.plain(hypothesis, first.candidate()));
    }

    /** A fit of one hypothesis of a pair without the other. */
    private Fitter.State alone(Hypothesis hypothesis, Fitter.State pair, Fitter.State base) {
        Candidate one = base.candidate().with(hypothesis);
        double[] x = Arrays.copyOf(pair.x(), one.knobs().size());
        copy(hypothesis, pair, one, x);
        return refinement.polish(one, x);
    }

    /** The pair, or one of the two if that does as well. */
    private Fitter.State necessary(Fitter.State pair, Fitter.State base) {
        Fitter.State best = pair;
        for (Hypothesis alone : pair.candidate().added()) {
            Fitter.State fit = alone(alone, pair, base);
            double own = fit.reduced() - pair.reduced();
            // A small part is believed where with it little is left; beside a law much may be left, and the part be no more than its form.
            double most = alone.runsFree() ? NEARLY_ALL : MOST;
            boolean nearly = own < 0.3 * pair.reduced() || own < OWN_PART * (base.reduced() - 1) && own < most * (fit.reduced() - 1);
            if (nearly && (best == pair || fit.cost() < best.cost())) {
                best = fit;
            }
        }
        return best;
    }
}
