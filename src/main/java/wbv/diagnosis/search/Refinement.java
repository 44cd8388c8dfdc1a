package wbv.diagnosis.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Entering;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Knob;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.mechanism.Hypothesis;

/** Refits the hypotheses that the screening ranked first, every law by free run, and orders them by what they really explain. */
public final class Refinement {

    /**
     * Below this much of the noise nothing is missing that a recording could show: of 107 recordings in which nothing was concealed, with
     * sensors and sitters as they are, the fits leave 1.02 with a standard deviation of 0.03 (rig) to 0.05 (road) and never more than 1.13,
     * on either window.
     */
    public static final double SILENT = 1.2;
    /** What is more cannot be the noise by any chance. */
    public static final double STRANGE = 3;
    private static final int LINEAR = 12;
    private static final int LAWS = 10;
    private static final double LEAST_GAIN = 8;
    private static final double DISTORTED = 0.35;
    /** Steps of a moment that are tried, in its own unit [1]. */
    private static final double[] SHIFTS = {-1.5, -0.8, -0.4, -0.2, -0.1, -0.05, -0.02, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.5};
    /** So few links are all looked at for every kind of law. */
    private static final int FEW = 3;
    private static final int FINALISTS = 6;
    private static final double HOPELESS = 10;
    private static final int RIVALS = 2;
    /** What is left of a mismatch so plain that a law could not pass for something linear. */
    public static final double PLAIN = 10;
    private static final double PLAIN_IN_PART = 3;
    private static final double CLEAN = 1.1;
    private static final Comparator<Trial> LEAST = Comparator.comparingDouble(Trial::cost);
    /** Part of a mismatch from which on a mechanism explains nearly all of it: no second helps it, and no other law in its place. */
    public static final double NEARLY_ALL = 0.95;
    /** What no law's form leaves: then something else is missing too. */
    public static final double MUCH = 12;
    private static final double PROMISING = 0.3;
    private static final int GOING_ON = 16;
    private static final int BEGINNING = 4;
    private static final int LAW_STEPS = 10;
    private static final double[] GAINS = {0, 0.8, -0.8};

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
     * @param where what is known of where the mismatch enters
     * @return fits, least cost first, all in the same whitening
     */
    List<Fitter.State> refit(Fitter.State base, List<Screening.Score> scores, Whereabouts where) {
        // Where the first mechanism leaves much, the second is as large as any first.
        boolean second = !base.candidate().added().isEmpty() && base.reduced() < MUCH;
        List<Screening.Score> chosen = chosen(base, scores, second);
        Function<Hypothesis, List<double[]>> from = from(base, where);
        Trial.Ground whole = Trial.Ground.of(fitter, base);
        Trial.Ground brief = where.inPart() ? brief(base).orElse(whole) : whole;
        List<Trial> heat = begun(whole, brief, chosen.stream().filter(score -> !score.hypothesis().runsFree()).toList(), from);
        boolean promising = !heat.isEmpty() && heat.get(0).excess() < PROMISING * excess(base.reduced());
        if (promising) {
            goOn(base, heat);
        }
        if (!promising || !clean(base, heat.get(0))) {
            heat.addAll(begun(whole, brief, chosen.stream().filter(score -> score.hypothesis().runsFree()).toList(), from));
            goOn(base, heat);
        }
        int finalists = near(heat, second ? FINALISTS / 2 : FINALISTS);
        finalists += promised(heat, finalists, chosen) ? 1 : 0;
        List<Fitter.State> all = new ArrayList<>(Parallel.map(heat.subList(0, finalists),
                trial -> Trial.sorted(Parallel.map(trial.begun(), begun -> finish(begun, base))).get(0)));
        all.addAll(Parallel.map(heat.subList(finalists, heat.size()), trial -> trial.on(whole)));
        return Trial.sorted(all);
    }

    /**
     * Whether what promised most to first order is not among the finalists: a drift has farther to go than a step at the best of sixty
     * moments, and after as many steps stands behind that.
     *
     * @param heat least cost first; on return it follows them there
     * @param chosen that which promised most first
     */
    private static boolean promised(List<Trial> heat, int finalists, List<Screening.Score> chosen) {
        for (int i = finalists; i < heat.size(); i++) {
            if (heat.get(i).first().candidate().last().equals(chosen.get(0).hypothesis())) {
                heat.add(finalists, heat.remove(i));
                return true;
            }
        }
        return false;
    }

