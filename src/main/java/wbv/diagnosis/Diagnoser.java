package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.Model;
import wbv.recording.Recording;

/**
 * The whole way from a model and a recording to a diagnosis: fit what may be wrong without physics missing, screen every mechanism at
 * every place, refit the best by free run, add a second only if it must, decide, and prove on data not used.
 */
public final class Diagnoser {

    /** Below this much of the noise nothing is missing that a recording could show. */
    private static final double SILENT = 1.2;
    private static final double STRANGE = 3;
    /** How much worse a model does on data not used for it before what shows there is fitted instead. */
    private static final double LATER = 3;
    /** What a force must leave beside the best mechanism to be more than the law's form. */
    private static final double STRONG = 4;
    private static final int LEADERS = 3;
    private static final int FIRSTS = 2;
    private static final double REACH = 10;
    /** How many times what the best leaves a fit may leave and still be the best in another form. */
    private static final double FORM = 4;
    /** A single mechanism that explains this much is not helped by a second. */
    private static final double ALL = 0.95;
    /** Part of the whole mismatch that each of two mechanisms has to carry beside the other. */
    private static final double OWN_PART = 0.08;
    private static final double NEARLY_ALL = 0.9;
    private static final double MOST = 0.6;
    /** How much more than the best another may leave, in units of what the best leaves, and still fit about as well. */
    private static final double NEAR = 1.5;

    /** Laws that are simpler than another and take its place where both fit about equally. */
    private static final Map<String, Set<String>> SIMPLER = Map.of(
            "contact.bumpstop", Set.of("stiffness.asymmetric", "contact.loss", "stiffness.hardening"),
            "hysteresis", Set.of("friction.coulomb"), "muscle.reflex", Set.of("memory.viscoelastic"));

    /** Mechanisms that can imitate others at the ends of their range. */
    private static final Set<String> BOUNDED = Set.of("mode.hidden", "muscle.reflex", "memory.viscoelastic", "sensor.mount", "sensor.delay");

    private final Evidence evidence;
    private final Refinement refinement;
    private final Fitter fitter;
    private final BiConsumer<String, Double> progress;

    private Diagnoser(Evidence evidence, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.refinement = new Refinement(evidence);
        this.fitter = new Fitter(evidence);
        this.progress = progress;
    }

    /**
     * Diagnoses.
     *
     * @param progress told the step and the share of it that is done, 0 to 1 or NaN
     * @throws wbv.recording.DataFault if the recording lacks what the model needs
     */
    public static Diagnosis diagnose(Model model, Recording recording, BiConsumer<String, Double> progress) {
        return diagnose(Question.of(model, recording), progress);
    }

    /** Diagnoses, with what else is known. @param progress as for the shorter form */
    public static Diagnosis diagnose(Question question, BiConsumer<String, Double> progress) {
        return examine(question, progress).diagnosis();
    }

    /** Diagnoses, and keeps what the pictures are drawn from. */
    public static Diagnosed examine(Question question, BiConsumer<String, Double> progress) {
        Evidence evidence = new Evidence(question.asked(), question.recording(), question.noise());
        if (!question.unitsKnown()) {
            Admission.units(evidence);
        }
        return new Diagnoser(evidence, progress).run();
    }

    private Diagnosed run() {
        progress.accept("fitting the model", 0.0);
        Candidate baseline = Baseline.of(evidence);
        Fitter.State base = fitBaseline(baseline);
        List<Fitter.State> leaders = List.of();
        double heldOut = refinement.heldOut(base);
        if (!evidence.onRig() && !evidence.isLate() && heldOut > STRANGE && heldOut > LATER * base.reduced()) {
            return new Diagnoser(evidence.late(), progress).run();
        }
        if (base.reduced() > SILENT && heldOut > SILENT) {
            leaders = leaders(base, LEADERS);
            // What the best hypothesis leaves shows the person's own force, and not what the hypothesis explains.
            Fitter.State best = leaders.isEmpty() ? base : leaders.get(0);
            Optional<BodyForce> rest = best.reduced() < SILENT ? Optional.empty() : BodyForce.in(evidence, best);
            if (rest.isPresent() && rest.get().ordinary(evidence)) {
                return new Diagnoser(evidence.with(rest.get()), progress).judge(baseline, leaders);
            }
            if (rest.isPresent() && rest.get().independent() && best != base && best.reduced() > STRONG) {
                // A strong push hides what else is missing: what shows beside it?
                Diagnosed beside = new Diagnoser(evidence.with(rest.get()), progress).judge(baseline, leaders);
                if (Verdicts.namesBesidePush(beside.diagnosis())) {
                    return beside;
                }
            }
        }
        return conclude(baseline, base, leaders);
    }

    /** A diagnosis in which a person's own force counts as noise. @param known hypotheses fitted without it, to be fitted again */
    private Diagnosed judge(Candidate baseline, List<Fitter.State> known) {
        Fitter.State base = fitBaseline(baseline);
        return conclude(baseline, base, again(base, known));
    }

