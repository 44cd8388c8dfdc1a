package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.concealed.law.Lugre;
import wbv.rig.concealed.law.MaxwellArms;
import wbv.rig.concealed.law.Muscle;
import wbv.rig.concealed.law.PullingMuscle;
import wbv.rig.concealed.law.Sliders;
import wbv.rig.concealed.law.Springs;

/** Link forces against what is known of them in closed form. */
class LawsTest {

    private static final double K = 50_000;
    private static final double C = 900;

    @Test
    void softAndHardSpringsAreLinearAtRest() {
        double small = 1e-7;
        for (LinkPhysics law : new LinkPhysics[] {Springs.tanh(K, C, 1e-3), Springs.rational(K, C, 1e-2), Springs.hardening(K, C,
                1e-3),
            Springs.hertz(K, C, 1e7, 1e-3), Springs.contactLoss(K, C, 100, 5)}) {
            assertEquals(K * small + C * small, law.force(0, small, small, new double[0], 0), 1e-4 * (K + C) * small);
        }
    }

    @Test
    void theOneSidedActOnOneSideOnly() {
        LinkPhysics loss = Springs.contactLoss(K, 0, 100, 5);
        assertEquals(100, loss.force(0, 0.02, 0, new double[0], 0), 1e-9);
        assertEquals(-1000, loss.force(0, -0.02, 0, new double[0], 0), 1e-6);
        LinkPhysics stop = Springs.hertz(K, 0, 1e7, 1e-3);
        assertEquals(K * 2e-3, stop.force(0, 2e-3, 0, new double[0], 0), 1e-9);
        assertEquals(-K * 2e-3 - 1e7 * Math.pow(1e-3, 1.5), stop.force(0, -2e-3, 0, new double[0], 0), 1e-9);
        LinkPhysics bend = Springs.asymmetric(K, 0, 0.5, 1e-6);
        assertEquals(-1.5 * K * 1e-2, bend.force(0, -1e-2, 0, new double[0], 0), 0.05);
        assertEquals(K * 1e-2, bend.force(0, 1e-2, 0, new double[0], 0), 0.05);
    }

    /** One slider: a loop between ±x loses 4 k y (x - y). */
    @Test
    void aSliderLosesWhatItsLoopEncloses() {
        double yield = 4e-4;
        double amplitude = 1e-3;
        Sliders sliders = Sliders.partOf(K, 0, 0.3, new double[] {yield});
        double lost = 0;
        double last = 0;
        double before = 0;
        int steps = 20_000;
        for (int i = 1; i <= 2 * steps; i++) {
            double r = amplitude * Math.sin(2 * Math.PI * i / steps);
            double f = sliders.force(0, r, 0, new double[0], 0);
            if (i > steps) {
                lost += (f + before) / 2 * (r - last);
            }
            sliders.commit(0, r, 0);
            last = r;
            before = f;
        }
        assertEquals(4 * 0.3 * K * yield * (amplitude - yield), lost, 1e-3 * lost);
    }

    /** Sliding at one speed the bristle's force is the friction of that speed (Canudas de Wit et al. 1995, Eq. 5). */
    @Test
    void bristlesSlideAtTheFrictionOfTheirSpeed() {
        Lugre lugre = new Lugre(0, 0, 20, 28, 0.01, 1e6);
        for (double v : new double[] {0.001, 0.01, 0.2}) {
            double[] z = {0};
            double[] rate = new double[1];
            double h = 1e-6;
            for (int i = 0; i < 200_000; i++) {
                lugre.rates(0, 0, v, z, 0, rate);
                z[0] += h * rate[0];
            }
            double expected = 20 + 8 * Math.exp(-v * v / 1e-4);
            assertEquals(expected, lugre.force(0, 0, v, z, 0), 1e-3 * expected);
        }
    }

