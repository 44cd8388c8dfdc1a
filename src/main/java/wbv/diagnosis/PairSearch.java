package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * The search for two mechanisms at once. Each hides the other: with one of them missing, the fit bends the model to make up for it. So
 * two places are looked for that explain together what is left, and each mechanism is found while whatever acts at the other place is
 * ignored. Where sensors are too few for that, a second is added to the best first ones.
 */
final class PairSearch {

    private static final int FIRSTS = 2;
    /** How many pairs of laws are fitted to the end, and how many times the excess of the best they may leave before. */
    private static final int FINALISTS = 4;
    private static final double BEGUN = 3;
    /** As how many mechanisms each of two is tried. */
    private static final int RIVALS = 2;
    /** Part of the whole mismatch that each of two mechanisms has to carry beside the other. */
    private static final double OWN_PART = 0.08;
    private static final double NEARLY_ALL = 0.9;
    private static final double MOST = 0.6;
    /** Part of what the best single mechanism leaves that a pair must not leave. */
    private static final double WORTH = 0.35;
    /** The same where one place cannot hold all that is missing: then what a pair leaves is the form of its laws. */
    private static final double NEEDED = 0.6;
    /** What a pair may leave of what the single one does so that no better one is sought. */
    private static final double ALL = 0.05;
    /** How many times the excess of the best pair of places another may leave and still be the pair. */
    private static final double ALIKE = 2;
    /** Part of the whole mismatch by which what two places leave scatters, since noise is seen through numbers that fit them. */
    private static final double SCATTER = 0.012;
    /** How many times what two places have to leave a pair may leave because its laws have another form. */
    private static final double FORM = 4;
    /** Part of what one place leaves from which on another explains nothing beside it. */
    private static final double NEEDLESS = 0.5;
    /** Part of the mismatch that a mechanism explains if it is at least one of those that are missing. */
    private static final double HALF = 0.5;
    /** The least that counts as an excess. */
    static final double QUIET = Refinement.excess(1);
    /** Part of the excess that two places must not leave; the acceptance asks for less, but what is left is mostly measured on a part of the data. */
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
        if (evidence.outputs().size() < Locator.FEWEST_OUTPUTS) {
            return oneByOne(base, single, leaders, first -> hypothesis -> true, WORTH);
        }
        Place own = Place.ofLast(single);
        Looked looked = looked(own, base);
        if (Standing.explained(base, single) < HALF && atOnePlace(looked.singles().get(0), base)) {
            return single;   // and no mechanism is near it
        }
        double alone = Refinement.excess(Locator.left(looked.singles(), own));
        // Where nothing more than noise is left beside a place no pair of places leaves less.
        List<Locator.Found> places = alone > QUIET ? looked.locator().pairs(looked.singles()) : List.of();
        if (alone <= QUIET || needless(own, alone, places)) {
            // What a law leaves there is its form; what anything else leaves may be another mechanism at its side.
            return single.candidate().last().isLaw() ? single : oneByOne(base, single, List.of(single),
                    first -> hypothesis -> Place.plain(hypothesis, base.candidate()).equals(own), WORTH);
        }
        Optional<Fitter.State> apart = apart(base, places, leaders).filter(pair -> pair.reduced() < single.reduced()
                && refinement.heldOut(pair) < refinement.heldOut(single));
        if (apart.isPresent() && (apart.get().reduced() < Locator.reach(places, FORM) || worth(apart.get(), single, NEEDED))) {
            return apart.get();
        }
        double most = Math.min(1 + HOPELESS * (single.reduced() - 1), reach(places, FORM, base));
        Fitter.State added = oneByOne(base, single, leaders, first -> partners(first, places, most), NEEDED);
        return apart.filter(pair -> pair.reduced() < added.reduced()).orElse(added);
    }

    /** Whether a second place explains little beside one. @param alone excess where the one is ignored @param pairs on the same data */
    private static boolean needless(Place own, double alone, List<Locator.Found> pairs) {
        List<Locator.Found> beside = pairs.stream().filter(pair -> pair.places().contains(own)).toList();
        return !beside.isEmpty() && beside.stream().allMatch(pair -> Refinement.excess(pair.reduced()) > NEEDLESS * alone);
    }

    /** Whether all that is missing enters at a place. @param best as a part of the data may show it */
    private boolean atOnePlace(Locator.Found best, Fitter.State base) {
        return Refinement.excess(best.reduced()) <= QUIET
                && Refinement.excess(new Locator(evidence, base.candidate()).left(best.places().get(0), base.x())) <= QUIET;
    }

    /** Places one by one, best first, as some data show them. */
    private record Looked(Locator locator, List<Locator.Found> singles) { }

    /** On a part of the data where that shows beside a place as much as all of them do; else on all. */
    private Looked looked(Place own, Fitter.State base) {
        Locator all = new Locator(evidence, base.candidate());
        return evidence.brief().map(part -> new Locator(part, base.candidate())).map(part -> new Looked(part, part.singles(base.x())))
                .filter(part -> Refinement.excess(all.left(own, base.x())) < ALIKE * Refinement.excess(Locator.left(part.singles(), own)))
                .orElseGet(() -> new Looked(all, all.singles(base.x())));
    }

    /**
     * A pair at two places of which each mechanism shows while whatever acts at the other's place is ignored.
     *
     * @param places pairs of places, best first @param leaders single hypotheses fitted with nothing ignored
     */
    private Optional<Fitter.State> apart(Fitter.State base, List<Locator.Found> places, List<Fitter.State> leaders) {
        double reach = reach(places, ALIKE, base);
        double good = Locator.reach(places, FORM);
        List<Locator.Found> near = places.stream().filter(pair -> pair.reduced() < reach).toList();
        List<Fitter.State> found = new ArrayList<>();
        // The better of two places stands first, often beside several others that outputs do not tell apart.
        Set<Place> tried = new HashSet<>();
        for (Place one : near.stream().map(pair -> pair.places().get(0)).distinct().limit(FIRSTS).toList()) {
            if (!tried.add(one)) {
                continue;
            }
            List<Fitter.State> seconds = shown(base, one, partners(one, near));
            if (!seconds.isEmpty()) {
                Place other = Place.ofLast(seconds.get(0));
                Map<Place, double[]> firsts = partners(other, near);
                tried.addAll(firsts.keySet());
                found.addAll(joined(base, shown(base, other, firsts), seconds, leaders));
                if (found.stream().noneMatch(fit -> fit.reduced() < good)) {
                    onTop(seconds.get(0), one).ifPresent(found::add);
                }
            }
            found.sort(Comparator.comparingDouble(Fitter.State::reduced));
            if (!found.isEmpty() && found.get(0).reduced() < good) {
                break;
            }
        }
        return found.stream().findFirst();
    }

    /** What two places may leave to be some times as far from the noise as the best, or as far as what they leave scatters. */
    private static double reach(List<Locator.Found> places, double times, Fitter.State base) {
        return Math.max(Locator.reach(places, times), 1 + times * SCATTER * (base.reduced() - 1));
    }

    /** The places that make a pair with one, best first, with the base's numbers as they fit beside both. */
    private static Map<Place, double[]> partners(Place one, List<Locator.Found> pairs) {
        Map<Place, double[]> out = new LinkedHashMap<>();
        pairs.stream().filter(pair -> pair.places().contains(one))
                .forEach(pair -> pair.places().stream().filter(place -> !place.equals(one)).forEach(place -> out.put(place, pair.x())));
        return out;
    }

    /**
     * The most credible mechanism that shows where a place is ignored, and others at its place that explain about as much.
     *
     * @param places where it may act, likeliest first, with the base's numbers as they fit beside both
     */
    private List<Fitter.State> shown(Fitter.State base, Place ignored, Map<Place, double[]> places) {
        Candidate baseline = base.candidate();
        Search blind = new Search(evidence.ignoring(ignored), progress);
        Fitter.State without = blind.base(baseline, places.values().iterator().next());
        if (without.reduced() < Verdicts.SILENT) {
            return List.of();
        }
        Map<Place, double[]> given = new LinkedHashMap<>();
        places.forEach((place, numbers) -> given.put(place, ignored.asGiven(baseline, numbers)));
        List<Fitter.State> fits = blind.leaders(without, Search.LEADERS, Whereabouts.among(evidence, baseline, given));
        // Not asked to hold on other data: a law answers to the motion, of which what is ignored makes a part.
        List<Fitter.State> shown = blind.credible(fits).stream().filter(fit -> !Search.extreme(fit) && Standing.explained(without, fit) > MOST)
                .toList();
        Set<String> mechanisms = new HashSet<>();
        return shown.stream().filter(fit -> Place.ofLast(fit).equals(Place.ofLast(shown.get(0)))
                && Refinement.excess(fit.reduced()) < ALIKE * Refinement.excess(shown.get(0).reduced())
                && mechanisms.add(fit.candidate().last().mechanism())).limit(RIVALS).toList();
    }

    /** A mechanism that was found while a place was ignored, and on top of it one there, from the numbers of the model that fitted beside that place. */
    private Optional<Fitter.State> onTop(Fitter.State shown, Place ignored) {
        Candidate first = shown.candidate();
        Fitter.State bent = search.base(first, shown.x());
        return search.best(bent, Whereabouts.among(evidence, first, Map.of(ignored, shown.x())));
    }

    /** A mechanism as it was found with another place ignored, and as it was found with none ignored, if it was. */
    private static List<Fitter.State> forms(Fitter.State found, List<Fitter.State> leaders) {
        Hypothesis own = found.candidate().last();
        List<Fitter.State> out = new ArrayList<>(List.of(found));
        leaders.stream().filter(fit -> fit.candidate().last().mechanism().equals(own.mechanism())
                && fit.candidate().last().where().equals(own.where())).findFirst().ifPresent(out::add);
        return out;
    }

    /** Both mechanisms in one model, each as every rival and in the forms it was found in; none that fails. */
    private List<Fitter.State> joined(Fitter.State base, List<Fitter.State> firsts, List<Fitter.State> seconds, List<Fitter.State> leaders) {
        List<Fitter.State> others = seconds.stream().flatMap(fit -> forms(fit, leaders).stream()).toList();
        List<Fitter.State[]> both = firsts.stream().flatMap(fit -> forms(fit, leaders).stream())
                .flatMap(one -> others.stream().map(other -> new Fitter.State[] {one, other})).toList();
        // A few steps tell which are worth all of them.
        List<Fitter.State> begun = new ArrayList<>(Cores.map(both, pair -> joined(base, pair[0], pair[1])));
        begun.removeIf(Fitter.State::failed);
        begun.sort(Comparator.comparingDouble(Fitter.State::reduced));
        double near = begun.isEmpty() ? 0 : 1 + BEGUN * Refinement.excess(begun.get(0).reduced());
        List<Fitter.State> worth = begun.stream().filter(fit -> fit.reduced() <= near).limit(FINALISTS).toList();
        return Cores.map(worth, refinement::polish).stream().filter(fit -> !fit.failed()).toList();
    }

    /** Both mechanisms in one model, after the first steps. */
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
        return refinement.begun(both, x);
    }

    /** Carries the numbers of a hypothesis over from a fit. @param x filled in */
    private static void copy(Hypothesis hypothesis, Fitter.State from, Candidate to, double[] x) {
        int[] source = from.candidate().positions(hypothesis);
        int[] target = to.positions(hypothesis);
        for (int i = 0; i < source.length; i++) {
            x[target[i]] = from.x()[source[i]];
        }
    }

    /**
     * A second mechanism on top of each of the best firsts.
     *
     * @param partners what may stand beside a first @param worth part of what the single one leaves that a pair must not leave
     */
    private Fitter.State oneByOne(Fitter.State base, Fitter.State single, List<Fitter.State> leaders,
                                  Function<Fitter.State, Predicate<Hypothesis>> partners, double worth) {
        double all = 1 + ALL * (single.reduced() - 1);
        Fitter.State best = single;
        for (Fitter.State first : leaders.subList(0, Math.min(FIRSTS, leaders.size()))) {
            if (best.reduced() > all && (first == single || first.cost() < 0.9 * base.cost())) {
                best = better(best, beside(first, partners.apply(first)));
            }
        }
        if (best != single && best.reduced() > all) {
            // The first was chosen while the second was still missing: once more, the other way round.
            Fitter.State second = alone(best.candidate().last(), best, base);
            best = better(best, beside(second, partners.apply(second)));
        }
        if (best == single || !worth(best, single, worth) || refinement.heldOut(best) > refinement.heldOut(single)) {
            return single;
        }
        return necessary(best, base);
    }

    private static boolean worth(Fitter.State pair, Fitter.State single, double part) {
        return pair.reduced() - 1 <= part * (single.reduced() - 1);
    }

    /** The most credible second mechanism, sought where something still enters that the first does not explain. */
    private Optional<Fitter.State> beside(Fitter.State first, Predicate<Hypothesis> partners) {
        if (!Double.isFinite(first.cost())) {
            return Optional.empty();   // a run that left all bounds has nothing to be found beside it
        }
        return search.best(first, Whereabouts.found(evidence, first.candidate(), first.x()).only(partners));
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
