package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.Learned;
import wbv.body.Model;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.mechanism.Mechanism;
import wbv.diagnosis.mechanism.UnmeasuredForce;
import wbv.recording.Quantity;

/** Turns fits into a diagnosis: a verdict with its probability, values with their deviations, where, how well, and what would settle it. */
final class Verdicts {

    /**
     * Below this much of the noise nothing is missing that a recording could show: of 107 recordings in which nothing was concealed, with sensors and
     * sitters as they are, the fits leave 1.02 with a standard deviation of 0.03 (rig) to 0.05 (road) and never more than 1.13, on either window.
     */
    static final double SILENT = 1.2;
    /** From here on a mismatch is plain, whatever the rest of the recording shows. */
    private static final double PLAIN = 1.5;
    /** What is more cannot be the noise by any chance. */
    static final double STRANGE = 3;
    /** Part of the best output that the input has to explain, on data not used, before anything is said of what it leaves. */
    private static final double CAUSED = 0.5;
    private static final double LEAST_GAIN = 80;
    private static final double LEAST_SHARE = 0.5;
    /** What a mechanism must take off the mean square of the residual, in units of the noise; less is in the reach of second-order effects. */
    private static final double LEAST_DROP = 0.1;
    private static final double UNEXPLAINED = 4;
    private static final double WELL_EXPLAINED = 0.72;
    private static final double CARRIED_OVER = 0.72;
    /** On a rig what is left is chatter and the form of the law as often as missing physics: what went says more, if it went on unseen data too. */
    private static final double RIG_SHARE = 0.4;
    private static final double RIG_HELD = 0.75;
    private static final double NEAR = 0.5;
    /** What is less likely is no finding. */
    private static final double LIKELY = 0.5;
    /** How sure a name is that leaves too much, at most. */
    private static final double UNSURE = 0.4;
    /** How sure what nearly imitates a spring and a damper can be: the number may have been given wrong after all. */
    private static final double IMITATED = 0.75;
    /** How much of the mean square the small errors of one sensor take where they are found anew. */
    private static final double FOUND_ANEW = 0.02;
    private final Fits fits;
    private final Evidence evidence;
    private final Fitter.State given;
    private final Fitter.State base;
    private final double heldBefore;
    private final Fitter.State best;
    private final List<Fitter.State> leaders;
    private final Refinement refinement;
    private final double heldAfter;
    private final MassScale scale;

    /** @param heldBefore what the fitted model without anything found leaves on data not used */
    Verdicts(Fits fits, double heldBefore, Refinement refinement) {
        this.fits = fits;
        this.evidence = fits.evidence();
        this.given = fits.given();
        this.base = fits.base();
        this.heldBefore = heldBefore;
        this.best = fits.best();
        this.leaders = fits.leaders();
        this.refinement = refinement;
        this.scale = MassScale.of(evidence, base);
        this.heldAfter = best == base ? heldBefore : refinement.heldOut(best);
    }

    /**
     * One way to see a mismatch.
     *
     * @param fit    what explains it, or the base @param scale of its masses @param rivals what else might be
     * @param where  places that could carry it, where no name is good enough @param ending of the sentence
     */
    private record Finding(Diagnosis.Verdict verdict, Fitter.State fit, MassScale scale, List<Diagnosis.Named> missing,
                           List<Diagnosis.Named> rivals, List<Diagnosis.Latent> where, String ending) { }

    /** @param locate finds the places that could carry the mismatch; asked only where no name is good enough */
    Diagnosed diagnosed(Supplier<List<Diagnosis.Latent>> locate) {
        boolean named = isNamed();
        Finding sought = pushed(named).or(() -> named ? Optional.of(named(locate)) : imitated().or(this::lateSensor)).orElseGet(() -> nothing(locate));
        double caused = new SeenErrors(evidence).explained(sought.fit());
        boolean idle = caused < CAUSED;
        Finding found = idle ? notCaused(caused) : sought;
        List<Diagnosis.Named> missing = new ArrayList<>(idle ? List.of() : new PlainFaults(evidence).in(base, best));
        boolean plain = !missing.isEmpty() && (found.verdict().isQuiet() || found.verdict() == Diagnosis.Verdict.CANNOT_TELL);
        missing.addAll(found.missing());
        Diagnosis.Verdict verdict = plain ? Diagnosis.Verdict.MISSING_PHYSICS : found.verdict();
        return shown(found.fit(), found.scale(), model -> new Diagnosis(verdict,
                sentence(verdict, missing, found.ending(), found.verdict() == Diagnosis.Verdict.CANNOT_TELL), new Mismatch(evidence, base).located(), missing,
                found.rivals(), experiment(verdict, missing, found.rivals(), idle), fit(found.fit()), found.where(), model, Optional.empty()));
    }