    /** A held extension: each arm's force decays as exp(-t/τ). */
    @Test
    void armsRelax() {
        MaxwellArms arms = new MaxwellArms(0, 0, 1000, 0.05, 500, 0.2);
        double[] y = new double[2];
        double[] rate = new double[2];
        double h = 1e-5;
        for (int i = 0; i < 10_000; i++) {
            arms.rates(0, 1e-3, 0, y, 0, rate);
            y[0] += h * rate[0];
            y[1] += h * rate[1];
        }
        assertEquals(1e-3 * (1000 * Math.exp(-2) + 500 * Math.exp(-0.5)), arms.force(0, 1e-3, 0, y, 0), 1e-4);
    }

    /** A ramp felt by the muscle comes out a delay and a time constant later. */
    @Test
    void muscleAnswersLate() {
        double h = 1e-4;
        double delay = 0.06;
        Muscle muscle = new Muscle(0, 0, 1000, 0, delay, h);
        double[] y = new double[1];
        double[] rate = new double[1];
        double t = 0;
        for (int i = 1; i <= 5000; i++) {
            muscle.rates(t, 0, 0, y, 0, rate);
            y[0] += h * rate[0];
            t = i * h;
            muscle.commit(t, 0.01 * t, 0);
        }
        assertEquals(1000 * 0.01 * (t - delay - 0.025), muscle.force(t, 0, 0, y, 0), 0.01);
    }

    /** A ramp felt by a critically damped twitch comes out 2/ω after the delay; felt the other way it calls nothing. */
    @Test
    void aMuscleThatPullsDoesNotPush() {
        double h = 1e-4;
        for (double speed : new double[] {0.01, -0.01}) {
            PullingMuscle muscle = new PullingMuscle(0, 0, 1000, 0, 0.05, 4, h);
            double[] y = new double[2];
            double[] rate = new double[2];
            double t = 0;
            for (int i = 1; i <= 8000; i++) {
                muscle.rates(t, 0, 0, y, 0, rate);
                y[0] += h * rate[0];
                y[1] += h * rate[1];
                t = i * h;
                muscle.commit(t, speed * t, 0);
            }
            double late = t - 0.05 - 2 / (2 * Math.PI * 4);
            assertEquals(Math.max(0, 1000 * speed * late), muscle.force(t, 0, 0, y, 0), 0.01);
        }
    }

    /** A strap at rest shows what is there; at its resonance it shows 1/(2 ζ) and more. */
    @Test
    void aStrapAmplifiesAtItsResonance() {
        double zeta = 0.2;
        double[][] six = new double[6][9600];
        for (int i = 0; i < 9600; i++) {
            six[Fault.Z][i] = Math.sin(2 * Math.PI * 8 * i / UniformSeries.RATE);
        }
        Fault.strap(8, zeta).whileSensing(six);
        double[] end = Arrays.copyOfRange(six[Fault.Z], 4800, 9600);
        assertEquals(Math.sqrt(1 + 4 * zeta * zeta) / (2 * zeta) / Math.sqrt(2), UniformSeries.rms(end), 1e-3);
    }

    @Test
    void faultsTouchNoMoreThanTheySay() {
        double[][] six = new double[6][960];
        for (int q = 0; q < 6; q++) {
            for (int i = 0; i < 960; i++) {
                six[q][i] = Math.sin(0.02 * (q + 1) * i);
            }
        }
        double[][] before = Arrays.stream(six).map(double[]::clone).toArray(double[][]::new);
        Fault.gain(1.1).whileSensing(six);
        Fault.clipping(-0.5, 0.7).whileSensing(six);
        for (int q : new int[] {0, 1, 3, 4, 5}) {
            assertTrue(Arrays.equals(before[q], six[q]));
        }
        assertEquals(0.7, Arrays.stream(six[Fault.Z]).max().orElse(0), 0);
        Fault.turned(0.3).whileSensing(six);
        assertTrue(Arrays.equals(before[1], six[1]));
    }
}
