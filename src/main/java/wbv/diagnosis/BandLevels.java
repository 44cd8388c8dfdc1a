package wbv.diagnosis;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Bands of a window's lines, of which each is as wide as all others on a logarithmic axis, and levels that a process may have in each. Bands have
 * no line in common, so that beside given errors of the sensors each is likely or not by itself.
 */
final class BandLevels {

    static final int BANDS = 14;
    /** Steps of a level's logarithm, in deviations with which the lines of its band tell it: finer ones do not change a sum. */
    private static final double STEP = 1.2;
    private static final int FEWEST = 28;

    private final Window window;
    private final int[] edges;
    private final double[][] levels;

    /** @param least root mean square in a band, in the unit of what enters @param most greatest */
    BandLevels(Window window, double least, double most) {
        this.window = window;
        double low = Math.max(window.frequency(0), window.spacing());
        double top = window.frequency(window.lines() - 1);
        edges = IntStream.rangeClosed(0, BANDS).map(band -> band == 0 ? 0 : band == BANDS ? window.lines()
                : (int) Math.round((low * Math.pow(top / low, (double) band / BANDS) - window.frequency(0)) / window.spacing())).toArray();
        levels = new double[BANDS][];
        for (int band = 0; band < BANDS; band++) {
            int lines = lines(band);
            // The likelihood of a power over n lines is as wide as 1/√n of its logarithm.
            int steps = Math.max(FEWEST, (int) Math.ceil(2 * Math.log(most / least) * Math.sqrt(lines) / STEP));
            levels[band] = IntStream.range(0, steps).mapToDouble(step -> Math.pow(least * Math.pow(most / least, step / (steps - 1.0)), 2)
                    * window.length() / 2 / lines).toArray();
        }
    }

    private int lines(int band) {
        return Math.max(1, edges[band + 1] - edges[band]);
    }

    /** Powers that a band may have: variance of each part of a line, rising by one factor. Not a copy. */
    double[] powers(int band) {
        return levels[band];
    }

    /** Log of the likelihood of each power in each band, without what all have in common: {@code -log(1 + Φa) + ½ Φb / (1 + Φa)} over its lines. */
    double[][] likelihood(LogLikelihood.Held held) {
        double[][] out = new double[BANDS][];
        for (int band = 0; band < BANDS; band++) {
            double[] own = levels[band];
            out[band] = new double[own.length];
            for (int step = 0; step < own.length; step++) {
                out[band][step] = held.value(edges[band], edges[band + 1], own[step]);
            }
        }
        return out;
    }

    /** By line. @param byBand by band */
    double[] spread(double[] byBand) {
        double[] out = new double[window.lines()];
        for (int band = 0; band < BANDS; band++) {
            Arrays.fill(out, edges[band], edges[band + 1], byBand[band]);
        }
        return out;
    }

    /** Mean by band. @param byLine Not modified. */
    double[] mean(double[] byLine) {
        double[] out = sum(byLine);
        for (int band = 0; band < BANDS; band++) {
            out[band] /= lines(band);
        }
        return out;
    }

    /** Sum by band. @param byLine Not modified. */
    double[] sum(double[] byLine) {
        return IntStream.range(0, BANDS).mapToDouble(band -> Arrays.stream(byLine, edges[band], edges[band + 1]).sum()).toArray();
    }

    /** What is expected of the power in a band. @param logs of its probabilities, but for a factor @return mean and variance */
    double[] expected(int band, double[] logs) {
        double sum = LogSum.of(logs);
        double mean = 0;
        double square = 0;
        for (int step = 0; step < logs.length; step++) {
            double p = Math.exp(logs[step] - sum);
            mean += p * levels[band][step];
            square += p * levels[band][step] * levels[band][step];
        }
        return new double[] {mean, square - mean * mean};
    }
}
