package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import wbv.body.Simulator;

/** Refits the hypotheses that the screening ranked first, every law by free run, and orders them by what they really explain. */
final class Refinement {

    private static final int LINEAR = 12;
    private static final int LAWS = 10;
    private static final double LEAST_GAIN = 8;
    private static final double DISTORTED = 0.35;
    private static final double[] SHIFTS = {-1.5, -0.8, -0.4, -0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.5};
    private static final Set<String> ALWAYS = Set.of("mode.hidden", "memory.viscoelastic", "sensor.delay", "sensor.mount");
    private static final int FINALISTS = 6;
    private static final int FIRST_STEPS = 1;
    private static final double HOPELESS = 10;
    private static final int RIVALS = 2;
    private static final double PLAIN = 10;
    private static final double PLAIN_IN_PART = 3;
    private static final double CLEAN = 1.1;
    private static final Comparator<Trial> LEAST = Comparator.comparingDouble(Trial::cost);
    private static final int FIRST_LINEAR_STEPS = 2;
    private static final int OWN_LINEAR_STEPS = 4;
    private static final int MORE_LINEAR_STEPS = 8;
    /** What no law's form leaves: then something else is missing too. */
    static final double MUCH = 12;
    private static final double PROMISING = 0.3;
    private static final int GOING_ON = 16;
    private static final double BEHIND = 3;
    private static final double IDLE = 1e-3;
    private static final int OVERTURNING_STEPS = 25;
    private static final double[] GAINS = {0, 0.8, -0.8};
    private static final int MOST_STARTS = 9;

    private final Evidence evidence;
    private final Fitter fitter;

    Refinement(Evidence evidence) {
        this.evidence = evidence;
        this.fitter = new Fitter(evidence);
    }

    /**
     * Refits, in two heats: a few steps for all, the whole way for those that lead then. The heats make the answer independent of how many
     * hypotheses run at a time.
     *
     * @param base   the fit on top of which the hypotheses stand
     * @param scores greatest first
     * @return fits, least cost first, all in the same whitening
     */
    List<Fitter.State> refit(Fitter.State base, List<Screening.Score> scores) {
        // Where the first mechanism leaves much, the second is as large as any first.
        boolean second = !base.candidate().added().isEmpty() && base.reduced() < MUCH;
        // A refit that went far to absorb the effect is a bad place to start from: try the user's own values too.
        boolean distorted = false;
        for (int i = 0; i < base.x().length; i++) {
            distorted |= base.candidate().knobs().get(i).deviation() > 1 && Math.abs(base.x()[i]) > DISTORTED;
        }
        boolean both = distorted;
        String carrying = second ? "" : carryingLink(base);
        List<Screening.Score> chosen = choose(scores, second, carrying);
        Ground whole = new Ground(fitter, base);
        Ground brief = brief(base).orElse(whole);
        List<Trial> heat = begun(whole, brief, chosen.stream().filter(score -> !score.hypothesis().runsFree()).toList(), both);
        boolean promising = !heat.isEmpty() && heat.get(0).excess() < PROMISING * excess(base);
        if (promising) {
            goOn(base, heat);
        }
        if (!promising || !clean(base, heat.get(0))) {
            heat.addAll(begun(whole, brief, chosen.stream().filter(score -> score.hypothesis().runsFree()).toList(), both));
            goOn(base, heat);
        }
        int finalists = near(heat, second ? FINALISTS / 2 : FINALISTS);
        List<Fitter.State> all = new ArrayList<>(heat.subList(0, finalists).parallelStream()
                .map(trial -> sorted(trial.begun().stream().map(begun -> finish(begun, base)).toList()).get(0)).toList());
        all.addAll(heat.subList(finalists, heat.size()).parallelStream().map(trial -> trial.onWhole(whole)).toList());
        return sorted(all);
    }

    /** What hypotheses are tried on. @param base what they stand on, fitted on all data */
    private record Ground(Fitter fitter, Fitter.State base) { }

    /** A hypothesis on its way. @param begun one fit for each start that may still win, least cost first */
    private record Trial(Ground ground, List<Fitter.State> begun) {

        Fitter.State first() {
            return begun.get(0);
        }

        /** Cost by number of data, priors included. */
        double cost() {
            return first().cost() / first().frame().whitening().degrees();
        }

        double excess() {
            return Refinement.excess(first());
        }

        Trial onward() {
            return new Trial(ground, sorted(begun.stream().map(this::onward).toList()));
        }

        private Fitter.State onward(Fitter.State state) {
            int steps = state.candidate().last().runsFree() ? 1 : MORE_LINEAR_STEPS;
            return state.failed() ? state : ground.fitter().fit(state.candidate(), state.x(), state.frame(), steps, 2e-3);
        }

        Fitter.State onWhole(Ground whole) {
            return ground == whole ? first() : whole.fitter().look(first().candidate(), first().x(), whole.base().frame());
        }
    }

