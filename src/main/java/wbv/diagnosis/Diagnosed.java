package wbv.diagnosis;

import java.util.Optional;

/** A diagnosis with what it rests on, from which its pictures can be drawn. */
public final class Diagnosed {

    private final Diagnosis diagnosis;
    final Fits fits;
    /** The same at the scale that all masses tell, as it is shown. */
    final Evidence evidence;
    final Fitter.State base;
    final Fitter.State chosen;

    Diagnosed(Diagnosis diagnosis, Fits fits, Evidence evidence, Fitter.State base, Fitter.State chosen) {
        this.diagnosis = diagnosis;
        this.fits = fits;
        this.evidence = evidence;
        this.base = base;
        this.chosen = chosen;
    }

    public Diagnosis diagnosis() {
        return diagnosis;
    }

    /** The data held out beside what the last model makes of them: two simulations more. */
    public Predicted predicted() {
        return Predicted.of(diagnosis, evidence, chosen);
    }

    /** What the laws that were found do: a simulation more. Empty where none was. */
    public Optional<FoundForces> forces() {
        return FoundForces.of(diagnosis, evidence, base, chosen);
    }

    /** Draws: a few simulations more. */
    public Pictures pictures() {
        return Pictures.of(evidence, fits.given(), base, chosen, diagnosis);
    }
}
