package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.body.LawAt;
import wbv.body.Structure;
import wbv.body.law.CoulombFriction;
import wbv.body.law.Law;

/** A mass that only friction holds, in steps in which friction turns round. */
class FreeRunInPartsTest {

    private static final double STEP = 1 / 400.0;
    private static final Structure SLIDE = new Structure(new int[] {-1}, new int[] {0}, new double[] {0}, new double[] {15},
            new double[] {12});

    /** Momentum: what the push gives and friction takes leaves the mass with, in the sum, nothing, wherever in a step it turned round. */
    @Test
    void theImpulseIsThatOfTheTimedJump() {
        double[] push = push(1);
        double[] force = run(SLIDE, new CoulombFriction(20, 1e-6), push).force()[0];
        double[] often = oversampled(push, 64);
        double[] fine = new FreeRun(SLIDE, List.of(new LawAt(0, new CoulombFriction(20, 1e-6))), STEP / 64, false)
                .run(new double[often.length], new double[][] {often}, false).force()[0];
        double gone = 0;
        double square = 0;
        for (int j = 0; j + 1 < push.length; j++) {
            gone += STEP * (force[j] + force[j + 1]) / 2;
            for (int i = 64 * j; i < 64 * j + 64; i++) {
                gone -= STEP / 64 * (fine[i] + fine[i + 1]) / 2;
            }
            square += gone * gone / push.length;
        }
        // 20 N that turn round half a step of 1/400 s too late are 0.05 N s each time, and the mass carries them along.
        assertTrue(Math.sqrt(square) < 0.008, "" + Math.sqrt(square));
    }

    @Test
    void slopesAreThoseOfTheRunInParts() {
        double[] push = push(2);
        CoulombFriction law = new CoulombFriction(20, 1e-2);
        FreeRun.Run run = FreeRun.inParts(SLIDE, List.of(new LawAt(0, law)), STEP, Sensitivities.ALL, new double[1][0])
                .run(new double[push.length], new double[][] {push}, true);
        double[] values = SLIDE.values();
        for (int p : new int[] {1, 2, 3}) {   // damping, mass, friction
            double h = p == 3 ? 1e-4 : 1e-5 * values[p];
            double[] high = shifted(values, law, p, h, push);
            double[] low = shifted(values, law, p, -h, push);
            double[] slope = run.slope()[0][p];
            double size = Math.sqrt(Arrays.stream(slope).map(s -> s * s).sum());
            double off = 0;
            for (int j = 0; j < high.length; j++) {
                off += Math.pow((high[j] - low[j]) / (2 * h) - slope[j], 2);
            }
            assertEquals(0, Math.sqrt(off) / size, 0.02, "parameter " + p);
        }
    }

    private static double[] shifted(double[] values, CoulombFriction law, int p, double h, double[] push) {
        double[] other = values.clone();
        if (p < 3) {
            other[p] += h;
        }
        return run(SLIDE.with(other), p < 3 ? law : new CoulombFriction(law.friction() + h, law.transition()), push).force()[0];
    }

    private static FreeRun.Run run(Structure structure, Law law, double[] push) {
        return FreeRun.inParts(structure, List.of(new LawAt(0, law)), STEP, Sensitivities.NONE, new double[1][0])
                .run(new double[push.length], new double[][] {push}, false);
    }

    private static double[] push(long seed) {
        double[] phase = new Random(seed).doubles(20, 0, 2 * Math.PI).toArray();
        double[] out = new double[1200];
        for (int j = 0; j < out.length; j++) {
            for (int k = 0; k < phase.length; k++) {
                out[j] += 20 * Math.sin(2 * Math.PI * (0.3 + 0.2 * k) * j * STEP + phase[k]);
            }
        }
        return out;
    }

    private static double[] oversampled(double[] x, int by) {
        double[] out = new double[by * (x.length - 1) + 1];
        for (int i = 0; i < out.length; i++) {
            int at = Math.min(i / by, x.length - 2);
            out[i] = x[at] + (x[at + 1] - x[at]) * (i - by * at) / by;
        }
        return out;
    }
}