    /**
     * What is shown and written has the scale that all masses tell; what is simulated is the same.
     *
     * @param fit of what was found @param masses the scale of it @param diagnosis of the model at that scale
     */
    private Diagnosed shown(Fitter.State fit, MassScale masses, Function<Model, Diagnosis> diagnosis) {
        Fitter.State before = scale.applied(base);
        Fitter.State chosen = fit == base ? before : masses.applied(fit);
        Evidence seen = evidence.bodyForce().map(force -> evidence.with(force.scaled(masses.factor()))).orElse(evidence);
        return new Diagnosed(diagnosis.apply(Augmented.of(evidence.model(), chosen.candidate().at(chosen.x()))), fits.with(fit), seen, before, chosen);
    }

    private Diagnosis.Fit fit(Fitter.State chosen) {
        return new FitFigures(fits, heldBefore).of(chosen, chosen == base ? heldBefore : refinement.heldOut(chosen));
    }

    /**
     * The diagnosis where the best fit holds a law that was learned.
     *
     * @param refused what was said without it @param rivals other laws @param probability of this one against them
     */
    Diagnosed learned(Diagnosis refused, List<Diagnosis.LearnedLaw.Rival> rivals, double probability) {
        Values values = new Values(evidence, best);
        String where = best.candidate().last().where();
        Map<String, Double> numbers = new LinkedHashMap<>();
        Map<String, Interval> intervals = new LinkedHashMap<>();
        for (Hypothesis term : best.candidate().added()) {
            Diagnosis.Named named = values.named(term, probability);
            named.parameters().forEach((key, value) -> numbers.put(distinct(key, term), value));
            named.intervals().forEach((key, value) -> intervals.put(distinct(key, term), value));
        }
        List<Diagnosis.Named> missing = new ArrayList<>(new PlainFaults(evidence).in(base, best));
        missing.add(new Diagnosis.Named(Learned.MECHANISM, where, probability, numbers, intervals, values.fit().reduced()));
        return shown(values.fit(), values.scale(), model -> {
            LearnedWords words = new LearnedWords(model, where);
            return new Diagnosis(Diagnosis.Verdict.LEARNED_LAW, String.format(Locale.ROOT,
                    "Something is missing in the link %s that is not in the library. Its law was learned: %s. %s of what was missing on data not used went with it.",
                    where, words.formula(), Phrases.percent(gone(heldBefore))), new Mismatch(evidence, base).located(), missing,
                    Stream.concat(refused.missing().stream(), refused.verdict() == Diagnosis.Verdict.MISSING_PHYSICS ? refused.alternatives().stream() : Stream.empty())
                            .filter(name -> missing.stream().noneMatch(own -> own.mechanism().equals(name.mechanism())))
                            .map(name -> name.at(Math.min(name.probability(), 1 - probability))).toList(),
                    words.experiment(), fit(values.fit()), refused.latent(), model,
                    Optional.of(new Diagnosis.LearnedLaw(where, words.formula(), words.terms(), rivals)));
        });
    }

    /**
     * The diagnosis of mechanisms one of which has another form than the library's: what it does beside that was learned, and stands beside its name.
     *
     * @param named what was said without it @param held what it leaves on data not used without it @param rivals other corrections
     */
    Diagnosed corrected(Diagnosis named, double held, List<Diagnosis.LearnedLaw.Rival> rivals) {
        Values values = new Values(evidence, best);
        String where = best.candidate().last().where();
        List<Diagnosis.Named> missing = named.missing().stream().map(one -> best.candidate().added().stream()
                .filter(part -> part.mechanism().equals(one.mechanism()) && part.where().equals(one.where())).findFirst()
                .map(part -> values.named(part, one.probability())).orElse(one)).toList();
        return shown(values.fit(), values.scale(), model -> {
            LearnedWords words = new LearnedWords(model, where);
            return new Diagnosis(named.verdict(), sentence(named.verdict(), missing, ending(explained(), named.alternatives()), false) + String.format(Locale.ROOT,
                    " In %s it has not quite the library's form: %s beside it takes %s of what it leaves on data not used.", where, words.formula(),
                    Phrases.percent(gone(held))), named.located(), missing, named.alternatives(), named.nextExperiment(), fit(values.fit()), named.latent(), model,
                    Optional.of(new Diagnosis.LearnedLaw(where, words.formula(), words.terms(), rivals)));
        });
    }

