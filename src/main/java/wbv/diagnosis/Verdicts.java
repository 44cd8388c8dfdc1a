package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Mechanism;
import wbv.diagnosis.mechanism.UnmeasuredForce;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.OddSensor;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;
import wbv.recording.Quantity;

/** Turns fits into a diagnosis: a verdict with its probability, values with their deviations, where, how well, and what would settle it. */
final class Verdicts {

    /** Part of a push, in root mean square, that is left beside a mechanism if it is not what the mechanism did [1]. */
    static final double REMAINS = 0.5;

    /** From here on a mismatch is plain, whatever the rest of the recording shows. */
    private static final double PLAIN = 1.5;
    /** Part of the best output that the input has to explain, on data not used, before anything is said of what it leaves. */
    static final double CAUSED = 0.5;
    private static final double LEAST_GAIN = 80;
    private static final double LEAST_SHARE = 0.5;
    /**
     * What a mechanism must take off the mean square of the residual, in units of the noise; less is in the reach of second-order effects.
     */
    private static final double LEAST_DROP = 0.1;
    private static final double CARRIED_OVER = 0.72;
    /**
     * On a rig what is left is chatter and the form of the law as often as missing physics: what went says more, if it went on unseen data
     * too.
     */
    private static final double RIG_SHARE = 0.4;
    private static final double RIG_HELD = 0.75;
    /** How sure a name is that leaves too much, at most. */
    private static final double UNSURE = 0.4;
    /** How sure a late sensor can be: its delay may be one of those that sensors have. */
    private static final double IMITATED = 0.75;
    /** How much of the mean square the small errors of one sensor take where they are found anew. */
    private static final double FOUND_ANEW = 0.02;

    private final Evidence evidence;
    private final Fitter.State given;
    private final Fitter.State base;
    private final double heldBefore;
    private final Fitter.State best;
    private final Search search;
    private final Refinement refinement;
    private final double heldAfter;
    private final MassScale scale;
    private final Standing standing;
    private final Presentation shown;
    private final VerdictWords words;

    /** @param heldBefore what the fitted model without anything found leaves on data not used */
    Verdicts(Standing standing, double heldBefore, Search search) {
        Fits fits = standing.fits();
        this.evidence = fits.evidence();
        this.given = fits.given();
        this.base = fits.base();
        this.heldBefore = heldBefore;
        this.best = fits.best();
        this.search = search;
        this.refinement = search.refinement();
        this.standing = standing;
        this.shown = new Presentation(fits, heldBefore, refinement);
        this.scale = shown.scale();
        this.words = new VerdictWords(fits, heldBefore, scale);
        this.heldAfter = best == base ? heldBefore : refinement.heldOut(best);
    }

    /**
     * One way to see a mismatch.
     *
     * @param fit    what explains it, or the base
     * @param scale of its masses
     * @param rivals what else might be
     * @param where  places that could carry it, where no name is good enough
     * @param ending of the sentence
     */
    private record Finding(Diagnosis.Verdict verdict, Fitter.State fit, MassScale scale, List<Diagnosis.Named> missing,
            List<Diagnosis.Named> rivals, List<Diagnosis.Latent> where, String ending) {}

    /** @param locate finds the places that could carry the mismatch; asked only where no name is good enough */
    Diagnosed diagnosed(Supplier<List<Diagnosis.Latent>> locate) {
        boolean named = isNamed();
        Finding sought = pushed(named).or(() -> named ? named(locate) : imitated().or(this::lateSensor)).orElseGet(() -> nothing(locate));
        double caused = new SeenErrors(evidence).explained(sought.fit());
        boolean idle = caused < CAUSED;
        Finding found = idle ? cannotTell(words.notCaused(caused)) : sought;
        List<Diagnosis.Named> missing = new ArrayList<>(idle ? List.of() : new PlainFaults(evidence).in(base, best));
        boolean plain = !missing.isEmpty() && (found.verdict().isQuiet() || found.verdict() == Diagnosis.Verdict.CANNOT_TELL);
        missing.addAll(found.missing());
        Diagnosis.Verdict verdict = plain ? Diagnosis.Verdict.MISSING_PHYSICS : found.verdict();
        return shown.of(found.fit(), found.scale(), model -> new Diagnosis(verdict,
                words.sentence(verdict, missing, found.ending(), found.verdict() == Diagnosis.Verdict.CANNOT_TELL),
                new Mismatch(evidence, base).located(), missing,
                found.rivals(), experiment(verdict, missing, found.rivals(), idle), shown.figures(found.fit()), found.where(), model,
                Optional.empty()));
    }

