package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.law.LawAt;
import wbv.body.law.Learned;
import wbv.body.number.Modulator;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/**
 * Learns the law of a force that no mechanism of the library makes: terms of a {@link Grammar} are ranked by a score test, the few best are
 * fitted by free run, and the sentence is taken whose evidence is greatest, each further term having to pay for itself. What does not hold
 * on data that were not used is no law.
 */
public final class LawLearner {

    /** Links that are tried, likeliest first, and how many times the excess of the likeliest place one of them may leave. */
    private static final int LINKS = 2;
    private static final double NEAR = 2;
    /** How many times the excess of what is known without a law its first terms may leave for others to be sought beside them. */
    private static final double HOPELESS = 10;
    /** Sentences that are begun by free run, and those of them that are fitted to the end. */
    private static final int FITTED = 6;
    private static final int POLISHED = 3;
    /**
     * Terms that are begun where the model went far to make up for the law, where the first order tells little: of five laws made by
     * another place the right one came second to 125th along the motion as measured, and of the three that were begun among the first five
     * after three steps of its free run.
     */
    private static final int BEGUN = 64;
    /** Terms [1] of a sentence that are begun together: effort, since of two thousand terms the pairs can still all be scored. */
    private static final int FIRST = 2;
    private static final int MOST_TERMS = 4;
    /** A form that more terms correct is another law. */
    private static final int MOST_CORRECTING = 2;

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;
    private final List<Known.Ignoring> places;
    private final LawFits fits;
    private final LawProof proof;
    private final Openings openings;