    /** The best few fitted in the whitening of a new base, the others looked at in it. */
    private List<Fitter.State> again(Fitter.State base, List<Fitter.State> fits) {
        List<Fitter.State> out = new ArrayList<>(IntStream.range(0, fits.size()).parallel().mapToObj(i -> i < LEADERS
                ? refinement.polish(fits.get(i)) : fitter.look(fits.get(i).candidate(), fits.get(i).x(), base.frame())).toList());
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        return out;
    }

    private Diagnosed conclude(Candidate baseline, Fitter.State base, List<Fitter.State> leaders) {
        Fitter.State given = fitter.look(baseline, baseline.start(), fitter.frame(baseline, baseline.start(), evidence.fit()));
        List<Fitter.State> credible = credible(leaders);
        Fitter.State best = credible.isEmpty() ? base : simplest(credible);
        boolean more = Verdicts.explained(base, best) < ALL || best.reduced() > Refinement.MUCH;
        if (best != base && best.reduced() > STRANGE && more && refinement.heldOut(best) > 2.5) {
            best = pair(base, best, credible);
        }
        progress.accept("proving", 0.9);
        return new Verdicts(evidence, given, base, refinement.heldOut(base), best, credible, refinement).diagnosed(
                state -> new Locator(evidence).places(baseline, base.x()));
    }

    private Fitter.State fitBaseline(Candidate baseline) {
        return Baseline.starts(evidence, baseline).parallelStream().map(start -> fitBaseline(baseline, start))
                .min(Comparator.comparingDouble(Fitter.State::reduced)).orElseThrow();
    }

    private Fitter.State fitBaseline(Candidate baseline, double[] start) {
        double[] x = start;
        for (int round = 0; round < 3; round++) {
            x = fitter.fit(baseline, x, fitter.frame(baseline, x, evidence.fit()), 12, 1e-4).x();
        }
        return fitter.lookWithSlopes(baseline, x, fitter.frame(baseline, x, evidence.fit()));
    }

    /** Refitted hypotheses on top of a fit, the first ones polished; least cost per number first. */
    private List<Fitter.State> leaders(Fitter.State base, int polished) {
        progress.accept("screening", 0.2);
        Motion motion = new Motion(evidence, base.candidate().at(base.x()));
        Assembly fitted = base.candidate().at(base.x());
        List<Hypothesis> bank = evidence.onRig() ? new RigBank(evidence, fitted, motion).hypotheses()
                : new Bank(evidence, fitted, motion, Lines.of(base.residual(), evidence.fit())).hypotheses();
        Set<String> used = base.candidate().added().stream().map(Hypothesis::name).collect(Collectors.toSet());
        List<Hypothesis> open = bank.stream().filter(h -> !used.contains(h.name())).toList();
        List<Screening.Score> scores = new Screening(evidence, base, motion).scores(open);
        progress.accept("refitting", 0.4);
        List<Fitter.State> fits = refinement.refit(base, scores).stream().filter(fit -> !fit.failed()).toList();
        // A rival far behind does not come up by polishing.
        double reach = fits.isEmpty() ? 0 : 1 + REACH * Math.max(fits.get(0).reduced() - 1, 0.5);
        int count = (int) fits.stream().limit(polished).filter(fit -> fit.reduced() <= reach).count();
        List<Fitter.State> out = new ArrayList<>(fits.subList(0, count).parallelStream().map(refinement::polish).toList());
        out.addAll(fits.subList(count, fits.size()));
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        if (!evidence.onRig()) {
            Yielding yielding = new Yielding(evidence, refinement, new Bank(evidence, fitted, motion, new double[0]), base);
            double near = out.isEmpty() ? 0 : 1 + FORM * Math.max(out.get(0).reduced() - 1, 0.5);
            out.stream().limit(LEADERS).filter(fit -> fit.reduced() < near).map(yielding::rivals).filter(rivals -> !rivals.isEmpty()).findFirst()
                    .ifPresent(out::addAll);
            out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        }
        return out;
    }

    /**
     * The fits, those last that need a number of the model to be far off where another that fits about as well needs none: play of which
     * the spring would have to be several times as stiff as given is hardening where the given stiffness is right.
     */
    private List<Fitter.State> credible(List<Fitter.State> leaders) {
        if (evidence.onRig() || leaders.size() < 2) {
            return leaders;
        }
        double reach = leaders.get(0).reduced() + NEAR * Math.max(leaders.get(0).reduced() - 1, 0.1);
        List<Fitter.State> out = new ArrayList<>();
        List<Fitter.State> odd = new ArrayList<>();
        for (Fitter.State fit : leaders) {
            if (fit.reduced() > reach) {
                out.add(fit);
                continue;
            }
            Optional<OddLink> link = odd(fit);
            Optional<Fitter.State> held = link.map(it -> it.held(fitter, fit)).filter(it -> it.reduced() < reach && odd(it).isEmpty());
            (link.isEmpty() || held.isPresent() ? out : odd).add(held.orElse(fit));
        }
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        boolean any = !out.isEmpty() && out.get(0).reduced() < reach;
        out.addAll(any ? out.size() : 0, odd);
        return out;
    }

