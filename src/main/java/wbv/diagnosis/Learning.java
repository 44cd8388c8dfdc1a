package wbv.diagnosis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Model;
import wbv.body.Structure;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.learn.LawLearner;
import wbv.diagnosis.learn.Sentence;
import wbv.diagnosis.learn.LawProof;
import wbv.diagnosis.learn.LearnedWords;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/**
 * Completes a diagnosis by what can be learned: the law where nothing was named, and what a named law does beside the library's form of it.
 */
final class Learning {

    private final Evidence evidence;
    private final Search search;
    private final Refinement refinement;
    private final BiConsumer<String, Double> progress;

    private Learning(Evidence evidence, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.search = new Search(evidence, progress);
        this.refinement = search.refinement();
        this.progress = progress;
    }

    /** A law that was learned among others. */
    private record Learnt(LawLearner learner, List<Sentence> sentences, Sentence law) {}

    /**
     * A name that leaves more than noise gives way to a likelier law, as does a refusal; or it stands with what it lacks of the library's
     * form. Beside a law that explains nearly all only a name that does so too is asked for its form: with enough terms any name can be
     * dressed up as that law.
     */
    static Diagnosed completed(Diagnosed found, BiConsumer<String, Double> progress) {
        // A white noise of the input passes for whatever a form that is not quite right leaves: the form is asked first.
        boolean heard = !found.fits.evidence().heard().isEmpty();
        Evidence evidence = heard ? found.fits.evidence().with(Map.of()) : found.fits.evidence();
        boolean open = isRefused(found) || found.fits.best().candidate().added().stream().anyMatch(Hypothesis::isLaw);
        return new Learning(evidence, progress).completed(found, heard && open ? found.fits.seen(evidence) : found.fits);
    }

    private static boolean isRefused(Diagnosed found) {
        return found.diagnosis().verdict() == Diagnosis.Verdict.UNEXPLAINED;
    }

    private Diagnosed completed(Diagnosed found, Fits fits) {
        // A law that nobody has named passes for a push, as arbitrary as that is; one that is learned takes its place.
        boolean pushed = found.isPush() && mayBeLaw(found, fits.base());
        boolean refused = isRefused(found) || pushed;
        boolean doubts = !refused && LawProof.doubts(fits, refinement.heldOut(fits.best()));
        boolean lacks = !isRefused(found) && !found.diagnosis().missing().isEmpty() && LawProof.lacks(fits);
        // A law in place of a name that explains nearly all differs from it by little, as a form of it does: what that may gain shows
        // beside the name. Two at one place it may outweigh and gain nothing.
        boolean near = Refinement.explainsNearlyAll(fits.base(), fits.best()) && !LawProof.isTwofold(fits);
        boolean bounded = evidence.floor() < 1;
        LawLearner beside = new LawLearner(evidence, search, fits.best(), List.of());
        boolean promising = (doubts && near || lacks && !bounded) && beside.promises();
        Optional<Learnt> law = (refused || (doubts && (promising || !near)) ? law(fits, refused) : Optional.<Learnt>empty())
                .filter(alone -> !pushed || Refinement.isTaken(fits.base().reduced(), alone.law().fit().reduced()));
        boolean dressed = !Refinement.explainsNearlyAll(fits.base(), fits.best())
                && law.filter(alone -> Refinement.explainsNearlyAll(fits.base(), alone.law().fit())).isPresent();
        Optional<Learnt> form = lacks && !dressed && (promising || bounded) ? form(fits, beside) : Optional.empty();
        return law.filter(alone -> form.map(own -> alone.learner().isLikelier(alone.law(), own.law())).orElse(true))
                .map(alone -> told(alone, fits).learned(found.diagnosis(), rivals(alone), share(alone, alone.law())))
                .or(() -> form
                        .flatMap(own -> told(own, fits).corrected(found.diagnosis(), refinement.heldOut(fits.best()), rivals(own))))
                .orElse(found);
    }

    /** Whether a push acts on what stands on the base, where a law of the link below might as well. */
    private boolean mayBeLaw(Diagnosed push, Fitter.State base) {
        LawLearner learner = new LawLearner(evidence, search, base, List.of());
        Structure structure = base.candidate().template().structure();
        List<Model.Body> bodies = evidence.model().bodies();
        return push.diagnosis().missing().stream()
                .flatMap(named -> IntStream.range(0, bodies.size()).filter(b -> bodies.get(b).name().equals(named.where())).boxed())
                .anyMatch(body -> IntStream.range(0, structure.links())
                        .anyMatch(link -> structure.standsOnBase(link, body) && learner.promises(link)));
    }

    private LearnedVerdict told(Learnt learnt, Fits fits) {
        return new LearnedVerdict(fits.with(learnt.law().fit()), refinement.heldOut(fits.base()), refinement);
    }

    /**
     * The law of what is missing, where one can be learned.
     *
     * @param refused whether nothing was named; else the law has to do better than the name
     */
    private Optional<Learnt> law(Fits fits, boolean refused) {
        progress.accept("learning the law", 0.8);
        LawLearner learner = new LawLearner(evidence, search, fits.base(), places(fits, refused));
        Chosen than = refused ? Chosen.single(fits.base()) : fits.chosen();
        List<Sentence> sentences = learner.sentences(than.fit());
        return learner.law(sentences, than).or(() -> refused ? learner.law(learner.tables(), than) : Optional.empty())
                .map(law -> new Learnt(learner, sentences, law));
    }

    /** Where the mismatch may enter, likeliest first: where a name explains nearly all, no place but its own is asked. */
    private List<Known.Ignoring> places(Fits fits, boolean refused) {
        Locator locator = new Locator(evidence, fits.base().candidate());
        Candidate named = fits.best().candidate();
        return refused || !Refinement.explainsNearlyAll(fits.base(), fits.best()) ? locator.singles(fits.base().x())
                : locator.among(named.added().stream().map(part -> Place.plain(part, named)).distinct().toList(), fits.base().x());
    }

    /** What a named law does beside the library's form of it, where that can be learned. */
    private Optional<Learnt> form(Fits fits, LawLearner learner) {
        progress.accept("learning the form", 0.85);
        List<Sentence> sentences = learner.sentences(fits.best());
        return learner.law(sentences, fits.chosen()).map(law -> new Learnt(learner, sentences, law));
    }

    /**
     * How likely one of the laws that were fitted is. Likelier ones than the law that was taken foretold data not used too badly to be
     * laws.
     */
    private static double share(Learnt learnt, Sentence of) {
        double evidence = learnt.law().evidence();
        return Math.exp(of.evidence() - evidence) / (1 + others(learnt).mapToDouble(each -> Math.exp(each.evidence() - evidence)).sum());
    }

    private static Stream<Sentence> others(Learnt learnt) {
        return learnt.sentences().stream().filter(each -> !each.terms().equals(learnt.law().terms())
                && each.evidence() <= learnt.law().evidence());
    }

    private List<Diagnosis.LearnedLaw.Rival> rivals(Learnt learnt) {
        return others(learnt).limit(VerdictWords.RIVALS)
                .map(each -> new Diagnosis.LearnedLaw.Rival(LearnedWords.of(evidence.model(), each.fit()), share(learnt, each),
                        each.fit().reduced()))
                .toList();
    }
}
