package wbv.diagnosis.search;

import java.util.List;
import java.util.function.UnaryOperator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;

/**
 * The fits that a diagnosis rests on, with the heaviest mass as the user gave it.
 *
 * @param evidence what they were fitted to
 * @param given the model as given
 * @param base with fitted values
 * @param best with what was found; the base
 *                 itself where nothing was
 * @param price    what the choice of its parts beyond the first cost [nat]
 * @param leaders  single mechanisms that were fitted, most credible first
 */
public record Fits(Evidence evidence, Fitter.State given, Fitter.State base, Fitter.State best, double price, List<Fitter.State> leaders) {

    public Fits {
        leaders = List.copyOf(leaders);
    }

    /** With the best as it was chosen, price and all. */
    public Fits(Evidence evidence, Fitter.State given, Fitter.State base, Chosen best, List<Fitter.State> leaders) {
        this(evidence, given, base, best.fit(), best.price(), leaders);
    }

    /** The best, with what it costs. */
    public Chosen chosen() {
        return new Chosen(best, price);
    }

    /** The same on other evidence about the same data: what noise is there. */
    public Fits seen(Evidence other) {
        Fitter fitter = new Fitter(other);
        Fitter.Frame frame = fitter.frame(base.candidate(), base.x(), other.fit());
        UnaryOperator<Fitter.State> look = fit -> fitter.look(fit.candidate(), fit.x(), frame);
        Fitter.State fitted = fitter.lookWithSlopes(base.candidate(), base.x(), frame);
        return new Fits(other, look.apply(given), fitted, best == base ? fitted : new Refinement(other).polish(best), price,
                leaders.stream().map(look).toList());
    }

    /** What the choice of a fit's parts beyond the first cost [nat]: as much as that of the best where it has as many. */
    public double price(Fitter.State fit) {
        return fit.candidate().added().size() < best.candidate().added().size() ? 0 : price;
    }

    /**
     * Whether one of the leaders is likelier than the best by data used and not used, and by the model's own numbers.
     *
     * @param numbers by how much these speak for it [nat]
     */
    public boolean isLikelier(Fitter.State other, double numbers) {
        Refinement refinement = new Refinement(evidence);
        return Chosen.single(other).evidence(refinement.heldOut(other), chosen(), refinement.heldOut(best)) + price - price(other)
                + numbers > 0;
    }

    /** The same with another best; what has more parts than that is no rival of it. */
    public Fits with(Fitter.State other) {
        int parts = other.candidate().added().size();
        return new Fits(evidence, given, base, other, price(other),
                leaders.stream().filter(fit -> fit.candidate().added().size() <= parts).toList());
    }
}
