package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.function.LongFunction;
import java.util.stream.DoubleStream;

/** Estimates of a and b of {@link KnownSystem#armax} over seeds: by fits that state deviations, or by models alone. */
record Scatter(double[][] estimates, double[][] deviations) {

    private static final double[] TRUTH = DoubleStream.concat(Arrays.stream(KnownSystem.A), Arrays.stream(KnownSystem.B))
            .toArray();

    static Scatter of(int seeds, LongFunction<ArmaxFit> method) {
        double[][] estimates = new double[seeds][];
        double[][] deviations = new double[seeds][];
        for (int seed = 0; seed < seeds; seed++) {
            ArmaxFit fit = method.apply(seed);
            estimates[seed] = ArmaxTest.coefficients(fit.model());
            deviations[seed] = fit.deviations();
        }
        return new Scatter(estimates, deviations);
    }

    double mean(int i) {
        return Arrays.stream(estimates).mapToDouble(e -> e[i]).average().orElseThrow();
    }

    double deviation(int i) {
        double mean = mean(i);
        return Math.sqrt(Arrays.stream(estimates).mapToDouble(e -> (e[i] - mean) * (e[i] - mean)).sum() / (estimates.length - 1));
    }

    double claimed(int i) {
        return Arrays.stream(deviations).mapToDouble(d -> d[i]).average().orElseThrow();
    }

    /**
     * The mean of every coefficient of A and B lies within so many of its standard errors, and the scatter is what was claimed.
     */
    void requireUnbiasedAndHonest(double sigmas) {
        for (int i = 0; i < TRUTH.length; i++) {
            double error = claimed(i) / Math.sqrt(estimates.length);
            assertTrue(Math.abs(mean(i) - TRUTH[i]) < sigmas * error, "coefficient " + i + " is biased: " + mean(i)
                    + " for " + TRUTH[i]
                    + " ± " + error);
            double ratio = deviation(i) / claimed(i);
            assertTrue(ratio > 0.35 && ratio < 2, "coefficient " + i + " scatters " + ratio + " times as much as claimed");
        }
    }
}
