package wbv.diagnosis;

import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Known;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.MassScale;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;
import wbv.diagnosis.search.Search;

/** What a verdict rests on: how what was found stands, here and on data not used, and the words for it. */
final class Grounds {

    private final Standing standing;
    private final Search search;
    private final double heldBefore;
    private final double heldAfter;
    private final Presentation shown;
    private final VerdictWords words;

    /** @param heldBefore what the fitted model without anything found leaves on data not used */
    Grounds(Standing standing, double heldBefore, Search search) {
        this.standing = standing;
        this.search = search;
        this.heldBefore = heldBefore;
        this.heldAfter = best() == base() ? heldBefore : search.refinement().heldOut(best());
        this.shown = new Presentation(standing.fits(), heldBefore, search.refinement());
        this.words = new VerdictWords(standing.fits(), heldBefore, shown.scale());
    }

    Standing standing() {
        return standing;
    }

    Search search() {
        return search;
    }

    Refinement refinement() {
        return search.refinement();
    }

    Evidence evidence() {
        return standing.fits().evidence();
    }

    /** The model with the values that its user gave it. */
    Fitter.State given() {
        return standing.fits().given();
    }

    /** The model with fitted values. */
    Fitter.State base() {
        return standing.fits().base();
    }

    /** The model with what was found; the base where nothing was. */
    Fitter.State best() {
        return standing.fits().best();
    }

    /** What the base leaves on data not used. */
    double heldBefore() {
        return heldBefore;
    }

    /** What the best leaves on data not used. */
    double heldAfter() {
        return heldAfter;
    }

    /** The scale of the base's masses. */
    MassScale scale() {
        return shown.scale();
    }

    Presentation shown() {
        return shown;
    }

    VerdictWords words() {
        return words;
    }

    /**
     * Whether a fit with more in it does better than the base on data that neither has seen, with the sensors' errors as they were found on
     * data that both have: those are the errors that are reported.
     */
    boolean foretells(Fitter.State fit) {
        return foretold(fit) < foretold(base());
    }

    /** The same, or does worse by chance alone. */
    boolean foretellsAsWell(Fitter.State fit) {
        return foretold(fit) < foretold(base()) + Calibration.standard().chance() * evidence().outputs().size();
    }

    private record Foretold(Fitter.State fit) implements Known.Question<Double> {}

    private double foretold(Fitter.State fit) {
        return evidence().known().once(new Foretold(fit), () -> new SeenErrors(evidence()).of(fit));
    }

    /**
     * Whether both windows together show nothing, and neither by itself shows something plain.
     *
     * @param fit what the window fitted leaves
     * @param held the other
     */
    boolean isQuiet(double fit, double held) {
        double fitted = evidence().fit().length();
        double unused = evidence().heldOut().length();
        return (fitted * fit + unused * held) / (fitted + unused) < Priors.SILENT && Math.max(fit, held) < Priors.LOUD;
    }
}
