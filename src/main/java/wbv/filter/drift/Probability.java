package wbv.filter.drift;

/** Probabilities that the alarms are fed with. */
public final class Probability {

    private Probability() {}

    /**
     * Distribution function of χ² with one degree of freedom, erf(√(x/2)), to 2e-7 (Abramowitz and Stegun 1964, 7.1.26).
     *
     * @param x a χ² [1], &gt;= 0
     * @return in [0, 1]
     */
    public static double chiSquare1(double x) {
        double z = Math.sqrt(x / 2);
        double t = 1 / (1 + 0.3275911 * z);
        double poly = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
        return Math.min(1, Math.max(0, 1 - poly * Math.exp(-z * z)));
    }
}
