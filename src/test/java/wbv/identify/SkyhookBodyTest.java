package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

/** The body with a skyhook damper against the closed form of its answer to sines. */
class SkyhookBodyTest {

    private static final double RATE = 60;

    /** Input and answer of a body that has been shaken by sines for ever, in closed form. */
    private static double[][] shaken(SkyhookBody body, int length, int seed) {
        Well19937c random = new Well19937c(seed);
        double[] u = new double[length];
        double[] y = new double[length];
        for (int line = 0; line < 80; line++) {
            double f = 0.5 + 13 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            double r = f / body.frequency();
            double d = 2 * body.damping() * r;
            double gain = Math.hypot(1, body.baseShare() * d) / Math.hypot(1 - r * r, d);
            double angle = Math.atan2(body.baseShare() * d, 1) - Math.atan2(d, 1 - r * r);
            for (int k = 0; k < length; k++) {
                u[k] += Math.sin(2 * Math.PI * f * k / RATE + phase);
                y[k] += gain * Math.sin(2 * Math.PI * f * k / RATE + phase + angle);
            }
        }
        return new double[][] {u, y};
    }

    @Test
    void theBodyIsFoundAndSimulated() {
        for (double share : new double[] {1, 0.6, 0.2}) {
            SkyhookBody truth = new SkyhookBody(5.3, 0.34, share);
            double[][] data = shaken(truth, 1500, 3);
            SkyhookBody found = SkyhookBody.of(RATE, data[0], new double[0][], data[1]).orElseThrow();
            assertEquals(truth.frequency(), found.frequency(), 0.01 * truth.frequency());
            assertEquals(truth.damping(), found.damping(), 0.01);
            assertEquals(truth.baseShare(), found.baseShare(), 0.02);
            double[] simulated = truth.simulate(data[0], RATE);
            double error = 0;
            for (int k = 200; k < 1300; k++) {
                error += Math.pow(simulated[k] - data[1][k], 2) / 1100 / KnownSystem.power(data[1]);
            }
            assertTrue(error < 1e-3, "share of the variance: " + error);
        }
    }

    @Test
    void otherMotionsAreTakenOut() {
        SkyhookBody truth = new SkyhookBody(4.5, 0.3, 0.7);
        double[][] data = shaken(truth, 1500, 5);
        double[][] other = shaken(new SkyhookBody(3, 0.4, 1), 1500, 6);
        double[] y = data[1].clone();
        for (int k = 0; k < y.length; k++) {
            y[k] += 0.5 * other[1][k];
        }
        SkyhookBody alone = SkyhookBody.of(RATE, data[0], new double[0][], y).orElseThrow();
        SkyhookBody with = SkyhookBody.of(RATE, data[0], new double[][] {other[0]}, y).orElseThrow();
        assertEquals(truth.frequency(), with.frequency(), 0.02);
        assertEquals(truth.damping(), with.damping(), 0.01);
        assertTrue(Math.abs(alone.damping() - truth.damping()) > 2 * Math.abs(with.damping() - truth.damping()), alone + ", " + with);
    }

    @Test
    void whatDoesNotMoveHasNoBody() {
        assertTrue(SkyhookBody.of(RATE, new double[1500], new double[0][], new double[1500]).isEmpty());
    }
}
