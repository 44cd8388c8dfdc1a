package wbv.signal;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * Puts in place of lost samples what the samples about them make likeliest: the linear combination of least mean square error (Wiener
 * 1949), by the series' own autocorrelation, which is found from the series with such gaps bridged, in a few rounds. So a series that
 * moves from sample to sample is bridged as well as its noise allows, where a polynomial knows slow ones only. A gap longer than that gets
 * a straight line.
 */
public final class LostSamples {

    /** Longest gap that is filled so, and samples on either side that are asked. */
    private static final int REACH = 16;
    /** Rounds in which the autocorrelation settles: with a hundredth lost each takes what is wrong of it down to a tenth. */
    private static final int ROUNDS = 3;
    /** Part of the power that no sample tells of another [1]: what rounding leaves of an autocorrelation. */
    private static final double OWN = 1e-10;

    private final double[] out;
    private final boolean[] lost;
    /** Those of them in gaps too long to be filled so, whose straight lines tell nothing of the series. */
    private final boolean[] far;
    /** Weights of the neighbours by which of them are there, one set a sample of the gap. */
    private final Map<BitSet, double[][]> known = new HashMap<>();
    private double[] correlation = new double[0];

    private LostSamples(double[] x) {
        this.out = x.clone();
        this.lost = new boolean[x.length];
        for (int i = 0; i < x.length; i++) {
            lost[i] = Double.isNaN(x[i]);
        }
        this.far = new boolean[x.length];
        for (int from = 0; from < x.length; from++) {
            int to = from;
            while (to < x.length && lost[to]) {
                to++;
            }
            Arrays.fill(far, from, to, to - from > REACH);
            from = to;
        }
    }

    /**
     * A series in its own unit, NaN where it does not count: a new array.
     *
     * @param x a series of any unit
     * @param valid samples that count. Neither is modified.
     */
    public static double[] marked(double[] x, boolean[] valid) {
        return IntStream.range(0, x.length).mapToDouble(i -> valid[i] ? x[i] : Double.NaN).toArray();
    }

    /**
     * A series in its own unit without gaps; the array itself if it has none, zero if it has nothing else.
     *
     * @param x a series of any unit, NaN where lost. Not modified.
     */
    public static double[] filled(double[] x) {
        if (Arrays.stream(x).noneMatch(Double::isNaN)) {
            return x;
        }
        LostSamples series = new LostSamples(x);
        series.straight();
        for (int round = 0; round < ROUNDS; round++) {
            series.fill();
        }
        return series.out;
    }

    /**
     * The same, at its mean in pauses, to which it goes and from which it comes within {@value #REACH} samples: what was
     * measured before says nothing of one, and a line through all of it would push on.
     *
     * @param x a series of any unit, NaN where lost. Not modified.
     * @param pause samples that are lost together at least to be one
     */
    public static double[] resting(double[] x, int pause) {
        double[] pausing = x.clone();
        double mean = mean(x);
        int last = -1;
        for (int i = 0; i < x.length; i++) {
            if (!Double.isNaN(x[i])) {
                if (last >= 0 && i - last > Math.max(pause, 2 * REACH)) {
                    Arrays.fill(pausing, last + 1 + REACH, i - REACH, mean);
                }
                last = i;
            }
        }
        return filled(pausing);
    }

    /**
     * The same less its mean, which is that of the samples that are there: a new array.
     *
     * @param x a series of any unit, NaN where lost. Not modified.
     */
    public static double[] centred(double[] x) {
        double mean = mean(x);
        return Arrays.stream(filled(x)).map(value -> value - mean).toArray();
    }

    /**
     * The mean of the samples that are there, in their unit; zero if none is.
     *
     * @param x a series of any unit, NaN where lost. Not modified.
     */
    public static double mean(double[] x) {
        return Arrays.stream(x).filter(value -> !Double.isNaN(value)).average().orElse(0);
    }

    /** Straight lines over all gaps; what is lost at an end is as the last there is. */
    private void straight() {
        int last = -1;
        for (int i = 0; i < out.length; i++) {
            if (!lost[i]) {
                for (int j = last + 1; j < i; j++) {
                    out[j] = last < 0 ? out[i] : out[last] + (out[i] - out[last]) * (j - last) / (i - last);
                }
                last = i;
            }
        }
        Arrays.fill(out, last + 1, out.length, last < 0 ? 0 : out[last]);
    }

    private void fill() {
        double mean = IntStream.range(0, out.length).filter(i -> !far[i]).mapToDouble(i -> out[i]).average().orElse(0);
        correlation = correlation(mean);
        known.clear();
        if (!(correlation[0] > 0)) {
            return;
        }
        double[] next = out.clone();
        int from = 0;
        while (from < out.length) {
            int to = from;
            while (to < out.length && lost[to]) {
                to++;
            }
            if (to > from && to - from <= REACH && from > 0 && to < out.length) {
                fill(from, to, mean, next);
            }
            from = to + 1;
        }
        System.arraycopy(next, 0, out, 0, out.length);
    }

    /** Biased, so that no combination of samples has a negative power. */
    private double[] correlation(double mean) {
        double[] centred = new double[out.length];
        for (int i = 0; i < out.length; i++) {
            centred[i] = far[i] ? 0 : out[i] - mean;
        }
        double[] sums = new double[3 * REACH + 1];
        for (int lag = 0; lag < sums.length; lag++) {
            for (int i = lag; i < out.length; i++) {
                sums[lag] += centred[i] * centred[i - lag];
            }
        }
        sums[0] *= 1 + OWN;
        return sums;
    }

    private void fill(int from, int to, double mean, double[] next) {
        int gap = to - from;
        int[] near = IntStream.concat(IntStream.range(from - REACH, from), IntStream.range(to, to + REACH))
                .filter(i -> i >= 0 && i < out.length && !lost[i]).toArray();
        BitSet there = new BitSet();
        Arrays.stream(near).forEach(i -> there.set(i - from + REACH));
        double[][] weights = known.computeIfAbsent(there, key -> weights(key.stream().map(i -> i - REACH).toArray(), gap));
        for (int g = 0; g < gap; g++) {
            double sum = mean;
            for (int i = 0; i < near.length; i++) {
                sum += weights[g][i] * (out[near[i]] - mean);
            }
            next[from + g] = sum;
        }
    }

    /**
     * Weights [1] of neighbours, by sample of a gap.
     *
     * @param near their places, from the gap's first sample
     */
    private double[][] weights(int[] near, int gap) {
        DMatrixRMaj among = new DMatrixRMaj(near.length, near.length);
        DMatrixRMaj with = new DMatrixRMaj(near.length, gap);
        for (int i = 0; i < near.length; i++) {
            for (int j = 0; j < near.length; j++) {
                among.set(i, j, correlation[Math.abs(near[i] - near[j])]);
            }
            for (int g = 0; g < gap; g++) {
                with.set(i, g, correlation[Math.abs(near[i] - g)]);
            }
        }
        DMatrixRMaj solved = new DMatrixRMaj(near.length, gap);
        LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(near.length);
        if (!solver.setA(among)) {
            throw new IllegalStateException("an autocorrelation is positive definite");
        }
        solver.solve(with, solved);
        double[][] out = new double[gap][near.length];
        for (int g = 0; g < gap; g++) {
            for (int i = 0; i < near.length; i++) {
                out[g][i] = solved.get(i, g);
            }
        }
        return out;
    }
}
