package wbv.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.DoubleStream;
import wbv.state.markov.BaumWelch;
import wbv.state.markov.ForwardFilter;
import wbv.state.markov.HiddenMarkov;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.Mixture;

/**
 * Processor time of hidden Markov models of 7 states over 18 features: a sample of the forward filter, and ten rounds of
 * Baum-Welch on
 * 43 200 rows; {@code hmm_speed.py} among the test resources times hmmlearn on the like. Processor time of one thread, so that
 * other
 * work on the machine counts little.
 */
public final class StatesTiming {

    private static final int ROWS = 43_200;
    private static final int STATES = 7;
    private static final int FEATURES = 18;
    private static final int RUNS = 5;

    private StatesTiming() {}

    public static void main(String[] words) {
        Random random = new Random(1);
        double[][] rows = rows(random);
        for (CovarianceShape shape : CovarianceShape.values()) {
            HiddenMarkov model = model(rows, shape, random);
            double sample = median(() -> {
                ForwardFilter filter = new ForwardFilter(model);
                for (int pass = 0; pass < 10; pass++) {
                    for (double[] row : rows) {
                        filter.step(row);
                    }
                }
            }) / (10.0 * ROWS);
            double rounds = median(() -> new BaumWelch(10, 0, 0.1, shape, 1e-6).fit(model, List.<double[][]>of(rows),
                    share -> {}));
            System.out.printf(Locale.ROOT, "%s: %.0f ns a sample (%.2f million a second), ten rounds %.2f s%n", shape,
                    1e9 * sample,
                    1e-6 / sample, rounds);
        }
    }

    /** Middle of five after two to warm up [s]. */
    private static double median(Runnable task) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        double[] seconds = new double[RUNS];
        for (int run = -2; run < RUNS; run++) {
            long before = threads.getCurrentThreadCpuTime();
            task.run();
            seconds[Math.max(0, run)] = 1e-9 * (threads.getCurrentThreadCpuTime() - before);
        }
        return DoubleStream.of(seconds).sorted().skip(RUNS / 2).findFirst().orElseThrow();
    }

    private static double[][] rows(Random random) {
        double[][] centres = new double[STATES][FEATURES];
        for (double[] centre : centres) {
            Arrays.setAll(centre, i -> 2 * random.nextGaussian());
        }
        double[][] rows = new double[ROWS][FEATURES];
        for (int t = 0; t < ROWS; t++) {
            double[] centre = centres[t / 60 % STATES];
            Arrays.setAll(rows[t], i -> centre[i] + random.nextGaussian());
        }
        return rows;
    }

    private static HiddenMarkov model(double[][] rows, CovarianceShape shape, Random random) {
        double[] wide = new double[FEATURES * FEATURES];
        for (int i = 0; i < FEATURES; i++) {
            wide[i * FEATURES + i] = 4;
        }
        List<Mixture> emissions = new ArrayList<>();
        double[][] transition = new double[STATES][STATES];
        double[] initial = new double[STATES];
        for (int k = 0; k < STATES; k++) {
            emissions.add(Mixture.of(Gaussian.exact(shape, rows[random.nextInt(ROWS)], wide)));
            Arrays.fill(transition[k], 0.1 / (STATES - 1));
            transition[k][k] = 0.9;
            initial[k] = 1.0 / STATES;
        }
        return new HiddenMarkov(initial, transition, emissions);
    }
}
