package wbv.diagnosis;

import java.util.function.Function;
import wbv.body.Model;
import wbv.diagnosis.fit.Augmented;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.search.Fits;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.Refinement;

/** What of fits is shown and written: it has the scale that all masses tell; what is simulated is the same. */
final class Presentation {

    private final Fits fits;
    private final double heldBefore;
    private final Refinement refinement;
    private final MassScale scale;

    /** @param heldBefore what the fitted model without anything found leaves on data not used */
    Presentation(Fits fits, double heldBefore, Refinement refinement) {
        this.fits = fits;
        this.heldBefore = heldBefore;
        this.refinement = refinement;
        this.scale = MassScale.of(fits.evidence(), fits.base());
    }

    /** The scale of the base. */
    MassScale scale() {
        return scale;
    }

    /**
     * @param fit of what was found
     * @param masses the scale of it
     * @param diagnosis of the model at that scale
     */
    Diagnosed of(Fitter.State fit, MassScale masses, Function<Model, Diagnosis> diagnosis) {
        Evidence evidence = fits.evidence();
        Fitter.State before = scale.applied(fits.base());
        Fitter.State chosen = fit == fits.base() ? before : masses.applied(fit);
        Evidence seen = evidence.with(evidence.acting().scaled(masses.factor()));
        return new Diagnosed(diagnosis.apply(Augmented.of(evidence.model(), chosen.candidate().at(chosen.x()))), fits.with(fit), seen,
                before, chosen);
    }

    /** How well a fit does. */
    Diagnosis.Fit figures(Fitter.State fit) {
        return new FitFigures(fits, heldBefore).of(fit, fit == fits.base() ? heldBefore : refinement.heldOut(fit));
    }
}
