package wbv.diagnosis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.diagnosis.fit.BodyForce;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.fit.SpectralLines;
import wbv.diagnosis.mechanism.UnmeasuredForce;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/** Forces that nobody measured, as what is missing. */
final class Pushes {

    private final Grounds grounds;

    Pushes(Grounds grounds) {
        this.grounds = grounds;
    }

    /**
     * A force that nobody measured, where no mechanism takes the mismatch.
     *
     * @param named whether a mechanism takes enough of it to be worth a name
     */
    Optional<Explanation> instead(boolean named) {
        double left = grounds.base().reduced();
        if (named && Refinement.isTaken(left, grounds.best().reduced()) || left < Priors.STRANGE) {
            return Optional.empty();
        }
        Standing standing = grounds.standing();
        Optional<BodyForce> force = named ? BodyForce.aboveBase(grounds.evidence(), grounds.base())
                : BodyForce.onAnyBody(grounds.evidence(), grounds.base());
        return force.filter(BodyForce::independent).filter(push -> isAll(grounds.evidence(), grounds.base(), push)).map(push -> {
            double p = named ? Math.max(Priors.MAJORITY, 1 - standing.explained())
                    : push.following().isTold() ? Priors.HELD : Priors.MAJORITY;
            List<Diagnosis.Named> rivals = standing.rivals(1 - p);
            return new Explanation(Diagnosis.Verdict.MISSING_PHYSICS, grounds.base(), grounds.scale(),
                    List.of(named(push, grounds.scale(), p)), rivals, List.of(),
                    grounds.words().ending(push.carried(), 0, rivals));
        });
    }

    /**
     * Whether a push is all that is missing: a model fitted beside it leaves no more than its level scatters, without tones, of data not
     * used as well. What it carries of the mismatch of a model that bent for the lack of it says less.
     *
     * @param base that model, fitted without
     */
    static boolean isAll(Evidence evidence, Fitter.State base, BodyForce push) {
        return evidence.known().once(new Asked(base, push.body()), () -> leavesNoise(evidence, base, push));
    }

    /** A push on a body, as a fit leaves it. */
    private record Asked(Fitter.State base, int body) implements Known.Question<Boolean> {}

    private static boolean leavesNoise(Evidence evidence, Fitter.State base, BodyForce push) {
        Evidence knowing = evidence.with(push);
        Search search = new Search(knowing, (step, share) -> {});
        Fitter.State left = search.base(base.candidate());
        double most = Math.max(Priors.NOISE, 1 + Priors.SCATTER * (base.reduced() - 1));
        return left.reduced() < most && search.refinement().heldOut(left) < most
                && !SpectralLines.standOut(left.residual(), knowing.fit()) && !answers(evidence, base, left, push.body());
    }

    /** Whether the force answers to the ride where the model is as it fits beside it, no longer bent for the lack of it. */
    private static boolean answers(Evidence evidence, Fitter.State base, Fitter.State beside, int body) {
        Fitter.State unbent = new Fitter(evidence).look(base.candidate(), beside.x(), base.frame());
        return BodyForce.known(evidence, unbent, body, new double[evidence.recording().length()]).coherent();
    }

    /** The force that counts as noise already, where that is more than a person makes who sits still. */
    Optional<Diagnosis.Named> beside(MassScale masses, double probability) {
        return grounds.evidence().acting().push().map(push -> named(push, masses, probability));
    }

    private Diagnosis.Named named(BodyForce force, MassScale masses, double probability) {
        double rms = masses.factor() * force.apart();
        // What goes with the base does so by errors, which may have made as much of the rest.
        double deviation = Math.hypot(masses.deviation() * rms, masses.factor() * (force.rms() - force.apart()));
        return new Diagnosis.Named(new UnmeasuredForce().word(), grounds.evidence().model().bodies().get(force.body()).name(), probability,
                Map.of("rms_N", rms), Map.of("rms_N", Interval.normal(rms, deviation).notBelow(0)), grounds.base().reduced());
    }
}
