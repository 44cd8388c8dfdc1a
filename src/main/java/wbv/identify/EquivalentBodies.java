package wbv.identify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import wbv.signal.GapBridge;
import wbv.signal.RealDft;

/**
 * Finds the {@link EquivalentBody} between the base and each output of one {@link MotionWindow}. Immutable: one object may serve many
 * threads.
 */
public final class EquivalentBodies {

    /** Corner below which motion counts as gravity and bias [Hz], as the streaming estimators have it. */
    private static final double CORNER = 0.1;
    /** Motion of before the stretch that the fit leaves aside; half of it after a gap of an input [s]. */
    private static final double SETTLING = 2;
    /** Time over which the level at the beginning is taken [s]. */
    private static final double LEVEL = 5;
    /** Missing samples that are bridged [s]. */
    private static final double LONGEST_BRIDGE = 0.05;
    /** Least length of a fit [s]: enough batches for a deviation. */
    private static final double SHORTEST = 18;
    /** Part of the stretch on which rivals are fitted; the rest judges them, in batches of a third of the usual length. */
    private static final double FITTED = 0.7;
    private static final int JUDGING = 3;
    /** Batches of which the deviation is made: 16 leave Student's quantile within 8 % of the normal one. */
    private static final int BATCHES = 16;
    /** Shortest batch [s]: some tens of a seated body's memories, and some sweeps. */
    private static final double SHORTEST_BATCH = 3;
    /** Probability of taking a motion, or a second mode, that brings nothing. */
    private static final double SIGNIFICANCE = 0.01;
    /** Where fits begin: natural frequencies [Hz] and damping ratios; a second mode at these times the first's frequency. */
    private static final double[] FREQUENCIES = {1.2, 2, 3, 4.2, 5.5, 7.5, 11, 16};
    private static final double[] DAMPINGS = {0.1, 0.3, 0.9};
    private static final double[] APART = {0.5, 1.6, 2.5, 4};
    private static final double SECOND_DAMPING = 0.3;
    private static final double SECOND_SHARE = 0.8;

    private final double rate;
    private final int n;
    private final int cut;
    private final double start;
    private final double[][] others;
    private final boolean[] sound;
    private final RealDft dft;
    private final double[] spectrum;
    private final int batch;
    private final CrossMotions crossing;
    private final Parts common;

    /** Samples that count: all, those on which rivals are fitted, and those that judge them. */
    private record Parts(CrossMotions.On all, CrossMotions.On early, CrossMotions.On late) {
        private static Parts of(CrossMotions.On early, CrossMotions.On late) {
            return new Parts(early.and(late), early, late);
        }
    }

    /**
     * Bridges and levels what moves the base, which all outputs share.
     *
     * @param window of the input, of the base's other motions, then of anything
     * @param motions number of other motions
     */
    public EquivalentBodies(MotionWindow window, int motions) {
        rate = window.rate();
        n = window.length();
        start = window.first() / rate;
        sound = new boolean[n];
        Arrays.fill(sound, true);
        double[] u = input(window.channel(0));
        others = new double[motions][];
        Arrays.setAll(others, i -> input(window.channel(1 + i)));
        for (int t = 0; t < Math.min(n, SETTLING * rate); t++) {
            sound[t] = false;
        }
        dft = new RealDft(RealDft.covering(n + (int) Math.ceil(2 * SETTLING * rate)));
        spectrum = dft.forward(Arrays.copyOf(u, dft.length()));
        batch = (int) Math.max(SHORTEST_BATCH * rate, n / (double) BATCHES);
        crossing = new CrossMotions(rate, others, n);
        cut = (int) (FITTED * n);
        common = Parts.of(crossing.on(weight(sound, 0, cut)), crossing.on(weight(sound, cut, n)));
    }

    /** On the samples that count where an output misses some. */
    private Parts only(boolean[] counts) {
        return Parts.of(common.early.only(weight(counts, 0, cut)), common.late.only(weight(counts, cut, n)));
    }

    private double[] weight(boolean[] counts, int from, int to) {
        double[] weight = new double[n];
        for (int t = from; t < to; t++) {
            weight[t] = counts[t] ? 1 : 0;
        }
        return weight;
    }