    /** Whether the best hypothesis takes enough away, here and from data not used, to be worth a name. */
    private boolean isNamed() {
        double drop = base.reduced() - best.reduced();
        return best != base && foretells(best) && standing.explained() > (evidence.onRig() ? RIG_SHARE : LEAST_SHARE) && drop > LEAST_DROP
                && drop * degrees() > LEAST_GAIN && (evidence.onRig() || heldBefore - heldAfter > LEAST_DROP / 2)
                // So near to the noise only a name without a rival is a finding.
                && (heldBefore > Refinement.SILENT || standing.reading().verdict() == DecisionRule.Verdict.MISSING_PHYSICS);
    }

    /**
     * Whether a fit with more in it does better than the base on data that neither has seen, with the sensors' errors as they were found on
     * data that both have: those are the errors that are reported.
     */
    private boolean foretells(Fitter.State fit) {
        SeenErrors errors = new SeenErrors(evidence);
        return errors.of(fit) < errors.of(base);
    }

    /** A force that nobody measured, where no mechanism takes the mismatch. */
    private Optional<Finding> pushed(boolean named) {
        if (named && isTaken(base.reduced(), best.reduced()) || base.reduced() < Refinement.STRANGE) {
            return Optional.empty();
        }
        return BodyForce.in(evidence, base, !named).filter(BodyForce::independent).map(force -> {
            double p = named ? Math.max(0.5, 1 - standing.explained()) : force.following().isTold() ? 0.9 : 0.6;
            List<Diagnosis.Named> rivals = standing.rivals(1 - p);
            return new Finding(Diagnosis.Verdict.MISSING_PHYSICS, base, scale, List.of(push(force, scale, p)), rivals, List.of(),
                    words.ending(force.carried(), 0, rivals));
        });
    }

    /**
     * Whether a name takes a mismatch that a force of its own might make. Such a force, arbitrary as it is, leaves nothing of it; but where
     * each line has x times the noise's power, of which a name explains a part η, the name gains ηx, and whatever process gains x - ln(1 +
     * x). And what a name takes most of is no force of its own, whatever the name leaves.
     *
     * @param without mean square of the whitened residual that the model without the name leaves
     * @param with that the name leaves
     */
    static boolean isTaken(double without, double with) {
        return with - 1 < Math.max(REMAINS * REMAINS * (without - 1), Math.log(without));
    }

    /** What the model's own numbers nearly imitate. */
    private Optional<Finding> imitated() {
        return base.reduced() > Refinement.SILENT ? Optional.empty() : new Imitations(evidence, search).in(base).map(found -> {
            DecisionRule.Reading reading = new DecisionRule(Priors.USUAL).read(found.posterior());
            Values values = new Values(evidence, found.fits().get(0));
            Diagnosis.Named first = values.named(found.fits().get(0).candidate().last(),
                    found.posterior().of(Standing.claim(found.fits().get(0))));
            // What would be said without it first.
            List<Diagnosis.Named> rivals = new ArrayList<>(List.of(found.asNumbers(base)));
            rivals.addAll(Standing.named(found.fits(), found.posterior(), Standing.claim(found.fits().get(0))));
            return new Finding(reading.names() > 1 ? Diagnosis.Verdict.AMBIGUOUS : Diagnosis.Verdict.MISSING_PHYSICS, values.fit(),
                    values.scale(), List.of(first), rivals, List.of(), words.imitating(rivals.get(0)));
        });
    }

