package wbv.diagnosis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.SpectralLines;
import wbv.diagnosis.learn.LawLearner;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.InputLevel;
import wbv.diagnosis.search.PairSearch;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.PushedLaws;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Screening;
import wbv.diagnosis.search.Search;
import wbv.recording.Channel;

/**
 * Evidence with what counts as noise in it, the user's model fitted to that, and the forces that fits leave. What turns out to be a force
 * of its own, or noise of an input, makes another inquiry, which knows of it: the same data, seen through other noise.
 */
final class Inquiry {

    private final Evidence evidence;
    private final Candidate baseline;
    private final Search search;
    private final BiConsumer<String, Double> progress;

    private Inquiry(Evidence evidence, Candidate baseline, BiConsumer<String, Double> progress) {
        this.evidence = evidence;
        this.baseline = baseline;
        this.search = new Search(evidence, progress);
        this.progress = progress;
    }

    /** @param progress told the step and the share of it that is done, 0 to 1 or NaN */
    static Inquiry of(Evidence evidence, BiConsumer<String, Double> progress) {
        Inquiry asked = new Inquiry(evidence, Baseline.of(evidence), progress);
        for (int i = 0; i < Effort.ROUNDS; i++) {
            Optional<Inquiry> quieter = asked.beside(asked.base());
            if (quieter.isEmpty()) {
                return asked;
            }
            asked = quieter.get();
        }
        return asked;
    }

    /** The same with less noise, of a rig, where a fit leaves so little that its outputs' sensors have to be better than they looked. */
    Optional<Inquiry> beside(Fitter.State fit) {
        return evidence.beside(fit).map(quieter -> new Inquiry(quieter, Baseline.of(quieter), progress));
    }

    /** The same where a person's own force counts as noise. */
    Inquiry knowing(BodyForce force) {
        return new Inquiry(evidence.with(force), baseline, progress);
    }

    private record BesidePush(List<Fitter.State> leaders) implements Known.Question<Optional<Diagnosed>> {}

    /** The diagnosis of a mechanism and a force that answers to nothing, found together; empty where they are not, or it is none. */
    Optional<Diagnosed> besidePush(List<Fitter.State> leaders) {
        return evidence.known().once(new BesidePush(leaders), () -> new PushedLaws(evidence, search, base()).best(leaders)
                .flatMap(law -> pushed(law).map(knowing -> Conclusion.of(knowing, knowing.again(List.of(law.fit())))))
                .filter(Diagnosed::namesBesidePush));
    }

    /** The same with a force that was found beside a law: models are simulated with it, and its power counts as noise. */
    private Optional<Inquiry> pushed(PushedLaws.Found law) {
        Evidence knowing = evidence.pushed(law.body(), law.force());
        return Optional.of(BodyForce.known(knowing, seen(knowing, law.fit()), law.body(), law.force()))
                .filter(BodyForce::mayBeIndependent)
                .map(push -> new Inquiry(knowing.with(evidence.acting().withPush(Optional.of(push))), baseline, progress));
    }

    /** The same where noise of the input counts too of which nobody knew, as far as a fit leaves it; itself where nothing shows any. */
    Inquiry hearingInput(Fitter.State fit) {
        boolean open = !evidence.measured().isInputNoiseKnown() && evidence.heard().isEmpty();
        Map<Channel, Double> levels = open ? new InputLevel(evidence).of(fit) : Map.of();
        return levels.isEmpty() ? this : new Inquiry(evidence.with(levels), baseline, progress);
    }

    /**
     * The same where noise of the input of which nobody knew is all that is left: no more than noise, of which no law promises to leave
     * less. Then none need be fitted.
     */
    Optional<Inquiry> hearingInputAlone() {
        return Optional.of(hearingInput(base())).filter(hearing -> hearing != this)
                .filter(hearing -> seen(hearing.evidence, base()).reduced() < Priors.LOUD)
                .filter(hearing -> hearing.leaves(hearing.base(), Priors.SILENT) && !hearing.isAnyPromising());
    }

    /** Whether a law promises to first order to leave so much less that it would be likelier than none. */
    private boolean isAnyPromising() {
        Fitter.State fit = base();
        double degrees = fit.frame().whitening().degrees();
        return new Screening(evidence, fit, Motion.measured(evidence, fit.candidate().at(fit.x()))).scores(search.hypotheses(fit)).stream()
                .anyMatch(score -> !Calibration.standard().isAsLikely(fit.reduced(), (fit.square() - score.gain()) / degrees));
    }

    Evidence evidence() {
        return evidence;
    }

    Candidate baseline() {
        return baseline;
    }

    Search search() {
        return search;
    }

    Refinement refinement() {
        return search.refinement();
    }

    BiConsumer<String, Double> progress() {
        return progress;
    }

    PairSearch pairs() {
        return new PairSearch(evidence, search, base(), progress);
    }

