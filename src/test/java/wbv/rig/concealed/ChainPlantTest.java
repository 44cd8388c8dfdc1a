package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.rig.concealed.law.Springs;

class ChainPlantTest {

    private static final double RATE = UniformSeries.RATE;

    /** A mass on a spring whose platform begins to move as 1 - cos wt: particular and decaying solution, from Laplace. */
    @ParameterizedTest
    @ValueSource(doubles = {0.7, 4.3, 9.6})
    void oneMassFollowsItsClosedForm(double hertz) {
        double k = 40_000;
        double c = 600;
        double m = 50;
        Chain chain = new Chain(List.of("torso"), new int[] {-1}, new double[] {m}, new double[] {k}, new double[] {c});
        double w = 2 * Math.PI * hertz;
        double[] platform = IntStream.range(0, 4800).mapToDouble(i -> 1 - Math.cos(w * i / RATE)).toArray();

        double[] x = new ChainPlant(new Setup(chain), RATE, ChainPlant.FINE).run(platform, RATE).extension()[0];

        // x'' + 2 z wn x' + wn² x = cos(w t) - 1, x(0) = x'(0) = 0.
        double wn = Math.sqrt(k / m);
        double z = c / (2 * Math.sqrt(k * m));
        double wd = wn * Math.sqrt(1 - z * z);
        double real = wn * wn - w * w;
        double imaginary = 2 * z * wn * w;
        double a = real / (real * real + imaginary * imaginary);
        double b = imaginary / (real * real + imaginary * imaginary);
        double p = 1 / (wn * wn) - a;
        double q = (z * wn * p - w * b) / wd;
        for (int i = 0; i < x.length; i += 37) {
            double t = i / RATE;
            double free = Math.exp(-z * wn * t) * (p * Math.cos(wd * t) + q * Math.sin(wd * t));
            double exact = a * Math.cos(w * t) + b * Math.sin(w * t) - 1 / (wn * wn) + free;
            assertEquals(exact, x[i], 2e-6 / (wn * wn), "at " + t + " s");
        }
    }

    /** Without damping, and once the platform stands: m v²/2 + k r²/2 + 2/5 hertz δ^2.5 stays. */
    @Test
    void aStopThatStoresEnergyGivesItBack() {
        double k = 30_000;
        double m = 20;
        Setup setup = new Setup(new Chain(List.of("torso"), new int[] {-1}, new double[] {m}, new double[] {k},
                new double[] {0}));
        setup.link(0, h -> Springs.hertz(k, 0, 3e7, 1e-3));
        double[] platform = new double[9600];
        for (int i = 0; i < 96; i++) {
            platform[i] = 6 * Math.sin(Math.PI * i / 96);
        }
        ChainPlant.Trace trace = new ChainPlant(setup, RATE, ChainPlant.FINE).run(platform, RATE);
        double[] energy = IntStream.range(200, 9600).mapToDouble(i -> {
            double r = trace.extension()[0][i];
            double v = trace.rate()[0][i];
            double depth = Math.max(0, -r - 1e-3);
            return m * v * v / 2 + k * r * r / 2 + 3e7 * 0.4 * Math.pow(depth, 2.5);
        }).toArray();
        assertTrue(UniformSeries.quantile(trace.extension()[0], 0) < -1.2e-3, "the stop must be reached");
        for (double e : energy) {
            assertEquals(energy[0], e, 1e-5 * energy[0]);
        }
    }

    @Test
    void aHiddenMassIsABodyOfTheChainThatIsNotShown() {
        Chain three = new Chain(List.of("seat", "torso", "viscera"), new int[] {-1, 0, 1}, new double[] {12, 40, 6},
                new double[] {150_000, 80_000, 9_000}, new double[] {2000, 1500, 60});
        Chain two = new Chain(List.of("seat", "torso"), new int[] {-1, 0}, new double[] {12, 40}, new double[] {150_000, 80_000},
                new double[] {2000, 1500});
        Setup hidden = new Setup(two);
        hidden.ride(new Setup.Rider(1, 6, 9_000, 60));
        double[] platform = UniformSeries.lines(2000, 1, 10, 0, 1, new Well19937c(5));
        double[][] open = new ChainPlant(new Setup(three), RATE, 4).run(platform, RATE).acceleration();
        double[][] closed = new ChainPlant(hidden, RATE, 4).run(platform, RATE).acceleration();
        assertEquals(2, closed.length);
        assertArrayEquals(open[0], closed[0], 1e-12);
        assertArrayEquals(open[1], closed[1], 1e-12);
    }

    @ParameterizedTest
    @EnumSource(Topology.class)
    void aSitterDrawnHasItsFirstResonanceAtFourToSixHertz(Topology topology) {
        for (int seed = 0; seed < 50; seed++) {
            Chain chain = topology.draw(new Well19937c(seed));
            double[] f = chain.frequencies();
            assertTrue(f[0] > 4 && f[0] < 6, topology + " " + seed + ": " + f[0]);
            int head = chain.body("head");
            double alone = Math.sqrt(chain.stiffness()[head] / chain.mass()[head]) / (2 * Math.PI);
            assertTrue(alone >= 8 && alone <= 14, topology + " " + seed + ": " + alone);
        }
    }

    /** Two bodies, by the roots of the quadratic in ω². */
    @Test
    void frequenciesOfTwoBodiesAreTheRootsOfTheirQuadratic() {
        double m1 = 40;
        double m2 = 5;
        double k1 = 50_000;
        double k2 = 15_000;
        Chain chain = new Chain(List.of("torso", "head"), new int[] {-1, 0}, new double[] {m1, m2}, new double[] {k1, k2},
                new double[] {0, 0});
        double b = (k1 + k2) / m1 + k2 / m2;
        double root = Math.sqrt(b * b - 4 * k1 * k2 / (m1 * m2));
        assertEquals(Math.sqrt((b - root) / 2) / (2 * Math.PI), chain.frequencies()[0], 1e-9);
        assertEquals(Math.sqrt((b + root) / 2) / (2 * Math.PI), chain.frequencies()[1], 1e-9);
    }
}
