package wbv.diagnosis.learn;

import java.util.Comparator;
import java.util.List;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Search;

/** Sentences on one model, seen through one whitening and in one unit, so that their evidences compare. */
final class Weighing {

    private final Evidence evidence;
    private final Fitter fitter;
    private final Fitter.State base;

    /** @param base on which all sentences stand */
    Weighing(Evidence evidence, Search search, Fitter.State base) {
        this.evidence = evidence;
        this.fitter = search.fitter();
        this.base = base;
    }

    /**
     * A sentence that is not weighed yet.
     *
     * @param of how many terms each of its own was chosen
     */
    Sentence begun(Fitter.State fit, int of) {
        List<Hypothesis> added = fit.candidate().added();
        return new Sentence(fit, added.subList(base.candidate().added().size(), added.size()), Double.NaN, of, 1);
    }

    /** All seen through the whitening of the one that leaves least, and in units of what that leaves; most evident first. */
    List<Sentence> of(List<Sentence> sentences) {
        if (sentences.isEmpty()) {
            return sentences;
        }
        Fitter.State least = sentences.stream().map(Sentence::fit).min(Comparator.comparingDouble(Fitter.State::reduced)).orElseThrow();
        double without = fitter.look(base.candidate(), base.x(), least.frame()).cost();
        double unit = evidence.onRig() ? least.reduced() : Math.max(1, least.reduced());
        return Parallel.map(sentences, sentence -> {
            double with = fitter.look(sentence.fit().candidate(), sentence.fit().x(), least.frame()).cost();
            return new Sentence(sentence.fit(), sentence.terms(), without - with, sentence.of(), unit);
        }).stream().sorted(Comparator.comparingDouble(Sentence::evidence).reversed()).toList();
    }

    /** The most evident; there must be one. */
    Sentence best(List<Sentence> sentences) {
        return of(sentences).get(0);
    }
}
