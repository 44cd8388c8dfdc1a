package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Search;

/**
 * Learns the law of a force that no mechanism of the library makes: terms of a {@link Grammar} are ranked by a score test, the few best are
 * fitted by free run, and the sentence is taken whose evidence is greatest, each further term having to pay for itself. What does not hold
 * on data that were not used is no law.
 */
public final class LawLearner {

    private final Evidence evidence;
    private final Fitter.State base;
    private final List<Known.Ignoring> places;
    private final LawFits fits;
    private final LawProof proof;
    private final Openings openings;
    private final Weighing weighing;
    private final boolean correction;

    /**
     * On evidence that its library does not explain.
     *
     * @param base   the model on which a law is to stand, fitted: without any, or with named ones whose form is to be corrected
     * @param places where the mismatch may enter, likeliest first; none where outputs do not tell
     */
    public LawLearner(Evidence evidence, Search search, Fitter.State base, List<Known.Ignoring> places) {
        this.evidence = evidence;
        this.base = base;
        this.places = places;
        this.correction = !base.candidate().added().isEmpty();
        this.fits = new LawFits(evidence, search, base);
        this.weighing = new Weighing(evidence, search, base);
        this.openings = new Openings(evidence, search, base, fits, weighing);
        this.proof = new LawProof(evidence, search, correction);
    }

    /** Whether one way to explain a mismatch is likelier than another, each charged for all its numbers, those of what was named too. */
    public boolean isLikelier(Sentence one, Sentence other) {
        Sentence first = weighing.begun(one.fit(), one.words());
        return weighing.best(List.of(first, weighing.begun(other.fit(), other.words()))).fit() == first.fit();
    }

    /**
     * The laws that were fitted, most evident first.
     *
     * @param than what is known without them: a law that begins by leaving far more gets no further terms
     */
    public List<Sentence> sentences(Fitter.State than) {
        List<Sentence> all = new ArrayList<>();
        // A law has to leave half of what a name does, or, of fewer parts than are named, about as much.
        int parts = than.candidate().added().size();
        double share = parts > 1 ? Effort.ALIKE : Priors.MAJORITY;
        for (int link : links().stream().filter(each -> parts == 0 || mayLeave(each, share, than)).toList()) {
            all.addAll(sentences(link, correction ? Effort.SECONDS : Effort.TERMS, than));
        }
        // What was found from two grounds is one sentence.
        Set<String> said = new HashSet<>();
        return weighing.of(all).stream().filter(sentence -> said.add(sentence.said())).toList();
    }

    /**
     * Whether terms beside what is named promise to leave so little that they may hold, or a law in its place.
     *
     * @see LawProof#within
     */
    public boolean promises() {
        return links().stream().anyMatch(this::promises);
    }

    /** The same of terms in one link. */
    public boolean promises(int link) {
        return openings.promise(link, LawProof.within(evidence, base));
    }

    /** Tables in place of a formula, most evident first. */
    public List<Sentence> tables() {
        List<Sentence> all = new ArrayList<>();
        for (int link : links()) {
            all.addAll(openings.tables(link, unbent(link)));
        }
        return weighing.of(all);
    }

    /** The model's numbers with which terms in a link are scored. */
    private double[] unbent(int link) {
        return at(link).findFirst().map(found -> found.places().get(0).asGiven(base.candidate(), found.x())).orElse(base.x());
    }

    /** What is left where a link is ignored, if that was looked at. */
    private Stream<Known.Ignoring> at(int link) {
        Place place = new Place(Place.Kind.LINK, link);
        return places.stream().filter(found -> found.places().get(0).equals(place));
    }

    /** Links in which all that is missing could enter. */
    private List<Integer> links() {
        int count = evidence.model().links().size();
        List<Integer> named = base.candidate().added().stream().map(Place::of).filter(place -> place.kind() == Place.Kind.LINK)
                .map(Place::index).distinct().toList();
        if (!named.isEmpty() || places.isEmpty()) {
            return named.isEmpty() ? IntStream.range(0, count).boxed().toList() : named;
        }
        double reach = Locator.reach(places, Effort.ALIKE);
        return places.stream().filter(found -> found.reduced() <= reach)
                .map(found -> found.places().get(0).plain(base.candidate().template()))
                .filter(place -> place.kind() == Place.Kind.LINK).map(Place::index).distinct().limit(Effort.SECONDS).toList();
    }

