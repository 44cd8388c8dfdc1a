package wbv.diagnosis;

import java.util.List;
import java.util.random.RandomGeneratorFactory;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.search.Fits;

/** How well models fit, in figures, on data used and not used for it. */
final class FitFigures {

    /** Seed of the blocks that are drawn for the proof's intervals: the same data give the same intervals. */
    private static final long DRAWS = 20200131;

    private final Fits fits;
    private final double heldBefore;

    /** @param heldBefore what the fitted model without anything found leaves on data not used */
    FitFigures(Fits fits, double heldBefore) {
        this.fits = fits;
        this.heldBefore = heldBefore;
    }

    /**
     * @param chosen the last model
     * @param heldAfter what it leaves on data not used
     */
    Diagnosis.Fit of(Fitter.State chosen, double heldAfter) {
        Evidence evidence = fits.evidence();
        double rate = evidence.recording().clock().rate();
        Window held = evidence.heldOut();
        List<Diagnosis.Proof> proofs = new HeldOut(evidence, RandomGeneratorFactory.of("L64X128MixRandom").create(DRAWS)).of(fits.base(),
                chosen);
        int outputs = evidence.outputs().size();
        return new Diagnosis.Fit(fits.given().reduced(), fits.base().reduced(), chosen.reduced(), heldBefore, heldAfter,
                new double[] {held.start() / rate, (held.start() + held.length()) / rate},
                proofs.subList(0, outputs), proofs.subList(outputs, proofs.size()), Readings.errors(evidence, chosen));
    }
}
