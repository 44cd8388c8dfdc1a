package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import wbv.body.Model;
import wbv.body.law.Learned;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Parallel;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.fit.SpectralLines;
import wbv.diagnosis.learn.LawLearner;
import wbv.diagnosis.measured.AccelerationUnit;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Chosen;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.InputLevel;
import wbv.diagnosis.search.Locator;
import wbv.diagnosis.search.PairSearch;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;
import wbv.diagnosis.search.SecondMechanism;
import wbv.diagnosis.search.Whereabouts;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * The whole way from a model and a recording to a diagnosis: fit what may be wrong without physics missing, screen every mechanism at
 * every place, refit the best by free run, add a second only if it must, decide, and prove on data not used.
 */
public final class Diagnoser {

    /** What is left beside noise that is known in full: 1, and what it scatters by. */
    private static final double NOISE = 1.04;
    /** What data not used must show for a second mechanism to be sought. */
    private static final double LOUD = 1.5;
    /** How much worse a model does on data not used for it before what shows there is fitted instead. */
    private static final double LATER = 3;
    /** What a force must leave beside the best mechanism to be more than the law's form. */
    private static final double STRONG = 4;
    /** Part of a push that its own level leaves by chance: only what is left beyond that is another mechanism. */
    private static final double OWN_SCATTER = 0.012;
    /** How much more than the best a fit may leave to be looked at with free ways. */
    private static final double CARRIED = 1.2;
    private static final int MOST_CARRIED = 2;
    /** Part of a plain mismatch that a mechanism must promise to first order that is to explain all of it. */
    private static final double PROMISED = 0.5;

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

    /**
     * Diagnoses, with what else is known.
     *
     * @param progress as for the shorter form
     */
    public static Diagnosis diagnose(Question question, BiConsumer<String, Double> progress) {
        return examine(question, progress).diagnosis();
    }

    /** Diagnoses, and keeps what the pictures are drawn from. */
    public static Diagnosed examine(Question question, BiConsumer<String, Double> progress) {
        Diagnoser diagnoser = asked(question, progress);
        Optional<ForceSign.Turned> turned = ForceSign.in(question, diagnoser.evidence);
        if (turned.isPresent()) {
            return examine(turned.get().question(), progress).saying(turned.get().sentence());
        }
        Diagnosed found = diagnoser.run();
        return new Learning(found.fits.evidence(), progress).completed(found);
    }

    /**
     * The diagnosis where nothing is missing of a model as it is given, but for what its sensors and a person who sits still do; empty
     * where there is more, which is not searched.
     */
    public static Optional<Diagnosed> silent(Question question, BiConsumer<String, Double> progress) {
        Diagnoser diagnoser = asked(question, progress);
        Candidate baseline = Baseline.of(diagnoser.evidence);
        Fitter.State base = diagnoser.search.base(baseline);
        Optional<Diagnoser> quiet = diagnoser.leaves(base, Refinement.SILENT) ? Optional.of(diagnoser)
                : diagnoser.knowingWhoSitsStill(baseline, base);
        return quiet.filter(knowing -> Verdicts.mayBeRight(knowing.given(baseline)))
                .map(knowing -> knowing.conclude(baseline, knowing.search.base(baseline), List.of()))
                .filter(found -> found.diagnosis().verdict() == Diagnosis.Verdict.NOTHING_MISSING);
    }

    private static Diagnoser asked(Question question, BiConsumer<String, Double> progress) {
        Evidence evidence = new Evidence(question.asked(), question.recording(), question.noise(), question.provedFrom())
                .with(question.library());
        if (!question.unitsKnown()) {
            AccelerationUnit.check(evidence.measured());
        }
        return new Diagnoser(evidence, progress);
    }