    private List<Screening.Score> chosen(Fitter.State base, List<Screening.Score> scores, boolean second) {
        Set<String> links = scores.stream().filter(score -> score.hypothesis().runsFree()).map(score -> score.hypothesis().where())
                .collect(Collectors.toSet());
        return choose(scores, second, links.size() <= FEW ? links : second ? Set.of() : Set.of(carryingLink(base)), bent(base));
    }

    /** Numbers of the model to start from. */
    private static Function<Hypothesis, List<double[]>> from(Fitter.State base, Whereabouts where) {
        boolean bent = bent(base);
        return h -> bent ? List.of(base.x(), where.unbent(h).orElseGet(base.candidate()::start)) : List.of(base.x());
    }

    /** Whether a fit went far to make up for what is missing: then it is a bad place to start from. */
    public static boolean bent(Fitter.State base) {
        return IntStream.range(0, base.x().length)
                .anyMatch(i -> base.candidate().knobs().get(i).unit() == 0 && base.candidate().knobs().get(i).deviation() > 1
                        && Math.abs(base.x()[i]) > DISTORTED);
    }

    /**
     * A part of the data that is enough to tell which hypotheses are worth the whole; empty where it may not be, as where the model with
     * other numbers explains the part: what goes by the clock is not in it, and anything that comes with free numbers would explain it.
     */
    public Optional<Trial.Ground> brief(Fitter.State base) {
        if (base.reduced() < PLAIN_IN_PART || base.candidate().added().stream().anyMatch(Hypothesis::byTheClock)) {
            return Optional.empty();
        }
        return evidence.brief().flatMap(part -> {
            Fitter own = new Fitter(part);
            Fitter.State there = own.lookWithSlopes(base.candidate(), base.x(), own.frame(base.candidate(), base.x(), part.fit()));
            return own.fit(base.candidate(), base.x(), there, BEGINNING, 1e-3).reduced() < PLAIN_IN_PART ? Optional.empty()
                    : Optional.of(Trial.Ground.of(own, there));
        });
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
            Function<Hypothesis, List<double[]>> from) {
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
        int most = heat.get(0).excess() < PROMISING * excess(base.reduced()) ? GOING_ON : 2 * GOING_ON;
        List<Trial> near = heat.subList(0, near(heat, most));
        List<Trial> further = Parallel.map(near, Trial::onward);
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

    /**
     * What is left beyond the noise [1]; half of it at least, so that fits near the noise are alike.
     *
     * @param reduced mean square of a whitened residual
     */
    public static double excess(double reduced) {
        return Math.max(reduced - 1, 0.5);
    }

    /** Whether a fit explains {@link #NEARLY_ALL} of the mismatch of a base. */
    public static boolean explainsNearlyAll(Fitter.State base, Fitter.State fit) {
        return explained(base, fit) > NEARLY_ALL;
    }

    /** Part of a mismatch that is explained, 0 to 1. */
    public static double explained(Fitter.State base, Fitter.State best) {
        return explained(base, best.reduced());
    }

    /**
     * Part of a mismatch that is explained, 0 to 1.
     *
     * @param left mean square of the whitened residual with it
     */
    public static double explained(Fitter.State base, double left) {
        return Math.max(0, Math.min(1, (base.reduced() - left) / Math.max(base.reduced() - 1, 1e-9)));
    }

    /** Whether a linear hypothesis leaves nothing of a mismatch so plain that no distortion by a law could be taken for it. */
    private static boolean clean(Fitter.State base, Trial linear) {
        return base.reduced() > PLAIN && linear.first().reduced() < CLEAN;
    }

    /** The link in which an arbitrary force would explain most; empty with a single output, where each would explain all. */
    private String carryingLink(Fitter.State base) {
        if (evidence.outputs().size() < 2 || evidence.onRig()) {
            return "";
        }
        Simulator.Linearised linear = new Simulator(evidence.excitation()).linearised(base.candidate().at(base.x()));
        return IntStream.range(0, evidence.model().links().size()).boxed()
                .min(Comparator.comparingDouble(l -> Entering.left(evidence, base, linear.ofLinkForce(l))))
                .map(l -> evidence.model().links().get(l).name()).orElseThrow();
    }

    /**
     * The best linear hypotheses and the best laws, and those whose effect a first-order look may miss: such as every kind of law in the
     * links that carry the mismatch, since a refit that went far turns the sign of what is seen to first order: then every form of it too,
     * for what acts one way only looks as if it acted the other.
     *
     * @param bent whether the refit went far
     */
    private static List<Screening.Score> choose(List<Screening.Score> scores, boolean second, Set<String> carrying, boolean bent) {
        int mostLaws = second ? LAWS / 2 : LAWS;
        int mostLinear = second ? LINEAR / 2 : LINEAR;
        List<Screening.Score> chosen = new ArrayList<>();
        int linear = 0;
        int laws = 0;
        Set<String> kinds = new HashSet<>();
        for (Screening.Score score : scores) {
            boolean law = score.hypothesis().runsFree();
            boolean first = law && carrying.contains(score.hypothesis().where())
                    && (kinds.add(score.hypothesis().mechanism() + score.hypothesis().where()) || bent && !second);
            if (first || !second && (score.hypothesis().overturns() || score.hypothesis().kind().isAlwaysRefitted())
                    || score.gain() > LEAST_GAIN && (law ? laws++ < mostLaws : linear++ < mostLinear)) {
                chosen.add(score);
            }
        }
        return chosen;
    }

    private Fitter.State finish(Fitter.State begun, Fitter.State base) {
        return timed(fitter.fit(begun.candidate(), begun.x(), base.frame(), 6, 2e-3), 1);
    }

    /** A moment is not found by slopes: steps of it are tried, and the rest refitted, until none helps. */
    private Fitter.State timed(Fitter.State fit, int rounds) {
        Fitter.State best = fit;
        for (int i = 0; i < best.candidate().knobs().size(); i++) {
            Knob knob = best.candidate().knobs().get(i);
            if (!knob.isMoment() || best.failed()) {
                continue;
            }
            for (int round = 0; round < rounds; round++) {
                Fitter.State start = best;
                for (double shift : SHIFTS) {
                    double[] x = start.x().clone();
                    x[i] = Math.max(knob.low(), Math.min(knob.high(), x[i] + shift));
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
    public Fitter.State polish(Fitter.State fit) {
        return polish(fit.candidate(), fit.x());
    }

    /**
     * The same from coordinates at which nothing was simulated yet.
     *
     * @param x coordinates [1], one a knob. Not modified.
     */
    public Fitter.State polish(Candidate candidate, double[] x) {
        Fitter.State once = polishedOnce(candidate, x);
        return polishedOnce(candidate, once.x());
    }

    /**
     * The best of a hypothesis from some starts, polished; none if it fails.
     *
     * @param on what it is added to
     * @param x coordinates of that [1], one a knob. Not modified.
     * @param starts values of the hypothesis' numbers, each in its unit
     */
    List<Fitter.State> polished(Candidate on, Hypothesis hypothesis, double[] x, Fitter.Frame frame, List<double[]> starts) {
        Fitter.State best = fitted(on, hypothesis, x, frame, starts);
        return best.failed() ? List.of() : List.of(polish(best));
    }

    /** The same without polish, in the frame given; failed if all starts fail. */
    Fitter.State fitted(Candidate on, Hypothesis hypothesis, double[] x, Fitter.Frame frame, List<double[]> starts) {
        Candidate with = on.with(hypothesis);
        return Parallel.map(starts, values -> fitter.fit(with, on.extended(x, with, hypothesis, values), frame, LAW_STEPS, 1e-3)).stream()
                .min(Comparator.comparingDouble(Fitter.State::cost)).orElseThrow();
    }

    /** The first steps from coordinates at which nothing was simulated yet, in the whitening of the model there. */
    Fitter.State begun(Candidate candidate, double[] x) {
        return fitter.fit(candidate, x, fitter.frame(candidate, x, evidence.fit()), BEGINNING, 1e-3);
    }

    private Fitter.State polishedOnce(Candidate candidate, double[] x) {
        return timed(fitter.fit(candidate, x, fitter.frame(candidate, x, evidence.fit()), 15, 3e-4), 4);
    }

    /** χ² per number on the held-out window [1]. */
    public double heldOut(Fitter.State fit) {
        return new Fitter(evidence, evidence.whole()).look(fit.candidate(), fit.x(), evidence.heldOut()).reduced();
    }
}
