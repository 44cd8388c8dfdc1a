package wbv.diagnosis.picture;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.learn.LatentForce;

/**
 * Samples of one signal over another: a thinned cloud of the fitted part and of the held-out part, and the mean of all of them.
 */
final class Clouds {

    private static final int MOST = 1500;
    private static final int BINS = 28;
    private static final int LEAST = 8;

    /** How much of a force is shown over time [s]; its last second, or quarter, is known worse. */
    private static final double SHOWN = 4;
    private static final double LAST = 1;
    private static final double QUARTER = 0.25;

    private final Evidence evidence;
    private final IntPredicate known;

    Clouds(Evidence evidence, IntPredicate known) {
        this.evidence = evidence;
        this.known = known;
    }

    /**
     * The two clouds and their mean.
     *
     * @param x by sample
     * @param xUnit factor to the unit shown
     * @param y by sample
     * @param yUnit likewise
     */
    List<Portrait.Trail> samples(double[] x, double xUnit, double[] y, double yUnit) {
        // The end is held out, or the beginning where it is the end that was fitted.
        IntPredicate held = evidence.isLate() ? i -> i < evidence.fit().start() : i -> i >= evidence.heldOut().start();
        return List.of(cloud("fitted part", x, xUnit, y, yUnit, i -> known.test(i) && !held.test(i)),
                cloud("held-out part", x, xUnit, y, yUnit, i -> known.test(i) && held.test(i)),
                mean("mean", Portrait.Kind.MEAN, x, xUnit, y, yUnit));
    }

    private static Portrait.Trail cloud(String name, double[] x, double xUnit, double[] y, double yUnit, IntPredicate chosen) {
        int[] all = IntStream.range(0, x.length).filter(chosen).toArray();
        int stride = Math.max(1, (all.length + MOST - 1) / MOST);
        int[] shown = IntStream.range(0, all.length / stride).map(i -> all[i * stride]).toArray();
        return Portrait.Trail.samples(name, scaled(x, shown, xUnit), scaled(y, shown, yUnit));
    }

    /** Means of y in bins of x, narrower where there are more samples, with their standard errors. */
    Portrait.Trail mean(String name, Portrait.Kind kind, double[] x, double xUnit, double[] y, double yUnit) {
        int[] shown = IntStream.range(0, x.length).filter(known).toArray();
        double[] sorted = scaled(x, shown, 1);
        Arrays.sort(sorted);
        double[] edges = new double[BINS + 1];
        for (int b = 0; b <= BINS; b++) {
            double even = sorted[0] + (sorted[sorted.length - 1] - sorted[0]) * b / BINS;
            edges[b] = (even + sorted[(sorted.length - 1) * b / BINS]) / 2;
        }
        double[][] sums = new double[BINS][4];
        for (int i : shown) {
            int at = Arrays.binarySearch(edges, x[i]);
            int bin = Math.max(0, Math.min(BINS - 1, at >= 0 ? at : -at - 2));
            sums[bin][0]++;
            sums[bin][1] += x[i];
            sums[bin][2] += y[i];
            sums[bin][3] += y[i] * y[i];
        }
        double[][] full = Arrays.stream(sums).filter(s -> s[0] >= LEAST).toArray(double[][]::new);
        return new Portrait.Trail(name, kind, Arrays.stream(full).mapToDouble(s -> xUnit * s[1] / s[0]).toArray(),
                Arrays.stream(full).mapToDouble(s -> yUnit * s[2] / s[0]).toArray(), kind != Portrait.Kind.MEAN ? new double[0]
                        : Arrays.stream(full).mapToDouble(s -> yUnit * Math.sqrt(Math.max(0, s[3] / s[0]
                                - Math.pow(s[2] / s[0], 2)) / s[0])).toArray());
    }

    private static double[] scaled(double[] values, int[] at, double unit) {
        return IntStream.of(at).mapToDouble(i -> unit * values[i]).toArray();
    }

    /** A force over the beginning of the held-out part, and what was found of it. */
    static List<Portrait.Trail> histories(Evidence evidence, double[] force, String name, double[] law) {
        double rate = evidence.recording().clock().rate();
        double held = evidence.heldOut().length();
        int from = evidence.heldOut().start();
        int to = from + (int) Math.round(Math.min(SHOWN * rate, held - Math.min(LAST * rate, QUARTER * held)));
        double[] time = IntStream.range(from, to).mapToDouble(evidence.recording()::elapsed).toArray();
        return List.of(
                Portrait.Trail.measured("force that the recording asks for", time, Arrays.copyOfRange(force, from, to), new double[0]),
                Portrait.Trail.law(name, time, Arrays.copyOfRange(law, from, to)));
    }

    /** What is said of a picture, with how far the sensors' noise scatters a sample of the force. */
    static String noted(LatentForce latent, String words) {
        return words + String.format(Locale.ROOT, " The sensors' noise alone scatters a sample by ±%.2g N.", 2 * latent.pointNoise());
    }
}
