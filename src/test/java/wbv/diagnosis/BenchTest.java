package wbv.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The benches of the tests against closed forms. */
class BenchTest {

    @Test
    void anOscillatorDecaysAsItsClosedFormSays() {
        double decay = 25.0 / 2 / 2;
        double omega = Math.sqrt(8000.0 / 2 - decay * decay);
        Bench bench = new Bench(200, 1, 50, 2).run((t, x, v, out) -> out[0] = -8000 * x[0] - 25 * v[0], new double[] {0.01}, new double[1],
                (t, x, v, out) -> {});
        double[] x = bench.sampled(bench.position(0));
        for (int j = 0; j < x.length; j++) {
            double t = j / 200.0;
            assertEquals(0.01 * Math.exp(-decay * t) * (Math.cos(omega * t) + decay / omega * Math.sin(omega * t)), x[j], 1e-7);
        }
    }

    /** v²/2a, from where it stays. */
    @Test
    void whatSlidesStopsWhereItsFrictionSays() {
        Bench bench = new Bench(100, 2, 10, 4).run((t, x, v, out) -> {}, new double[1], new double[] {0.777}, (t, x, v, out) -> out[0] = 5);
        double[] x = bench.sampled(bench.position(0));
        assertEquals(0.777 * 0.777 / 2 / (5.0 / 4), x[x.length - 1], 1e-6);
        assertEquals(x[150], x[x.length - 1]);
    }

    /** Under a push that is less than its friction a mass stays; under one that is more by a newton it goes. */
    @Test
    void whatSticksLetsGo() {
        Bench bench = new Bench(100, 2, 100, 4).run((t, x, v, out) -> out[0] = t < 1 ? 4.9 : 6, new double[1], new double[1],
                (t, x, v, out) -> out[0] = 5);
        double[] x = bench.sampled(bench.position(0));
        assertEquals(0, x[99]);
        assertEquals(0.25 * 0.99 * 0.99 / 2, x[199], 1e-4);
    }
}
