package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import wbv.body.Assembly;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.fit.SpectralLines;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Scene;

/**
 * The search for one mechanism on some evidence: screen every hypothesis at every place, refit the best by free run, and weigh what fits
 * alike.
 */
public final class Search {

    private final Evidence evidence;
    private final Refinement refinement;
    private final Fitter fitter;
    private final BiConsumer<String, Double> progress;

    /**
     * On this evidence, with its library of mechanisms.
     *
     * @param progress told the step and the share of it that is done
     */
    public Search(Evidence evidence, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.refinement = new Refinement(evidence);
        this.fitter = new Fitter(evidence);
        this.progress = progress;
    }

    /** What refits hypotheses on this evidence. */
    public Refinement refinement() {
        return refinement;
    }

    /** What fits models to this evidence. */
    public Fitter fitter() {
        return fitter;
    }

    /**
     * The user's model with no physics added, fitted from every start. With its derivatives.
     *
     * @param baseline of the evidence, see {@link Baseline}
     */
    public Fitter.State base(Candidate baseline) {
        return evidence.known().once(new Fitted(baseline), () -> fromAll(baseline));
    }

    private record Fitted(Candidate baseline) implements Known.Question<Fitter.State> {}

    private Fitter.State fromAll(Candidate baseline) {
        return Parallel.map(Baseline.starts(evidence, baseline), start -> base(baseline, start)).stream()
                .min(Comparator.comparingDouble(Fitter.State::reduced)).orElseThrow();
    }

    /**
     * The same from one start.
     *
     * @param start coordinates [1], one a knob. Not modified.
     */
    public Fitter.State base(Candidate baseline, double[] start) {
        double[] x = start;
        double left = Double.POSITIVE_INFINITY;
        boolean settled = false;
        for (int round = 0; round < Effort.ROUNDS || !settled && round < Effort.STEPS; round++) {
            Fitter.State fit = fitter.fit(baseline, x, fitter.frame(baseline, x, evidence.fit()), Effort.OWN_STEPS, Effort.EXACT);
            settled = !(fit.reduced() < (1 - Effort.ROUGH) * left);
            left = fit.reduced();
            x = fit.x();
        }
        return sloped(baseline, x);
    }

    /** A fit in its own frame, with its derivatives. */
    Fitter.State sloped(Candidate candidate, double[] x) {
        return fitter.lookWithSlopes(candidate, x, fitter.frame(candidate, x, evidence.fit()));
    }

    /**
     * Refitted hypotheses on top of a fit, least cost per number first.
     *
     * @param base with its derivatives
     * @param polished how many of the first are fitted to the end
     * @param where which hypotheses to try
     */
    public List<Fitter.State> leaders(Fitter.State base, int polished, Whereabouts where) {
        List<Fitter.State> measured = base.reduced() > Priors.GLARING ? alongMeasured(base, polished, where) : List.of();
        return measured.stream().anyMatch(fit -> fit.reduced() < Math.max(where.reach(), Refinement.form(base))) ? measured
                : both(measured, leaders(base, polished, where, score -> true));
    }

    /** The same as they race from where the measured motion has them: of a mismatch so plain that this shows more than noise. */
    private List<Fitter.State> alongMeasured(Fitter.State base, int polished, Whereabouts where) {
        progress.accept("refitting", 0.3);
        Motion motion = Motion.measured(evidence, base.candidate().at(base.x()));
        List<Hypothesis> all = evidence.library().hypotheses(scene(base, motion, where));
        return withForms(base, all, new MeasuredHeats(evidence, base, motion, open(base, all, where)).best(polished));
    }

    /** Those that may be added where they may act: in no form twice at one place. */
    private static List<Hypothesis> open(Fitter.State base, List<Hypothesis> all, Whereabouts where) {
        Set<String> used = base.candidate().added().stream().map(Hypothesis::claim).collect(Collectors.toSet());
        return all.stream().filter(h -> !used.contains(h.claim())).filter(where::likely).toList();
    }

    /**
     * The same of hypotheses that promise something to first order.
     *
     * @param least gain [1], see {@link Screening.Score}
     */
    public List<Fitter.State> leaders(Fitter.State base, int polished, Whereabouts where, double least) {
        return leaders(base, polished, where, score -> score.gain() > least);
    }

    /**
     * The same of linear hypotheses anywhere that promise to explain a part of the mismatch to first order; where the best of them explains
     * nearly all, with those that do so at its place from where the measured motion has them: as a bent model moves, one shows less than
     * what imitates it.
     *
     * @param part 0 to 1
     */
    public List<Fitter.State> linear(Fitter.State base, int polished, double part) {
        double least = part * (base.square() - base.frame().whitening().degrees());
        Whereabouts anywhere = Whereabouts.anywhere(evidence, base.candidate()).only(hypothesis -> !hypothesis.runsFree());
        List<Fitter.State> fits = leaders(base, polished, anywhere, score -> score.gain() > least);
        return fits.isEmpty() || !Refinement.explainsNearlyAll(base, fits.get(0)) ? fits
                : both(fits, alongMeasured(base, polished,
                        anywhere.only(each -> Place.plain(each, base.candidate()).equals(Place.ofLast(fits.get(0))))));
    }

    /** All of them, least first. */
    private static List<Fitter.State> both(List<Fitter.State> some, List<Fitter.State> others) {
        return Stream.concat(some.stream(), others.stream()).sorted(Comparator.comparingDouble(Fitter.State::reduced)).toList();
    }

