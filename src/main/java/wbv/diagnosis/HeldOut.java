package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.fit.Window;
import wbv.diagnosis.search.NoiseMetric;
import wbv.signal.ScalarProduct;

/**
 * Errors of two models on data that took no part in the fit, by output and band, and how far they might have come out otherwise
 * on another stretch of the same kind: blocks of the stretch are drawn anew with replacement, overlapping and closed to a ring
 * (Künsch 1989; Politis and Romano 1992), the same blocks for all outputs and bands, since what happens in one happens in all.
 */
final class HeldOut {

    private static final int REPLICATES = 1000;
    private static final double LOW = 0.05;
    private static final double HIGH = 0.95;
    /** Length of a cell, of which blocks are made [s]. */
    private static final double CELL = 0.5;
    private static final int CELLS = 24;
    /** Cells in a block: longer than any motion of a sitter rings on. */
    private static final int BLOCK = 6;
    /** Part of the input's noise that the recorder's own low-pass lets through. */
    private static final double PASSED = 0.9;
    /** A mismatch this much above the noise, or less, is nothing of which a share could be removed. */
    private static final double LEAST = 0.2;

    private final Evidence evidence;
    private final RandomGenerator random;
    private final Window window;
    private final double rate;
    private final int cells;

    /** @param random draws the blocks */
    HeldOut(Evidence evidence, RandomGenerator random) {
        this.evidence = evidence;
        this.random = random;
        this.window = evidence.heldOut();
        this.rate = evidence.recording().clock().rate();
        this.cells = Math.max(CELLS, (int) (window.length() / rate / CELL));
    }

    /**
     * Energy by cell of one output in one band.
     *
     * @param all  of the signal in all bands, against which errors are seen
     * @param own  of the signal in this band
     * @param floor energy of the noise in the whole window
     */
    private record Slice(String channel, double[] band, double[] all, double[] own, double[] before, double[] after,
            double floor) {}

    /** Whole outputs first, then their bands from the lowest. */
    List<Diagnosis.Proof> of(Fitter.State before, Fitter.State after) {
        Readings readings = new Readings(evidence);
        double[][] first = readings.of(before);
        double[][] second = before == after ? first : readings.of(after);
        NoiseMetric noise = new NoiseMetric(evidence, evidence.whole(), after.candidate().at(after.x()));
        double[] edges = Bands.edges(evidence, window);
        List<Slice> slices = new ArrayList<>();
        for (int o = 0; o < first.length; o++) {
            slices.add(whole(o, first[o], second[o], noise));
        }
        for (int o = 0; o < first.length; o++) {
            slices.addAll(bands(o, first[o], second[o], noise, edges));
        }
        double[][] draws = draws();
        return slices.stream().map(slice -> proof(slice, draws)).toList();
    }

    /** All samples that count, as they are. */
    private Slice whole(int o, double[] before, double[] after, NoiseMetric noise) {
        double[] y = new double[window.length()];
        double[] b = new double[y.length];
        double[] a = new double[y.length];
        int counted = 0;
        for (int i = 0; i < y.length; i++) {
            int at = window.start() + i;
            if (evidence.valid(o)[at]) {
                counted++;
                y[i] = evidence.measured(o)[at];
                b[i] = y[i] - before[at];
                a[i] = y[i] - after[at];
            }
        }
        double own = Math.pow(evidence.noise()[o], 2);
        double floor = counted * (own + PASSED * (mean(noise, o, 0, rate / 2) - own));
        double[] signal = energy(y);
        return new Slice(evidence.outputs().get(o).toString(), new double[] {0, rate / 2}, signal, signal, energy(b), energy(a),
                floor);
    }

