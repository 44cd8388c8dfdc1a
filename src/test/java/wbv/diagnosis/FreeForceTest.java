package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.apache.commons.math3.analysis.integration.SimpsonIntegrator;
import org.junit.jupiter.api.Test;

/** A force of no law, held to quadrature over its levels, and to what it is drawn from. */
class FreeForceTest {

    private static final Window WINDOW = new Window(0, 1200, 60);
    private static final int OUTPUTS = 2;
    private static final double LEAST = 1e-2;
    private static final double MOST = 100;

    private static double[] gaussian(Random random, int n, double size) {
        double[] out = new double[n];
        Arrays.setAll(out, i -> size * random.nextGaussian());
        return out;
    }

    /** Lines of each of fourteen bands, of which each is as wide as all others on a logarithmic axis. */
    private static int band(int line) {
        double low = WINDOW.frequency(0);
        double top = WINDOW.frequency(WINDOW.lines() - 1);
        int band = 0;
        while (band < 13 && line >= Math.round((low * Math.pow(top / low, (band + 1) / 14.0) - low) / WINDOW.spacing())) {
            band++;
        }
        return band;
    }

    @Test
    void theSumOverLevelsIsTheIntegral() {
        Random random = new Random(5);
        int n = 2 * OUTPUTS * WINDOW.lines();
        double[] way = gaussian(random, n, 0.3);
        double[] r = gaussian(random, n, 1.4);
        double[] sizes = RankOne.sizes(way, OUTPUTS);
        double[] along = RankOne.along(way, r, OUTPUTS);
        double expected = -0.5 * Fitter.dot(r, r) - 7;
        for (int b = 0; b < 14; b++) {
            int own = b;
            int[] lines = java.util.stream.IntStream.range(0, WINDOW.lines()).filter(line -> band(line) == own).toArray();
            double integral = new SimpsonIntegrator(1e-9, 1e-12, 3, 60).integrate(10_000_000, log -> {
                double power = Math.exp(2 * log) * WINDOW.length() / 2 / lines.length;
                double sum = 0;
                for (int line : lines) {
                    double square = along[2 * line] * along[2 * line] + along[2 * line + 1] * along[2 * line + 1];
                    sum += -Math.log1p(power * sizes[line]) + 0.5 * power * square / (1 + power * sizes[line]);
                }
                return Math.exp(sum);
            }, Math.log(LEAST), Math.log(MOST));
            expected += Math.log(integral / Math.log(MOST / LEAST));
        }
        double found = new FreeForce(WINDOW, LEAST, MOST).sum(new LogLikelihood(r, new double[0][], 7, OUTPUTS), way).value();
        assertEquals(expected, found, 0.35);
    }

    /** A force that is there is worth its evidence and found at its level; one that is not costs little, and less than a nat and a half a band. */
    @Test
    void itIsBelievedWhereItIsThere() {
        for (long seed = 1; seed <= 10; seed++) {
            Random random = new Random(seed);
            int n = 2 * OUTPUTS * WINDOW.lines();
            double[] way = gaussian(random, n, 0.7);
            double[] noise = gaussian(random, n, 1);
            double[][] errors = {gaussian(random, n, 0.05)};
            double[] force = gaussian(random, 2 * WINDOW.lines(), 2);
            double[] with = noise.clone();
            for (int i = 0; i < n; i += 2) {
                int line = i / (2 * OUTPUTS);
                with[i] += way[i] * force[2 * line] - way[i + 1] * force[2 * line + 1];
                with[i + 1] += way[i] * force[2 * line + 1] + way[i + 1] * force[2 * line];
            }
            FreeForce free = new FreeForce(WINDOW, LEAST / 10, MOST);
            double cost = free.sum(new LogLikelihood(noise, errors, 0, OUTPUTS), way).value() - new LogLikelihood(noise, errors, 0, OUTPUTS).value();
            assertTrue(cost > -21 && cost < 3, "on noise " + cost);
            FreeForce.Summed found = free.sum(new LogLikelihood(with, errors, 0, OUTPUTS), way);
            assertTrue(found.value() - new LogLikelihood(with, errors, 0, OUTPUTS).value() > 100);
            double mean = Arrays.stream(found.power()).average().orElseThrow();
            assertEquals(4, mean, 0.8);
            double[] law = new double[WINDOW.lines()];
            Arrays.fill(law, 4);
            assertEquals(1, found.share(law, RankOne.sizes(way, OUTPUTS)), 0.1);
            assertTrue(found.within(0.2, law, RankOne.sizes(way, OUTPUTS)) < 1e-6);
            assertTrue(found.within(2, law, RankOne.sizes(way, OUTPUTS)) > 0.999);
        }
    }
}