    private Diagnosed run() {
        progress.accept("fitting the model", 0.0);
        Candidate baseline = Baseline.of(evidence);
        Fitter.State base = search.base(baseline);
        double heldOut = refinement.heldOut(base);
        boolean asked = evidence.isLate() || evidence.measured().isChosen() || evidence.bodyForce().isPresent();
        if (!evidence.onRig() && !asked && heldOut > Refinement.STRANGE && heldOut > LATER * base.reduced()) {
            return louderLater(baseline, base);
        }
        boolean loud = Math.min(base.reduced(), heldOut) > Refinement.SILENT || Math.max(base.reduced(), heldOut) > Refinement.STRANGE;
        return loud ? searched(baseline, base) : conclude(baseline, base, List.of());
    }

    /** The diagnosis where data not used for the fit show much more than those that were: first of those that show it plainly. */
    private Diagnosed louderLater(Candidate baseline, Fitter.State base) {
        Optional<Diagnosed> here = Optional.of(base).filter(fit -> fit.reduced() > Refinement.PLAIN).map(fit -> searched(baseline, fit));
        if (here.filter(Diagnoser::isByHypothesis).isPresent()) {
            return here.get();
        }
        Diagnosed later = new Diagnoser(evidence.late(), progress).run();
        // Or the fit went astray, and what it was not made for shows that the most; or a change lies before the late part, which does
        // not show it.
        return isUnexplained(later)
                ? Optional.of(here.orElseGet(() -> searched(baseline, base))).filter(found -> !isUnexplained(found)).orElse(later)
                : later;
    }

    /** Whether a hypothesis explains the mismatch: a push, which may be anything, is none. */
    private static boolean isByHypothesis(Diagnosed diagnosed) {
        return !isUnexplained(diagnosed) && diagnosed.fits.best() != diagnosed.fits.base();
    }

    private static boolean isUnexplained(Diagnosed diagnosed) {
        return diagnosed.diagnosis().verdict().isRefusal();
    }

    /**
     * Whether nothing explains a mismatch that may be several mechanisms or a push: not one that enters in a link or at a sensor alone,
     * where all of the library was tried and nothing came near.
     */
    private static boolean isOpen(Diagnosed diagnosed) {
        List<Diagnosis.Latent> alone = diagnosed.diagnosis().latent().stream()
                .filter(place -> Refinement.excess(place.reduced()) <= PairSearch.QUIET).toList();
        // A body on the base feels what its link does: the two leave the same.
        Set<Double> elsewhere = alone.stream().filter(place -> !isBody(place)).map(Diagnosis.Latent::reduced).collect(Collectors.toSet());
        boolean near = diagnosed.fits.best() != diagnosed.fits.base();
        return isUnexplained(diagnosed)
                && (near || alone.isEmpty() || alone.stream().anyMatch(place -> isBody(place) && !elsewhere.contains(place.reduced())));
    }

    private static boolean isBody(Diagnosis.Latent place) {
        return place.kind().equals(Place.Kind.BODY.word());
    }

    /** The diagnosis where something is missing, if no more than a person's own force. */
    private Diagnosed searched(Candidate baseline, Fitter.State base) {
        if (evidence.bodyForce().isPresent()) {
            return asKnown(baseline, base, Whereabouts.found(evidence, baseline, base.x()));
        }
        Optional<Diagnosed> still = sittingStill(baseline, base);
        if (still.isPresent()) {
            return still.get();
        }
        Optional<Diagnosed> plain = plain(baseline, base);
        if (plain.isPresent()) {
            return plain.get();
        }
        Whereabouts where = Whereabouts.found(evidence, baseline, base.x());
        Optional<Diagnosed> knowing = where.ownForce().map(own -> new Diagnoser(evidence.with(own), progress).run());
        if (knowing.isEmpty()) {
            return asKnown(baseline, base, where);
        }
        if (!isOpen(knowing.get())) {
            return knowing.get();
        }
        // A push that is all there is goes by no law, and what is taken for a second force may be a part of it.
        boolean pushed = base.reduced() > Refinement.STRANGE && BodyForce.in(evidence, base).filter(BodyForce::independent).isPresent();
        // Or what was taken for a person's force is a part of what is missing.
        return Optional.of(pushed ? conclude(baseline, base, List.of()) : asKnown(baseline, base, where))
                .filter(found -> !isUnexplained(found))
                .orElse(knowing.get());
    }