    /** Part of what was left on data not used that goes with the best. */
    private double gone(double held) {
        return Math.max(0, Math.min(1, (held - heldAfter) / (held - 1)));
    }

    /** A number of a term by a key of its own, where several terms have one like it. */
    private static String distinct(String key, Hypothesis term) {
        return key.contains(" of ") ? key : key + " of " + term.form();
    }

    /** Whether the best hypothesis takes enough away, here and from data not used, to be worth a name. */
    private boolean isNamed() {
        double drop = base.reduced() - best.reduced();
        return best != base && foretells(best) && explained() > (evidence.onRig() ? RIG_SHARE : LEAST_SHARE) && drop > LEAST_DROP && drop * degrees() > LEAST_GAIN
                && (evidence.onRig() || heldBefore - heldAfter > LEAST_DROP / 2)
                // So near to the noise only a name without a rival is a finding.
                && (heldBefore > SILENT || rivalry() > NEAR);
    }

    /**
     * Whether a fit with more in it does better than the base on data that neither has seen, with the sensors' errors as they were found on data
     * that both have: those are the errors that are reported.
     */
    private boolean foretells(Fitter.State fit) {
        SeenErrors errors = new SeenErrors(evidence);
        return errors.of(fit) < errors.of(base);
    }

    /** A force that nobody measured, where no mechanism leaves little. */
    private Optional<Finding> pushed(boolean named) {
        if (named && best.reduced() < UNEXPLAINED || base.reduced() < STRANGE) {
            return Optional.empty();
        }
        return BodyForce.in(evidence, base, !named).filter(BodyForce::independent).map(force -> {
            double p = named ? Math.max(0.5, 1 - explained()) : force.following().isTold() ? 0.9 : 0.6;
            List<Diagnosis.Named> rivals = rivals(1 - p, p);
            return new Finding(Diagnosis.Verdict.MISSING_PHYSICS, base, scale, List.of(push(force, scale, p)), rivals, List.of(),
                    ending(force.carried(), rivals));
        });
    }

    /** A mechanism that a link's number, odd where all others are as given, nearly makes up for. */
    private Optional<Finding> imitated() {
        if (evidence.onRig() || base.reduced() > STRANGE) {
            return Optional.empty();
        }
        return OddLink.in(base).flatMap(link -> link.explained(evidence, base).filter(fit -> refinement.heldOut(fit) < heldBefore && foretells(fit)).map(fit -> {
            Values values = new Values(evidence, fit);
            return new Finding(Diagnosis.Verdict.MISSING_PHYSICS, values.fit(), values.scale(), List.of(values.named(fit.candidate().last(), IMITATED)),
                    List.of(link.asNumber(base, 1 - IMITATED)), List.of(), link.words());
        }));
    }

    /** A sensor that is later than sensors scatter. */
    private Optional<Finding> lateSensor() {
        return base.reduced() > SILENT ? Optional.empty() : new OddSensor(evidence, refinement).in(base)
                // In the mean square the base's errors are found anew where it is taken, and a fault's size is not.
                .filter(fit -> refinement.heldOut(fit) < heldBefore + FOUND_ANEW && foretells(fit)).map(fit -> {
                    Values values = new Values(evidence, fit);
                    return new Finding(Diagnosis.Verdict.MISSING_PHYSICS, values.fit(), values.scale(), List.of(values.named(fit.candidate().last(), IMITATED)),
                            List.of(), List.of(), ".");
                });
    }

    /** No name: nothing to find, nothing found, or not even that. */
    private Finding nothing(Supplier<List<Diagnosis.Latent>> locate) {
        boolean quiet = base.reduced() < SILENT;
        boolean heldQuiet = heldBefore < SILENT;
        if (isQuiet(base.reduced(), heldBefore)) {
            boolean right = given.reduced() < 1.12 * base.reduced() + 0.05 && isQuiet(given.reduced(), refinement.heldOut(given));
            return new Finding(right ? Diagnosis.Verdict.NOTHING_MISSING : Diagnosis.Verdict.PARAMETERS_ONLY, base, scale, List.of(), List.of(), List.of(),
                    counting());
        }
        if (quiet || heldQuiet || Math.max(base.reduced(), heldBefore) < STRANGE) {
            return cannotTell(quiet == heldQuiet ? "more than noise leaves, and too little for any mechanism to stand out" : "a law acts in both, an event in one only");
        }
        return new Finding(Diagnosis.Verdict.UNEXPLAINED, base, scale, List.of(), rivals(0.1, 1), locate.get(), ".");
    }

