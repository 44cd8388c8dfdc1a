package wbv.rig.concealed;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import wbv.rig.concealed.law.FadingDamper;
import wbv.rig.concealed.law.LaggedDrag;
import wbv.rig.concealed.law.LinkPhysics;
import wbv.rig.concealed.law.Mullins;
import wbv.rig.concealed.law.OpenLaws;
import wbv.rig.concealed.law.Orifice;
import wbv.rig.concealed.law.ParallelForce;

/** Laws of no library against what is known of them in closed form: most by what one sine of motion loses in them. */
class OpenLawsTest {

    private static final double C = 900;
    private static final double W = 2 * Math.PI * 5;
    private static final double A = 1e-3;
    private static final double V = W * A;
    private static final double[] NONE = new double[0];

    /** Work done on a law in one cycle of r = A sin wt that begins at a moment. */
    private static double lost(LinkPhysics law, double start) {
        int steps = 20_000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double t = start + 2 * Math.PI / W * (i + 0.5) / steps;
            double v = V * Math.cos(W * t);
            sum += law.force(t, A * Math.sin(W * t), v, NONE, 0) * v;
        }
        return sum * 2 * Math.PI / W / steps;
    }

    /** ∫ r² v² = A⁴ w π/4, where the travel is short of its bend. */
    @Test
    void dampingOfTravelLosesWithTheFourthPowerOfTheAmplitude() {
        double far = 1;
        assertEquals(C * Math.pow(A, 4) * W * Math.PI / 4, lost(OpenLaws.travelDamping(C, far), 0), 1e-5 * C * Math.pow(A, 4) * W);
        assertEquals(C * 9 / 2.0, OpenLaws.travelDamping(C, A).force(0, 3 * A, 1, NONE, 0), 1e-9);
    }

    @Test
    void reboundLosesHalfOfWhatADashpotDoes() {
        assertEquals(C * Math.PI * W * A * A / 2, lost(OpenLaws.rebound(C), 0), 1e-6);
        assertEquals(0, OpenLaws.rebound(C).force(0, 0, -1, NONE, 0), 0);
    }

    /** Half a dashpot's cycle; below, c s² (angle under the knee) and c s · (what is passed above it). */
    @Test
    void aValveThatBlowsOffIsADashpotBelowItsKneeAndConstantAboveIt() {
        double s = 0.4 * V;
        double knee = Math.asin(s / V);
        double below = 2 * C * V * V * (knee / 2 - Math.sin(2 * knee) / 4) / W;
        double above = 2 * C * s * V * Math.cos(knee) / W;
        assertEquals(C * Math.PI * W * A * A / 2 + below + above, lost(OpenLaws.blowOff(C, s), 0), 1e-6);
    }

    /** ∫ v² / (1 + v²/s²) = s² T (1 - 1/√(1 + V²/s²)). */
    @Test
    void anEddyBrakeLosesWhatItsIntegralSays() {
        double s = 0.5 * V;
        double period = 2 * Math.PI / W;
        assertEquals(C * s * s * period * (1 - 1 / Math.sqrt(1 + V * V / (s * s))), lost(OpenLaws.eddyBrake(C, s), 0), 1e-6);
        assertEquals(C * s / 2, OpenLaws.eddyBrake(C, s).force(0, 0, s, NONE, 0), 1e-9, "its crest");
    }

    /** ∫ |r| |v| = 2 A², whatever the speed. */
    @Test
    void aWedgeLosesTheSameAtEverySpeed() {
        assertEquals(2 * 5000 * A * A, lost(OpenLaws.wedge(5000, 1e-4 * V), 0), 1e-3 * 5000 * A * A);
    }

    /** ∫ |v| = 4 A under a constant pressure; a dashpot's cycle times what the damping is. */
    @Test
    void whatFollowsTheTimeDoesSo() {
        assertEquals(4 * A * 30, lost(OpenLaws.timedFriction(t -> t > 10 ? 30 : 0, 1e-4 * V), 20), 1e-3 * A * 30);
        assertEquals(0, lost(OpenLaws.timedFriction(t -> t > 10 ? 30 : 0, 1e-4 * V), 1), 0);
        assertEquals(C * Math.PI * W * A * A, lost(OpenLaws.timedDamping(t -> t > 10 ? C : 2 * C), 20), 1e-6);
        assertEquals(2000 * A, OpenLaws.timedStiffness(t -> 1000 * t).force(2, A, 7, NONE, 0), 1e-12);
    }

    /** Two links of two bodies and one that nobody sees: positions first, then speeds. */
    @Test
    void aNeighbourIsReadFromTheStatesOfTheWhole() {
        Chain chain = new Chain(List.of("seat", "torso"), new int[] {-1, 0}, new double[] {10, 40}, new double[] {1e5, 5e4},
                new double[] {900, 700});
        double[] y = {1e-3, 3e-3, 9, 0.02, 0.05, 9};
        Neighbour upper = Neighbour.of(chain, 1, 3);
        assertEquals(2e-3, upper.deflection(y), 1e-15);
        assertEquals(5e4 * 2e-3 + 700 * 0.03, upper.load(y), 1e-9);
        assertEquals(1e5 * 1e-3 + 900 * 0.02, Neighbour.of(chain, 0, 3).load(y), 1e-9);
        assertEquals(4 * upper.load(y), OpenLaws.loadedStiffness(upper::load).force(0, 4, 0, y, 0), 1e-9);
        assertEquals(-upper.load(y), OpenLaws.pressedFriction(upper::load, 1e-3).force(0, 0, -1, y, 0), 1e-9);
        assertEquals(2e-3, OpenLaws.foreign(upper::deflection).force(0, 7, 7, y, 0), 1e-15);
    }

    /** At one speed: f = c2 v² (1 - exp(-t/τ)). */
    @Test
    void dragAnswersLate() {
        double[] y = advanced(new LaggedDrag(2e4, 0.05), 0, -0.03, 0.08);
        assertEquals(-2e4 * 9e-4 * (1 - Math.exp(-1.6)), new LaggedDrag(2e4, 0.05).force(0, 0, 0, y, 0), 1e-3);
    }

    /** At one speed: m = v² (1 - exp(-t/τ)). */
    @Test
    void aDamperFades() {
        FadingDamper damper = new FadingDamper(C, 1e-4, 3);
        double[] y = advanced(damper, 0, 0.02, 2);
        assertEquals(C * 0.02 / (1 + 4 * (1 - Math.exp(-2.0 / 3))), damper.force(0, 0, 0.02, y, 0), 1e-3);
        assertEquals(C * 0.02, damper.force(0, 0, 0.02, new double[1], 0), 1e-12);
    }

    /** At one speed the pressure is d v (v + w0); at rest √p goes down in a straight line, K/(2√d) a second. */
    @Test
    void anOrificePassesTheRootOfItsPressure() {
        Orifice slow = new Orifice(1e6, 4e5, 1e4, 0);
        assertEquals(-4e5 * 9e-4, advanced(slow, 0, -0.03, 1)[0], 1e-3);
        assertEquals(1e4 * 9e-4, advanced(slow, 0, 0.03, 1)[0], 1e-3);
        assertEquals(4e5 * -0.03 * 0.04, advanced(new Orifice(1e6, 4e5, 1e4, 0.01), 0, -0.03, 1)[0], 1e-3);
        double[] pressed = {-100};
        double t = 0.005;
        assertEquals(-Math.pow(10 - 1e6 * t / (2 * Math.sqrt(4e5)), 2), advanced(slow, 0, 0, t, pressed)[0], 0.01);
    }

    private static double[] advanced(LinkPhysics law, double r, double v, double seconds) {
        return advanced(law, r, v, seconds, new double[1]);
    }

    /** By Euler's rule with small steps, which the plant does not use. */
    private static double[] advanced(LinkPhysics law, double r, double v, double seconds, double[] y) {
        double h = 1e-6;
        double[] rate = new double[1];
        for (long i = 0; i < Math.round(seconds / h); i++) {
            law.rates(i * h, r, v, y, 0, rate);
            y[0] += h * rate[0];
        }
        return y;
    }

    /** Stretched for the first time it is as it was; below, a parabola; a memory later the peak is a part 1/e of itself. */
    @Test
    void rubberRemembersHowFarItWasStretchedAndHeals() {
        double h = 1e-3;
        Mullins rubber = new Mullins(1e5, 5, 1e-6, h);
        rubber.commit(0, 2e-3, 0);
        assertEquals(0, rubber.force(0, 2e-3, 0, NONE, 0), 1e-12);
        assertEquals(1e5 * 1e-3 * 0.5, rubber.force(0, -1e-3, 0, NONE, 0), 1e-9);
        for (int i = 0; i < 5000; i++) {
            rubber.commit(0, 0, 0);
        }
        double peak = 2e-3 / Math.E;
        assertEquals(-1e5 * 5e-4 * (1 - 5e-4 / peak), rubber.force(0, 5e-4, 0, NONE, 0), 1e-6);
    }

    /** m q'' + b q'' = -m a - k q - c q': a mass of m + b under a platform that moves by m/(m + b) of it. */
    @Test
    void anInerterOnThePlatformIsAHeavierMassThatIsPushedLess() {
        double m = 40;
        double b = 25;
        Chain light = new Chain(List.of("torso"), new int[] {-1}, new double[] {m}, new double[] {5e4}, new double[] {C});
        Chain heavy = new Chain(List.of("torso"), new int[] {-1}, new double[] {m + b}, new double[] {5e4}, new double[] {C});
        Setup inert = new Setup(light);
        inert.link(0, h -> new ParallelForce(5e4, C, OpenLaws.inerter(b)));
        double[] platform = UniformSeries.lines(2000, 1, 10, 0, 1, new Well19937c(5));
        double[] expected = new ChainPlant(new Setup(heavy), UniformSeries.RATE, 4)
                .run(UniformSeries.scaled(platform, m / (m + b)), UniformSeries.RATE).extension()[0];
        assertArrayEquals(expected, new ChainPlant(inert, UniformSeries.RATE, 4).run(platform, UniformSeries.RATE).extension()[0], 1e-12);
    }

    /** Without damping, once the platform stands: Σ m v²/2 + b (v2 - v1)²/2 + Σ k r²/2 stays, in a tree with a branch. */
    @Test
    void anInerterStoresEnergyAndGivesItBack() {
        double b = 8;
        Chain chain = new Chain(List.of("seat", "torso", "viscera", "head"), new int[] {-1, 0, 1, 1}, new double[] {12, 40, 6, 5},
                new double[] {1.5e5, 8e4, 9e3, 1.6e4}, new double[4]);
        Setup setup = new Setup(chain);
        setup.link(1, h -> new ParallelForce(8e4, 0, OpenLaws.inerter(b)));
        setup.link(3, h -> new ParallelForce(1.6e4, 0, OpenLaws.inerter(2)));
        double[] platform = new double[4800];
        for (int i = 0; i < 96; i++) {
            platform[i] = 6 * Math.sin(Math.PI * i / 96);
        }
        ChainPlant.Trace trace = new ChainPlant(setup, UniformSeries.RATE, ChainPlant.FINE).run(platform, UniformSeries.RATE);
        double[] energy = IntStream.range(200, 4800).mapToDouble(i -> {
            double[] v = new double[4];
            double sum = 0;
            for (int j = 0; j < 4; j++) {
                v[j] = trace.rate()[j][i] + (chain.parent()[j] < 0 ? 0 : v[chain.parent()[j]]);
                sum += chain.mass()[j] * v[j] * v[j] / 2 + chain.stiffness()[j] * Math.pow(trace.extension()[j][i], 2) / 2;
            }
            return sum + b * Math.pow(trace.rate()[1][i], 2) / 2 + Math.pow(trace.rate()[3][i], 2);
        }).toArray();
        assertTrue(energy[0] > 1e-3);
        for (double e : energy) {
            assertEquals(energy[0], e, 1e-6 * energy[0]);
        }
    }

    /** Heavy, soft and left alone after a blow it hardly moves: the drag on what moves past it is d v². */
    @Test
    void aSloshingMassIsDraggedWithTheSquareOfItsSpeed() {
        LinkPhysics physics = new Setup.Rider(0, 5, 2000, 3, 400).physics();
        assertEquals(2000 * 0.01 + 3 * -0.2 - 400 * 0.04, physics.force(0, 0.01, -0.2, NONE, 0), 1e-12);
        assertEquals(2000 * 0.01 + 3 * -0.2, new Setup.Rider(0, 5, 2000, 3).physics().force(0, 0.01, -0.2, NONE, 0), 1e-12);
    }
}
