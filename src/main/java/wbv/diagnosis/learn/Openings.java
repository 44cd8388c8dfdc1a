package wbv.diagnosis.learn;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.law.Learned;
import wbv.body.simulate.ModulatorSeries;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/**
 * First terms of a law: those of a link's {@link Grammar} that promise most on a {@link Ground}, begun by free run, the best of them
 * fitted to the end. Whether a law may be one is asked before it is learned, and both begin with them: what a ground shows is worked out
 * once.
 */
final class Openings {

    private final Evidence evidence;
    private final Search search;
    private final Fitter.State base;
    private final LawFits fits;
    private final Weighing weighing;
    private final boolean correction;

    /** @param base on which all laws stand */
    Openings(Evidence evidence, Search search, Fitter.State base, LawFits fits, Weighing weighing) {
        this.evidence = evidence;
        this.search = search;
        this.base = base;
        this.fits = fits;
        this.weighing = weighing;
        this.correction = !base.candidate().added().isEmpty();
    }

    /** What a ground shows in a link; a ground is itself, or equal numbers. */
    private record Asked(Fitter.State base, int link, Object ground) implements Known.Question<Opening> {}

    /**
     * Sentences of a link with the first terms, of one and of two.
     *
     * @param x the model's numbers with which they are scored, coordinates [1], one a knob
     * @param than what is known without a law
     */
    Opening of(int link, double[] x, Fitter.State than) {
        if (correction) {
            return once(link, base, () -> beside(link).map(scored -> opened(scored, Effort.SECONDS, 0)).orElse(Opening.NONE));
        }
        boolean named = !than.candidate().added().isEmpty() && Refinement.explainsNearlyAll(base, than);
        Opening first = named ? along(link, than) : asMeasured(link, x);
        if (first.sentences().isEmpty()) {
            return first;
        }
        Sentence best = weighing.best(first.sentences());
        boolean enough = best.fit().reduced() <= Priors.SILENT || best.isHopelessBeside(than);
        return enough ? first : first.and(along(link, best.fit()));
    }

    /**
     * Whether terms beside those of the base promise to leave so little. A law in place of one that leaves little is that one and what they
     * differ by, which is small: beside it the first order says what any law may gain there.
     *
     * @param most mean square of the whitened residual that may be left [1]
     */
    boolean promise(int link, double most) {
        return beside(link).map(scored -> scored.promising().stream().anyMatch(proposal -> proposal.left() < most)).orElse(false);
    }

    /** What terms beside those of the base promise, if that could be looked at. */
    private record Beside(Fitter.State base, int link) implements Known.Question<Optional<Scored>> {}

    private Optional<Scored> beside(int link) {
        return evidence.known().once(new Beside(base, link), () -> {
            Ground ground = Ground.beside(evidence, base, base);
            return scored(ground, link, Effort.SECONDS, grammar -> grammar.terms(known(ground)), term -> true);
        });
    }

    private Opening asMeasured(int link, double[] x) {
        return once(link, Arrays.stream(x).boxed().toList(),
                () -> opened(Ground.asMeasured(evidence, base.candidate(), x, Effort.BEGUN_TERMS), link, Effort.SECONDS, term -> true));
    }

    private Opening along(int link, Fitter.State fit) {
        return once(link, fit,
                () -> opened(Ground.along(evidence, base.candidate(), fit, Effort.BEGUN_TERMS / 2), link, Effort.SECONDS, term -> true));
    }

    private Opening once(int link, Object ground, Supplier<Opening> find) {
        return evidence.known().once(new Asked(base, link, ground), find);
    }

    /**
     * One more term on top of a sentence.
     *
     * @param likely forms of those that are tried
     */
    List<Sentence> beside(Sentence sentence, int link, List<String> likely) {
        return opened(Ground.beside(evidence, base, sentence.fit()), link, 1, term -> likely.contains(term.form())).sentences();
    }

    /**
     * Tables in place of a formula.
     *
     * @param x the model's numbers with which they are scored, coordinates [1], one a knob
     */
    List<Sentence> tables(int link, double[] x) {
        return opened(Ground.asMeasured(evidence, base.candidate(), x, 0), link, 1, Grammar::tables, term -> true).sentences();
    }

    /** The most promising laws, or terms beside a law, fitted by free run. */
    private Opening opened(Ground ground, int link, int most, Predicate<Hypothesis> open) {
        return opened(ground, link, most, grammar -> grammar.terms(known(ground)), open);
    }