    private List<Fitter.State> leaders(Fitter.State base, int polished, Whereabouts where, Predicate<Screening.Score> open) {
        progress.accept("screening", 0.2);
        Motion motion = Motion.measured(evidence, base.candidate().at(base.x()));
        List<Hypothesis> all = evidence.library().hypotheses(scene(base, motion, where));
        List<Screening.Score> scores = new Screening(evidence, base, motion).scores(open(base, all, where)).stream().filter(open)
                .toList();
        progress.accept("refitting", 0.4);
        List<Fitter.State> fits = new Heats(evidence, refinement, fitter).refit(base, scores, where);
        // A rival far behind does not come up by polishing, but for what promised most and has not got there yet.
        double reach = fits.isEmpty() ? 0 : 1 + Effort.HOPELESS * Refinement.excess(fits.get(0).reduced());
        List<Fitter.State> ahead = fits.stream().limit(polished).filter(fit -> fit.reduced() <= reach).toList();
        List<Screening.Score> promising = Screening.alike(scores);
        List<Fitter.State> chosen = fits.stream()
                .filter(fit -> ahead.contains(fit) || promising.stream().anyMatch(score -> score.promisesMore(base, fit))).toList();
        List<Fitter.State> out = new ArrayList<>(Parallel.map(chosen, refinement::polishFromBoth));
        fits.stream().filter(fit -> !chosen.contains(fit)).forEach(out::add);
        return withForms(base, all, out);
    }

    /** Fits with rivals of the first of them in other forms, least first. */
    private List<Fitter.State> withForms(Fitter.State base, List<Hypothesis> all, List<Fitter.State> fits) {
        List<Fitter.State> out = new ArrayList<>(fits);
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        if (!out.isEmpty()) {
            double near = 1 + Effort.BEHIND * Refinement.excess(out.get(0).reduced());
            List<Fitter.State> first = out.stream().limit(Effort.LEADERS).filter(fit -> fit.reduced() < near).toList();
            Yielding yielding = new Yielding(refinement, all, base);
            FurtherForm further = new FurtherForm(refinement, base, all);
            Stream.<Function<Fitter.State, List<Fitter.State>>>of(yielding::rivals, further::rivals)
                    .forEach(rivals -> first.stream().map(rivals).filter(some -> !some.isEmpty()).findFirst().ifPresent(out::addAll));
            out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        }
        return out;
    }

    /**
     * Fits on top of a base seen again through other noise, least first: the best few fitted, the first of them in its further form too if
     * that pays now, the others looked at.
     *
     * @param base seen through that noise
     */
    public List<Fitter.State> again(Fitter.State base, List<Fitter.State> fits) {
        int leading = Math.min(Effort.LEADERS, fits.size());
        List<Fitter.State> out = new ArrayList<>(Parallel.map(fits.subList(0, leading), refinement::polish));
        fits.subList(leading, fits.size()).forEach(fit -> out.add(fitter.look(fit.candidate(), fit.x(), base.frame())));
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        FurtherForm further = new FurtherForm(refinement, base, hypotheses(base));
        return both(out, out.stream().limit(1).flatMap(first -> further.rivals(first).stream()).toList());
    }

    /** Those of the library at a fit. */
    public List<Hypothesis> hypotheses(Fitter.State base) {
        return evidence.known().once(new On(base), () -> {
            Assembly fitted = base.candidate().at(base.x());
            return evidence.library().hypotheses(FittedScene.of(evidence, fitted, Motion.measured(evidence, fitted),
                    SpectralLines.of(base.residual(), evidence.fit())));
        });
    }

    private record On(Fitter.State base) implements Known.Question<List<Hypothesis>> {}

    /** Those of them that may act at some places, by their plain names. */
    List<Hypothesis> hypotheses(Fitter.State base, Predicate<Place> places) {
        return hypotheses(base).stream().filter(each -> places.test(Place.plain(each, base.candidate()))).toList();
    }

    /**
     * What fits best beside a model that is nearly right, racing along the motion as measured; empty where that stands at a bound that
     * nothing real has.
     *
     * @param x coordinates [1], one a knob. Not modified.
     */
    Optional<Fitter.State> racedAsMeasured(Candidate on, double[] x, List<Hypothesis> open) {
        return new MeasuredHeats(evidence, sloped(on, x), Motion.measured(evidence, on.at(x)), open).first();
    }

    /** The same racing as the model moves, in some frame. */
    Optional<Fitter.State> racedAsMoved(Candidate on, double[] x, Fitter.Frame frame, List<Hypothesis> open) {
        return new MeasuredHeats(evidence, fitter.lookWithSlopes(on, x, frame), Motion.simulated(evidence, on.at(x)), open).first();
    }

    /** What sizes of hypotheses go by: how the model moves, as it would beside what is missing where that has bent it far. */
    private Scene scene(Fitter.State base, Motion motion, Whereabouts where) {
        double[] lines = SpectralLines.of(base.residual(), evidence.fit());
        Optional<Assembly> unbent = Refinement.bent(base) ? where.unbent().map(base.candidate()::at) : Optional.empty();
        return unbent.map(it -> FittedScene.of(evidence, it, Motion.measured(evidence, it), lines))
                .orElseGet(() -> FittedScene.of(evidence, base.candidate().at(base.x()), motion, lines));
    }

    /** The best hypothesis on top of a fit that does not stand at a bound that nothing real has; empty where there is none. */
    public Optional<Fitter.State> best(Fitter.State base, Whereabouts where) {
        return leaders(fitter.lookWithSlopes(base.candidate(), base.x(), base.frame()), 1, where).stream()
                .filter(fit -> !Refinement.extreme(fit)).findFirst();
    }
}
