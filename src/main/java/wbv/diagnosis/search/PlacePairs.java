package wbv.diagnosis.search;

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
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * Two mechanisms at two places, each found while whatever acts at the other's place is ignored, then fitted together. Proposes, and decides
 * nothing.
 */
final class PlacePairs {

    private final Evidence evidence;
    private final BiConsumer<String, Double> progress;
    private final Search search;
    private final Refinement refinement;

    PlacePairs(Evidence evidence, Search search, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.progress = progress;
        this.search = search;
        this.refinement = search.refinement();
    }

    /**
     * A pair at two places of which each mechanism shows while whatever acts at the other's place is ignored.
     *
     * @param places pairs of places, best first
     * @param leaders single hypotheses fitted with nothing ignored
     */
    Optional<Fitter.State> pair(Fitter.State base, List<Known.Ignoring> places, List<Fitter.State> leaders) {
        double good = Math.max(Locator.reach(places, Effort.BEHIND), Refinement.form(base));
        NearPairs near = NearPairs.of(evidence, base, places);
        Optional<MeasuredHeats.Found> measured = measured(base, places, near.twins());
        List<Fitter.State> found = new ArrayList<>(measured.map(MeasuredHeats.Found::fit).stream().toList());
        if (measured.filter(pair -> pair.fit().reduced() < good
                || pair.isAlone() && Refinement.explainsNearlyAll(base, pair.fit())).isPresent()) {
            return found.stream().findFirst();
        }
        Set<Set<Place>> tried = new HashSet<>();
        Set<Set<String>> joined = new HashSet<>();
        for (Beside beside : besides(base, near, good)) {
            Place other = near.twins().first(Place.ofLast(beside.seconds().get(0)));
            // Nothing where a place is ignored leaves less than is left so.
            double least = found.isEmpty() ? Double.POSITIVE_INFINITY : found.get(0).reduced();
            if (least >= good && beside.left() < least && tried.add(Set.of(beside.ignored(), other))) {
                found.addAll(joined(base, firsts(base, other, beside.ignored(), near), beside.seconds(), leaders, joined));
                if (found.stream().noneMatch(fit -> fit.reduced() < good)) {
                    onTop(beside.seconds().get(0), near.twins().of(beside.ignored())).ifPresent(found::add);
                }
                found.sort(Comparator.comparingDouble(Fitter.State::reduced));
            }
        }
        return found.stream().findFirst();
    }

    /** The best of those along what was measured, at places that may do. */
    private Optional<MeasuredHeats.Found> measured(Fitter.State base, List<Known.Ignoring> places, Twins twins) {
        progress.accept("pairs", 0.4);
        double most = NearPairs.reach(places, base);
        Set<Set<Place>> near = places.stream().filter(pair -> pair.reduced() < most)
                .map(pair -> MeasuredHeats.both(twins.first(pair.places().get(0)), twins.first(pair.places().get(1))))
                .collect(Collectors.toSet());
        return new MeasuredHeats(evidence, refinement, base, Motion.measured(evidence, base.candidate().at(base.x())),
                search.hypotheses(base))
                .two(near::contains, twins);
    }

    /**
     * What shows beside a place that is ignored.
     *
     * @param seconds the best mechanism first, at least one
     */
    private record Beside(Place ignored, List<Fitter.State> seconds) {

        double left() {
            return seconds.get(0).reduced();
        }
    }

    /**
     * What shows beside the first of each pair: of several first places that outputs do not tell apart only one need be that beside which a
     * mechanism explains the rest. No more of them than it takes to find one that leaves next to nothing.
     *
     * @param good what counts as that
     * @return those that leave least, least first
     */
    private List<Beside> besides(Fitter.State base, NearPairs near, double good) {
        List<Beside> out = new ArrayList<>();
        for (Place one : near.firsts().stream().limit(Effort.PLACES).toList()) {
            if (out.stream().noneMatch(beside -> beside.left() < good)) {
                shown(base, one, near.partners(one)).forEach(seconds -> out.add(new Beside(one, seconds)));
            }
        }
        return out.stream().sorted(Comparator.comparingDouble(Beside::left)).limit(Effort.PLACES).toList();
    }

    /** What shows where one place is ignored: best of all, and at the other. */
    private List<Fitter.State> firsts(Fitter.State base, Place ignored, Place at, NearPairs near) {
        List<List<Fitter.State>> shown = shown(base, ignored, near.partners(ignored));
        List<Place> same = near.twins().of(at);
        return IntStream.range(0, shown.size()).filter(i -> i == 0 || same.contains(Place.ofLast(shown.get(i).get(0))))
                .mapToObj(shown::get).flatMap(List::stream).toList();
    }