    /** An input without gaps and offset. Where it is missing for long, nothing counts until that is forgotten. */
    private double[] input(double[] raw) {
        double[] x = bridged(raw);
        int disturbed = 0;
        for (int t = 0; t < n; t++) {
            disturbed = Double.isFinite(x[t]) ? disturbed - 1 : (int) (SETTLING / 2 * rate);
            sound[t] &= disturbed <= 0;
        }
        return withoutOffset(x);
    }

    /** y' = a (y' + x - x₋), a first-order high-pass from the level of the first seconds, that rests where samples are missing. */
    private double[] withoutOffset(double[] x) {
        double[] out = new double[n];
        double keep = Math.exp(-2 * Math.PI * CORNER / rate);
        double last = Arrays.stream(x, 0, (int) Math.min(n, LEVEL * rate)).filter(Double::isFinite).average().orElse(0);
        double high = 0;
        for (int t = 0; t < n; t++) {
            boolean there = Double.isFinite(x[t]);
            high = keep * (high + (there ? x[t] - last : 0));
            last = there ? x[t] : last;
            out[t] = high;
        }
        return out;
    }

    private double[] bridged(double[] x) {
        return GapBridge.over(x, Math.max(1, (int) Math.round(LONGEST_BRIDGE * rate)));
    }

    private EquivalentBodyFit fit(double[] y, CrossMotions.On on, List<Integer> with, int modes) {
        return new EquivalentBodyFit(rate, dft, spectrum, y, on.weight(), on.by(with), new ModalBody(modes));
    }

    /**
     * The body between input and an output.
     *
     * @param output  by sample of the window, in its own unit. Not modified.
     * @param degrees 1 or 2, or 0 for two where one does not carry the output and two do better on data they were not fitted to
     * @return empty if nothing moves, or there is too little to fit
     */
    public Optional<EquivalentBody> of(double[] output, int degrees) {
        double[] bridged = bridged(output);
        double[] y = withoutOffset(bridged);
        boolean[] counts = new boolean[n];
        int counted = 0;
        double mean = 0;
        for (int t = 0; t < n; t++) {
            counts[t] = sound[t] && Double.isFinite(bridged[t]);
            counted += counts[t] ? 1 : 0;
            mean += counts[t] ? y[t] : 0;
        }
        if (counted < SHORTEST * rate) {
            return Optional.empty();
        }
        mean /= counted;
        double power = 0;
        for (int t = 0; t < n; t++) {
            y[t] -= mean;
            power += counts[t] ? y[t] * y[t] : 0;
        }
        return power >= Double.MIN_NORMAL ? of(y, power, Arrays.equals(counts, sound) ? common : only(counts), degrees) : Optional.empty();
    }

    private Optional<EquivalentBody> of(double[] y, double power, Parts parts, int degrees) {
        double[] theta = start(fit(y, parts.all(), List.of(), 1));
        if (theta.length == 0) {
            return Optional.empty();
        }
        List<Integer> with = helping(y, parts, theta);
        EquivalentBodyFit fit = fit(y, parts.all(), with, 1);
        double left = fit.whole();
        double cost = fit.minimise(theta);
        boolean two = degrees == 2
                || degrees == 0 && 1 - cost / left < EquivalentBody.LEAST_SHARE && twoDoBetter(y, parts, with, theta);
        if (two) {
            fit = fit(y, parts.all(), with, 2);
            theta = two(fit, theta);
            cost = fit.cost(theta);
        }
        double[] deviation = fit.deviations(theta, batch);
        if (deviation.length == 0) {
            return Optional.empty();
        }
        int modes = two ? 2 : 1;
        List<EquivalentBody.Mode> list = new ArrayList<>();
        for (int m = 0; m < modes; m++) {
            double f = ModalBody.frequency(theta, m);
            double z = ModalBody.damping(theta, m);
            list.add(new EquivalentBody.Mode(f, f * deviation[2 * m] / 2, z, z * deviation[2 * m + 1] / 2));
        }
        list.sort(Comparator.comparingDouble(EquivalentBody.Mode::frequency));
        double alone = with.isEmpty() ? cost : fit(y, parts.all(), List.of(), modes).cost(theta);
        return Optional.of(new EquivalentBody(list, start, start + n / rate, 1 - alone / power, 1 - cost / power, 1 - cost / left, with));
    }

