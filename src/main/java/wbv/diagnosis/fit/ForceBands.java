package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * How strong a force is, by third-octave bands.
 *
 * @param rms   root mean square [N], as far as the fit's window shows it; below a hertz no stronger than above
 * @param even  the same of a force as strong in every band as in the middle one [N]: where accelerations hardly show a force, its
 *              estimate is mostly their noise
 * @param edges upper edges of the bands [Hz], rising
 * @param power by band: variance of the real and of the imaginary part of a line of {@link Window#spectrum} [N²]
 */
record ForceBands(double rms, double even, double[] edges, double[] power) {

    /** By how much, of its neighbours' level, that of a band may differ from it (one standard deviation). */
    private static final double ROUGH = 0.7;
    private static final int ROUNDS = 10;
    /** Bands within which a neighbour's word is worth a third of a band's own. */
    private static final double NEIGHBOURS = 1.5;
    private static final double FIRST_EDGE = 0.7;
    private static final double SHOWN = 1.2;

    /** Of a force as a fit's residual shows it. */
    static ForceBands of(Entering force, Window window) {
        double[] edges = edges(window);
        double[] power = new double[edges.length];
        int[] count = new int[edges.length];
        double[] noise = new double[edges.length];
        for (int line = 0; line < window.lines(); line++) {
            int band = band(edges, window.frequency(line));
            double re = force.signal()[2 * line];
            double im = force.signal()[2 * line + 1];
            power[band] += (re * re + im * im) / 2;
            noise[band] += force.variance()[line];
            count[band]++;
        }
        for (int i = 0; i < edges.length; i++) {
            power[i] /= Math.max(1, count[i]);
            noise[i] /= Math.max(1, count[i]);
        }
        return of(edges, levels(power, noise, count), count, window);
    }

    private static ForceBands of(double[] edges, double[] power, int[] count, Window window) {
        double[] shown = shown(edges, power);
        double half = window.length() / 2.0;
        double total = IntStream.range(0, edges.length).mapToDouble(i -> shown[i] * count[i]).sum();
        double[] sorted = power.clone();
        Arrays.sort(sorted);
        return new ForceBands(Math.sqrt(total / half), Math.sqrt(sorted[sorted.length / 2] * window.lines() / half), edges, power);
    }

    /**
     * Power by band as it counts: far below its resonance a body hardly moves under a force, and what the sensors' small errors make of the
     * ride looks like a large one.
     */
    private static double[] shown(double[] edges, double[] power) {
        double[] shown = power.clone();
        for (int i = edges.length - 2; i >= 0; i--) {
            if (edges[i] < SHOWN) {
                shown[i] = Math.min(shown[i], shown[i + 1]);
            }
        }
        return shown;
    }

    /**
     * Power of a force by band, from estimates with noise: what a band and its neighbours show together, and its own the more the better it
     * is known.
     *
     * @param power of estimates that hold the noise's too
     * @param count lines by band
     */
    static double[] levels(double[] power, double[] noise, int[] count) {
        double[] level = new double[power.length];
        for (int round = 0; round < ROUNDS; round++) {
            double[] before = level.clone();
            for (int i = 0; i < level.length; i++) {
                double sum = 0;
                double weights = 0;
                for (int j = 0; j < power.length; j++) {
                    double deviation = before[i] + noise[j];
                    double weight = Math.exp(-Math.abs(i - j) / NEIGHBOURS) * count[j] / (deviation * deviation);
                    sum += count[j] == 0 ? 0 : weight * (power[j] - noise[j]);
                    weights += count[j] == 0 ? 0 : weight;
                }
                level[i] = Math.max(0, sum / weights);
            }
        }
        for (int i = 0; i < level.length; i++) {
            double own = power[i] - noise[i];
            double known = Math.pow((level[i] + noise[i]) / (ROUGH * level[i]), 2) / Math.max(1, count[i]);
            level[i] = level[i] == 0 ? Math.max(0, own) : Math.max(0, level[i] + (own - level[i]) / (1 + known));
        }
        return level;
    }

    /** Third-octave edges over the window's lines. */
    private static double[] edges(Window window) {
        double top = window.frequency(window.lines() - 1);
        int n = (int) Math.ceil(3 * Math.log(top / FIRST_EDGE) / Math.log(2));
        double[] out = new double[n + 1];
        for (int i = 0; i <= n; i++) {
            out[i] = FIRST_EDGE * Math.pow(2, i / 3.0);
        }
        return out;
    }

    /** Variance of each part of a line at a frequency [N²]. */
    double power(double frequency) {
        return power[band(edges, frequency)];
    }

    private static int band(double[] edges, double frequency) {
        int band = 0;
        while (band < edges.length - 1 && edges[band] < frequency) {
            band++;
        }
        return band;
    }

    /**
     * The force, each line weighed by what it tells of the level of all together, √S/(S + N) with the force's power S and the noise's
     * N: the derivative of Whittle's (1953) likelihood by a factor of S is the sum of the squares of that, but for a constant. By itself
     * a force on a body is mostly the noise of the lowest lines, which accelerations hardly show, and its level scatters as that of so
     * few.
     *
     * @param force whose bands these are
     * @return [1], at the lines of the window, a new array
     */
    double[] telling(Entering force, Window window) {
        return weighed(force, window, line -> {
            double own = power(window.frequency(line));
            return own > 0 ? Math.sqrt(own) / (own + force.variance()[line]) : 0;
        });
    }

    /**
     * The force as it counts in {@link #rms}: each line as strong as its band is without noise, and below a hertz no stronger than above.
     *
     * @param force whose bands these are
     * @return [N], at the lines of the window, a new array
     */
    double[] counting(Entering force, Window window) {
        double[] shown = shown(edges, power);
        return weighed(force, window, line -> {
            int band = band(edges, window.frequency(line));
            double own = power[band] + force.variance()[line];
            return own > 0 ? Math.sqrt(shown[band] / own) : 0;
        });
    }

    private static double[] weighed(Entering force, Window window, IntToDoubleFunction weight) {
        double[] out = force.signal().clone();
        for (int line = 0; line < window.lines(); line++) {
            double by = weight.applyAsDouble(line);
            out[2 * line] *= by;
            out[2 * line + 1] *= by;
        }
        return out;
    }

    /**
     * Part of the power of what is {@link #telling} that is noise [1], on average.
     *
     * @param force whose bands these are
     */
    double noise(Entering force, Window window) {
        double noise = 0;
        double all = 0;
        for (int line = 0; line < window.lines(); line++) {
            double own = power(window.frequency(line));
            double both = own + force.variance()[line];
            noise += own > 0 ? own / both * force.variance()[line] / both : 0;
            all += own > 0 ? own / both : 0;
        }
        return all > 0 ? noise / all : 1;
    }

    /** The same force where all masses are greater by a factor. */
    ForceBands scaled(double factor) {
        return new ForceBands(factor * rms, factor * even, edges, Arrays.stream(power).map(p -> factor * factor * p).toArray());
    }
}
