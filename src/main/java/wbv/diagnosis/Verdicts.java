package wbv.diagnosis;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.OddSensor;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Search;
import wbv.recording.Quantity;

/**
 * Turns fits into a diagnosis: a verdict with its probability, values with their deviations, where, how well, and what would settle it. A
 * push goes before a name ({@link Pushes}), a name ({@link Naming}) before what the model's numbers nearly imitate and a late sensor, and
 * where nothing explains the mismatch that is said.
 */
final class Verdicts {

    private final Grounds grounds;
    private final Evidence evidence;
    private final Fitter.State base;
    private final Naming naming;

    /** @param heldBefore what the fitted model without anything found leaves on data not used */
    Verdicts(Standing standing, double heldBefore, Search search) {
        this.grounds = new Grounds(standing, heldBefore, search);
        this.evidence = grounds.evidence();
        this.base = grounds.base();
        this.naming = new Naming(grounds);
    }

    /** @param locate finds the places that could carry the mismatch; asked only where no name is good enough */
    Diagnosed diagnosed(Supplier<List<Diagnosis.Latent>> locate) {
        boolean named = naming.isWorth();
        Explanation sought = new Pushes(grounds).instead(named)
                .or(() -> named ? naming.explanation(locate) : imitated().or(this::lateSensor)).orElseGet(() -> nothing(locate));
        double caused = new SeenErrors(evidence).explained(sought.fit());
        boolean idle = caused < Priors.MAJORITY;
        Explanation found = idle ? cannotTell(grounds.words().notCaused(caused)) : sought;
        List<Diagnosis.Named> missing = new ArrayList<>(idle ? List.of() : new PlainFaults(evidence).in(base, grounds.best()));
        boolean untold = found.verdict() == Diagnosis.Verdict.CANNOT_TELL;
        boolean plain = !missing.isEmpty() && (found.verdict().isQuiet() || untold);
        missing.addAll(found.missing());
        Diagnosis.Verdict verdict = plain ? Diagnosis.Verdict.MISSING_PHYSICS : found.verdict();
        Presentation shown = grounds.shown();
        return shown.of(found.fit(), found.scale(), model -> new Diagnosis(verdict,
                grounds.words().sentence(verdict, missing, found.rivals(), found.ending(), untold), new Mismatch(evidence, base).located(),
                missing,
                found.rivals(), experiment(verdict, missing, found.rivals(), idle), shown.figures(found.fit()), found.where(), model,
                Optional.empty()));
    }

    /** What the model's own numbers nearly imitate. */
    private Optional<Explanation> imitated() {
        return base.reduced() > Priors.SILENT ? Optional.empty() : new Imitations(evidence, grounds.search()).in(base).map(found -> {
            DecisionRule.Reading reading = DecisionRule.read(found.posterior());
            Values values = new Values(evidence, found.fits().get(0));
            Diagnosis.Named first = values.named(found.fits().get(0).candidate().last(),
                    found.posterior().of(Standing.claim(found.fits().get(0))));
            // What would be said without it first.
            List<Diagnosis.Named> rivals = new ArrayList<>(List.of(found.asNumbers(base)));
            rivals.addAll(Standing.named(found.fits(), found.posterior(), Standing.claim(found.fits().get(0))));
            return new Explanation(reading.names() > 1 ? Diagnosis.Verdict.AMBIGUOUS : Diagnosis.Verdict.MISSING_PHYSICS, values.fit(),
                    values.scale(), List.of(first), rivals, List.of(), grounds.words().imitating(rivals.get(0)));
        });
    }

    /** A sensor that is later than sensors scatter. */
    private Optional<Explanation> lateSensor() {
        return new OddSensor(evidence, grounds.search()).in(base).filter(this::isQuiet).map(fit -> {
            Values values = new Values(evidence, fit);
            return new Explanation(Diagnosis.Verdict.MISSING_PHYSICS, values.fit(), values.scale(),
                    List.of(values.named(fit.candidate().last(), Priors.LATE)), List.of(), List.of(), ".");
        });
    }

    /**
     * Whether a fit with a sensor's fault leaves nothing, and on data not used no more than without it but by chance: what is late within
     * the reach of small errors is foretold by these as well.
     */
    private boolean isQuiet(Fitter.State fit) {
        double held = grounds.refinement().heldOut(fit);
        return held < grounds.heldBefore() + Calibration.standard().chance() && grounds.isQuiet(fit.reduced(), held)
                && grounds.foretellsAsWell(fit);
    }

    /** No name: nothing to find, nothing found, or not even that. */
    private Explanation nothing(Supplier<List<Diagnosis.Latent>> locate) {
        double left = base.reduced();
        double held = grounds.heldBefore();
        boolean quiet = left < Priors.SILENT;
        boolean heldQuiet = held < Priors.SILENT;
        boolean little = quiet || heldQuiet || Math.max(left, held) < Priors.STRANGE;
        String why = quiet == heldQuiet ? "more than noise leaves, and too little for any mechanism to stand out"
                : "a law acts in both, an event in one only";
        return grounds.isQuiet(left, held) ? nothingMissing()
                : little ? cannotTell(grounds.words().cannotTell(why)) : unexplained(locate.get());
    }

    private Explanation nothingMissing() {
        Fitter.State given = grounds.given();
        boolean right = grounds.isQuiet(given.reduced(), grounds.refinement().heldOut(given));
        return Explanation.nameless(right ? Diagnosis.Verdict.NOTHING_MISSING : Diagnosis.Verdict.PARAMETERS_ONLY, grounds,
                grounds.words().counting());
    }

    private Explanation unexplained(List<Diagnosis.Latent> places) {
        return naming.nearest(places).orElseGet(() -> new Explanation(Diagnosis.Verdict.UNEXPLAINED, base, grounds.scale(), List.of(),
                grounds.standing().names(Set.of(), 1 - Priors.HELD), places, grounds.words().entering(places)));
    }

    /**
     * Whether a model as its user gave it may turn out to lack nothing.
     *
     * @param given it on what is fitted
     */
    static boolean mayBeRight(Fitter.State given) {
        return given.reduced() < Priors.LOUD;
    }

    private Explanation cannotTell(String ending) {
        return Explanation.nameless(Diagnosis.Verdict.CANNOT_TELL, grounds, ending);
    }

    /** Whether a rotation about an axis across the model's was recorded. */
    private boolean turned() {
        return evidence.recording().channels().stream()
                .anyMatch(channel -> channel.quantity() == Quantity.ANGULAR_RATE && channel.axis() != evidence.model().axis());
    }

    private String experiment(Diagnosis.Verdict verdict, List<Diagnosis.Named> missing, List<Diagnosis.Named> rivals, boolean idle) {
        List<Diagnosis.Named> open = grounds.words().shown(rivals).toList();
        boolean nameless = verdict == Diagnosis.Verdict.UNEXPLAINED && missing.isEmpty() && open.isEmpty();
        return idle ? Experiments.CAUSE : verdict == Diagnosis.Verdict.CANNOT_TELL ? Experiments.AGAIN
                : nameless ? Family.UNLISTED.experiment()
                        : new Experiments(evidence.library()).between(missing, open, atBase(), grounds.scale().deviation() > 0, turned());
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
}
