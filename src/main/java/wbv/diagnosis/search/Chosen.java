package wbv.diagnosis.search;

import java.util.stream.Stream;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A fit among those that are compared.
 *
 * @param price what the choice of its parts beyond the first costs: the logarithm of how many each was chosen among [nat]
 */
public record Chosen(Fitter.State fit, double price) {

    public Chosen {
        if (!(price >= 0)) {
            throw new IllegalArgumentException("a choice costs 0 nat at least: " + price);
        }
    }

    /** One that is chosen without further parts. */
    public static Chosen single(Fitter.State fit) {
        return new Chosen(fit, 0);
    }

    /** What the choice of one name among those of some hypotheses costs [nat]. */
    public static double price(Stream<Hypothesis> among) {
        return Math.log(Math.max(1, among.map(Hypothesis::claim).distinct().count()));
    }

    /**
     * Whether it is likelier than another, by what both leave of the data that were fitted and of data that were not, in the mean: no
     * formula is quite right, so that of what one leaves more than the other only the ratio counts, see {@link Calibration#evidence}. What
     * does worse on data not used, and leaves more than noise there, is not.
     *
     * @param heldOut mean square of the whitened residual that this leaves of data not used
     * @param otherHeldOut likewise, of what the other does
     */
    public boolean outweighs(double heldOut, Chosen other, double otherHeldOut) {
        return (heldOut <= 1 || gain(heldOut, otherHeldOut) > 0) && evidence(heldOut, other, otherHeldOut) > price - other.price();
    }

    /** Logarithm of the evidence for it against another, but for their prices, by both kinds of data in the mean [nat]; as above. */
    double evidence(double heldOut, Chosen other, double otherHeldOut) {
        return (gain(fit.reduced(), other.fit().reduced()) + gain(heldOut, otherHeldOut)) / 2;
    }

    private static double gain(double left, double otherLeft) {
        double least = Math.min(left, otherLeft);
        return Calibration.standard().evidence(left, least) - Calibration.standard().evidence(otherLeft, least);
    }
}
