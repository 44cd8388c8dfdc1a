package wbv.diagnosis;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.learn.LawLearner;
import wbv.diagnosis.learn.LearnedWords;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/** Completes a diagnosis by what can be learned: the law where nothing was named, and what a named law does beside the library's form of it. */
final class Learning {

    /** Other laws that are told beside one that was learned. */
    private static final int RIVALS = 5;

    private final Evidence evidence;
    private final Search search;
    private final Refinement refinement;
    private final BiConsumer<String, Double> progress;

    Learning(Evidence evidence, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.search = new Search(evidence, progress);
        this.refinement = search.refinement();
        this.progress = progress;
    }

    /** A name that leaves more than the right one may gives way to a law that leaves less; so does a refusal. */
    Diagnosed completed(Diagnosed found) {
        boolean refused = found.diagnosis().verdict() == Diagnosis.Verdict.UNEXPLAINED;
        Diagnosed named = found.diagnosis().verdict() == Diagnosis.Verdict.MISSING_PHYSICS && LawLearner.lacks(found.fits) ? corrected(found) : found;
        return refused || LawLearner.doubts(found.fits) ? learned(named, refused) : named;
    }

    /** The same with the law of what is missing, where one can be learned. @param refused whether nothing was named; else the law has to do better than the name */
    private Diagnosed learned(Diagnosed unexplained, boolean refused) {
        progress.accept("learning the law", 0.8);
        Fits fits = unexplained.fits;
        LawLearner learner = new LawLearner(evidence, search, fits.base(), new Locator(evidence, fits.base().candidate()).singles(fits.base().x()));
        List<LawLearner.Sentence> sentences = learner.sentences();
        Chosen than = refused ? Chosen.single(fits.base()) : fits.chosen();
        return learner.law(sentences, than).or(() -> refused ? learner.law(learner.tables(), than) : Optional.empty())
                .map(law -> new LearnedVerdict(fits.with(law.fit()), refinement.heldOut(fits.base()), refinement)
                .learned(unexplained.diagnosis(), rivals(sentences, law), share(sentences, law, law))).orElse(unexplained);
    }

    /** The same with what a named law does beside the library's form of it, where that can be learned. */
    private Diagnosed corrected(Diagnosed named) {
        progress.accept("learning the form", 0.85);
        Fits fits = named.fits;
        LawLearner learner = new LawLearner(evidence, search, fits.best(), List.of());
        List<LawLearner.Sentence> sentences = learner.sentences();
        return learner.law(sentences, fits.chosen()).map(law -> new LearnedVerdict(fits.with(law.fit()), refinement.heldOut(fits.base()), refinement)
                .corrected(named.diagnosis(), refinement.heldOut(fits.best()), rivals(sentences, law))).orElse(named);
    }

    /** How likely one of the laws that were fitted is. Likelier ones than the law that was taken foretold data not used too badly to be laws. */
    private static double share(List<LawLearner.Sentence> sentences, LawLearner.Sentence law, LawLearner.Sentence of) {
        return Math.exp(of.evidence() - law.evidence()) / (1 + others(sentences, law).mapToDouble(each -> Math.exp(each.evidence() - law.evidence())).sum());
    }

    private static Stream<LawLearner.Sentence> others(List<LawLearner.Sentence> sentences, LawLearner.Sentence law) {
        return sentences.stream().filter(each -> each.gain() != law.gain() && each.evidence() <= law.evidence());
    }

    private List<Diagnosis.LearnedLaw.Rival> rivals(List<LawLearner.Sentence> sentences, LawLearner.Sentence law) {
        return others(sentences, law).limit(RIVALS)
                .map(each -> new Diagnosis.LearnedLaw.Rival(LearnedWords.of(evidence.model(), each.fit()), share(sentences, law, each), each.fit().reduced())).toList();
    }
}