    private static List<Learned> known(Ground ground) {
        return ground.on().at(ground.x()).laws().stream().map(LawAt::law).filter(Learned.class::isInstance).map(Learned.class::cast)
                .toList();
    }

    /** @param words of the grammar */
    private Opening opened(Ground ground, int link, int most, Function<Grammar, List<Hypothesis>> words,
            Predicate<Hypothesis> open) {
        return scored(ground, link, most, words, open).map(scored -> opened(scored, most, ground.begun())).orElse(Opening.NONE);
    }

    /**
     * What terms promise on a ground.
     *
     * @param state where they were scored
     * @param kin those beside which more are begun
     * @param promising those that pay for their choice and their numbers to first order, most worth first
     */
    private record Scored(Fitter.State state, Sentences sentences, Vocabulary vocabulary, List<Sentences.Proposal> kin,
            List<Sentences.Proposal> promising) {}

    private Optional<Scored> scored(Ground ground, int link, int most, Function<Grammar, List<Hypothesis>> words,
            Predicate<Hypothesis> open) {
        Fitter.State scored = search.fitter().lookWithSlopes(ground.on(), ground.x(), base.frame());
        if (scored.failed()) {
            return Optional.empty();
        }
        Assembly assembly = ground.on().at(ground.x());
        Motion motion = ground.motion();
        ModulatorSeries modulators = new ModulatorSeries(evidence.excitation(), motion);
        Grammar grammar = new Grammar(evidence, assembly, motion, modulators, link);
        List<Hypothesis> all = words.apply(grammar);
        Vocabulary vocabulary = Vocabulary.of(evidence.library().mechanisms().size(), all);
        List<Hypothesis> terms = all.stream().filter(open).toList();
        Sentences sentences = new Sentences(evidence, scored, motion, modulators, link, vocabulary);
        List<Sentences.Proposal> kin = sentences.of(
                terms.stream().filter(term -> ground.kin().contains(Grammar.modulator(term))).toList(), 1, term -> Optional.empty());
        List<Sentences.Proposal> promising = sentences.of(terms, most, grammar::limited).stream().filter(proposal -> proposal.worth() > 0)
                .toList();
        return Optional.of(new Scored(scored, sentences, vocabulary, kin, promising));
    }

    /** @param begun terms that are begun where the model went far */
    private Opening opened(Scored on, int most, int begun) {
        Fitter fitter = search.fitter();
        Fitter.State scored = on.state();
        Sentences sentences = on.sentences();
        Vocabulary vocabulary = on.vocabulary();
        List<Sentences.Proposal> kin = on.kin();
        List<Sentences.Proposal> promising = on.promising();
        List<Sentences.Proposal> proposals = IntStream.rangeClosed(1, most).boxed()
                .flatMap(length -> promising.stream().filter(proposal -> proposal.terms().size() == length).limit(Effort.FINALISTS / most))
                .toList();
        List<Fitter.State> finalists = new ArrayList<>(
                first(Parallel.map(proposals, proposal -> LawFits.begun(fitter, scored, sentences, proposal)), vocabulary));
        // Beside a name, with which the model need make up for nothing, the first order tells terms apart.
        if (!correction && Refinement.bent(base)) {
            List<Sentences.Proposal> many = promising.stream().filter(proposal -> proposal.terms().size() == 1)
                    .filter(proposal -> kin.stream().noneMatch(each -> each.kind().equals(proposal.kind()))).limit(begun)
                    .collect(Collectors.toCollection(() -> new ArrayList<>(kin)));
            finalists.addAll(first(fits.begunInPart(scored, sentences, many), vocabulary));
        }
        return new Opening(
                Parallel.map(finalists, fits::settled).stream().filter(state -> !state.failed())
                        .map(state -> weighing.begun(state, vocabulary))
                        .toList(),
                sentences.likely().stream().map(Hypothesis::form).toList());
    }

    /** The most evident of some fits that were begun. */
    private List<Fitter.State> first(List<Fitter.State> states, Vocabulary vocabulary) {
        return weighing.of(states.stream().filter(state -> !state.failed()).map(state -> weighing.begun(state, vocabulary)).toList())
                .stream()
                .limit(Effort.LEADERS)
                .map(Sentence::fit).toList();
    }
}