    /** Whether both windows together show nothing, and neither by itself shows something plain. @param fit what the window fitted leaves @param held the other */
    private boolean isQuiet(double fit, double held) {
        double all = evidence.fit().length() + evidence.heldOut().length();
        return (evidence.fit().length() * fit + evidence.heldOut().length() * held) / all < SILENT && Math.max(fit, held) < PLAIN;
    }

    private Finding cannotTell(String why) {
        double rate = evidence.recording().clock().rate();
        Window fit = evidence.fit();
        Window held = evidence.heldOut();
        return new Finding(Diagnosis.Verdict.CANNOT_TELL, base, scale, List.of(), List.of(), List.of(), String.format(Locale.ROOT,
                "the model leaves %.3g times the noise from %.0f to %.0f s, to which it was fitted, and %.3g times from %.0f to %.0f s: %s.", base.reduced(),
                fit.start() / rate, (fit.start() + fit.length()) / rate, heldBefore, held.start() / rate, (held.start() + held.length()) / rate, why));
    }

    /** Where the input does not move what was measured, neither what fits nor what does not says anything of the model. @param caused part of the best output */
    private Finding notCaused(double caused) {
        return new Finding(Diagnosis.Verdict.CANNOT_TELL, base, scale, List.of(), List.of(), List.of(), String.format(Locale.ROOT,
                "on data not used, %s explains %s of what the best of the sensors measured, whatever the model; at least %.0f %% is needed.",
                evidence.model().excitations().get(0), caused > 0 ? Phrases.percent(caused) : "nothing", 100 * CAUSED));
    }

