package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.mechanism.Start;

/**
 * A hypothesis on its way through a heat.
 *
 * @param begun one fit for each start that may still win, least cost first
 */
public record Trial(Ground ground, List<Fitter.State> begun) {

    private static final double IDLE = 1e-3;

    /**
     * What hypotheses are tried on.
     *
     * @param fitter for what lies near the base
     * @param base what they stand on, fitted on all data, with its derivatives if any are known
     */
    public record Ground(Fitter fitter, Fitter.State base) {

        static Ground of(Fitter fitter, Fitter.State base) {
            return new Ground(fitter.about(base), base);
        }

        /** @param x coordinates [1], one a knob, not copied, not modified */
        Fitter.State look(Candidate candidate, double[] x) {
            return fitter.look(candidate, x, base.frame());
        }
    }

    /**
     * The most promising starts of a hypothesis, and a few steps from each; those that are far behind are dropped.
     *
     * @param from numbers of the model to start from: as fitted without the hypothesis, or better ones
     * @param most starts that are begun
     */
    static Trial begun(Ground ground, Screening.Score score, double[] from, int most) {
        Fitter.State base = ground.base();
        Candidate with = score.candidate();
        List<double[]> starts = new ArrayList<>();
        starts.add(score.x());
        for (Start start : score.hypothesis().starts()) {
            if (score.hypothesis().starts().size() <= Effort.STARTS
                    && (base.candidate().added().isEmpty() || base.reduced() > Priors.GLARING)) {
                starts.add(base.candidate().extended(base.x(), with, score.hypothesis(), start.values()));
            }
        }
        List<Fitter.State> begun = sorted(begun(ground, score, starts, from, most, Arrays.equals(from, base.x())).toList());
        return new Trial(ground, begun.stream().takeWhile(fit -> !(fit.cost() > Effort.BEHIND * begun.get(0).cost())).toList());
    }

    /** @param near whether the starts are so near to what was fitted that its derivatives lead from there */
    private static Stream<Fitter.State> begun(Ground ground, Screening.Score score, List<double[]> starts, double[] numbers, int most,
            boolean near) {
        Fitter.State base = ground.base();
        List<double[]> own = starts.stream().map(start -> Candidate.standing(start, numbers)).toList();
        double without = near ? base.cost() : ground.look(base.candidate(), numbers).cost();
        int steps = steps(score, near);
        return best(ground, score.candidate(), own, without).stream().limit(most)
                .map(first -> near ? ground.fitter().fit(score.candidate(), first.x(), base, steps, Effort.ROUGH)
                        : ground.fitter().fit(score.candidate(), first.x(), base.frame(), steps, Effort.ROUGH));
    }

    private static int steps(Screening.Score score, boolean near) {
        return score.hypothesis().runsFree() ? 1 : near ? 2 : Effort.OWN_STEPS;
    }

    /**
     * Some starts, best first. One that changes nothing, a stop that is never reached, looks best where every other start is
     * still far off, and leads nowhere: it counts only where there is no other.
     *
     * @param without cost without the hypothesis
     */
    private static List<Fitter.State> best(Ground ground, Candidate with, List<double[]> starts, double without) {
        List<Fitter.State> looks = sorted(starts.stream().map(x -> ground.look(with, x)).toList());
        List<Fitter.State> at = looks.stream().filter(look -> Math.abs(look.cost() - without) > IDLE * without && !look.failed()).toList();
        return at.isEmpty() ? looks.subList(0, 1) : at;
    }

    /**
     * The best of fits from every start, the model's own numbers as the user gave them, since those fitted without the hypothesis mean
     * nothing.
     *
     * @param gains by which the model may be stiffer, heavier and more damped all at once (logarithms): what the given one may have missed
     */
    static Trial overturning(Ground ground, Screening.Score score, double[] gains) {
        Candidate base = ground.base().candidate();
        Candidate with = score.candidate();
        List<Fitter.State> fits = new ArrayList<>();
        for (double gain : gains) {
            double[] own = base.start();
            for (int i = 0; i < own.length; i++) {
                Knob knob = base.knobs().get(i);
                own[i] = knob.unit() == 0 ? knob.within(own[i] + gain) : own[i];
            }
            for (Start start : score.hypothesis().starts()) {
                fits.add(ground.fitter().fit(with, base.extended(own, with, score.hypothesis(), start.values()), ground.base().frame(),
                        Effort.LAST_STEPS, Effort.ENOUGH));
            }
        }
        return new Trial(ground, sorted(fits).subList(0, 1));
    }

    Fitter.State first() {
        return begun.get(0);
    }

    /** Cost by number of data, priors included. */
    double cost() {
        return first().cost() / first().frame().whitening().degrees();
    }

    double excess() {
        return Refinement.excess(first().reduced());
    }

    /** More steps of each. */
    Trial onward() {
        return onward(first().candidate().last().runsFree() ? 1 : Effort.HEAT_STEPS);
    }

    Trial onward(int steps) {
        return new Trial(ground, sorted(begun.stream().map(state -> state.failed() ? state
                : ground.fitter().fit(state.candidate(), state.x(), state.frame(), steps, Effort.ROUGH)).toList()));
    }

    /** The first as it stands on other ground. */
    Fitter.State on(Ground whole) {
        return ground == whole ? first() : whole.look(first().candidate(), first().x());
    }

    /** Least cost first. A new list. */
    public static List<Fitter.State> sorted(List<Fitter.State> states) {
        List<Fitter.State> out = new ArrayList<>(states);
        out.sort(Comparator.comparingDouble(Fitter.State::cost));
        return out;
    }
}
