package wbv.state.markov;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.MessageLength;
import wbv.state.mixture.Mixture;

/** Laws of hidden Markov models, most against sums over all paths. */
class HiddenMarkovTest {

    private static final double[] UNIT = {1, 0, 0, 1};

    /** Table 7-1 of the thesis [%], rows from, columns to; the sixth row's probabilities sum to 99.999. */
    private static final double[][] TABLE_7_1 = {
        {10.018, 11.668, 2.619, 2.720, 15.264, 3.203, 54.507}, {7.7249, 5.482, 0.407, 2.300, 45.207, 9.782, 29.098},
        {1.475, 0.218, 92.387, 7.83e-5, 2.688, 2.550, 0.682}, {0.419, 1.743, 21e-6, 93.399, 0.823, 1.265, 2.350},
        {10.368, 52.105, 0.151, 0.209, 27.114, 3.241, 6.811}, {0.583, 41.702, 2.209, 2.998, 6.044, 10.853, 35.610},
        {6.434, 15.490, 0.688, 3.738, 38.176, 3.927, 31.547}};

    @Test
    void simulatedTable71IsRecoveredWithinItsSamplingError() {
        int k = TABLE_7_1.length;
        double[][] truth = new double[k][];
        List<Mixture> emissions = new ArrayList<>();
        List<Mixture> begin = new ArrayList<>();
        for (int i = 0; i < k; i++) {
            truth[i] = TABLE_7_1[i].clone();
            HiddenMarkov.normalise(truth[i]);
            double[] mean = {6 * Math.cos(2 * Math.PI * i / k), 6 * Math.sin(2 * Math.PI * i / k)};
            emissions.add(Mixture.of(Gaussian.exact(CovarianceShape.FULL, mean, new double[] {0.5, 0, 0, 0.5})));
            begin.add(Mixture.of(Gaussian.exact(CovarianceShape.FULL, new double[] {mean[0] * 0.8, mean[1] * 0.9}, UNIT)));
        }
        double[][] flat = new double[k][k];
        double[] even = new double[k];
        for (int i = 0; i < k; i++) {
            java.util.Arrays.fill(flat[i], 1.0 / k);
            even[i] = 1.0 / k;
        }
        double[][] rows = new double[60_000][2];
        int[] states = new HiddenMarkov(even, truth, emissions).sample(new Well19937c(71), rows);
        HiddenMarkov found = new BaumWelch(40, 1e-3, 0, CovarianceShape.FULL, 1e-6)
                .fit(new HiddenMarkov(even, flat, begin), List.<double[][]>of(rows), share -> {}).model();
        double[] visits = new double[k];
        for (int t = 0; t < states.length - 1; t++) {
            visits[states[t]]++;
        }
        double chiSquare = 0;
        for (int i = 0; i < k; i++) {
            for (int j = 0; j < k; j++) {
                double p = truth[i][j];
                double deviation = Math.sqrt((p * (1 - p) + 1 / visits[i]) / visits[i]);
                double z = (found.transition()[i][j] - p) / deviation;
                assertTrue(Math.abs(z) < 4.5, i + " to " + j + ": " + found.transition()[i][j] + ", true " + p + ", z " + z);
                chiSquare += (1 - p) * z * z;
            }
        }
        // 7 rows of 7 probabilities leave 42 free; 42 + 4.5 √84 is the 4.5σ bound.
        assertTrue(chiSquare < 42 + 4.5 * Math.sqrt(84), "sum of squares " + chiSquare);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void likelihoodNeverFallsWithSeveralSequences(int seed) {
        RandomGenerator random = new Well19937c(seed);
        List<double[][]> sequences = new ArrayList<>();
        for (int length : new int[] {40, 1, 7, 90}) {
            double[][] rows = new double[length][2];
            small(random).sample(random, rows);
            sequences.add(rows);
        }
        sequences.get(3)[10] = new double[] {Double.NaN, 1};
        for (double pseudo : new double[] {0, 0.3}) {
            List<Double> history = new BaumWelch(25, 0, pseudo, CovarianceShape.FULL, 1e-9)
                    .fit(small(random), sequences, share -> {}).history();
            for (int i = 1; i < history.size(); i++) {
                assertTrue(history.get(i) >= history.get(i - 1) - 1e-9, "round " + i + ": " + history);
            }
        }
    }

    @Test
    void posteriorsWithHolesAreTheSumsOverAllPaths() {
        RandomGenerator random = new Well19937c(5);
        HiddenMarkov model = small(random);
        double[][] rows = new double[6][2];
        model.sample(random, rows);
        rows[2] = new double[] {Double.NaN, 0};
        double[][] expected = new double[6][3];
        double whole = 0;
        for (int path = 0; path < 729; path++) {
            int[] states = new int[6];
            double p = 1;
            for (int t = 0, rest = path; t < 6; t++, rest /= 3) {
                states[t] = rest % 3;
                p *= t == 0 ? model.initial()[states[0]] : model.transition()[states[t - 1]][states[t]];
                p *= t == 2 ? 1 : Math.exp(model.emissions().get(states[t]).logDensity(rows[t], new double[2], new double[2]));
            }
            whole += p;
            for (int t = 0; t < 6; t++) {
                expected[t][states[t]] += p;
            }
        }
        Trellis trellis = new Trellis(model, rows);
        assertEquals(Math.log(whole), trellis.logLikelihood(), 1e-12);
        for (int t = 0; t < 6; t++) {
            for (int k = 0; k < 3; k++) {
                assertEquals(expected[t][k] / whole, trellis.posterior()[t][k], 1e-12);
            }
        }
    }

    @Test
    void streamGivesWhatTheTrellisFilters() {
        RandomGenerator random = new Well19937c(6);
        HiddenMarkov model = small(random);
        double[][] rows = new double[300][2];
        model.sample(random, rows);
        rows[7][1] = Double.NaN;
        double[][] filtered = new Trellis(model, rows).filtered();
        ForwardFilter filter = new ForwardFilter(model);
        double[] seen = new double[3];
        double[] looked = new double[3];
        for (int t = 0; t < rows.length; t++) {
            filter.look(rows[t], looked);
            filter.step(rows[t]);
            filter.probabilities(seen);
            assertArrayEquals(seen, looked);
            assertArrayEquals(filtered[t], seen, 1e-12);
        }
    }

    @Test
    void forecastIsTheSumOverAllPathsThatMeetTheState() {
        HiddenMarkov model = small(new Well19937c(7));
        boolean[] wanted = {false, true, false};
        double[] now = {0.2, 0.3, 0.5};
        double expected = 0;
        for (int path = 0; path < 243; path++) {
            double p = 1;
            boolean met = false;
            int before = -1;
            for (int t = 0, rest = path; t < 5; t++, rest /= 3) {
                int state = rest % 3;
                p *= t == 0 ? now[state] : model.transition()[before][state];
                met |= t >= 2 && wanted[state];
                before = state;
            }
            expected += met ? p : 0;
        }
        assertEquals(expected, new Forecast(model, wanted, 2, 4).probability(now), 1e-12);
        double[] ahead = Forecast.ahead(model, now, 1);
        assertEquals(ahead[1], new Forecast(model, wanted, 1, 1).probability(now), 1e-12);
    }

    @Test
    void stateThatNothingSupportsKeepsItsRowAndItsDensity() {
        Mixture near = Mixture.of(Gaussian.exact(CovarianceShape.FULL, new double[] {0, 0}, UNIT));
        Mixture far = Mixture.of(Gaussian.exact(CovarianceShape.FULL, new double[] {1e4, 1e4}, UNIT));
        HiddenMarkov model = new HiddenMarkov(new double[] {1, 0}, new double[][] {{1, 0}, {0.5, 0.5}}, List.of(near, far));
        double[][] rows = new double[50][2];
        model.sample(new Well19937c(8), rows);
        HiddenMarkov found = new BaumWelch(5, 0, 0, CovarianceShape.FULL, 1e-6).fit(model, List.<double[][]>of(rows), share -> {}).model();
        assertArrayEquals(new double[] {0.5, 0.5}, found.transition()[1]);
        assertEquals(1e4, found.emissions().get(1).components().get(0).mean(0));
    }

    @Test
    void rowsThatNoStateCanExplainDoNotBreakTheChain() {
        HiddenMarkov model = small(new Well19937c(9));
        double[][] rows = {{0, 0}, {1e170, 0}, {1e300, -1e300}, {0.1, 0.2}};
        Trellis trellis = new Trellis(model, rows);
        ForwardFilter filter = new ForwardFilter(model);
        for (int t = 0; t < rows.length; t++) {
            filter.step(rows[t]);
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                sum += filter.probability(k);
                assertTrue(trellis.posterior()[t][k] >= 0);
            }
            assertEquals(1, sum, 1e-9);
        }
    }