    private Optional<OddLink> odd(Fitter.State fit) {
        return OddLink.in(fitter.lookWithSlopes(fit.candidate(), fit.x(), fit.frame()));
    }

    /** The best, or a simpler law at the same place that is nearly as good. */
    private static Fitter.State simplest(List<Fitter.State> leaders) {
        Fitter.State best = leaders.get(0);
        Hypothesis first = best.candidate().added().get(0);
        for (Fitter.State other : leaders.subList(1, Math.min(LEADERS, leaders.size()))) {
            Hypothesis rival = other.candidate().added().get(0);
            if (SIMPLER.getOrDefault(first.mechanism(), Set.of()).contains(rival.mechanism()) && rival.where().equals(first.where())
                    && other.cost() - best.cost() < 100 + 0.3 * Math.max(best.cost() - degrees(best), 0)) {
                return other;
            }
        }
        return best;
    }

    static int degrees(Fitter.State state) {
        return state.frame().whitening().degrees();
    }

    /** A second omission on top of each of the best firsts, kept if it removes most of what is left and neither does alone. */
    private Fitter.State pair(Fitter.State base, Fitter.State single, List<Fitter.State> leaders) {
        List<Fitter.State> pairs = new ArrayList<>();
        for (Fitter.State first : leaders.subList(0, Math.min(FIRSTS, leaders.size()))) {
            if (first == single || first.cost() < 0.9 * base.cost()) {
                seconds(first).ifPresent(pairs::add);
            }
        }
        pairs.sort(Comparator.comparingDouble(Fitter.State::reduced));
        if (pairs.isEmpty()) {
            return single;
        }
        // The first was chosen while the second was still missing: once more, the other way round.
        Hypothesis second = pairs.get(0).candidate().added().get(1);
        seconds(alone(second, pairs.get(0), base)).filter(other -> other.reduced() < pairs.get(0).reduced()).ifPresent(other -> pairs.add(0, other));
        Fitter.State best = pairs.get(0);
        if (best.reduced() - 1 > 0.35 * (single.reduced() - 1) || refinement.heldOut(best) > refinement.heldOut(single)) {
            return single;
        }
        return necessary(best, base);
    }

    /** The best that a second hypothesis makes of a fit. */
    private Optional<Fitter.State> seconds(Fitter.State first) {
        return credible(leaders(fitter.lookWithSlopes(first.candidate(), first.x(), first.frame()), 1)).stream()
                .filter(fit -> !extreme(fit)).findFirst();
    }

    /** A fit of one hypothesis of a pair without the other. */
    private Fitter.State alone(Hypothesis hypothesis, Fitter.State pair, Fitter.State base) {
        Candidate one = base.candidate().with(hypothesis);
        double[] x = Arrays.copyOf(pair.x(), one.knobs().size());
        int[] from = hypothesis.positions(pair.candidate());
        int[] to = hypothesis.positions(one);
        for (int i = 0; i < from.length; i++) {
            x[to[i]] = pair.x()[from[i]];
        }
        return refinement.polish(fitter.look(one, x, fitter.frame(one, x, evidence.fit())));
    }

    /** Whether the last hypothesis of a fit stands at a bound that nothing real has: a mass of half a person, a relaxation without end. */
    static boolean extreme(Fitter.State fit) {
        Hypothesis last = fit.candidate().added().get(fit.candidate().added().size() - 1);
        if (!BOUNDED.contains(last.mechanism())) {
            return false;
        }
        return Arrays.stream(last.positions(fit.candidate())).anyMatch(i -> {
            Knob knob = fit.candidate().knobs().get(i);
            boolean free = knob.high() - knob.low() > 1e-2;   // a number that is held stands at a bound without meaning it
            return free && (fit.x()[i] <= knob.low() + 1e-6 || fit.x()[i] >= knob.high() - 1e-6);
        });
    }

    /** The pair, or one of the two if that does as well. */
    private Fitter.State necessary(Fitter.State pair, Fitter.State base) {
        Fitter.State best = pair;
        for (Hypothesis alone : pair.candidate().added()) {
            Fitter.State fit = alone(alone, pair, base);
            double own = fit.reduced() - pair.reduced();
            // A small part is believed where with it little is left; beside a law much may be left, and the part be no more than its form.
            double most = alone.runsFree() ? NEARLY_ALL : MOST;
            boolean nearly = own < 0.3 * pair.reduced() || own < OWN_PART * (base.reduced() - 1) && own < most * (fit.reduced() - 1);
            if (nearly && (best == pair || fit.cost() < best.cost())) {
                best = fit;
            }
        }
        return best;
    }
}