    /** A part of the data that is enough to tell which hypotheses are worth the whole; empty where it may not be. */
    private Optional<Ground> brief(Fitter.State base) {
        if (base.reduced() < PLAIN_IN_PART || base.candidate().added().stream().anyMatch(Hypothesis::byTheClock)) {
            return Optional.empty();
        }
        return evidence.brief().map(part -> {
            Fitter own = new Fitter(part);
            return new Ground(own, own.look(base.candidate(), base.x(), own.frame(base.candidate(), base.x(), part.fit())));
        });
    }

    /** The first steps of each, least cost first. */
    private List<Trial> begun(Ground whole, Ground brief, List<Screening.Score> scores, boolean both) {
        return new ArrayList<>(scores.parallelStream().map(score -> {
            Ground ground = score.hypothesis().byTheClock() ? whole : brief;
            return new Trial(ground, score.hypothesis().overturns() ? List.of(overturn(ground, score)) : begin(ground, score, both));
        }).sorted(LEAST).toList());
    }

    /** More steps of those that may win yet. @param heat in any order; least cost first on return */
    private static void goOn(Fitter.State base, List<Trial> heat) {
        heat.sort(LEAST);
        int most = heat.get(0).excess() < PROMISING * excess(base) ? GOING_ON : 2 * GOING_ON;   // no leader yet: look farther down
        List<Trial> near = heat.subList(0, near(heat, most));
        List<Trial> further = near.parallelStream().map(Trial::onward).toList();
        for (int i = 0; i < further.size(); i++) {
            heat.set(i, further.get(i));
        }
        heat.sort(LEAST);
    }

    /** How many of the first in a heat are near enough to the leader to win yet: the rest are left where they stand. */
    private static int near(List<Trial> heat, int most) {
        double reach = heat.isEmpty() ? 0 : HOPELESS * heat.get(0).excess();
        int near = (int) heat.stream().takeWhile(trial -> trial.excess() <= reach).count();
        return Math.min(Math.min(most, heat.size()), Math.max(RIVALS, near));
    }

    private static double excess(Fitter.State state) {
        return excess(state.reduced());
    }

    /** What is left beyond the noise; half of it at least, so that fits near the noise are alike. */
    static double excess(double reduced) {
        return Math.max(reduced - 1, 0.5);
    }

    /** Whether a linear hypothesis leaves nothing of a mismatch so plain that no distortion by a law could be taken for it. */
    private static boolean clean(Fitter.State base, Trial linear) {
        return base.reduced() > PLAIN && linear.first().reduced() < CLEAN;
    }

    private static List<Fitter.State> sorted(List<Fitter.State> states) {
        List<Fitter.State> out = new ArrayList<>(states);
        out.sort(Comparator.comparingDouble(Fitter.State::cost));
        return out;
    }

    /** The link in which an arbitrary force would explain most; empty with a single output, where each would explain all. */
    private String carryingLink(Fitter.State base) {
        if (evidence.outputs().size() < 2 || evidence.onRig()) {
            return "";
        }
        Simulator.Linearised linear = new Simulator(evidence.excitation()).linearised(base.candidate().at(base.x()));
        return IntStream.range(0, evidence.model().links().size()).boxed()
                .min(Comparator.comparingDouble(l -> BodyForce.left(evidence, base, linear.ofLinkForce(l))))
                .map(l -> evidence.model().links().get(l).name()).orElseThrow();
    }

    /**
     * The best linear hypotheses and the best laws, and those whose effect a first-order look may miss: such as every kind of law in the
     * link that carries the mismatch, since a refit that went far turns the sign of what is seen to first order.
     */
    private static List<Screening.Score> choose(List<Screening.Score> scores, boolean second, String carrying) {
        int mostLaws = second ? LAWS / 2 : LAWS;
        int mostLinear = second ? LINEAR / 2 : LINEAR;
        List<Screening.Score> chosen = new ArrayList<>();
        int linear = 0;
        int laws = 0;
        Set<String> kinds = new HashSet<>();
        for (Screening.Score score : scores) {
            boolean law = score.hypothesis().runsFree();
            boolean first = law && score.hypothesis().where().equals(carrying) && kinds.add(score.hypothesis().mechanism());
            if (first || !second && (score.hypothesis().overturns() || ALWAYS.contains(score.hypothesis().mechanism()))
                    || score.gain() > LEAST_GAIN && (law ? laws++ < mostLaws : linear++ < mostLinear)) {
                chosen.add(score);
            }
        }
        return chosen;
    }

