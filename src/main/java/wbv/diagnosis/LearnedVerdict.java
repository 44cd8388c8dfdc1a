package wbv.diagnosis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import wbv.body.law.Learned;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.learn.LearnedWords;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.Refinement;

/**
 * The diagnosis where the best fit holds a law that was learned: all that is missing, or what a named law does beside its library's form.
 */
final class LearnedVerdict {

    private final Fits fits;
    private final Evidence evidence;
    private final Fitter.State best;
    private final double heldBefore;
    private final Refinement refinement;
    private final Presentation shown;
    private final VerdictWords words;

    /** @param heldBefore what the fitted model without anything found leaves on data not used */
    LearnedVerdict(Fits fits, double heldBefore, Refinement refinement) {
        this.fits = fits;
        this.evidence = fits.evidence();
        this.best = fits.best();
        this.heldBefore = heldBefore;
        this.refinement = refinement;
        this.shown = new Presentation(fits, heldBefore, refinement);
        this.words = new VerdictWords(fits, heldBefore, shown.scale());
    }

    /**
     * The diagnosis where the best fit holds a law that was learned.
     *
     * @param refused what was said without it
     * @param rivals other laws
     * @param probability of this one against them
     */
    Diagnosed learned(Diagnosis refused, List<Diagnosis.LearnedLaw.Rival> rivals, double probability) {
        Values values = new Values(evidence, best);
        String where = best.candidate().last().where();
        Map<String, Double> numbers = new LinkedHashMap<>();
        Map<String, Interval> intervals = new LinkedHashMap<>();
        for (Hypothesis term : best.candidate().added()) {
            Diagnosis.Named named = values.named(term, probability);
            named.parameters().forEach((key, value) -> numbers.put(distinct(key, term), value));
            named.intervals().forEach((key, value) -> intervals.put(distinct(key, term), value));
        }
        List<Diagnosis.Named> missing = new ArrayList<>(new PlainFaults(evidence).in(fits.base(), best));
        missing.add(new Diagnosis.Named(Learned.MECHANISM, where, probability, numbers, intervals, values.fit().reduced()));
        return shown.of(values.fit(), values.scale(), model -> {
            LearnedWords law = new LearnedWords(model, where);
            return new Diagnosis(Diagnosis.Verdict.LEARNED_LAW, String.format(Locale.ROOT,
                    "Something is missing in the link %s that is not in the library. Its law was learned: %s. %s of what was missing on "
                            + "data not used went with it.%s",
                    where, law.formula(), Phrases.percent(gone(heldBefore)), words.resembling(refused.missing())),
                    new Mismatch(evidence, fits.base()).located(), missing,
                    Stream.concat(refused.missing().stream(),
                            refused.verdict() == Diagnosis.Verdict.MISSING_PHYSICS ? refused.alternatives().stream() : Stream.empty())
                            .filter(name -> missing.stream().noneMatch(own -> own.mechanism().equals(name.mechanism())))
                            .map(name -> name.at(Math.min(name.probability(), 1 - probability))).toList(),
                    law.experiment(), shown.figures(values.fit()), refused.latent(), model,
                    Optional.of(new Diagnosis.LearnedLaw(where, law.formula(), law.terms(), rivals)));
        });
    }

    /**
     * The diagnosis of mechanisms one of which has another form than the library's: what it does beside that was learned, and stands beside
     * its name. Empty where it takes nothing that shows of what the name leaves on data not used: then the name says all.
     *
     * @param named what was said without it
     * @param held what it leaves on data not used without it
     * @param rivals other corrections
     */
    Optional<Diagnosed> corrected(Diagnosis named, double held, List<Diagnosis.LearnedLaw.Rival> rivals) {
        return gone(held) < VerdictWords.LEAST_SHOWN ? Optional.empty() : Optional.of(beside(named, held, rivals));
    }

    private Diagnosed beside(Diagnosis named, double held, List<Diagnosis.LearnedLaw.Rival> rivals) {
        Values values = new Values(evidence, best);
        String where = best.candidate().last().where();
        List<Diagnosis.Named> missing = named.missing().stream().map(one -> best.candidate().added().stream()
                .filter(part -> part.mechanism().equals(one.mechanism()) && part.where().equals(one.where())).findFirst()
                .map(part -> values.named(part, one.probability()).with(one.numbers())).orElse(one)).toList();
        List<Diagnosis.Named> alternatives = named.alternatives().stream().map(this::seen).toList();
        return shown.of(values.fit(), values.scale(), model -> {
            LearnedWords law = new LearnedWords(model, where);
            return new Diagnosis(named.verdict(),
                    words.sentence(named.verdict(), missing, alternatives,
                            words.ending(Refinement.explained(fits.base(), best), missing.get(0).numbers(), alternatives), false)
                            + String.format(Locale.ROOT,
                                    " In %s it has not quite the library's form: %s beside it takes %s of what it leaves on data not used.",
                                    where, law.formula(), Phrases.percent(gone(held))),
                    named.located(), missing, alternatives, named.nextExperiment(), shown.figures(values.fit()), named.latent(),
                    model, Optional.of(new Diagnosis.LearnedLaw(where, law.formula(), law.terms(), rivals)));
        });
    }

    /** A rival as the form is seen: beside the outputs' noise, where it may have been weighed beside that of the input too. */
    private Diagnosis.Named seen(Diagnosis.Named rival) {
        return fits.leaders().stream().filter(fit -> fit.candidate().added().size() == 1
                && fit.candidate().last().mechanism().equals(rival.mechanism()) && fit.candidate().last().where().equals(rival.where()))
                .mapToDouble(Fitter.State::reduced).min().stream().mapToObj(rival::leaving).findFirst().orElse(rival);
    }

    /** Part of what was left on data not used that goes with the best: of what is beyond noise. */
    private double gone(double held) {
        return Math.max(0, Math.min(1, (held - refinement.heldOut(fits.best())) / (held - evidence.floor())));
    }

    /** A number of a term by a key of its own, where several terms have one like it. */
    private static String distinct(String key, Hypothesis term) {
        return key.contains(" of ") ? key : key + " of " + term.form();
    }
}
