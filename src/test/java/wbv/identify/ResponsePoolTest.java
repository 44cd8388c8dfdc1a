package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

/** Responses that differ in speed alone: against bodies in closed form, and a model of its own. */
class ResponsePoolTest {

    @Test
    void bodiesOfManySpeedsTeachOneResponse() {
        ResponsePool pool = new ResponsePool(new boolean[] {false}, 0.7, 10);
        for (int seed = 0; seed < 6; seed++) {
            double frequency = 4 + 0.5 * seed;
            pool.add(KnownSystem.body(frequency, 0.35, 30, 4096, seed), 2 * Math.PI * frequency);
        }
        ScaledResponse response = pool.fit(2);
        TransferModel unseen = response.at(2 * Math.PI * 5.25);
        Pole pole = unseen.poles().modes().get(0);
        assertEquals(5.25, pole.frequency(), 0.03);
        assertEquals(0.35, pole.damping(), 0.01);
        assertEquals(Math.hypot(1, 0.7) / 0.7, unseen.modulus(0, 5.25), 0.03);
    }

    @Test
    void aRunIsTheSimulationAndKeepsItsShapeWhenTunedAnew() {
        ScaledResponse response = new ScaledResponse(new double[] {1, 0.7}, new double[][] {{1, 0.7}, {0.3}},
                new boolean[] {false, true});
        double[][] u = {KnownSystem.input(400, new Well19937c(1)), KnownSystem.input(400, new Well19937c(2))};
        TransferModel model = response.at(30);
        double[] simulated = model.simulate(u, 60, new double[2]);
        TransferRun run = new TransferRun(model, 60);
        for (int k = 0; k < 400; k++) {
            if (k == 200) {
                run.retune(response.at(30), 1);
            }
            assertEquals(simulated[k], run.step(new double[] {u[0][k], u[1][k]}), 1e-9);
        }
        // The derivative of an angular rate acts: at rest nothing remains of a constant one.
        assertEquals(0, model.modulus(1, 0), 1e-15);
        assertEquals(1, model.modulus(0, 0), 1e-12);
    }

    /** What was measured moves as the power 1/0.8 of the body: the pool finds 0.8, and the body behind a measured value. */
    @Test
    void aBodyThatFollowsWithAPowerIsFoundOut() {
        ResponsePool pool = new ResponsePool(new boolean[] {false}, 0.7, 12);
        for (int seed = 0; seed < 6; seed++) {
            double measured = 6 + seed;
            pool.add(KnownSystem.body(5 * Math.pow(measured / 8, 0.8), 0.35, 30, 4096, seed), 2 * Math.PI * measured);
        }
        TunedResponse tuned = pool.fitTuned(2);
        assertEquals(0.8, tuned.exponent(), 0.02);
        assertEquals(5 * Math.pow(7.5 / 8, 0.8), tuned.at(2 * Math.PI * 7.5).poles().modes().get(0).frequency(), 0.04);
        assertEquals(tuned.reference(), tuned.pulsation(tuned.reference()), 1e-9);
    }

    @Test
    void tooFewLinesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> new ResponsePool(new boolean[] {false}, 0.7, 10).fit(4));
        assertThrows(IllegalArgumentException.class, () -> new ScaledResponse(new double[] {1}, new double[][] {{1, 2, 3}},
                new boolean[] {false}));
    }
}
