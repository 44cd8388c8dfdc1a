package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import wbv.body.Model;
import wbv.recording.Recording;

/**
 * The whole way from a model and a recording to a diagnosis: fit what may be wrong without physics missing, screen every mechanism at
 * every place, refit the best by free run, add a second only if it must, decide, and prove on data not used.
 */
public final class Diagnoser {

    /** Below this much of the noise nothing is missing that a recording could show. */
    private static final double SILENT = 1.2;
    /** What is left beside noise that is known in full: 1, and what it scatters by. */
    private static final double NOISE = 1.04;
    private static final double STRANGE = 3;
    private static final double LOUD = 1.5;
    /** How much worse a model does on data not used for it before what shows there is fitted instead. */
    private static final double LATER = 3;
    /** What a force must leave beside the best mechanism to be more than the law's form. */
    private static final double STRONG = 4;
    /** A single mechanism that explains this much is not helped by a second. */
    private static final double ALL = 0.95;

    /** Laws that are simpler than another and take its place where both fit about equally. */
    private static final Map<String, Set<String>> SIMPLER = Map.of(
            "contact.bumpstop", Set.of("stiffness.asymmetric", "contact.loss", "stiffness.hardening"),
            "hysteresis", Set.of("friction.coulomb"), "muscle.reflex", Set.of("memory.viscoelastic"));

    /** A form that goes nowhere beyond the data, where another of the same mechanism may run away. */
    private static final String BOUNDED = "settling";

    private final Evidence evidence;
    private final Search search;
    private final Refinement refinement;
    private final Fitter fitter;
    private final BiConsumer<String, Double> progress;

    private Diagnoser(Evidence evidence, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.search = new Search(evidence, progress);
        this.refinement = search.refinement();
        this.fitter = search.fitter();
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
        Fitter.State base = search.base(baseline);
        double heldOut = refinement.heldOut(base);
        if (!evidence.onRig() && !evidence.isLate() && heldOut > STRANGE && heldOut > LATER * base.reduced()) {
            Diagnosed later = new Diagnoser(evidence.late(), progress).run();
            // Or the fit went astray, and what it was not made for shows that the most.
            return isUnexplained(later) ? Optional.of(searched(baseline, base)).filter(found -> !isUnexplained(found)).orElse(later) : later;
        }
        return base.reduced() > SILENT && heldOut > SILENT ? searched(baseline, base) : conclude(baseline, base, List.of());
    }

    private static boolean isUnexplained(Diagnosed diagnosed) {
        return diagnosed.diagnosis().verdict() == Diagnosis.Verdict.UNEXPLAINED;
    }

    /** The diagnosis where something is missing, if no more than a person's own force. */
    private Diagnosed searched(Candidate baseline, Fitter.State base) {
        boolean unknown = evidence.bodyForce().isEmpty();
        Optional<Diagnosed> still = unknown ? sittingStill(baseline, base) : Optional.empty();
        if (still.isPresent()) {
            return still.get();
        }
        Whereabouts where = Whereabouts.found(evidence, baseline, base.x());
        Optional<BodyForce> own = unknown ? where.ownForce() : Optional.empty();
        if (own.isPresent()) {
            Diagnosed beside = new Diagnoser(evidence.with(own.get()), progress).run();
            // A push that is all there is goes by no law, and what is taken for a second force may be a part of it.
            boolean pushed = isUnexplained(beside)
                    && BodyForce.in(evidence, base).filter(BodyForce::independent).isPresent();
            return pushed ? conclude(baseline, base, List.of()) : beside;
        }
        List<Fitter.State> leaders = search.leaders(base, Search.LEADERS, where);
        // What the best hypothesis leaves shows the person's own force, and not what the hypothesis explains.
        Fitter.State best = leaders.isEmpty() ? base : leaders.get(0);
        Optional<BodyForce> rest = best.reduced() < (unknown ? SILENT : NOISE) ? Optional.empty() : left(best);
        if (rest.isPresent() && rest.get().ordinary(evidence)) {
            return new Diagnoser(evidence.with(rest.get()), progress).judge(baseline, leaders);
        }
        // A strong push hides what else is missing: what shows beside it?
        Optional<Diagnosed> beside = rest.filter(push -> push.independent() && best != base && best.reduced() > STRONG)
                .map(push -> new Diagnoser(evidence.with(push), progress).judge(baseline, leaders)).filter(Diagnoser::besidePush);
        if (beside.isPresent()) {
            return beside.get();
        }
        Diagnosed found = conclude(baseline, base, leaders);
        if (isUnexplained(found) && unknown) {
            return where.push().map(push -> new Diagnoser(evidence.with(push), progress).run()).filter(Diagnoser::besidePush).orElse(found);
        }
        return found;
    }