    /** The user's model with fitted values and nothing added. */
    Fitter.State base() {
        return search.base(baseline);
    }

    /** Whether one law at one place does what a single mechanism does not, see {@link LawLearner#isOne}. */
    boolean isOneLaw(Fitter.State name) {
        return LawLearner.isOne(evidence, base(), name);
    }

    /** The model with the values that its user gave it. */
    Fitter.State given() {
        return search.fitter().look(baseline, baseline.start(), evidence.fit());
    }

    /** What a fit leaves of data not used. */
    double heldOut(Fitter.State fit) {
        return refinement().heldOut(fit);
    }

    /** Whether a fit leaves less than that, on data not used for it too. */
    boolean leaves(Fitter.State fit, double most) {
        return fit.reduced() < most && heldOut(fit) < most;
    }

    /** Fits seen again through the noise that this knows of, least first. */
    List<Fitter.State> again(List<Fitter.State> fits) {
        return search.again(base(), fits);
    }

    /**
     * What a person who sits still does of what a fit leaves, whatever is known of that already. On a body on the base it cannot be told
     * from noise of the base's sensor, which enters there at one level as well.
     */
    Optional<BodyForce> own(Fitter.State fit) {
        return aboveBase(fit).filter(force -> force.ordinary(evidence));
    }

    /**
     * Whether what was taken for a person's own force, where a model had bent itself for what is missing, is more than that beside a fit:
     * stronger, or in answer to the ride.
     */
    boolean isMoreThanOwn(Fitter.State fit) {
        return aboveBase(fit).filter(force -> !force.ordinary(evidence) || force.coherent()).isPresent();
    }

    private Optional<BodyForce> aboveBase(Fitter.State fit) {
        Evidence plain = evidence.with(evidence.acting().withOwn(Optional.empty()));
        return BodyForce.aboveBase(plain, seen(plain, fit));
    }

    /** A force of more than that, which does not answer to the ride, that a fit leaves, whatever is known of one already. */
    Optional<BodyForce> push(Fitter.State fit) {
        return pushLeft(evidence, fit).filter(force -> force.independent() && !force.coherent() && !force.ordinary(evidence));
    }

    /** The same beside a single mechanism, where no two mechanisms take what is left. */
    Optional<BodyForce> pushBeside(Fitter.State single) {
        return push(single).filter(push -> !pairs().isEnough(single));
    }

    private static Optional<BodyForce> pushLeft(Evidence knowing, Fitter.State fit) {
        Evidence plain = knowing.with(knowing.acting().withPush(Optional.empty()));
        return BodyForce.onAnyBody(plain, seen(plain, fit));
    }

    private static Fitter.State seen(Evidence through, Fitter.State fit) {
        return new Fitter(through).look(fit.candidate(), fit.x(), through.fit());
    }

    /**
     * The same where what a person does who sits still counts as noise, if that is all that is left: no more than noise on smooth stretches
     * and on rough ones alike, or nothing of which a law promises to leave less.
     */
    Optional<Inquiry> knowingWhoSitsStill() {
        // A tone would be taken for a part of a force that has all frequencies.
        return SpectralLines.standOut(base().residual(), evidence.fit()) ? Optional.empty()
                : own(base()).flatMap(force -> Optional.of(knowing(force)).filter(knowing -> {
                    boolean steady = force.following().isSteady() && knowing.leaves(knowing.base(), Priors.NOISE);
                    return steady || !force.coherent() && knowing.leaves(knowing.base(), Priors.SILENT) && !knowing.isAnyPromising();
                }));
    }

    /** A strong force of its own that is left without any mechanism. */
    Optional<BodyForce> push() {
        return base().reduced() > Priors.STRANGE ? BodyForce.onAnyBody(evidence, base()).filter(BodyForce::independent) : Optional.empty();
    }

    /** Whether a push is all that is missing. */
    boolean isPush() {
        return push().filter(push -> Pushes.isAll(evidence, base(), push)).isPresent();
    }

    /**
     * The diagnosis that knows of a strong push, where it names a mechanism beside it, and leaves the push: what is left beside that has to
     * be more than the push scatters by itself.
     *
     * @param ask what makes it of the inquiry that knows
     */
    Optional<Diagnosed> besideKnown(BodyForce push, Function<Inquiry, Diagnosed> ask) {
        return Optional.of(ask.apply(knowing(push))).filter(found -> isBeside(push, found));
    }

    private boolean isBeside(BodyForce push, Diagnosed found) {
        double known = found.evidence.acting().push().map(BodyForce::rms).orElse(Double.NaN);
        return found.namesBesidePush() && found.base.reduced() - 1 > Priors.SCATTER * (base().reduced() - 1)
                && pushLeft(found.evidence, found.chosen)
                        .filter(force -> force.body() == push.body() && force.rms() > Priors.MAJORITY * known).isPresent();
    }
}