    /**
     * On evidence that its library does not explain.
     *
     * @param base   the model on which a law is to stand, fitted: without any, or with named ones whose form is to be corrected
     * @param places where the mismatch may enter, likeliest first; none where outputs do not tell
     */
    public LawLearner(Evidence evidence, Search search, Fitter.State base, List<Known.Ignoring> places) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
        this.places = places;
        this.fits = new LawFits(evidence, search, base);
        this.proof = new LawProof(evidence, search, isCorrection());
        this.openings = evidence.known().about(base, Openings.class, Openings::new);
    }

    /**
     * A sentence of the grammar.
     *
     * @param fit   by free run
     * @param terms that it adds to what was known
     * @param gain by how much it lowers the cost [1] of the model without a law, as {@link #weighed}
     * @param of   how many terms each of its own was chosen
     * @param unit mean square of the residual that the best fit so far leaves; 1 at least
     */
    public record Sentence(Fitter.State fit, List<Hypothesis> terms, double gain, int of, double unit) {

        /** Logarithm of its evidence against the model without a law [nat]. */
        public double evidence() {
            double half = gain / (2 * unit);
            int numbers = terms.stream().mapToInt(term -> term.numbers().size()).sum();
            return half - price(half, terms.size(), of, numbers, fit.frame().whitening().degrees());
        }

        /** Its place and its terms, whatever their order and their numbers. */
        String said() {
            return fit.candidate().last().where() + terms.stream().map(Hypothesis::form).sorted().toList();
        }

        /** @param known that it stands on */
        static Sentence begun(Fitter.State fit, int known, int of) {
            List<Hypothesis> added = fit.candidate().added();
            return new Sentence(fit, added.subList(known, added.size()), Double.NaN, of, 1);
        }
    }

    /** Whether one way to explain a mismatch is likelier than another, each charged for all its numbers, those of what was named too. */
    public boolean isLikelier(Sentence one, Sentence other) {
        Sentence first = begun(one.fit(), one.of());
        return weighed(List.of(first, begun(other.fit(), other.of()))).get(0).fit() == first.fit();
    }

    private Sentence begun(Fitter.State fit, int of) {
        return Sentence.begun(fit, base.candidate().added().size(), of);
    }

    /** All seen through the whitening of the one that leaves least, and in units of what that leaves; most evident first. */
    private List<Sentence> weighed(List<Sentence> sentences) {
        if (sentences.isEmpty()) {
            return sentences;
        }
        Fitter.State least = sentences.stream().map(Sentence::fit).min(Comparator.comparingDouble(Fitter.State::reduced)).orElseThrow();
        double without = search.fitter().look(base.candidate(), base.x(), least.frame()).cost();
        return Parallel
                .map(sentences, sentence -> new Sentence(sentence.fit(), sentence.terms(),
                        without - search.fitter().look(sentence.fit().candidate(), sentence.fit().x(),
                                least.frame()).cost(),
                        sentence.of(), evidence.onRig() ? least.reduced() : Math.max(1, least.reduced())))
                .stream()
                .sorted(Comparator.comparingDouble(Sentence::evidence).reversed()).toList();
    }

    /**
     * The laws that were fitted, most evident first.
     *
     * @param than what is known without them: a law that begins by leaving far more gets no further terms
     */
    public List<Sentence> sentences(Fitter.State than) {
        List<Sentence> all = new ArrayList<>();
        for (int link : links()) {
            all.addAll(sentences(link, isCorrection() ? MOST_CORRECTING : MOST_TERMS, than));
        }
        // What was found from two grounds is one sentence.
        Set<String> said = new HashSet<>();
        return weighed(all).stream().filter(sentence -> said.add(sentence.said())).toList();
    }

    /** Tables in place of a formula, most evident first. */
    public List<Sentence> tables() {
        List<Sentence> all = new ArrayList<>();
        for (int link : links()) {
            all.addAll(opened(Ground.asMeasured(evidence, base.candidate(), unbent(link), 0), link, 1, Grammar::tables, term -> true)
                    .sentences());
        }
        return weighed(all);
    }

    /** The model's numbers with which terms in a link are scored. */
    private double[] unbent(int link) {
        Place place = new Place(Place.Kind.LINK, link);
        return places.stream().filter(found -> found.places().get(0).equals(place)).findFirst()
                .map(found -> place.asGiven(base.candidate(), found.x())).orElse(base.x());
    }

    /** Links in which all that is missing could enter. */
    private List<Integer> links() {
        int count = evidence.model().links().size();
        List<Integer> named = base.candidate().added().stream().map(Place::of).filter(place -> place.kind() == Place.Kind.LINK)
                .map(Place::index).distinct().toList();
        if (!named.isEmpty() || places.isEmpty()) {
            return named.isEmpty() ? IntStream.range(0, count).boxed().toList() : named;
        }
        double reach = Locator.reach(places, NEAR);
        return places.stream().filter(found -> found.reduced() <= reach)
                .map(found -> found.places().get(0).plain(base.candidate().template()))
                .filter(place -> place.kind() == Place.Kind.LINK).map(Place::index).distinct().limit(LINKS).toList();
    }

    private List<Sentence> sentences(int link, int most, Fitter.State than) {
        Openings.Opening opening = opening(link, than);
        List<Sentence> all = new ArrayList<>(opening.sentences());
        List<Sentence> latest = all;
        // Along the motion that a law makes, another term may show that the motion as measured did not.
        while (!latest.isEmpty()) {
            Sentence best = weighed(all).get(0);
            latest = best.terms().size() >= most || best.evidence() <= 0 || hopeless(best, than) ? List.of()
                    : opened(Ground.beside(evidence, base, best.fit()), link, 1, term -> opening.likely().contains(term.form()))
                            .sentences();
            all.addAll(latest);
            latest = latest.isEmpty() || weighed(all).get(0).fit() == best.fit() ? List.of() : latest;
        }
        if (!all.isEmpty()) {
            all.addAll(shorter(weighed(all).get(0)));
            all.addAll(limited(weighed(all).get(0), link));
        }
        return all;
    }

    /** Sentences of a link with the first terms, of one and of two. */
    private Openings.Opening opening(int link, Fitter.State than) {
        boolean known = !than.candidate().added().isEmpty() && !isCorrection() && Refinement.explainsNearlyAll(base, than);
        Openings.Opening first = known ? along(link, than) : asMeasured(link);
        if (isCorrection() || first.sentences().isEmpty()) {
            return first;
        }
        Sentence best = weighed(first.sentences()).get(0);
        return !leaves(best) || hopeless(best, than) ? first : first.and(along(link, best.fit()));
    }

    private Openings.Opening asMeasured(int link) {
        double[] x = unbent(link);
        return openings.once(link, Arrays.stream(x).boxed().toList(),
                () -> opened(Ground.asMeasured(evidence, base.candidate(), x, BEGUN), link, FIRST, term -> true));
    }

    private Openings.Opening along(int link, Fitter.State fit) {
        return openings.once(link, fit,
                () -> opened(Ground.along(evidence, base.candidate(), fit, BEGUN / 2), link, FIRST, term -> true));
    }

    private static boolean hopeless(Sentence sentence, Fitter.State than) {
        return Refinement.excess(sentence.fit().reduced()) > HOPELESS * Refinement.excess(than.reduced());
    }

    private static boolean leaves(Sentence sentence) {
        return sentence.fit().reduced() > Refinement.SILENT;
    }

    /** A sentence without each of its terms in turn: beside another a term may have been taken that nothing needs. */
    private List<Sentence> shorter(Sentence sentence) {
        List<Hypothesis> terms = sentence.terms();
        return terms.size() < 2 ? List.of()
                : Parallel.map(terms, left -> {
                    List<Hypothesis> kept = terms.stream().filter(term -> term != left).toList();
                    return begun(fits.changed(sentence.fit(), kept, kept), sentence.of());
                }).stream().filter(each -> !each.fit().failed()).toList();
    }

    /** A sentence whose modulators have limits, one after the other where that is better. */
    private List<Sentence> limited(Sentence sentence, int link) {
        Assembly assembly = base.candidate().at(base.x());
        Motion motion = new Motion(evidence, assembly);
        Grammar grammar = new Grammar(evidence, assembly, motion, new ModulatorSeries(evidence.excitation(), motion), link);
        List<Sentence> out = new ArrayList<>();
        Sentence best = sentence;
        for (int i = 0; i < sentence.terms().size(); i++) {
            int at = i;
            Sentence known = best;
            Optional<Sentence> tried = grammar.limited(known.terms().get(i)).map(term -> {
                List<Hypothesis> terms = new ArrayList<>(known.terms());
                terms.set(at, term);
                return begun(fits.changed(known.fit(), known.terms(), terms), known.of());
            }).filter(each -> !each.fit().failed());
            if (tried.isPresent() && weighed(List.of(known, tried.get())).get(0).fit() == tried.get().fit()) {
                best = tried.get();
                out.add(best);
            }
        }
        return out;
    }

    /** The most promising laws, or terms beside a law, fitted by free run. */
    private Openings.Opening opened(Ground ground, int link, int most, Predicate<Hypothesis> open) {
        List<Learned> known = ground.on().at(ground.x()).laws().stream().map(LawAt::law).filter(Learned.class::isInstance)
                .map(Learned.class::cast).toList();
        return opened(ground, link, most, grammar -> grammar.terms(known), open);
    }

    /** @param words of the grammar */
    private Openings.Opening opened(Ground ground, int link, int most, Function<Grammar, List<Hypothesis>> words,
            Predicate<Hypothesis> open) {
        Fitter fitter = search.fitter();
        Fitter.State scored = fitter.lookWithSlopes(ground.on(), ground.x(), base.frame());
        if (scored.failed()) {
            return new Openings.Opening(List.of(), List.of());
        }
        Assembly assembly = ground.on().at(ground.x());
        Motion motion = ground.motion();
        ModulatorSeries modulators = new ModulatorSeries(evidence.excitation(), motion);
        Grammar grammar = new Grammar(evidence, assembly, motion, modulators, link);
        List<Hypothesis> terms = words.apply(grammar).stream().filter(open).toList();
        Sentences sentences = new Sentences(evidence, scored, motion, modulators, link);
        List<Sentences.Proposal> kin = sentences.of(
                terms.stream().filter(term -> ground.kin().contains(Grammar.modulator(term))).toList(), 1, term -> Optional.empty());
        // What does not pay for its choice and its numbers to first order is not begun.
        List<Sentences.Proposal> all = sentences.of(terms, most, grammar::limited).stream().filter(proposal -> proposal.worth() > 0)
                .toList();
        List<Sentences.Proposal> proposals = IntStream.rangeClosed(1, most).boxed()
                .flatMap(length -> all.stream().filter(proposal -> proposal.terms().size() == length).limit(FITTED / most)).toList();
        List<Fitter.State> finalists = new ArrayList<>(
                first(Parallel.map(proposals, proposal -> LawFits.begun(fitter, scored, sentences, proposal)), terms.size()));
        // Beside a name, with which the model need make up for nothing, the first order tells terms apart.
        if (!isCorrection() && Refinement.bent(base)) {
            List<Sentences.Proposal> many = all.stream().filter(proposal -> proposal.terms().size() == 1)
                    .filter(proposal -> kin.stream().noneMatch(each -> each.kind().equals(proposal.kind()))).limit(ground.begun())
                    .collect(Collectors.toCollection(() -> new ArrayList<>(kin)));
            finalists.addAll(first(fits.begunInPart(scored, sentences, many), terms.size()));
        }
        return new Openings.Opening(
                Parallel.map(finalists, fits::settled).stream().filter(state -> !state.failed()).map(state -> begun(state, terms.size()))
                        .toList(),
                sentences.likely().stream().map(Hypothesis::form).toList());
    }

    /** The most evident of some fits that were begun. */
    private List<Fitter.State> first(List<Fitter.State> states, int of) {
        return weighed(states.stream().filter(state -> !state.failed()).map(state -> begun(state, of)).toList()).stream().limit(POLISHED)
                .map(Sentence::fit).toList();
    }

    /**
     * What a sentence costs: the choice of each term among all of them, and of each number among those that data of this length tell apart
     * (Schwarz 1978). A further number has to explain more than a formula that is right may leave, which is right to a part of its own
     * force only.
     *
     * @param gain of the sentence [nat]
     * @param chosen terms
     * @param of how many
     * @param numbers of all terms together
     * @param degrees of freedom of the data
     */
    static double price(double gain, int chosen, int of, int numbers, double degrees) {
        return (numbers - 1) * Priors.USUAL.form() * Priors.USUAL.form() * Math.max(0, gain) + chosen * Math.log(of)
                + 0.5 * numbers * Math.log(degrees);
    }

    /** Whether a law of a single term leaves less than half of what a single name does: then nobody need look for two. */
    public boolean isOne(Fitter.State name) {
        List<Sentence> all = new ArrayList<>();
        for (int link : links()) {
            List<Sentence> single = opening(link, name).sentences().stream().filter(sentence -> sentence.terms().size() == 1).toList();
            all.addAll(single);
            all.addAll(single.isEmpty() ? single : limited(weighed(single).get(0), link));
        }
        return law(weighed(all).stream().limit(1).toList(), Chosen.single(name)).isPresent();
    }

    private boolean isCorrection() {
        return !base.candidate().added().isEmpty();
    }

    /**
     * The best law, if it holds on data that were not used, see {@link LawProof}.
     *
     * @param name what is known without it: the model alone, or with what was named
     */
    public Optional<Sentence> law(List<Sentence> sentences, Chosen name) {
        return proof.law(sentences, name);
    }
}
