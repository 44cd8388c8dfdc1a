package wbv.rig.concealed.law;

import java.util.List;
import java.util.OptionalDouble;

/**
 * A summand of a law in neutral mathematics: a product of what it depends on.
 *
 * @param memory over which the whole product is lagged [s]
 */
public record Term(List<Factor> factors, OptionalDouble memory) {

    /**
     * A factor of a term.
     *
     * @param of     speed, deflection, acceleration, load (of spring and dashpot), time, tilt, channel, pressure
     * @param at     link or channel, empty for the law's own link. Deflection, speed and load are positive in tension
     * @param as     itself, magnitude, sign, square, square with sign, positive part, negative part (as a positive number), level (mean
     *               square over the memory), peak (largest magnitude over the memory), and what else is said in words
     * @param memory [s]
     */
    public record Factor(String of, String at, String as, OptionalDouble memory) {

        /** Of the law's own link, at the moment. */
        public static Factor of(String of, String as) {
            return new Factor(of, "", as, OptionalDouble.empty());
        }

        /** Of another place, at the moment. */
        public static Factor at(String of, String at, String as) {
            return new Factor(of, at, as, OptionalDouble.empty());
        }

        /** Of the law's own link, over a memory [s]. */
        public static Factor over(String of, String as, double memory) {
            return new Factor(of, "", as, OptionalDouble.of(memory));
        }
    }

    public Term {
        factors = List.copyOf(factors);
    }

    /** A product without a lag. */
    public static Term of(Factor... factors) {
        return new Term(List.of(factors), OptionalDouble.empty());
    }

    /**
     * A product that lags.
     *
     * @param memory [s]
     */
    public static Term lagged(double memory, Factor... factors) {
        return new Term(List.of(factors), OptionalDouble.of(memory));
    }
}