    /** Where one mode costs least; empty where it costs no number anywhere. */
    private static double[] start(EquivalentBodyFit fit) {
        double[] best = new double[0];
        double least = Double.POSITIVE_INFINITY;
        for (double f : FREQUENCIES) {
            for (double z : DAMPINGS) {
                double[] theta = {Math.log(2 * Math.PI * f), Math.log(z)};
                double cost = fit.cost(theta);
                if (cost < least) {
                    least = cost;
                    best = theta;
                }
            }
        }
        if (best.length > 0) {
            fit.minimise(best);
        }
        return best;
    }

    /** The best of two modes, from one and several second ones. */
    private static double[] two(EquivalentBodyFit fit, double[] one) {
        double[] best = new double[0];
        double least = Double.POSITIVE_INFINITY;
        for (double apart : APART) {
            double[] theta = {one[0], one[1], one[0] + Math.log(apart), Math.log(SECOND_DAMPING), SECOND_SHARE, 0};
            double cost = fit.minimise(theta);
            if (cost < least) {
                least = cost;
                best = theta;
            }
        }
        return best;
    }

    /** Whether two modes fitted to the first part simulate the rest better than one. */
    private boolean twoDoBetter(double[] y, Parts parts, List<Integer> with, double[] one) {
        double[] a = one.clone();
        fit(y, parts.early(), with, 1).minimise(a);
        double[] b = two(fit(y, parts.early(), with, 2), one);
        return better(fit(y, parts.late(), with, 1).errors(a), fit(y, parts.late(), with, 2).errors(b), 1);
    }

    /** Other motions whose part in the output, learned on the first stretch, makes the errors smaller on the rest. */
    private List<Integer> helping(double[] y, Parts parts, double[] theta) {
        List<Integer> with = new ArrayList<>();
        double[] early = fit(y, parts.early(), List.of(), 1).errors(theta);
        double[] late = fit(y, parts.late(), List.of(), 1).errors(theta);
        double[] before = late;
        while (with.size() < others.length) {
            int best = -1;
            double least = Double.POSITIVE_INFINITY;
            double[] errors = before;
            for (int i = 0; i < others.length; i++) {
                List<Integer> candidate = new ArrayList<>(with);
                candidate.add(i);
                CrossMotions.Explaining learned = parts.early().by(candidate);
                if (with.contains(i) || !learned.sound()) {
                    continue;
                }
                double[] left = late.clone();
                parts.late().by(candidate).takeOut(left, learned.coefficients(early));
                double cost = Arrays.stream(left, 0, n).map(e -> e * e).sum();
                if (cost < least) {
                    least = cost;
                    best = i;
                    errors = left;
                }
            }
            if (best < 0 || !better(before, errors, others.length)) {
                return with;
            }
            with.add(best);
            before = errors;
        }
        return with;
    }

    /**
     * Whether the second errors are smaller, by the scatter of their difference over batches (one-sided).
     *
     * @param looks comparisons made
     */
    private boolean better(double[] first, double[] second, int looks) {
        SummaryStatistics gains = new SummaryStatistics();
        int length = Math.max((int) Math.ceil(rate), batch / JUDGING);
        for (int from = cut; from + length <= n; from += length) {
            double gain = 0;
            for (int t = from; t < from + length; t++) {
                gain += first[t] * first[t] - second[t] * second[t];
            }
            gains.addValue(gain);
        }
        if (gains.getN() < 3 || !(gains.getStandardDeviation() > 0)) {
            return false;
        }
        double t = gains.getMean() / gains.getStandardDeviation() * Math.sqrt(gains.getN());
        return t > new TDistribution(gains.getN() - 1.0).inverseCumulativeProbability(1 - SIGNIFICANCE / looks);
    }
}
