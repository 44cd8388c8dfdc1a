package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Test;
import wbv.filter.SimulatedSitter;

class EquivalentBodiesTest {

    private static final int SAMPLES = 60 * 60;
    private static final double RMS = 0.8;

    private static EquivalentBodies bodies(double[]... inputs) {
        MotionWindow window = new MotionWindow(SimulatedSitter.RATE, inputs.length, inputs[0].length);
        double[] row = new double[inputs.length];
        for (int t = 0; t < inputs[0].length; t++) {
            for (int i = 0; i < row.length; i++) {
                row[i] = inputs[i][t];
            }
            window.accept(row);
        }
        return new EquivalentBodies(window, inputs.length - 1);
    }

    private static double[] noise(double deviation, double memory, int samples, long seed) {
        Random random = new Random(seed);
        double[] out = new double[samples];
        double state = 0;
        for (int t = 0; t < samples; t++) {
            state = memory * state + Math.sqrt(1 - memory * memory) * deviation * random.nextGaussian();
            out[t] = state;
        }
        return out;
    }

    private static double[] sum(double[] a, double[] b) {
        double[] out = a.clone();
        Arrays.setAll(out, t -> a[t] + b[t]);
        return out;
    }

    @Test
    void slopesAreDerivativesAndTheBodyFollowsItsBaseAtRest() {
        double[] theta = {Math.log(31), Math.log(0.4), Math.log(70), Math.log(0.2), 0.7, 0.15};
        ModalBody body = new ModalBody(2);
        body.at(theta, 0);
        assertEquals(1, body.re()[0], 1e-12);
        assertEquals(0, body.im()[0], 1e-12);
        double small = 1e-6;
        for (double omega : new double[] {5, 31, 44, 90}) {
            body.at(theta, omega);
            double[] re = body.re().clone();
            double[] im = body.im().clone();
            for (int i = 0; i < theta.length; i++) {
                double[] up = theta.clone();
                up[i] += small;
                body.at(up, omega);
                double upRe = body.re()[0];
                double upIm = body.im()[0];
                up[i] -= 2 * small;
                body.at(up, omega);
                assertEquals((upRe - body.re()[0]) / (2 * small), re[1 + i], 1e-6, "parameter " + i + " at " + omega);
                assertEquals((upIm - body.im()[0]) / (2 * small), im[1 + i], 1e-6, "parameter " + i + " at " + omega);
            }
        }
    }

    @Test
    void oneModeIsTheTextbooks() {
        SimulatedSitter sitter = new SimulatedSitter(4.7, 0.33);
        ModalBody body = new ModalBody(1);
        for (double f : new double[] {0.5, 3, 4.7, 9, 20}) {
            body.at(new double[] {Math.log(2 * Math.PI * 4.7), Math.log(0.33)}, 2 * Math.PI * f);
            Complex h = sitter.transfer(f);
            assertEquals(h.getReal(), body.re()[0], 1e-12);
            assertEquals(h.getImaginary(), body.im()[0], 1e-12);
        }
    }

    @Test
    void aLinearBodyIsFoundExactly() {
        for (int seed = 1; seed <= 5; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            SimulatedSitter.Motion motion = sitter.steady(RMS, SAMPLES, seed);
            EquivalentBody body = bodies(motion.u()).of(motion.y(), 0).orElseThrow();
            assertEquals(1, body.modes().size());
            assertEquals(sitter.frequency(), body.modes().get(0).frequency(), 2e-3 * sitter.frequency());
            assertEquals(sitter.damping(), body.modes().get(0).damping(), 2e-3 * sitter.damping());
            assertTrue(body.explained() > 0.9999, "explains " + body.explained());
            assertTrue(body.carries());
        }
    }

    /**
     * Noise that follows itself for a third of a second, as large as a third of the motion: a filter that takes it for white is too sure.
     */
    @Test
    void deviationsHoldTheTruthAsOftenAsTheySay() {
        int held = 0;
        int of = 0;
        for (int seed = 1; seed <= 60; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            SimulatedSitter.Motion motion = sitter.steady(RMS, SAMPLES, seed);
            double[] y = sum(motion.y(), noise(0.35, 0.95, SAMPLES, 77 + seed));
            EquivalentBody.Mode mode = bodies(motion.u()).of(y, 1).orElseThrow().modes().get(0);
            held += Math.abs(mode.frequency() - sitter.frequency()) <= 2 * mode.frequencyDeviation() ? 1 : 0;
            held += Math.abs(mode.damping() - sitter.damping()) <= 2 * mode.dampingDeviation() ? 1 : 0;
            of += 2;
        }
        // 95 % of 120: fewer than 107 or more than all but one come once in a hundred times
        assertTrue(held >= 107, held + " of " + of);
    }