    /**
     * The best mechanism that shows where a place is ignored, and others at its place that explain about as much; the same at other places
     * where as little is left: beside a link's force that is ignored, one on either of its ends does the same.
     *
     * @param places where it may act, likeliest first, with the base's numbers as they fit beside both
     * @return by place, none of them empty
     */
    private List<List<Fitter.State>> shown(Fitter.State base, Place ignored, Map<Place, double[]> places) {
        ShownBeside.Shown all = new ShownBeside(evidence, base, progress).among(ignored, places);
        // Not asked to hold on other data: a law answers to the motion, of which what is ignored makes a part.
        List<Fitter.State> shown = all.fits().stream()
                .filter(fit -> !Search.extreme(fit) && Refinement.explained(all.without(), fit) > Priors.MAJORITY)
                .toList();
        Map<Place, List<Fitter.State>> out = new LinkedHashMap<>();
        Set<String> claims = new HashSet<>();
        shown.stream().filter(fit -> Refinement.excess(fit.reduced()) < Effort.ALIKE * Refinement.excess(shown.get(0).reduced())
                && claims.add(fit.candidate().last().claim())).forEach(fit -> {
                    List<Fitter.State> there = out.computeIfAbsent(Place.ofLast(fit), place -> new ArrayList<>());
                    if (there.size() < Effort.SECONDS) {
                        there.add(fit);
                    }
                });
        return List.copyOf(out.values());
    }

    /**
     * A mechanism that was found while a place was ignored, and on top of it one there, from the numbers of the model that fitted beside
     * that place.
     *
     * @param ignored that place and its twins
     */
    private Optional<Fitter.State> onTop(Fitter.State shown, List<Place> ignored) {
        Candidate first = shown.candidate();
        Fitter.State bent = search.base(first, shown.x());
        Map<Place, double[]> there = new LinkedHashMap<>();
        ignored.forEach(place -> there.put(place, shown.x()));
        return search.best(bent, Whereabouts.among(evidence, first, there));
    }

    /** A mechanism as it was found with another place ignored, and as it was found with none ignored, if it was. */
    private static List<Fitter.State> forms(Fitter.State found, List<Fitter.State> leaders) {
        Hypothesis own = found.candidate().last();
        List<Fitter.State> out = new ArrayList<>(List.of(found));
        leaders.stream().filter(fit -> fit.candidate().last().mechanism().equals(own.mechanism())
                && fit.candidate().last().where().equals(own.where())).findFirst().ifPresent(out::add);
        return out;
    }

    /**
     * Both mechanisms in one model, each as every rival and in the forms it was found in; none that fails.
     *
     * @param tried claims that were joined before, and need not be again: other places were ignored that do the same; filled in
     */
    private List<Fitter.State> joined(Fitter.State base, List<Fitter.State> firsts, List<Fitter.State> seconds,
            List<Fitter.State> leaders, Set<Set<String>> tried) {
        List<Fitter.State> others = seconds.stream().flatMap(fit -> forms(fit, leaders).stream()).toList();
        List<Fitter.State[]> both = firsts.stream().flatMap(fit -> forms(fit, leaders).stream())
                .flatMap(one -> others.stream().map(other -> new Fitter.State[] {one, other}))
                .filter(pair -> !tried.contains(claims(pair))).toList();
        both.forEach(pair -> tried.add(claims(pair)));
        // A few steps tell which are worth all of them.
        List<Fitter.State> begun = new ArrayList<>(Parallel.map(both, pair -> joined(base, pair[0], pair[1])));
        begun.removeIf(Fitter.State::failed);
        begun.sort(Comparator.comparingDouble(Fitter.State::reduced));
        double near = begun.isEmpty() ? 0 : 1 + Effort.BEHIND * Refinement.excess(begun.get(0).reduced());
        List<Fitter.State> worth = begun.stream().filter(fit -> fit.reduced() <= near).limit(Effort.LEADERS).toList();
        return Parallel.map(worth, refinement::polish).stream().filter(fit -> !fit.failed()).toList();
    }

    private static Set<String> claims(Fitter.State[] pair) {
        return Arrays.stream(pair).map(fit -> fit.candidate().last().claim()).collect(Collectors.toSet());
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

    /**
     * Carries the numbers of a hypothesis over from a fit.
     *
     * @param x filled in
     */
    private static void copy(Hypothesis hypothesis, Fitter.State from, Candidate to, double[] x) {
        int[] source = from.candidate().positions(hypothesis);
        int[] target = to.positions(hypothesis);
        for (int i = 0; i < source.length; i++) {
            x[target[i]] = from.x()[source[i]];
        }
    }
}