    /**
     * The most promising starts of a hypothesis, and a few steps from each: from the model as fitted without it and, where that went
     * far, from the user's own values. Least cost first; one that is far behind is dropped.
     */
    private static List<Fitter.State> begin(Ground ground, Screening.Score score, boolean both) {
        Fitter.State base = ground.base();
        Candidate with = score.candidate();
        List<double[]> starts = new ArrayList<>();
        starts.add(score.x().clone());
        for (Hypothesis.Start start : score.hypothesis().starts()) {
            if (score.hypothesis().starts().size() <= MOST_STARTS && (base.candidate().added().isEmpty() || base.reduced() > MUCH)) {
                starts.add(base.candidate().extended(base.x(), with, score.hypothesis(), start.values()));
            }
        }
        int steps = score.hypothesis().runsFree() ? FIRST_STEPS : FIRST_LINEAR_STEPS;
        List<Fitter.State> begun = new ArrayList<>(List.of(best(ground, with, starts, base.cost(), steps)));
        if (both) {
            for (double[] start : starts) {
                System.arraycopy(base.candidate().start(), 0, start, 0, base.x().length);
            }
            double without = ground.fitter().look(base.candidate(), base.candidate().start(), base.frame()).cost();
            begun.add(best(ground, with, starts, without, score.hypothesis().runsFree() ? FIRST_STEPS : OWN_LINEAR_STEPS));
        }
        List<Fitter.State> out = sorted(begun);
        return out.size() > 1 && out.get(1).cost() > BEHIND * out.get(0).cost() ? out.subList(0, 1) : out;
    }

    /**
     * A few steps from the best of some starts. One that changes nothing, a stop that is never reached, looks best where every other start is
     * still far off, and leads nowhere: it counts only where there is no other.
     *
     * @param without cost without the hypothesis
     */
    private static Fitter.State best(Ground ground, Candidate with, List<double[]> starts, double without, int steps) {
        Fitter.Frame frame = ground.base().frame();
        List<Fitter.State> looks = sorted(starts.stream().map(x -> ground.fitter().look(with, x, frame)).toList());
        Fitter.State first = looks.stream().filter(look -> Math.abs(look.cost() - without) > IDLE * without && !look.failed()).findFirst()
                .orElse(looks.get(0));
        return ground.fitter().fit(with, first.x(), frame, steps, 2e-3);
    }

    /**
     * The best of fits from every start, the model's own numbers as the user gave them, since those fitted without the hypothesis mean nothing.
     * Where forces push it, also a model that is stiffer, heavier and more damped all at once, or less: a gain that the given one may have missed.
     */
    private Fitter.State overturn(Ground ground, Screening.Score score) {
        Candidate base = ground.base().candidate();
        Candidate with = score.candidate();
        List<Fitter.State> fits = new ArrayList<>();
        for (double gain : evidence.model().inputs().isEmpty() ? new double[] {0} : GAINS) {
            double[] own = base.start();
            for (int i = 0; i < own.length; i++) {
                Knob knob = base.knobs().get(i);
                own[i] = knob.unit() == 0 ? Math.max(knob.low(), Math.min(knob.high(), own[i] + gain)) : own[i];
            }
            for (Hypothesis.Start start : score.hypothesis().starts()) {
                fits.add(ground.fitter().fit(with, base.extended(own, with, score.hypothesis(), start.values()), ground.base().frame(),
                        OVERTURNING_STEPS, 1e-3));
            }
        }
        return sorted(fits).get(0);
    }

    private Fitter.State finish(Fitter.State begun, Fitter.State base) {
        return timed(fitter.fit(begun.candidate(), begun.x(), base.frame(), 6, 2e-3), 1);
    }

    /** A moment is not found by slopes: steps of it are tried, and the rest refitted, until none helps. */
    private Fitter.State timed(Fitter.State fit, int rounds) {
        Fitter.State best = fit;
        for (int i = 0; i < best.candidate().knobs().size(); i++) {
            if (!best.candidate().knobs().get(i).name().endsWith("time_s") || best.failed()) {
                continue;
            }
            for (int round = 0; round < rounds; round++) {
                Fitter.State start = best;
                for (double shift : SHIFTS) {
                    double[] x = start.x().clone();
                    x[i] = start.candidate().knobs().get(i).coordinate(start.candidate().knobs().get(i).value(x[i]) + shift);
                    Fitter.State look = fitter.look(start.candidate(), x, start.frame());
                    best = look.cost() < best.cost() ? look : best;
                }
                if (best == start) {
                    break;
                }
                Fitter.State again = fitter.fit(best.candidate(), best.x(), best.frame(), 5, 1e-3);
                best = again.cost() < best.cost() ? again : best;
            }
        }
        return best;
    }

    /** A leader fitted to the end, in the whitening of its own model. */
    Fitter.State polish(Fitter.State fit) {
        return polish(fit.candidate(), fit.x());
    }

    /** The same from coordinates at which nothing was simulated yet. */
    Fitter.State polish(Candidate candidate, double[] x) {
        Fitter.State once = polishedOnce(candidate, x);
        return polishedOnce(candidate, once.x());
    }

    private Fitter.State polishedOnce(Candidate candidate, double[] x) {
        return timed(fitter.fit(candidate, x, fitter.frame(candidate, x, evidence.fit()), 15, 3e-4), 4);
    }

    /** χ² per number on the held-out window. */
    double heldOut(Fitter.State fit) {
        Fitter whole = new Fitter(evidence, evidence.whole());
        return whole.look(fit.candidate(), fit.x(), whole.frame(fit.candidate(), fit.x(), evidence.heldOut())).reduced();
    }
}