    @Test
    void constantChannelsAndMoreStatesThanSamplesAreDefined() {
        double[][] rows = {{1, 2}, {1, 2}, {1, 2}};
        Mixture mixture = MessageLength.USUAL.fit(rows, new Well19937c(1), share -> {}).mixture();
        assertEquals(1, mixture.size());
        assertEquals(1, mixture.components().get(0).mean(0), 1e-9);
        HiddenMarkov found = new BaumWelch(10, 0, 0.1, CovarianceShape.FULL, 1e-6)
                .fit(small(new Well19937c(2)), List.<double[][]>of(rows, new double[][] {{3, 1}}), share -> {}).model();
        assertTrue(Double.isFinite(BaumWelch.logLikelihood(found, List.<double[][]>of(rows))));
        assertThrows(IllegalArgumentException.class,
                () -> new BaumWelch(20, 1e-2, 0.1, CovarianceShape.FULL, 1e-6).fit(small(new Well19937c(2)),
                        List.<double[][]>of(new double[][] {{Double.NaN, 1}}), share -> {}));
    }

    @Test
    void filterAllocatesNothingOnceItRuns() {
        HiddenMarkov model = small(new Well19937c(3));
        ForwardFilter filter = new ForwardFilter(model);
        double[] row = {0.3, 0.1};
        for (int i = 0; i < 20_000; i++) {
            filter.step(row);
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
        for (int i = 0; i < 20_000; i++) {
            filter.step(row);
        }
        long bytes = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        assertTrue(bytes < 20_000, bytes + " bytes in 20 000 samples");
    }

    /** Three states in two dimensions, the last a mixture of two. */
    private static HiddenMarkov small(RandomGenerator random) {
        double[][] transition = new double[3][3];
        double[] initial = new double[3];
        for (int i = 0; i < 3; i++) {
            initial[i] = 0.2 + random.nextDouble();
            for (int j = 0; j < 3; j++) {
                transition[i][j] = 0.1 + random.nextDouble() + (i == j ? 2 : 0);
            }
            HiddenMarkov.normalise(transition[i]);
        }
        HiddenMarkov.normalise(initial);
        return new HiddenMarkov(initial, transition, List.of(
                Mixture.of(Gaussian.exact(CovarianceShape.FULL, new double[] {0, 0}, new double[] {1, 0.4, 0.4, 1})),
                Mixture.of(Gaussian.exact(CovarianceShape.FULL, new double[] {2, 1}, UNIT)),
                new Mixture(new double[] {0.3, 0.7}, List.of(Gaussian.exact(CovarianceShape.FULL, new double[] {-2, 1}, UNIT),
                        Gaussian.exact(CovarianceShape.FULL, new double[] {-1, 3}, new double[] {0.5, 0, 0, 0.5})))));
    }
}
