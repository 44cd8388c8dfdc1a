package wbv.diagnosis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.learn.LawLearner;
import wbv.diagnosis.mechanism.Family;
import wbv.diagnosis.mechanism.Mechanism;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.PairSearch;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;

/** A diagnosis with what it rests on, from which its pictures can be drawn. */
public final class Diagnosed {

    private final Diagnosis diagnosis;
    /** The fits, with the heaviest mass as the user gave it. */
    public final Fits fits;
    /** The same at the scale that all masses tell, as it is shown. */
    public final Evidence evidence;
    /** The user's model fitted, at the same scale. */
    public final Fitter.State base;
    /** The model with what was found; {@link #base} where nothing was. */
    public final Fitter.State chosen;

    Diagnosed(Diagnosis diagnosis, Fits fits, Evidence evidence, Fitter.State base, Fitter.State chosen) {
        this.diagnosis = diagnosis;
        this.fits = fits;
        this.evidence = evidence;
        this.base = base;
        this.chosen = chosen;
    }

    /** What it came to. */
    public Diagnosis diagnosis() {
        return diagnosis;
    }

    /** Whether nothing is claimed of any mechanism. */
    boolean isUnexplained() {
        return diagnosis.verdict().isRefusal();
    }

    /** Whether a hypothesis explains the mismatch: a push, which may be anything, is none. */
    boolean isByHypothesis() {
        return !isUnexplained() && isNear();
    }

    /** Whether it names what explains nearly all of the mismatch. */
    boolean explainsNearlyAll() {
        return !isUnexplained() && Refinement.explainsNearlyAll(base, chosen);
    }

    /** Whether a hypothesis was found that may be what is missing. */
    private boolean isNear() {
        return fits.best() != fits.base();
    }

    /**
     * Whether nothing explains a mismatch that may be several mechanisms or a push: not one that enters in a link or at a sensor alone,
     * where all of the library was tried and nothing came near, taking half of it.
     */
    boolean isOpen() {
        List<Diagnosis.Latent> alone = diagnosis.latent().stream().filter(place -> Refinement.excess(place.reduced()) <= PairSearch.QUIET)
                .toList();
        // A body on the base feels what its link does: the two leave the same.
        Set<Double> elsewhere = alone.stream().filter(place -> !isBody(place)).map(Diagnosis.Latent::reduced).collect(Collectors.toSet());
        return isUnexplained() && (Refinement.explained(fits.base(), fits.best()) > Priors.MAJORITY || alone.isEmpty()
                || alone.stream().anyMatch(place -> isBody(place) && !elsewhere.contains(place.reduced())));
    }

    private static boolean isBody(Diagnosis.Latent place) {
        return place.kind().equals(Place.Kind.BODY.word());
    }

    /** Whether nothing is named since one law does what no name does, see {@link LawLearner#isOne}, at a place that outputs tell. */
    boolean isOneLaw() {
        return isUnexplained() && !diagnosis.latent().isEmpty() && LawLearner.isOne(fits.evidence(), fits.base(), fits.best());
    }

    /** Whether it names a push and nothing else. */
    boolean isPush() {
        return !isNear() && !diagnosis.missing().isEmpty()
                && diagnosis.missing().stream().flatMap(one -> evidence.library().of(one.mechanism()).stream())
                        .allMatch(one -> one.family() == Family.FORCE);
    }

    /** Whether it names a push and a mechanism beside it. */
    boolean namesBesidePush() {
        List<Mechanism> named = diagnosis.missing().stream().flatMap(one -> evidence.library().of(one.mechanism()).stream()).toList();
        return named.stream().anyMatch(one -> one.family() == Family.FORCE)
                && named.stream().anyMatch(one -> one.family() != Family.FORCE && !one.showsWithoutFit());
    }

    /**
     * The same where nothing was found missing of a simulation whose own values were fitted first: these were wrong, and nothing else.
     *
     * @param sentence that says which
     * @param before root mean square of recorded less simulated over that of recorded, held out, with the values as
     *                 they were, by channel
     */
    public Diagnosed afterFitting(String sentence, Map<String, Double> before) {
        Diagnosis.Fit fit = diagnosis.fit();
        List<Diagnosis.Proof> channels = fit.channels().stream().map(proof -> before.containsKey(proof.channel())
                ? new Diagnosis.Proof(proof.channel(), proof.band(), proof.signal(),
                        new Diagnosis.Ranged(before.get(proof.channel()), Double.NaN, Double.NaN),
                        proof.after(), proof.floor(), proof.removed())
                : proof).toList();
        Diagnosis other = new Diagnosis(Diagnosis.Verdict.PARAMETERS_ONLY, sentence, diagnosis.located(), diagnosis.missing(),
                diagnosis.alternatives(), diagnosis.nextExperiment(),
                new Diagnosis.Fit(fit.given(), fit.before(), fit.after(), fit.heldBefore(), fit.heldAfter(), fit.heldOut(), channels,
                        fit.bands(), fit.sensors()),
                diagnosis.latent(), diagnosis.model(), diagnosis.learned());
        return new Diagnosed(other, fits, evidence, base, chosen);
    }

    /** The same, with a sentence before its own. */
    Diagnosed saying(String first) {
        Diagnosis d = diagnosis;
        Diagnosis other = new Diagnosis(d.verdict(), first + " " + d.sentence(), d.located(), d.missing(), d.alternatives(),
                d.nextExperiment(), d.fit(), d.latent(), d.model(), d.learned());
        return new Diagnosed(other, fits, evidence, base, chosen);
    }

    /** The same, with a sentence before its own where there is one. */
    Diagnosed saying(Optional<String> first) {
        return first.map(this::saying).orElse(this);
    }

    /** The data held out beside what the last model makes of them: two simulations more. */
    public Predicted predicted() {
        return Predicted.of(diagnosis, evidence, chosen);
    }

    /** What the laws that were found do: a simulation more. Empty where none was. */
    public Optional<FoundForces> forces() {
        return FoundForces.of(diagnosis, evidence, base, chosen);
    }
}