    /**
     * The diagnosis of a plain mismatch of which a linear mechanism leaves noise alone, or what a person does who sits still, on data not
     * used for it too: no law that is not linear does so little to the form of the motion, and where it enters need not be asked first.
     */
    private Optional<Diagnosed> plain(Candidate baseline, Fitter.State base) {
        if (evidence.onRig() || base.reduced() < Refinement.PLAIN) {
            return Optional.empty();
        }
        List<Fitter.State> leaders = search.linear(base, Search.LEADERS, PROMISED);
        if (leaders.isEmpty() || Refinement.explained(base, leaders.get(0)) < Refinement.NEARLY_ALL) {
            return Optional.empty();
        }
        if (leaves(leaders.get(0), Refinement.SILENT)) {
            return Optional.of(conclude(baseline, base, leaders));
        }
        return left(leaders.get(0)).filter(force -> force.ordinary(evidence)).flatMap(force -> {
            Diagnoser knowing = new Diagnoser(evidence.with(force), progress);
            Fitter.State quiet = knowing.search.base(baseline);
            List<Fitter.State> again = knowing.again(quiet, leaders);
            return knowing.leaves(again.get(0), Refinement.SILENT) ? Optional.of(knowing.conclude(baseline, quiet, again))
                    : Optional.empty();
        });
    }

    /** The diagnosis with no more known of a person's own force than the evidence says, until a hypothesis has explained the rest. */
    private Diagnosed asKnown(Candidate baseline, Fitter.State base, Whereabouts where) {
        boolean unknown = evidence.bodyForce().isEmpty();
        List<Fitter.State> leaders = leaders(base, where);
        // What the best hypothesis leaves shows the person's own force, and not what the hypothesis explains.
        Fitter.State best = leaders.isEmpty() ? base : leaders.get(0);
        Map<Channel, Double> input = evidence.onRig() && evidence.heard().isEmpty() ? new InputLevel(evidence).of(best) : Map.of();
        if (!input.isEmpty()) {
            return new Diagnoser(evidence.with(input), progress).judge(baseline, leaders);
        }
        Optional<BodyForce> rest = best.reduced() < (unknown ? Refinement.SILENT : NOISE) ? Optional.empty() : left(best);
        if (rest.isPresent() && rest.get().ordinary(evidence)) {
            return new Diagnoser(evidence.with(rest.get()), progress).judge(baseline, leaders);
        }
        // A hidden mass looks like a push too, and so may a sitter's own force; so first they were asked for.
        if (unknown && best.reduced() > STRONG && isPush(baseline, base)) {
            return conclude(baseline, base, List.of());
        }
        // A strong push hides what else is missing: what shows beside it?
        Optional<Diagnosed> beside = rest.filter(push -> push.independent() && best != base && best.reduced() > STRONG)
                .flatMap(push -> beside(push, base, knowing -> knowing.judge(baseline, leaders)));
        if (beside.isPresent()) {
            return beside.get();
        }
        Diagnosed found = conclude(baseline, base, leaders);
        return isUnexplained(found) && unknown ? where.push().flatMap(push -> beside(push, base, Diagnoser::run)).orElse(found) : found;
    }

    private List<Fitter.State> leaders(Fitter.State base, Whereabouts where) {
        List<Fitter.State> near = search.leaders(base, Search.LEADERS, where);
        double unlisted = Calibration.unlisted(base.reduced() - 1);
        List<Fitter.State> all = new ArrayList<>(near);
        if (near.isEmpty() || near.get(0).reduced() - 1 > unlisted) {
            where.besideSensor(unlisted).ifPresent(farther -> all.addAll(search.leaders(base, Search.LEADERS, farther)));
            all.sort(Comparator.comparingDouble(Fitter.State::reduced));
        }
        return all;
    }

