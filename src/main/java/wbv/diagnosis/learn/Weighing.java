package wbv.diagnosis.learn;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Search;

/** Sentences on one model, seen through one whitening and beside the best of them, so that their evidences compare. */
final class Weighing {

    private final boolean bounded;
    private final Fitter fitter;
    private final Fitter.State base;

    /** @param base on which all sentences stand */
    Weighing(Evidence evidence, Search search, Fitter.State base) {
        this.bounded = evidence.floor() < 1;
        this.fitter = search.fitter();
        this.base = base;
    }

    /**
     * A sentence that is not weighed yet.
     *
     * @param words among which its terms were chosen
     */
    Sentence begun(Fitter.State fit, Vocabulary words) {
        List<Hypothesis> added = fit.candidate().added();
        return new Sentence(fit, added.subList(base.candidate().added().size(), added.size()), Double.NaN, Double.NaN, Double.NaN, words);
    }

    /**
     * All seen through the whitening of the one that leaves least, most evident first. Where noise is only bounded, in units of what
     * that leaves.
     */
    List<Sentence> of(List<Sentence> sentences) {
        if (sentences.isEmpty()) {
            return sentences;
        }
        Fitter.Frame frame = sentences.stream().map(Sentence::fit).min(Comparator.comparingDouble(Fitter.State::reduced)).orElseThrow()
                .frame();
        double[] left = Parallel.map(sentences, sentence -> left(sentence.fit(), frame)).stream().mapToDouble(Double::doubleValue)
                .toArray();
        double least = Arrays.stream(left).min().orElseThrow();
        double unit = bounded ? least : 1;
        double without = left(base, frame) / unit;
        return IntStream.range(0, left.length).mapToObj(i -> {
            Sentence sentence = sentences.get(i);
            return new Sentence(sentence.fit(), sentence.terms(), left[i] / unit, without, least / unit, sentence.words());
        }).sorted(Comparator.comparingDouble(Sentence::evidence).reversed()).toList();
    }

    private double left(Fitter.State fit, Fitter.Frame frame) {
        return fitter.look(fit.candidate(), fit.x(), frame).cost() / frame.whitening().degrees();
    }

    /** The most evident; there must be one. */
    Sentence best(List<Sentence> sentences) {
        return of(sentences).get(0);
    }
}