    private static boolean besidePush(Diagnosed diagnosed) {
        return Verdicts.namesBesidePush(diagnosed.diagnosis());
    }

    /** The force that a fit leaves, whatever force is known of already. */
    private Optional<BodyForce> left(Fitter.State fit) {
        Evidence plain = evidence.withoutForce();
        return BodyForce.in(plain, new Fitter(plain).look(fit.candidate(), fit.x(), plain.fit()));
    }

    /** The diagnosis where all that is left is what a person does who sits still, on smooth stretches and on rough ones alike. */
    private Optional<Diagnosed> sittingStill(Candidate baseline, Fitter.State base) {
        // A tone would be taken for a part of a force that has all frequencies.
        if (Lines.standOut(base.residual(), evidence.fit())) {
            return Optional.empty();
        }
        return BodyForce.in(evidence, base).filter(force -> force.ordinary(evidence) && force.following().isSteady()).flatMap(force -> {
            Diagnoser knowing = new Diagnoser(evidence.with(force), progress);
            Fitter.State quiet = knowing.search.base(baseline);
            return quiet.reduced() < NOISE && knowing.refinement.heldOut(quiet) < NOISE
                    ? Optional.of(knowing.conclude(baseline, quiet, List.of())) : Optional.empty();
        });
    }

    /** A diagnosis in which a person's own force counts as noise. @param known hypotheses fitted without it, to be fitted again */
    private Diagnosed judge(Candidate baseline, List<Fitter.State> known) {
        Fitter.State base = search.base(baseline);
        return conclude(baseline, base, again(base, known));
    }

    /** The best few fitted in the whitening of a new base, the others looked at in it. */
    private List<Fitter.State> again(Fitter.State base, List<Fitter.State> fits) {
        int leading = Math.min(Search.LEADERS, fits.size());
        List<Fitter.State> out = new ArrayList<>(Cores.map(fits.subList(0, leading), refinement::polish));
        fits.subList(leading, fits.size()).forEach(fit -> out.add(fitter.look(fit.candidate(), fit.x(), base.frame())));
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        return out;
    }

    private Diagnosed conclude(Candidate baseline, Fitter.State base, List<Fitter.State> leaders) {
        Fitter.State given = fitter.look(baseline, baseline.start(), evidence.fit());
        List<Fitter.State> credible = search.credible(leaders);
        Fitter.State best = credible.isEmpty() ? base : simplest(credible);
        if (best != base) {
            boolean more = Verdicts.explained(base, best) < ALL || best.reduced() > Refinement.MUCH;
            boolean much = best.reduced() > STRANGE && more && refinement.heldOut(best) > LOUD;
            best = much ? new PairSearch(evidence, search, progress).pair(base, best, credible) : best;
            if (best.candidate().added().size() == 1 && base.reduced() > SILENT) {
                best = new Companion(evidence, search).of(best, much).orElse(best);
            }
        }
        progress.accept("proving", 0.9);
        return new Verdicts(evidence, given, base, refinement.heldOut(base), best, credible, refinement).diagnosed(
                state -> new Locator(evidence, baseline).places(base.x()));
    }

    /** The best, or a simpler law at the same place that is nearly as good. */
    private static Fitter.State simplest(List<Fitter.State> leaders) {
        Fitter.State best = leaders.get(0);
        Hypothesis first = best.candidate().added().get(0);
        for (Fitter.State other : leaders.subList(1, Math.min(Search.LEADERS, leaders.size()))) {
            Hypothesis rival = other.candidate().added().get(0);
            boolean simpler = SIMPLER.getOrDefault(first.mechanism(), Set.of()).contains(rival.mechanism())
                    || rival.mechanism().equals(first.mechanism()) && rival.form().equals(BOUNDED);
            if (simpler && rival.where().equals(first.where())
                    && other.cost() - best.cost() < 100 + 0.3 * Math.max(best.cost() - degrees(best), 0)) {
                return other;
            }
        }
        return best;
    }

    static int degrees(Fitter.State state) {
        return state.frame().whitening().degrees();
    }
}
