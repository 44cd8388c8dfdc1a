package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Learned;

/**
 * Learns the law of a force that no mechanism of the library makes: terms of a {@link Grammar} are ranked by a score test, the few best are
 * fitted by free run, and the sentence is taken whose evidence is greatest, each further term having to pay for itself. What does not hold on
 * data that were not used is no law.
 */
final class LawLearner {

    /** Links that are tried, likeliest first, and how many times the excess of the likeliest place one of them may leave. */
    private static final int LINKS = 2;
    private static final double NEAR = 2;
    /** Sentences that are fitted by free run, and those of them that go on to another term. */
    private static final int FITTED = 6;
    private static final int BEAM = 2;
    private static final int MOST_TERMS = 3;

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;
    private final List<Locator.Found> places;

    /** @param base the model without any law, fitted @param places where the mismatch may enter, likeliest first; none where outputs do not tell */
    LawLearner(Evidence evidence, Search search, Fitter.State base, List<Locator.Found> places) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
        this.places = places;
    }

    /**
     * A sentence of the grammar.
     *
     * @param fit      by free run
     * @param evidence logarithm of it, against the model without a law [nat]
     */
    record Sentence(Fitter.State fit, double evidence) { }

    /** The laws that were fitted, most evident first. */
    List<Sentence> sentences() {
        List<Sentence> all = new ArrayList<>();
        for (int link : links()) {
            all.addAll(sentences(link));
        }
        all.sort(Comparator.comparingDouble(Sentence::evidence).reversed());
        return all;
    }

    /** Links in which all that is missing could enter. */
    private List<Integer> links() {
        int count = evidence.model().links().size();
        if (places.isEmpty()) {
            return IntStream.range(0, count).boxed().toList();
        }
        double reach = Locator.reach(places, NEAR);
        return places.stream().filter(found -> found.reduced() <= reach).map(found -> found.places().get(0).plain(base.candidate().template()))
                .filter(place -> place.kind() == Place.Kind.LINK).map(Place::index).distinct().limit(LINKS).toList();
    }

    private List<Sentence> sentences(int link) {
        Place place = new Place(Place.Kind.LINK, link);
        double[] unbent = places.stream().filter(found -> found.places().get(0).equals(place)).findFirst()
                .map(found -> place.asGiven(base.candidate(), found.x())).orElse(base.x());
        List<Sentence> all = new ArrayList<>();
        List<Sentence> beam = List.of(new Sentence(base, 0));
        for (int terms = 1; terms <= MOST_TERMS && !beam.isEmpty(); terms++) {
            List<Sentence> next = new ArrayList<>();
            for (Sentence sentence : beam) {
                double least = terms == 1 ? Double.NEGATIVE_INFINITY : sentence.evidence();
                longer(sentence.fit(), terms == 1 ? unbent : sentence.fit().x(), link).stream().filter(more -> more.evidence() > least).forEach(next::add);
            }
            next.sort(Comparator.comparingDouble(Sentence::evidence).reversed());
            all.addAll(next);
            beam = next.stream().limit(BEAM).toList();
        }
        return all;
    }

    /** A sentence with each of the most promising terms more. @param x where the terms are scored */
    private List<Sentence> longer(Fitter.State fit, double[] x, int link) {
        Fitter fitter = search.fitter();
        Fitter.State scored = fitter.lookWithSlopes(fit.candidate(), x, fit.frame());
        if (scored.failed()) {
            return List.of();
        }
        Assembly assembly = fit.candidate().at(x);
        Motion motion = new Motion(evidence, assembly);
        List<Learned> known = assembly.laws().stream().map(LawAt::law).filter(Learned.class::isInstance).map(Learned.class::cast).toList();
        List<Hypothesis> terms = new Grammar(evidence, assembly, motion, link).terms(known);
        List<Screening.Score> scores = distinct(new Screening(evidence, scored, motion).scores(terms));
        Place place = new Place(Place.Kind.LINK, link);
        List<double[]> from = Stream.of(fit.x(), x).distinct().toList();
        List<Fitter.State> begun = Cores.map(scores, score -> Trial.begun(new Trial.Ground(fitter, fit), score, from).first());
        List<Fitter.State> near = Trial.sorted(begun).stream().filter(state -> !state.failed()).limit(FITTED / 2).toList();
        return Cores.map(near, search.refinement()::polish).stream().filter(state -> !state.failed())
                .map(state -> new Sentence(state, evidence(state, terms.size()))).toList();
    }

    /** The best scores, no two of which differ only in a moment, a frequency or a time constant. */
    private static List<Screening.Score> distinct(List<Screening.Score> scores) {
        Set<String> kinds = new HashSet<>();
        return scores.stream().filter(score -> kinds.add(score.hypothesis().form().replaceAll("[0-9.]+ (s|Hz)", ""))).limit(FITTED).toList();
    }

    /**
     * Evidence of a sentence against the model without a law: what its fit gains, in units of what it leaves, less what the choice of each term
     * among all of them and of each number among those that data of this length tell apart costs (Schwarz 1978).
     */
    private double evidence(Fitter.State state, int terms) {
        double unit = Math.max(1, state.reduced());
        double without = search.fitter().look(base.candidate(), base.x(), state.frame()).cost();
        int numbers = state.x().length - base.x().length;
        return (without - state.cost()) / (2 * unit) - state.candidate().added().size() * Math.log(terms)
                - 0.5 * numbers * Math.log(state.frame().whitening().degrees());
    }

    /** The best law, if it holds on data that were not used: more than half of what is missing there goes with it. */
    Optional<Sentence> law(List<Sentence> sentences) {
        double before = search.refinement().heldOut(base);
        return sentences.stream().filter(sentence -> sentence.evidence() > 0)
                .filter(sentence -> search.refinement().heldOut(sentence.fit()) - 1 < 0.5 * (before - 1)).findFirst();
    }
}