    /**
     * The diagnosis that knows of a strong push, where that leaves enough to show a mechanism, and the mechanism leaves the push.
     *
     * @param ask one who knows of the push
     */
    private Optional<Diagnosed> beside(BodyForce push, Fitter.State base, Function<Diagnoser, Diagnosed> ask) {
        Diagnosed found = ask.apply(new Diagnoser(evidence.with(push), progress));
        double known = found.evidence.bodyForce().map(BodyForce::rms).orElse(Double.NaN);
        return Verdicts.namesBesidePush(found) && found.base.reduced() - 1 > OWN_SCATTER * (base.reduced() - 1)
                && left(found.chosen).filter(force -> force.body() == push.body() && force.rms() > Verdicts.REMAINS * known).isPresent()
                        ? Optional.of(found) : Optional.empty();
    }

    /** The force that a fit leaves, whatever force is known of already. */
    private Optional<BodyForce> left(Fitter.State fit) {
        Evidence plain = evidence.withoutForce();
        return BodyForce.in(plain, new Fitter(plain).look(fit.candidate(), fit.x(), plain.fit()));
    }

    /** The diagnosis where all that is left is what a person does who sits still, on smooth stretches and on rough ones alike. */
    private Optional<Diagnosed> sittingStill(Candidate baseline, Fitter.State base) {
        return knowingWhoSitsStill(baseline, base).map(knowing -> knowing.conclude(baseline, knowing.search.base(baseline), List.of()));
    }

    /** One who takes what such a person does for noise. */
    private Optional<Diagnoser> knowingWhoSitsStill(Candidate baseline, Fitter.State base) {
        // A tone would be taken for a part of a force that has all frequencies.
        if (SpectralLines.standOut(base.residual(), evidence.fit())) {
            return Optional.empty();
        }
        return BodyForce.in(evidence, base).filter(force -> force.ordinary(evidence) && force.following().isSteady())
                .map(force -> new Diagnoser(evidence.with(force), progress))
                .filter(knowing -> knowing.leaves(knowing.search.base(baseline), NOISE));
    }

    /** Whether a push is all that is missing: a force of its own, without tones, that leaves no more than its level scatters. */
    private boolean isPush(Candidate baseline, Fitter.State base) {
        return base.reduced() > Refinement.STRANGE && BodyForce.in(evidence, base).filter(BodyForce::independent).filter(force -> {
            Diagnoser knowing = new Diagnoser(evidence.with(force), progress);
            Fitter.State quiet = knowing.search.base(baseline);
            return knowing.leaves(quiet, Math.max(NOISE, 1 + OWN_SCATTER * (base.reduced() - 1)))
                    && !SpectralLines.standOut(quiet.residual(), evidence.fit());
        }).isPresent();
    }

    /** Whether a fit leaves less than that, on data not used for it too. */
    private boolean leaves(Fitter.State fit, double most) {
        return fit.reduced() < most && refinement.heldOut(fit) < most;
    }

    /**
     * A diagnosis in which a person's own force counts as noise.
     *
     * @param known hypotheses fitted without it, to be fitted again
     */
    private Diagnosed judge(Candidate baseline, List<Fitter.State> known) {
        Fitter.State base = search.base(baseline);
        return conclude(baseline, base, again(base, known));
    }

    /** The best few fitted in the whitening of a new base, the others looked at in it. */
    private List<Fitter.State> again(Fitter.State base, List<Fitter.State> fits) {
        int leading = Math.min(Search.LEADERS, fits.size());
        List<Fitter.State> out = new ArrayList<>(Parallel.map(fits.subList(0, leading), refinement::polish));
        fits.subList(leading, fits.size()).forEach(fit -> out.add(fitter.look(fit.candidate(), fit.x(), base.frame())));
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        return out;
    }