    /** What the noise holds beside that of sensors, to end a sentence. */
    private String counting() {
        return evidence.bodyForce().map(force -> String.format(Locale.ROOT, " (%.2g N rms of the sitter's own force on %s count as noise).",
                scale.factor() * force.rms(), evidence.model().bodies().get(force.body()).name())).orElse(".");
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

    /** The mechanisms of the best hypothesis; not by name alone where they leave too much. */
    private Finding named(Supplier<List<Diagnosis.Latent>> locate) {
        double rivalry = rivalry();
        double p = probability(rivalry);
        // What fits best at a bound that nothing real has is something else.
        boolean poor = evidence.onRig() ? heldAfter > RIG_HELD * heldBefore || p < LIKELY && rivalry >= NEAR : explained() < WELL_EXPLAINED || !carriesOver() || Search.extreme(best);
        Values values = new Values(evidence, best);
        List<Diagnosis.Named> missing = new ArrayList<>();
        double held = poor ? Math.min(p, UNSURE) : p;
        best.candidate().added().stream().sorted(Comparator.comparingInt(this::rankAlone)).forEach(hypothesis -> missing.add(values.named(hypothesis, held)));
        evidence.bodyForce().filter(push -> !poor && !push.ordinary(evidence)).ifPresent(push -> missing.add(push(push, values.scale(), p)));
        List<Diagnosis.Named> rivals = rivals(1 - p, held);
        return new Finding(poor ? Diagnosis.Verdict.UNEXPLAINED : rivalry < NEAR ? Diagnosis.Verdict.AMBIGUOUS : Diagnosis.Verdict.MISSING_PHYSICS,
                values.fit(), values.scale(), missing, rivals, poor ? locate.get() : List.of(), ending(explained(), rivals));
    }

    /** How credible a hypothesis is by itself: what explains more is said first, whichever was added first. */
    private int rankAlone(Hypothesis hypothesis) {
        return IntStream.range(0, leaders.size()).filter(i -> leaders.get(i).candidate().added().stream()
                .allMatch(alone -> alone.mechanism().equals(hypothesis.mechanism()) && alone.where().equals(hypothesis.where())))
                .findFirst().orElse(leaders.size());
    }

    /** A force that nobody measured, as a finding. @param masses their scale */
    private Diagnosis.Named push(BodyForce force, MassScale masses, double probability) {
        double rms = masses.factor() * force.rms();
        return new Diagnosis.Named(new UnmeasuredForce().word(), evidence.model().bodies().get(force.body()).name(), probability, Map.of("rms_N", rms),
                Map.of("rms_N", Interval.normal(rms, masses.deviation() * force.rms())), base.reduced());
    }

    /** Whether a diagnosis names a push and a mechanism beside it. */
    static boolean namesBesidePush(Diagnosed found) {
        List<Mechanism> named = found.diagnosis().missing().stream().flatMap(one -> found.evidence.library().of(one.mechanism()).stream()).toList();
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

    /** Part of the mismatch that the found mechanisms explain. */
    private double explained() {
        return explained(base, best);
    }

    static double explained(Fitter.State base, Fitter.State best) {
        return explained(base, best.reduced());
    }

    /** Part of a mismatch that is explained, 0 to 1. @param left mean square of the residual with it */
    private static double explained(Fitter.State base, double left) {
        return Math.max(0, Math.min(1, (base.reduced() - left) / Math.max(base.reduced() - 1, 1e-9)));
    }

    /** Whether data not used for the fit are explained about as well: a wrong law with enough freedom follows only what it has seen. */
    private boolean carriesOver() {
        return heldBefore < STRANGE || (heldBefore - heldAfter) / (heldBefore - 1) > CARRIED_OVER * explained();
    }

    /** How much worse the best other mechanism is, in units of what the best one leaves. */
    private double rivalry() {
        Set<String> own = new HashSet<>();
        best.candidate().added().forEach(h -> own.add(h.mechanism() + h.where()));
        double rival = leaders.stream().filter(fit -> !own.contains(fit.candidate().last().mechanism() + fit.candidate().last().where()))
                .mapToDouble(Fitter.State::reduced).findFirst().orElse(base.reduced());
        return (Math.min(rival, base.reduced()) - best.reduced()) / Math.max(best.reduced() - 1, 0.1);
    }

    private double probability(double rivalry) {
        double r = Math.max(0, rivalry);
        double p = 0.62 + 0.36 * r / (r + 1.5);
        double share = Math.min(1, explained() / 0.95);
        return Math.min(0.98, p * Math.pow(share, 2));
    }

    /**
     * The other mechanisms, each once, sharing what probability is left: none is likelier than what was named in proportion to what it leaves, and
     * what they do not take belongs to what is in no library.
     *
     * @param named probability of what was named; 1 where nothing was
     */
    private List<Diagnosis.Named> rivals(double left, double named) {
        List<Diagnosis.Named> out = new ArrayList<>();
        Set<String> seen = new HashSet<>();
        best.candidate().added().forEach(h -> seen.add(h.mechanism() + h.where()));
        double share = left / 2;
        for (Fitter.State rival : leaders) {
            Hypothesis h = rival.candidate().added().get(0);
            if (out.size() < 5 && seen.add(h.mechanism() + h.where())) {
                double worse = Math.min(1, Refinement.excess(best.reduced()) / Refinement.excess(rival.reduced()));
                out.add(new Diagnosis.Named(h.mechanism(), h.where(), Math.min(share, named * worse), Map.of(), Map.of(), rival.reduced()));
                share /= 2;
            }
        }
        return out;
    }

    /** How a sentence ends that names something. @param share of the mismatch that it explains */
    private String ending(double share, List<Diagnosis.Named> rivals) {
        return "; explains " + Phrases.percent(share) + " of the mismatch" + (rivals.isEmpty() ? "." : "; next best " + rivals.get(0).mechanism()
                + " at " + rivals.get(0).where() + ", " + Phrases.percent(explained(base, rivals.get(0).reduced())) + ".");
    }

    private String sentence(Diagnosis.Verdict verdict, List<Diagnosis.Named> missing, String ending, boolean untold) {
        String found = missing.stream().map(named -> Phrases.of(evidence.library(), named)).reduce((first, next) -> first + " and " + next.substring(0, 1).toLowerCase(Locale.ROOT)
                + next.substring(1)).orElse("");
        return switch (verdict) {
            case NOTHING_MISSING -> String.format(Locale.ROOT,
                    "Nothing is missing: the model as given leaves %.2f times the noise%s", given.reduced(), ending);
            case PARAMETERS_ONLY -> String.format(Locale.ROOT,
                    "No physics is missing; with fitted values the model leaves %.2f times the noise instead of %.3g times%s",
                    base.reduced(), given.reduced(), ending);
            case CANNOT_TELL -> "Cannot tell whether anything is missing: " + ending;
            case UNEXPLAINED -> String.format(Locale.ROOT,
                    "Something is missing (%.3g times the noise), and nothing in the library explains it.", base.reduced());
            case LEARNED_LAW -> throw new IllegalStateException("a law that was learned has a sentence of its own");
            case AMBIGUOUS -> found + ending + " The recording does not tell the two apart.";
            case MISSING_PHYSICS -> found + (untold ? ". Whether more is missing cannot be told: " : "") + ending;
        };
    }
}
