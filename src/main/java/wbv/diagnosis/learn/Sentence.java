package wbv.diagnosis.learn;

import java.util.List;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.diagnosis.search.Calibration;
import wbv.diagnosis.search.Effort;
import wbv.diagnosis.search.Refinement;

/**
 * A sentence of the grammar. What it leaves is told in mean squares of the whitened residual, all through the whitening of the sentence
 * that leaves least, with what its numbers cost before the data were seen.
 *
 * @param fit     by free run
 * @param terms   that it adds to what was known
 * @param left    mean square that it leaves [1]
 * @param without mean square that the model without a law leaves [1]
 * @param least   mean square that the best of those that it is compared with leaves [1]
 * @param words   among which its terms were chosen
 */
public record Sentence(Fitter.State fit, List<Hypothesis> terms, double left, double without, double least, Vocabulary words) {

    public Sentence {
        terms = List.copyOf(terms);
    }

    /**
     * Logarithm of its evidence against the model without a law [nat]. Of so many terms the best makes up for the form of the others by
     * chance, which is what its choice costs.
     */
    public double evidence() {
        Calibration calibration = Calibration.standard();
        return calibration.evidence(left, least) - calibration.evidence(without, least) - words.price(terms)
                - numbers(terms) * calibration.price();
    }

    /** Whether it explains more than chance lets the best of so many terms explain of data of this length. */
    boolean shows() {
        double degrees = fit.frame().whitening().degrees();
        return (without - left) / (2 * Math.max(1, left)) * degrees > chance(words, terms, degrees);
    }

    private static int numbers(List<Hypothesis> terms) {
        return terms.stream().mapToInt(term -> term.numbers().size()).sum();
    }

    /**
     * What chance may explain [nat]: the choice of each term, and each number as far as data of a length tell it (Schwarz 1978).
     *
     * @param degrees of freedom of the data
     */
    static double chance(Vocabulary words, List<Hypothesis> terms, double degrees) {
        return words.price(terms) + 0.5 * numbers(terms) * Math.log(degrees);
    }

    /** Whether it leaves so much more than what is known without a law that no further term helps. */
    boolean isHopelessBeside(Fitter.State than) {
        return Refinement.excess(fit.reduced()) > Effort.HOPELESS * Refinement.excess(than.reduced());
    }

    /** The same, fitted further. */
    Sentence fitted(Fitter.State further) {
        return new Sentence(further, terms, left, without, least, words);
    }

    /** Its place and its terms, whatever their order and their numbers. */
    String said() {
        return fit.candidate().last().where() + terms.stream().map(Hypothesis::form).sorted().toList();
    }
}