    private Diagnosed conclude(Candidate baseline, Fitter.State base, List<Fitter.State> leaders) {
        List<Fitter.State> credible = carried(search.credible(leaders));
        Fitter.State best = credible.isEmpty() ? base : simplest(credible);
        Chosen chosen = Chosen.single(best);
        if (best != base) {
            boolean more = Refinement.explained(base, best) < Refinement.NEARLY_ALL || best.reduced() > Refinement.MUCH;
            boolean much = best.reduced() > Refinement.STRANGE && more && refinement.heldOut(best) > LOUD
                    && !isOneLaw(baseline, base, best);
            chosen = much ? new PairSearch(evidence, search, base, progress).best(best, credible) : chosen;
            if (chosen.fit().candidate().added().size() == 1 && base.reduced() > Refinement.SILENT) {
                chosen = new SecondMechanism(evidence, search, () -> new PairSearch(evidence, search, base, progress))
                        .of(chosen.fit(), much).orElse(chosen);
            }
        }
        progress.accept("proving", 0.9);
        Standing standing = Standing.of(new Fits(evidence, given(baseline), base, chosen, credible));
        Fits fits = standing.fits();
        double heldBefore = refinement.heldOut(base);
        Diagnosed found = new Verdicts(standing, heldBefore, search).diagnosed(() -> places(baseline, base));
        List<Diagnosis.Named> missing = found.diagnosis().missing();
        boolean unlisted = found.diagnosis().verdict() == Diagnosis.Verdict.MISSING_PHYSICS
                && missing.stream().allMatch(named -> named.mechanism().equals(Learned.MECHANISM));
        return unlisted
                ? new LearnedVerdict(fits, heldBefore, refinement).learned(found.diagnosis(), List.of(), missing.get(0).probability())
                : found;
    }

    /** The model with the values that its user gave it. */
    private Fitter.State given(Candidate baseline) {
        return fitter.look(baseline, baseline.start(), evidence.fit());
    }

    private List<Diagnosis.Latent> places(Candidate baseline, Fitter.State base) {
        return new Locator(evidence, baseline).singles(base.x()).stream().map(found -> {
            Place place = found.places().get(0);
            return new Diagnosis.Latent(place.kind().word(), place.name(evidence), found.reduced());
        }).toList();
    }

    /**
     * Fits on a model that stands for a simulation, the best few of them with forces that may go another way than the model's. The others
     * stay as they are: which law it is shows in what it does where it acts, and a way that may differ makes many alike.
     */
    private List<Fitter.State> carried(List<Fitter.State> fits) {
        if (!evidence.standsForSimulation() || fits.isEmpty()) {
            return fits;
        }
        double near = 1 + CARRIED * Refinement.excess(fits.get(0).reduced());
        int count = (int) fits.stream().limit(MOST_CARRIED).filter(fit -> fit.reduced() < near).count();
        List<Fitter.State> out = new ArrayList<>(
                Parallel.map(fits.subList(0, count), fit -> refinement.polish(fit.candidate().withFreeWays(), fit.x())));
        out.addAll(fits.subList(count, fits.size()));
        out.sort(Comparator.comparingDouble(Fitter.State::reduced));
        return out;
    }

    /** Whether one law that is in no library leaves so much less than a name that two of the library are not asked for. */
    private boolean isOneLaw(Candidate baseline, Fitter.State base, Fitter.State name) {
        return !evidence.onRig() && new LawLearner(evidence, search, base, new Locator(evidence, baseline).singles(base.x())).isOne(name);
    }

    /** The best, or a simpler law at the same place that is nearly as good. */
    private static Fitter.State simplest(List<Fitter.State> leaders) {
        Fitter.State best = leaders.get(0);
        Hypothesis first = best.candidate().added().get(0);
        for (Fitter.State other : leaders.subList(1, Math.min(Search.LEADERS, leaders.size()))) {
            Hypothesis rival = other.candidate().added().get(0);
            boolean plainer = first.byTheClock() && !rival.byTheClock() && first.kind().equals(rival.kind());
            if ((plainer || first.kind().yieldsTo(rival)) && rival.where().equals(first.where())
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