    private List<Sentence> sentences(int link, int most, Fitter.State than) {
        Opening opening = openings.of(link, unbent(link), than);
        if (opening.sentences().isEmpty()) {
            return List.of();
        }
        List<Sentence> all = new ArrayList<>(opening.sentences());
        Sentence best = weighing.best(all);
        // Along the motion that a law makes, another term may show that the motion as measured did not.
        for (boolean better = true; better;) {
            List<Sentence> more = best.terms().size() >= most || !best.shows() || best.isHopelessBeside(than) ? List.of()
                    : openings.beside(best, link, opening.likely());
            all.addAll(more);
            Sentence next = more.isEmpty() ? best : weighing.best(all);
            better = next.fit() != best.fit();
            best = next;
        }
        all.addAll(shorter(best));
        all.addAll(limited(weighing.best(all), link));
        return all;
    }

    /** A sentence without each of its terms in turn: beside another a term may have been taken that nothing needs. */
    private List<Sentence> shorter(Sentence sentence) {
        List<Hypothesis> terms = sentence.terms();
        return terms.size() < 2 ? List.of()
                : Parallel.map(terms, left -> {
                    List<Hypothesis> kept = terms.stream().filter(term -> term != left).toList();
                    return weighing.begun(fits.changed(sentence.fit(), kept, kept), sentence.words());
                }).stream().filter(each -> !each.fit().failed()).toList();
    }

    /** A sentence whose modulators have limits, one after the other where that is better. */
    private List<Sentence> limited(Sentence sentence, int link) {
        Assembly assembly = base.candidate().at(base.x());
        Motion motion = Motion.measured(evidence, assembly);
        Grammar grammar = new Grammar(evidence, assembly, motion, new ModulatorSeries(evidence.excitation(), motion), link);
        List<Sentence> out = new ArrayList<>();
        Sentence best = sentence;
        for (int i = 0; i < sentence.terms().size(); i++) {
            int at = i;
            Sentence known = best;
            Optional<Sentence> tried = grammar.limited(known.terms().get(i)).map(term -> {
                List<Hypothesis> terms = new ArrayList<>(known.terms());
                terms.set(at, term);
                return weighing.begun(fits.changed(known.fit(), known.terms(), terms), known.words());
            }).filter(each -> !each.fit().failed());
            if (tried.isPresent() && weighing.best(List.of(known, tried.get())).fit() == tried.get().fit()) {
                best = tried.get();
                out.add(best);
            }
        }
        return out;
    }

    private record One(Fitter.State base, Fitter.State name) implements Known.Question<Boolean> {}

    /**
     * Whether a law of a single term at one place, one that is in no library, leaves less than half of what a single name does: then nobody
     * need look for two of the library. Kept with the evidence.
     *
     * @param base the model without any mechanism, fitted
     */
    public static boolean isOne(Evidence evidence, Fitter.State base, Fitter.State name) {
        return evidence.known().once(new One(base, name), () -> new LawLearner(evidence, new Search(evidence, (step, share) -> {}), base,
                new Locator(evidence, base.candidate()).singles(base.x())).isOne(name));
    }

    private boolean isOne(Fitter.State name) {
        List<Sentence> all = new ArrayList<>();
        for (int link : links().stream().filter(each -> mayHoldAll(each) && mayLeave(each, Priors.MAJORITY, name)).toList()) {
            List<Sentence> single = openings.of(link, unbent(link), name).sentences().stream()
                    .filter(sentence -> sentence.terms().size() == 1).toList();
            all.addAll(single);
            all.addAll(single.isEmpty() ? single : limited(weighing.best(single), link));
        }
        return law(weighing.of(all).stream().limit(1).toList(), Chosen.single(name)).isPresent();
    }

    /**
     * Whether all that is missing may enter in a link: ignored there it leaves no more than places scatter by. What stands for a simulation
     * leaves more of its own.
     */
    private boolean mayHoldAll(int link) {
        double most = Math.max(Priors.LOUD, Locator.scatter(base, Effort.BEHIND));
        return evidence.standsForSimulation() || at(link).allMatch(found -> found.reduced() < most);
    }

    /**
     * Whether whatever force in a link leaves less than some share of what a name leaves beyond noise: no law there leaves less. Where a
     * force is ignored, one residual in each sample goes with it, which a law may have left empty.
     */
    private boolean mayLeave(int link, double share, Fitter.State name) {
        double shown = 1 - 1.0 / evidence.outputs().size();
        double floor = evidence.floor();
        return at(link).allMatch(found -> shown * found.reduced() - floor < share * (name.reduced() - floor));
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
