package wbv.exposure;

/**
 * Risk of injury of the lumbar spine after years of daily shocks (ISO 2631-5:2018 Annex C).
 *
 * @param sex      whose strength and size are assumed
 * @param startAge when exposure began b [years]
 * @param years    of exposure n, at least 1
 * @param days     of exposure a year N [days], above 0
 */
public record SpinalRisk(Sex sex, int startAge, int years, double days) {

    private static final double GRAVITY = 9.81;
    private static final double STRENGTH = 6.75;

    public SpinalRisk {
        if (startAge < 0 || startAge > 100 || years < 1 || years > 80 || !(days > 0 && days <= 366)) {
            throw new IllegalArgumentException("exposure must begin at 0 to 100 years of age and last 1 to 80 years of"
                    + " 1 to 366 days: " + startAge + ", " + years + ", " + days);
        }
    }

    /** Size and strength of a spine, of 82 kg or 64 kg (ISO 2631-5:2018 Tables C.1 and C.2). */
    public enum Sex {
        MALE(0.029, 0.052, 1.613, 2.799), FEMALE(0.025, 0.039, 0.959, 3.709);

        private final double stress;
        private final double ageing;
        private final double scale;
        private final double shape;

        Sex(double stress, double ageing, double scale, double shape) {
            this.stress = stress;
            this.ageing = ageing;
            this.scale = scale;
            this.shape = shape;
        }
    }

    /**
     * Daily compressive stress Sd, Formula C.1 [MPa].
     *
     * @param dose Dzd [m/s²]
     */
    public double stress(double dose) {
        return sex.stress * dose;
    }

    /**
     * Stress variable R [1], Formulae C.3 and C.4; infinite where a year begins with no strength left.
     *
     * @param dose Dzd [m/s²]
     */
    public double variable(double dose) {
        double load = stress(dose) * Math.pow(days, 1.0 / 6);
        double sum = 0;
        for (int i = 0; i < years; i++) {
            double left = STRENGTH - sex.ageing * (startAge + i) - sex.stress * GRAVITY;
            if (left <= 0) {
                return Double.POSITIVE_INFINITY;
            }
            sum += Math.pow(load / left, 6);
        }
        return Math.pow(sum, 1.0 / 6);
    }

    /**
     * Probability of injury, Formula C.5, 0 to 1.
     *
     * @param dose Dzd [m/s²]
     */
    public double probability(double dose) {
        return -Math.expm1(-Math.pow(variable(dose) / sex.scale, sex.shape));
    }
}