    /** A sensor that is later than sensors scatter. */
    private Optional<Finding> lateSensor() {
        return new OddSensor(evidence, refinement).in(base)
                // In the mean square the base's errors are found anew where it is taken, and a fault's size is not.
                .filter(fit -> refinement.heldOut(fit) < heldBefore + FOUND_ANEW && isQuiet(fit.reduced(), refinement.heldOut(fit))
                        && foretells(fit))
                .map(fit -> {
                    Values values = new Values(evidence, fit);
                    return new Finding(Diagnosis.Verdict.MISSING_PHYSICS, values.fit(), values.scale(),
                            List.of(values.named(fit.candidate().last(), IMITATED)), List.of(), List.of(), ".");
                });
    }

    /** No name: nothing to find, nothing found, or not even that. */
    private Finding nothing(Supplier<List<Diagnosis.Latent>> locate) {
        boolean quiet = base.reduced() < Refinement.SILENT;
        boolean heldQuiet = heldBefore < Refinement.SILENT;
        if (isQuiet(base.reduced(), heldBefore)) {
            boolean right = given.reduced() < 1.12 * base.reduced() + 0.05 && isQuiet(given.reduced(), refinement.heldOut(given));
            return new Finding(right ? Diagnosis.Verdict.NOTHING_MISSING : Diagnosis.Verdict.PARAMETERS_ONLY, base, scale, List.of(),
                    List.of(), List.of(), words.counting());
        }
        if (quiet || heldQuiet || Math.max(base.reduced(), heldBefore) < Refinement.STRANGE) {
            return cannotTell(words.cannotTell(quiet == heldQuiet ? "more than noise leaves, and too little for any mechanism to stand out"
                    : "a law acts in both, an event in one only"));
        }
        List<Diagnosis.Latent> places = locate.get();
        return new Finding(Diagnosis.Verdict.UNEXPLAINED, base, scale, List.of(), standing.rivals(0.1), places, words.entering(places));
    }

    /**
     * Whether a model as its user gave it may turn out to lack nothing.
     *
     * @param given it on what is fitted
     */
    static boolean mayBeRight(Fitter.State given) {
        return given.reduced() < PLAIN;
    }

    /**
     * Whether both windows together show nothing, and neither by itself shows something plain.
     *
     * @param fit what the window fitted leaves
     * @param held the other
     */
    private boolean isQuiet(double fit, double held) {
        double all = evidence.fit().length() + evidence.heldOut().length();
        return (evidence.fit().length() * fit + evidence.heldOut().length() * held) / all < Refinement.SILENT
                && Math.max(fit, held) < PLAIN;
    }

    private Finding cannotTell(String ending) {
        return new Finding(Diagnosis.Verdict.CANNOT_TELL, base, scale, List.of(), List.of(), List.of(), ending);
    }

    /** Whether a rotation about an axis across the model's was recorded. */
    private boolean turned() {
        return evidence.recording().channels().stream()
                .anyMatch(channel -> channel.quantity() == Quantity.ANGULAR_RATE && channel.axis() != evidence.model().axis());
    }

    private String experiment(Diagnosis.Verdict verdict, List<Diagnosis.Named> missing, List<Diagnosis.Named> rivals, boolean idle) {
        return idle ? Experiments.CAUSE : verdict == Diagnosis.Verdict.CANNOT_TELL ? Experiments.AGAIN
                : new Experiments(evidence.library()).between(missing, rivals, atBase(), scale.deviation() > 0, turned());
    }

