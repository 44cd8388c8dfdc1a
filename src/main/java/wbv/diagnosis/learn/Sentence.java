package wbv.diagnosis.learn;

import java.util.List;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Priors;
import wbv.diagnosis.search.Refinement;

/**
 * A sentence of the grammar.
 *
 * @param fit   by free run
 * @param terms that it adds to what was known
 * @param gain by how much it lowers the cost [1] of the model without a law, as {@link Weighing} sees it
 * @param of   how many terms each of its own was chosen
 * @param unit mean square of the residual that the best fit so far leaves; 1 at least
 */
public record Sentence(Fitter.State fit, List<Hypothesis> terms, double gain, int of, double unit) {

    /** How many times the excess of what is known without a law its first terms may leave for others to be sought beside them. */
    private static final double HOPELESS = 10;

    /** Logarithm of its evidence against the model without a law [nat]. */
    public double evidence() {
        double half = gain / (2 * unit);
        int numbers = terms.stream().mapToInt(term -> term.numbers().size()).sum();
        return half - price(half, terms.size(), of, numbers, fit.frame().whitening().degrees());
    }

    /** Whether it leaves so much more than what is known without a law that no further term helps. */
    boolean isHopelessBeside(Fitter.State than) {
        return Refinement.excess(fit.reduced()) > HOPELESS * Refinement.excess(than.reduced());
    }

    /** Its place and its terms, whatever their order and their numbers. */
    String said() {
        return fit.candidate().last().where() + terms.stream().map(Hypothesis::form).sorted().toList();
    }

    /**
     * What a sentence costs: the choice of each term among all of them, and of each number among those that data of this length tell apart
     * (Schwarz 1978). A further number has to explain more than a formula that is right may leave, which is right to a part of its own
     * force only.
     *
     * @param gain of the sentence [nat]
     * @param chosen terms
     * @param of how many
     * @param numbers of all terms together
     * @param degrees of freedom of the data
     */
    static double price(double gain, int chosen, int of, int numbers, double degrees) {
        return (numbers - 1) * Priors.USUAL.form() * Priors.USUAL.form() * Math.max(0, gain) + chosen * Math.log(of)
                + 0.5 * numbers * Math.log(degrees);
    }
}