    private List<Slice> bands(int o, double[] before, double[] after, NoiseMetric noise, double[] edges) {
        double[] measured = evidence.measured(o);
        boolean[] valid = evidence.valid(o);
        double[] y = window.spectrum(measured, valid);
        double[] b = window.spectrum(less(measured, before), valid);
        double[] a = window.spectrum(less(measured, after), valid);
        double[] all = energy(window.series(y));
        List<Slice> out = new ArrayList<>();
        for (int i = 0; i + 1 < edges.length; i++) {
            double floor = window.weight() * mean(noise, o, edges[i], edges[i + 1]) * (edges[i + 1] - edges[i]) / (rate / 2);
            out.add(new Slice(evidence.outputs().get(o).toString(), new double[] {edges[i], edges[i + 1]}, all,
                    within(y, edges, i),
                    within(b, edges, i), within(a, edges, i), floor));
        }
        return out;
    }

    /** Energy by cell of the part of a spectrum between two edges. */
    private double[] within(double[] spectrum, double[] edges, int band) {
        double[] part = spectrum.clone();
        for (int line = 0; line < window.lines(); line++) {
            double f = window.frequency(line);
            if (f < edges[band] || f >= edges[band + 1] && band + 2 < edges.length) {
                part[2 * line] = 0;
                part[2 * line + 1] = 0;
            }
        }
        return energy(window.series(part));
    }

    private double[] energy(double[] series) {
        double[] out = new double[cells];
        for (int i = 0; i < series.length; i++) {
            out[(int) ((long) i * cells / series.length)] += series[i] * series[i];
        }
        return out;
    }

    private static double[] less(double[] a, double[] b) {
        return IntStream.range(0, a.length).mapToDouble(i -> a[i] - b[i]).toArray();
    }

    /** Variance of a sample of white noise as strong as what is in a band. */
    private double mean(NoiseMetric noise, int o, double from, double to) {
        double[] omega = evidence.whole().omega();
        return IntStream.range(0, omega.length).filter(k -> omega[k] >= 2 * Math.PI * from && omega[k] <= 2 * Math.PI * to)
                .mapToDouble(k -> noise.variance(o, k)).average().orElse(Math.pow(evidence.noise()[o], 2));
    }

    /** How often each cell is drawn, by replicate. */
    private double[][] draws() {
        int blocks = Math.round((float) cells / BLOCK);
        double[][] out = new double[REPLICATES][cells];
        for (double[] counts : out) {
            for (int b = 0; b < blocks; b++) {
                int from = random.nextInt(cells);
                for (int i = 0; i < BLOCK; i++) {
                    counts[(from + i) % cells] += (double) cells / (blocks * BLOCK);
                }
            }
        }
        return out;
    }

    private Diagnosis.Proof proof(Slice slice, double[][] draws) {
        double[] once = new double[cells];
        Arrays.fill(once, 1);
        double share = ScalarProduct.of(once, slice.own()) / ScalarProduct.of(once, slice.all());
        return new Diagnosis.Proof(slice.channel(), slice.band(), share,
                ranged(draws, once, counts -> root(slice.before(), slice.all(), counts)),
                ranged(draws, once, counts -> root(slice.after(), slice.all(), counts)),
                Math.sqrt(slice.floor() / ScalarProduct.of(once, slice.all())),
                ranged(draws, once, counts -> removed(slice, counts)));
    }

    private static double root(double[] error, double[] signal, double[] counts) {
        return Math.sqrt(ScalarProduct.of(error, counts) / ScalarProduct.of(signal, counts));
    }

    /** Part of what is above the noise that the later model removes; NaN where there is nothing to remove. */
    private static double removed(Slice slice, double[] counts) {
        double before = ScalarProduct.of(slice.before(), counts) - slice.floor();
        double after = ScalarProduct.of(slice.after(), counts) - slice.floor();
        return before > LEAST * slice.floor() ? Math.min(1, (before - after) / before) : Double.NaN;
    }

    private static Diagnosis.Ranged ranged(double[][] draws, double[] once, ToDoubleFunction<double[]> figure) {
        double[] all = Arrays.stream(draws).mapToDouble(figure).toArray();
        if (Arrays.stream(all).anyMatch(Double::isNaN)) {
            return new Diagnosis.Ranged(figure.applyAsDouble(once), Double.NaN, Double.NaN);
        }
        Arrays.sort(all);
        return new Diagnosis.Ranged(figure.applyAsDouble(once), all[(int) (LOW * all.length)],
                all[(int) (HIGH * all.length) - 1]);
    }
}
