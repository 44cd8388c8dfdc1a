package wbv.diagnosis;

/**
 * Something that enters at one place and follows no law: a process whose spectrum is level by bands, each level unknown over many decades and
 * summed over.
 */
final class FreeForce {

    /** Rounds in which the sensors' errors and the levels settle beside each other. */
    private static final int ROUNDS = 3;

    private final BandLevels bands;

    /** @param kind of place: what enters at a sensor is no force */
    FreeForce(Window window, Place.Kind kind, Priors priors) {
        this(window, kind == Place.Kind.SENSOR ? priors.errorLeast() : priors.freeLeast(), kind == Place.Kind.SENSOR ? priors.errorMost() : priors.freeMost());
    }

    /** @param least root mean square in a band, the same unit as what enters @param most greatest */
    FreeForce(Window window, double least, double most) {
        bands = new BandLevels(window, least, most);
    }

    /**
     * A likelihood with it.
     *
     * @param value    log of the likelihood, summed over all levels and integrated over the sensors' errors
     * @param power    expected variance of each part of a line, by line
     * @param shown    expected power of it as the sensors see it, in units of their noise: Σ Φa
     * @param variance of that
     */
    record Summed(double value, double[] power, double shown, double variance) {

        /**
         * Probability that no more of it is left beside a law than a share of the law's own force, as the sensors see both.
         *
         * @param law power of the law's force, by line @param sizes |G|² in units of the noise, by line
         */
        double within(double share, double[] law, double[] sizes) {
            double most = 2 * Math.log(share) + Math.log(Fitter.dot(law, sizes));
            // A power is positive: taken as log-normal with this mean and variance.
            double spread = Math.log1p(variance / (shown * shown));
            return normal((most - Math.log(shown) + spread / 2) / Math.sqrt(spread));
        }

        /** Expected force left over the law's own, root mean square, as the sensors see both: what can be printed. */
        double share(double[] law, double[] sizes) {
            return Math.sqrt(shown / Fitter.dot(law, sizes));
        }
    }

    private static double normal(double z) {
        return 0.5 * org.apache.commons.math3.special.Erf.erfc(-z / Math.sqrt(2));
    }

    /** @param way a unit of it in each output, whitened as the likelihood's residual is. Not modified. */
    Summed sum(LogLikelihood likelihood, double[] way) {
        Summed found = new Summed(0, new double[way.length / (2 * likelihood.outputs())], 0, 0);
        for (int round = 0; round < ROUNDS; round++) {
            found = bands(likelihood.held(way, found.power()));
        }
        return found;
    }

    private Summed bands(LogLikelihood.Held held) {
        double[][] logs = bands.likelihood(held);
        double[] visible = bands.sum(held.sizes());
        double[] power = new double[BandLevels.BANDS];
        double value = held.known();
        double shown = 0;
        double variance = 0;
        for (int band = 0; band < power.length; band++) {
            double[] expected = bands.expected(band, logs[band]);
            power[band] = expected[0];
            value += LogSum.of(logs[band]) - Math.log(logs[band].length);
            shown += expected[0] * visible[band];
            variance += expected[1] * visible[band] * visible[band];
        }
        return new Summed(value, bands.spread(power), shown, variance);
    }
}
