package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;

/** Hypotheses race for the best fit, in heats: a few steps for all that are on the shortlist, the whole way for those that lead then. */
final class Heats {

    private static final Comparator<Trial> LEAST = Comparator.comparingDouble(Trial::cost);
    private static final double[] GAINS = {0, 0.8, -0.8};

    private final Evidence evidence;
    private final Refinement refinement;
    private final Fitter fitter;

    Heats(Evidence evidence, Refinement refinement, Fitter fitter) {
        this.evidence = evidence;
        this.refinement = refinement;
        this.fitter = fitter;
    }

    /**
     * Refits, in two heats: a few steps for all, the whole way for those that lead then. The heats make the answer independent of how many
     * hypotheses run at a time.
     *
     * @param base   the fit on top of which the hypotheses stand
     * @param scores greatest first
     * @param where what is known of where the mismatch enters
     * @return fits that did not fail, least cost first, all in the same whitening
     */
    List<Fitter.State> refit(Fitter.State base, List<Screening.Score> scores, Whereabouts where) {
        // Where the first mechanism leaves much, the second is as large as any first.
        boolean second = !base.candidate().added().isEmpty() && base.reduced() < Priors.GLARING;
        List<Screening.Score> chosen = new Shortlist(evidence).of(base, scores, second);
        boolean bent = Refinement.bent(base);
        Function<Hypothesis, double[]> from = from(base, where, bent);
        Trial.Ground whole = Trial.Ground.of(fitter, base);
        Trial.Ground brief = where.inPart() ? refinement.brief(base).orElse(whole) : whole;
        List<Trial> heat = begun(whole, brief, chosen.stream().filter(score -> !score.hypothesis().runsFree()).toList(), from);
        boolean promising = !heat.isEmpty() && heat.get(0).excess() < Priors.UNLISTED * Refinement.excess(base.reduced());
        if (promising) {
            goOn(base, heat);
        }
        if (!promising || !clean(base, heat.get(0))) {
            heat.addAll(begun(whole, brief, chosen.stream().filter(score -> score.hypothesis().runsFree()).toList(), from));
            goOn(base, heat);
        }
        int finalists = near(heat, second ? Effort.FINALISTS / 2 : Effort.FINALISTS);
        finalists = withPromising(heat, finalists, Screening.alike(chosen));
        List<Fitter.State> all = new ArrayList<>(Parallel.map(heat.subList(0, finalists),
                trial -> Trial.sorted(Parallel.map(trial.begun(), begun -> refinement.finish(begun, base))).get(0)));
        all.addAll(Parallel.map(rest(heat, finalists), trial -> trial.on(whole)));
        return Trial.sorted(all).stream().filter(fit -> !fit.failed()).toList();
    }

    /**
     * How many are finalists with those that promised to first order nearly as much as the first, wherever they stand: a drift has farther
     * to go than a step at the best of sixty moments, and after as many steps stands behind that.
     *
     * @param heat least cost first; on return they follow the finalists there
     */
    private static int withPromising(List<Trial> heat, int finalists, List<Screening.Score> promising) {
        int all = finalists;
        for (int i = finalists; i < heat.size(); i++) {
            Hypothesis own = heat.get(i).first().candidate().last();
            if (promising.stream().anyMatch(score -> score.hypothesis().equals(own))) {
                heat.add(all++, heat.remove(i));
            }
        }
        return all;
    }

    /** Numbers of the model to start from: as fitted, or where these are bent as they fit beside whatever enters there. */
    private static Function<Hypothesis, double[]> from(Fitter.State base, Whereabouts where, boolean bent) {
        return h -> bent ? where.unbent(h).orElseGet(base.candidate()::start) : base.x();
    }

    /**
     * How many starts of a hypothesis are begun. Between two delays at which a force agrees with what is missing lies one at which it
     * opposes it, which no step passes; nor does one along a driven link pass from friction of one kind to another.
     */
    private int begun(Hypothesis hypothesis) {
        return hypothesis.isLate() || evidence.model().driven() ? Integer.MAX_VALUE : 1;
    }

    /** The first steps of each, least cost first. */
    private List<Trial> begun(Trial.Ground whole, Trial.Ground brief, List<Screening.Score> scores,
            Function<Hypothesis, double[]> from) {
        double[] gains = evidence.model().inputs().isEmpty() ? new double[] {0} : GAINS;
        List<Trial> out = new ArrayList<>(Parallel.map(scores, score -> {
            Trial.Ground ground = score.hypothesis().byTheClock() ? whole : brief;
            return score.hypothesis().overturns() ? Trial.overturning(ground, score, gains)
                    : Trial.begun(ground, score, from.apply(score.hypothesis()), begun(score.hypothesis()));
        }));
        out.sort(LEAST);
        return out;
    }

    /**
     * More steps of those that may win yet.
     *
     * @param heat in any order; least cost first on return
     */
    private static void goOn(Fitter.State base, List<Trial> heat) {
        if (heat.isEmpty()) {
            return;
        }
        heat.sort(LEAST);
        // No leader yet: look farther down.
        int most = heat.get(0).excess() < Priors.UNLISTED * Refinement.excess(base.reduced()) ? Effort.CONTENDERS : 2 * Effort.CONTENDERS;
        List<Trial> near = heat.subList(0, near(heat, most));
        List<Trial> further = Parallel.map(near, Trial::onward);
        for (int i = 0; i < further.size(); i++) {
            heat.set(i, further.get(i));
        }
        heat.sort(LEAST);
    }

    /** How many of the first in a heat are near enough to the leader to win yet: the rest are left where they stand. */
    private static int near(List<Trial> heat, int most) {
        double reach = heat.isEmpty() ? 0 : Effort.HOPELESS * heat.get(0).excess();
        int near = (int) heat.stream().takeWhile(trial -> trial.excess() <= reach).count();
        return Math.min(Math.min(most, heat.size()), Math.max(Effort.SECONDS, near));
    }

    /**
     * Those behind the finalists that are not given up, and if all of these have the leader's name the first by another: how far behind
     * that is says what the name is worth. The others are no rivals, wherever they would stand on all data.
     *
     * @param heat least cost first
     */
    private static List<Trial> rest(List<Trial> heat, int finalists) {
        int open = Math.max(finalists, near(heat, heat.size()));
        List<Trial> out = new ArrayList<>(heat.subList(finalists, open));
        Predicate<Trial> other = trial -> !claim(trial).equals(claim(heat.get(0)));
        if (heat.subList(0, open).stream().noneMatch(other)) {
            heat.stream().filter(other).findFirst().ifPresent(out::add);
        }
        return out;
    }

    private static String claim(Trial trial) {
        return trial.first().candidate().last().claim();
    }

    /** Whether a linear hypothesis leaves nothing of a mismatch so plain that no distortion by a law could be taken for it. */
    private static boolean clean(Fitter.State base, Trial linear) {
        return base.reduced() > Priors.GLARING && linear.first().reduced() < Priors.SILENT;
    }
}
