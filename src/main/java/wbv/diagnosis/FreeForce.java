package wbv.diagnosis;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Something that enters at one place and follows no law: a process whose spectrum is level by bands, each level unknown over many decades and
 * summed over. Bands have no line in common, so that beside given errors of the sensors the sum is a product of sums, by
 * {@code -log(1 + Φa) + ½ Φb / (1 + Φa)} with {@code a = GᴴS⁻¹G} and {@code b = |GᴴS⁻¹r|²} at each line.
 */
final class FreeForce {

    private static final int BANDS = 14;
    /** Steps of a level's logarithm, in deviations with which the lines of its band tell it: finer ones do not change a sum. */
    private static final double STEP = 1.2;
    private static final int FEWEST = 28;
    /** Rounds in which the sensors' errors and the levels settle beside each other. */
    private static final int ROUNDS = 3;

    private final int[] edges;
    private final double[][] levels;

    /** @param kind of place: what enters at a sensor is no force */
    FreeForce(Window window, Place.Kind kind, Priors priors) {
        this(window, kind == Place.Kind.SENSOR ? priors.errorLeast() : priors.freeLeast(), kind == Place.Kind.SENSOR ? priors.errorMost() : priors.freeMost());
    }

    /** @param least root mean square in a band, the same unit as what enters @param most greatest */
    FreeForce(Window window, double least, double most) {
        double low = Math.max(window.frequency(0), window.spacing());
        double top = window.frequency(window.lines() - 1);
        edges = IntStream.rangeClosed(0, BANDS).map(band -> band == 0 ? 0 : band == BANDS ? window.lines()
                : (int) Math.round((low * Math.pow(top / low, (double) band / BANDS) - window.frequency(0)) / window.spacing())).toArray();
        levels = new double[BANDS][];
        for (int band = 0; band < BANDS; band++) {
            int lines = Math.max(1, edges[band + 1] - edges[band]);
            int steps = Math.max(FEWEST, (int) Math.ceil(2 * Math.log(most / least) * Math.sqrt(lines) / STEP));
            // The likelihood of a level over n lines is as wide as 1/√n of its logarithm.
            levels[band] = IntStream.range(0, steps).mapToDouble(step -> Math.pow(least * Math.pow(most / least, step / (steps - 1.0)), 2)
                    * window.length() / 2 / lines).toArray();
        }
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
        double[] power = new double[held.sizes().length];
        double value = held.known();
        double shown = 0;
        double variance = 0;
        for (int band = 0; band < BANDS; band++) {
            double visible = 0;
            double[] own = levels[band];
            double[] logs = new double[own.length];
            for (int line = edges[band]; line < edges[band + 1]; line++) {
                visible += held.sizes()[line];
                for (int step = 0; step < own.length; step++) {
                    logs[step] += held.term(line, own[step]);
                }
            }
            double sum = LogSum.of(logs);
            double mean = 0;
            double square = 0;
            for (int step = 0; step < own.length; step++) {
                double p = Math.exp(logs[step] - sum);
                mean += p * own[step];
                square += p * own[step] * own[step];
            }
            Arrays.fill(power, edges[band], edges[band + 1], mean);
            value += sum - Math.log(own.length);
            shown += mean * visible;
            variance += (square - mean * mean) * visible * visible;
        }
        return new Summed(value, power, shown, variance);
    }
}
