package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.Learned;
import wbv.body.ModulatorSeries;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * Learns the law of a force that no mechanism of the library makes: terms of a {@link Grammar} are ranked by a score test, the few best are
 * fitted by free run, and the sentence is taken whose evidence is greatest, each further term having to pay for itself. What does not hold on
 * data that were not used is no law.
 */
final class LawLearner {

    /** Links that are tried, likeliest first, and how many times the excess of the likeliest place one of them may leave. */
    private static final int LINKS = 2;
    private static final double NEAR = 2;
    /** Sentences that are begun by free run, and those of them that are fitted to the end. */
    private static final int FITTED = 6;
    private static final int POLISHED = 3;
    private static final int STEPS = 3;
    private static final int MORE_STEPS = 10;
    /** A linear term needs no free run, and is the harder to tell from the model's own numbers. */
    private static final int LINEAR_STEPS = 20;
    private static final int HALVINGS = 3;
    private static final int MOST_TERMS = 4;
    /** Part of its own force to which a formula is right. */
    private static final double FORM = 0.1;
    /** Part of what is missing on data not used that a law may leave: else more of it is something else. */
    private static final double HELD = 0.5;
    /** How many of the most evident laws are asked to hold. */
    private static final int HELD_OUT = 3;

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;
    private final List<Locator.Found> places;
    /** Forms of the terms that gained most where no law was known yet. */
    private final List<String> likely = new ArrayList<>();

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
     * @param fit  by free run
     * @param gain by how much it lowers the cost of the model without a law, as {@link #weighed}
     * @param of   how many terms each of its own was chosen
     * @param unit mean square of the residual that the best fit so far leaves; 1 at least
     */
    record Sentence(Fitter.State fit, double gain, int of, double unit) {

        /** Logarithm of its evidence against the model without a law [nat]. */
        double evidence() {
            double half = gain / (2 * unit);
            Candidate candidate = fit.candidate();
            int numbers = candidate.added().stream().mapToInt(term -> term.numbers().size()).sum();
            return half - price(half, candidate.added().size(), of, numbers, fit.frame().whitening().degrees());
        }
    }

    /** All seen through the whitening of the one that leaves least, and in units of what that leaves; most evident first. */
    private List<Sentence> weighed(List<Sentence> sentences) {
        if (sentences.isEmpty()) {
            return sentences;
        }
        Fitter.State least = sentences.stream().map(Sentence::fit).min(Comparator.comparingDouble(Fitter.State::reduced)).orElseThrow();
        double without = search.fitter().look(base.candidate(), base.x(), least.frame()).cost();
        return Cores.map(sentences, sentence -> new Sentence(sentence.fit(), without - search.fitter().look(sentence.fit().candidate(), sentence.fit().x(),
                least.frame()).cost(), sentence.of(), Math.max(1, least.reduced()))).stream()
                .sorted(Comparator.comparingDouble(Sentence::evidence).reversed()).toList();
    }

    /** The laws that were fitted, most evident first. */
    List<Sentence> sentences() {
        return sentences(MOST_TERMS);
    }

    /** @param most terms of each at most */
    private List<Sentence> sentences(int most) {
        List<Sentence> all = new ArrayList<>();
        for (int link : links()) {
            all.addAll(sentences(link, most));
        }
        return weighed(all);
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

    private List<Sentence> sentences(int link, int most) {
        Place place = new Place(Place.Kind.LINK, link);
        double[] unbent = places.stream().filter(found -> found.places().get(0).equals(place)).findFirst()
                .map(found -> place.asGiven(base.candidate(), found.x())).orElse(base.x());
        likely.clear();
        List<Sentence> all = new ArrayList<>();
        List<Sentence> latest = fitted(base.candidate(), unbent, link, Math.min(2, most), term -> true);
        // Along the motion that a law makes, another term may show that the motion as measured did not.
        while (!latest.isEmpty()) {
            all.addAll(latest);
            Fitter.State best = weighed(all).get(0).fit();
            latest = best.candidate().added().size() >= most ? List.of()
                    : fitted(best.candidate(), best.x(), link, 1, term -> likely.contains(term.form()));
            List<Sentence> both = new ArrayList<>(all);
            both.addAll(latest);
            latest = weighed(both).get(0).fit() == best ? List.of() : latest;
        }
        if (!all.isEmpty()) {
            all.addAll(limited(weighed(all).get(0), link));
        }
        return all;
    }

    /** A sentence whose modulators have limits, one after the other where that is better. */
    private List<Sentence> limited(Sentence sentence, int link) {
        Assembly assembly = base.candidate().at(base.x());
        Grammar grammar = new Grammar(evidence, assembly, new Motion(evidence, assembly), new ModulatorSeries(evidence.excitation(), assembly), link);
        List<Sentence> out = new ArrayList<>();
        Sentence best = sentence;
        for (int i = 0; i < sentence.fit().candidate().added().size(); i++) {
            int at = i;
            Sentence known = best;
            Optional<Sentence> tried = grammar.limited(known.fit().candidate().added().get(i))
                    .map(term -> new Sentence(replaced(known.fit(), at, term), Double.NaN, known.of(), 1)).filter(each -> !each.fit().failed());
            if (tried.isPresent() && weighed(List.of(known, tried.get())).get(0).fit() == tried.get().fit()) {
                best = tried.get();
                out.add(best);
            }
        }
        return out;
    }

    /** A fit with another term in the place of one. @param term begins with the coefficient of the one that it replaces */
    private Fitter.State replaced(Fitter.State fit, int at, Hypothesis term) {
        List<Hypothesis> terms = new ArrayList<>(fit.candidate().added());
        terms.set(at, term);
        Candidate with = base.candidate();
        for (Hypothesis each : terms) {
            with = with.with(each);
        }
        double[] x = Arrays.copyOf(fit.x(), with.knobs().size());
        for (int t = 0; t < terms.size(); t++) {
            int[] to = with.positions(terms.get(t));
            int[] from = fit.candidate().positions(fit.candidate().added().get(t));
            for (int i = 0; i < to.length; i++) {
                x[to[i]] = i < from.length ? fit.x()[from[i]] : with.knobs().get(to[i]).coordinate(term.starts().get(0).values()[i]);
            }
        }
        return settled(search.fitter().look(with, x, base.frame()));
    }

    /** The most promising laws, or terms beside a law, fitted by free run, most evident first. @param x where terms are scored */
    private List<Sentence> fitted(Candidate on, double[] x, int link, int most, Predicate<Hypothesis> open) {
        Fitter fitter = search.fitter();
        Fitter.State scored = fitter.lookWithSlopes(on, x, base.frame());
        if (scored.failed()) {
            return List.of();
        }
        Assembly assembly = on.at(x);
        Motion motion = new Motion(evidence, assembly);
        List<Learned> known = assembly.laws().stream().map(LawAt::law).filter(Learned.class::isInstance).map(Learned.class::cast).toList();
        ModulatorSeries modulators = new ModulatorSeries(evidence.excitation(), assembly);
        Grammar grammar = new Grammar(evidence, assembly, motion, modulators, link);
        List<Hypothesis> terms = grammar.terms(known).stream().filter(open).toList();
        Sentences sentences = new Sentences(evidence, scored, motion, modulators, link);
        List<Sentences.Proposal> all = sentences.of(terms, most, grammar::variants);
        List<Sentences.Proposal> proposals = IntStream.rangeClosed(1, most).boxed()
                .flatMap(length -> all.stream().filter(proposal -> proposal.terms().size() == length).limit(FITTED / most)).toList();
        List<Fitter.State> begun = Trial.sorted(Cores.map(proposals, proposal -> begun(on, sentences, proposal)));
        if (likely.isEmpty()) {
            likely.addAll(sentences.likely());
        }
        return Cores.map(begun.stream().filter(state -> !state.failed()).limit(POLISHED).toList(), this::settled).stream()
                .filter(state -> !state.failed()).map(state -> new Sentence(state, Double.NaN, terms.size(), 1)).toList();
    }

    /** The first steps from what is proposed; from less of it where that much is not stable. */
    private Fitter.State begun(Candidate on, Sentences sentences, Sentences.Proposal proposal) {
        Fitter fitter = search.fitter();
        Candidate with = on;
        for (Hypothesis term : proposal.terms()) {
            with = with.with(term);
        }
        double[] x = sentences.start(proposal, with);
        Fitter.State state = fitter.look(with, x, base.frame());
        for (int half = 0; half < HALVINGS && state.failed(); half++) {
            for (Hypothesis term : proposal.terms()) {
                int[] at = with.positions(term);
                for (int i = 0; i < at.length; i++) {
                    x[at[i]] *= with.knobs().get(at[i]).unit() == 0 ? 1 : 0.5;
                }
            }
            state = fitter.look(with, x, base.frame());
        }
        return state.failed() ? state : fitter.fit(with, x, base.frame(), runsFree(with) ? STEPS : LINEAR_STEPS, 1e-3);
    }

    /** Fitted on, in the whitening of its own model. */
    private Fitter.State settled(Fitter.State state) {
        Fitter fitter = search.fitter();
        return state.failed() ? state : fitter.fit(state.candidate(), state.x(), fitter.frame(state.candidate(), state.x(), evidence.fit()), runsFree(state.candidate()) ? MORE_STEPS : LINEAR_STEPS, 1e-3);
    }

    private static boolean runsFree(Candidate candidate) {
        return candidate.added().stream().anyMatch(Hypothesis::runsFree);
    }

    /**
     * What a sentence costs: the choice of each term among all of them, and of each number among those that data of this length tell apart (Schwarz 1978).
     * A further number has to explain more than a formula that is right may leave, which is right to a part of its own force only.
     *
     * @param gain of the sentence [nat] @param chosen terms @param of how many @param numbers of all terms together @param degrees of freedom of the data
     */
    static double price(double gain, int chosen, int of, int numbers, double degrees) {
        return (numbers - 1) * FORM * FORM * Math.max(0, gain) + chosen * Math.log(of) + 0.5 * numbers * Math.log(degrees);
    }

    /** Whether a law of a single term leaves less than half of what a single name does: then nobody need look for two. */
    boolean isOne(Fitter.State name) {
        return law(sentences(1).stream().limit(1).toList(), name).isPresent();
    }

    /**
     * Whether a name leaves more of its place's force than the name of a right law can: then it may be another law, which only looks like it.
     */
    static boolean doubts(Diagnosed named) {
        List<Hypothesis> added = named.chosen.candidate().added();
        boolean physics = !added.isEmpty() && added.stream().allMatch(term -> Place.of(term).kind() != Place.Kind.SENSOR)
                && added.stream().anyMatch(Hypothesis::isLaw);
        double left = named.chosen.reduced() - 1;
        return physics && !named.evidence.onRig() && named.chosen.reduced() > Verdicts.SILENT && left > FORM * FORM * (named.base.reduced() - 1);
    }

    /**
     * The best law, if it holds on data that were not used: more than half of what is missing there goes with it. Beside a name of more parts than it
     * has terms it need not leave less, here and there. Beside any name its evidence has to be greater.
     *
     * @param than what is known without it: the model alone, or with what was named
     */
    Optional<Sentence> law(List<Sentence> sentences, Fitter.State than) {
        double before = search.refinement().heldOut(than);
        int parts = than.candidate().added().size();
        return sentences.stream().filter(sentence -> sentence.evidence() > 0).limit(HELD_OUT)
                .map(sentence -> new Sentence(search.refinement().polish(sentence.fit()), sentence.gain(), sentence.of(), sentence.unit()))
                .filter(sentence -> {
                    double most = sentence.fit().candidate().added().size() < parts ? 1 : HELD;
                    boolean evident = parts == 0 || weighed(List.of(sentence, new Sentence(than, Double.NaN, sentence.of(), 1))).get(0).fit() == sentence.fit();
                    return evident && search.refinement().heldOut(sentence.fit()) - 1 < most * (before - 1) && sentence.fit().reduced() - 1 < most * (than.reduced() - 1);
                }).findFirst();
    }
}