    /**
     * The mechanisms of the best hypothesis; not by name alone where they leave too much, and not at all where all of it may as well be
     * nothing.
     */
    private Optional<Finding> named(Supplier<List<Diagnosis.Latent>> locate) {
        double p = standing.probability();
        // What fits best at a bound that nothing real has is something else.
        DecisionRule.Reading reading = standing.reading();
        boolean poor = reading.isUnknown()
                || (evidence.onRig() ? heldAfter > RIG_HELD * heldBefore : !carriesOver() || Search.extreme(best));
        Values values = new Values(evidence, best);
        Map<Hypothesis, Diagnosis.Named> claimed = new LinkedHashMap<>();
        double most = poor ? UNSURE : 1;
        best.candidate().added().stream().sorted(Comparator.comparingInt(standing::rankAlone))
                .forEach(hypothesis -> claimed.put(hypothesis,
                        values.named(hypothesis, Math.min(most, standing.probability(hypothesis))).with(standing.numbers())));
        if (claimed.entrySet().stream().allMatch(each -> mayBeNothing(each.getKey(), each.getValue()))) {
            return Optional.empty();
        }
        List<Diagnosis.Named> missing = new ArrayList<>(claimed.values());
        evidence.bodyForce().filter(push -> !poor && !push.ordinary(evidence))
                .ifPresent(push -> missing.add(push(push, values.scale(), p)));
        List<Diagnosis.Named> rivals = standing.rivals(1 - p);
        List<Diagnosis.Latent> places = poor ? locate.get() : List.of();
        return Optional.of(new Finding(
                poor ? Diagnosis.Verdict.UNEXPLAINED
                        : reading.names() > 1 ? Diagnosis.Verdict.AMBIGUOUS : Diagnosis.Verdict.MISSING_PHYSICS,
                values.fit(), values.scale(), missing, rivals, places,
                poor ? words.entering(places) : words.ending(standing.explained(), standing.numbers(), rivals)));
    }

    /** Whether a sensor's fault may be none by all that is told of its size: what may be nothing is not named. */
    private static boolean mayBeNothing(Hypothesis hypothesis, Diagnosis.Named named) {
        List<Hypothesis.Number> told = hypothesis.numbers().stream().filter(number -> named.intervals().containsKey(number.key())).toList();
        return hypothesis.kind().family() == Family.SENSOR && !told.isEmpty()
                && told.stream().allMatch(number -> number.unit() > 0 && named.intervals().get(number.key()).contains(number.nothing()));
    }

    /**
     * A force that nobody measured, as a finding.
     *
     * @param masses their scale
     */
    private Diagnosis.Named push(BodyForce force, MassScale masses, double probability) {
        double rms = masses.factor() * force.rms();
        return new Diagnosis.Named(new UnmeasuredForce().word(), evidence.model().bodies().get(force.body()).name(), probability,
                Map.of("rms_N", rms), Map.of("rms_N", Interval.normal(rms, masses.deviation() * force.rms())), base.reduced());
    }

    /** Whether a diagnosis names a push and a mechanism beside it. */
    static boolean namesBesidePush(Diagnosed found) {
        List<Mechanism> named = found.diagnosis().missing().stream().flatMap(one -> found.evidence.library().of(one.mechanism()).stream())
                .toList();
        return named.stream().anyMatch(one -> one.family() == Family.FORCE)
                && named.stream().anyMatch(one -> one.family() != Family.FORCE && !one.showsWithoutFit());
    }

    /** The link on the base and the body on it. */
    private Set<String> atBase() {
        Set<String> out = new HashSet<>();
        evidence.model().links().stream().filter(link -> link.from().equals(evidence.model().base().name())).forEach(link -> {
            out.add(link.name());
            out.add(link.to());
        });
        return out;
    }

    private int degrees() {
        return base.frame().whitening().degrees();
    }

    /** Whether data not used for the fit are explained about as well: a wrong law with enough freedom follows only what it has seen. */
    private boolean carriesOver() {
        return heldBefore < Refinement.STRANGE || (heldBefore - heldAfter) / (heldBefore - 1) > CARRIED_OVER * standing.explained();
    }
}