    @Test
    void whatTheInputDoesNotMoveIsNoBody() {
        for (int seed = 1; seed <= 20; seed++) {
            double[] u = SimulatedSitter.of(seed).steady(RMS, SAMPLES, seed).u();
            double[] other = SimulatedSitter.of(100 + seed).steady(RMS, SAMPLES, 100 + seed).y();
            Optional<EquivalentBody> body = bodies(u).of(other, 0);
            assertFalse(body.isPresent() && body.get().carries(), "seed " + seed + ": " + body);
        }
    }

    @Test
    void anotherMotionIsTakenWhereItHelpsAndNotWhereItDoesNot() {
        int taken = 0;
        for (int seed = 1; seed <= 20; seed++) {
            SimulatedSitter sitter = SimulatedSitter.of(seed);
            SimulatedSitter.Motion motion = sitter.steady(RMS, SAMPLES, seed);
            SimulatedSitter.Motion side = SimulatedSitter.of(50 + seed).steady(RMS, SAMPLES, 200 + seed);
            double[] idle = SimulatedSitter.of(seed).steady(RMS, SAMPLES, 300 + seed).u();
            double[] y = sum(sum(motion.y(), side.y()), noise(0.1, 0, SAMPLES, seed));
            EquivalentBody body = bodies(motion.u(), side.u(), idle).of(y, 0).orElseThrow();
            assertTrue(body.others().contains(0), "seed " + seed + ": " + body);
            taken += body.others().contains(1) ? 1 : 0;
            assertTrue(body.withOthers() > 0.95 && body.explained() < 0.8, "seed " + seed + ": " + body);
            EquivalentBody.Mode mode = body.modes().get(0);
            assertEquals(sitter.frequency(), mode.frequency(), Math.max(4 * mode.frequencyDeviation(), 0.01 * sitter.frequency()));
        }
        // one in a hundred is taken though it brings nothing: three of twenty come once in a thousand times
        assertTrue(taken <= 2, taken + " of 20");
    }

    @Test
    void gapsCostLittle() {
        SimulatedSitter sitter = new SimulatedSitter(5, 0.3);
        SimulatedSitter.Motion motion = sitter.steady(RMS, SAMPLES, 4);
        double[] u = motion.u().clone();
        double[] y = motion.y().clone();
        Random random = new Random(5);
        for (int t = 0; t < SAMPLES; t++) {
            if (random.nextDouble() < 0.01 || t > 1200 && t < 1500) {
                u[t] = Double.NaN;
            }
            if (random.nextDouble() < 0.01 || t > 2400 && t < 2460) {
                y[t] = Double.NaN;
            }
        }
        EquivalentBody.Mode mode = bodies(u).of(y, 0).orElseThrow().modes().get(0);
        assertEquals(5, mode.frequency(), 0.02);
        assertEquals(0.3, mode.damping(), 0.003);
    }

    @Test
    void twoModesAreFoundWhereTheyAreAskedFor() {
        SimulatedSitter slow = new SimulatedSitter(3.5, 0.25);
        SimulatedSitter fast = new SimulatedSitter(9, 0.2);
        SimulatedSitter.Motion first = slow.steady(RMS, SAMPLES, 6);
        double[] second = fast.steady(RMS, SAMPLES, 6).y();
        double[] y = new double[SAMPLES];
        Arrays.setAll(y, t -> 0.6 * first.y()[t] + 0.4 * second[t]);
        EquivalentBody body = bodies(first.u()).of(y, 2).orElseThrow();
        assertEquals(List.of(3.5, 9.0), body.modes().stream().map(mode -> Math.round(100 * mode.frequency()) / 100.0).toList());
        assertEquals(0.25, body.modes().get(0).damping(), 0.002);
        assertEquals(0.2, body.modes().get(1).damping(), 0.002);
    }

    @Test
    void tooShortIsSaidAndTheWindowKeepsTheLatest() {
        double[] u = SimulatedSitter.of(1).steady(RMS, 600, 1).u();
        assertTrue(bodies(u).of(u, 0).isEmpty());
        MotionWindow window = new MotionWindow(10, 1, 1500);
        for (int t = 0; t < 4000; t++) {
            window.accept(new double[] {t});
        }
        assertEquals(2500, window.first());
        assertEquals(1500, window.length());
        assertEquals(2500, window.channel(0)[0]);
        assertEquals(3999, window.channel(0)[1499]);
    }
}
