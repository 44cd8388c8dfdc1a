package wbv.sensing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import wbv.recording.DataFault;

class OrientationTest {

    private static final double G = 9.80665;

    private static Orientation about(double[] axis, double angle) {
        double[] unit = Vectors.unit(axis);
        double s = Math.sin(angle / 2);
        return Orientation.of(Math.cos(angle / 2), s * unit[0], s * unit[1], s * unit[2]);
    }

    private static double[] random(Random source) {
        return new double[] {source.nextGaussian(), source.nextGaussian(), source.nextGaussian()};
    }

    private static double[] outward(Orientation orientation, double... v) {
        double[] out = new double[3];
        orientation.outward(v, out);
        return out;
    }

    /** v cos + (n × v) sin + n (n·v)(1 - cos): Rodrigues. */
    @Test
    void vectorsTurnAsRodriguesSays() {
        Random source = new Random(1);
        for (int i = 0; i < 50; i++) {
            double[] n = Vectors.unit(random(source));
            double angle = 3 * source.nextGaussian();
            double[] v = random(source);
            double[] cross = Vectors.cross(n, v);
            double[] expected = new double[3];
            for (int j = 0; j < 3; j++) {
                expected[j] = v[j] * Math.cos(angle) + cross[j] * Math.sin(angle) + n[j] * Vectors.dot(n,
                        v) * (1 - Math.cos(angle));
            }
            Orientation made = about(n, angle);
            assertArrayEquals(expected, outward(made, v), 1e-12);
            made.inward(expected, expected);
            assertArrayEquals(v, expected, 1e-12);
            Orientation turned = new Orientation();
            turned.turn(angle * n[0], angle * n[1], angle * n[2]);
            assertArrayEquals(outward(made, v), outward(turned, v), 1e-12);
        }
    }

    @Test
    void theLeastRotationBetweenDirections() {
        Random source = new Random(2);
        for (int i = 0; i < 50; i++) {
            double[] a = Vectors.unit(random(source));
            double[] b = Vectors.unit(random(source));
            Orientation between = Orientation.between(a, b);
            assertArrayEquals(b, outward(between, a), 1e-9);
            assertEquals(Math.acos(Vectors.dot(a, b)), between.angle(), 1e-9);
        }
        assertArrayEquals(new double[] {-1, 0, 0}, outward(Orientation.between(new double[] {1, 0, 0}, new double[] {-2, 0, 0}),
                1, 0, 0),
                1e-9);
    }

    /** Neck: the head bent forward, to the side and turned by known angles one after the other, on a trunk that leans anyhow. */
    @Test
    void jointAnglesAreThoseThatWereBent() {
        Random source = new Random(3);
        for (int i = 0; i < 50; i++) {
            Orientation trunk = about(random(source), source.nextGaussian());
            double[] bent = {1.2 * source.nextDouble() - 0.4, source.nextDouble() - 0.5, 2 * source.nextDouble() - 1};
            Orientation head = new Orientation();
            head.set(trunk);
            head.turn(0, bent[0], 0);
            head.turn(bent[1], 0, 0);
            head.turn(0, 0, bent[2]);
            JointAngles angles = JointAngles.between(trunk, head);
            assertArrayEquals(bent, new double[] {angles.flexion(), angles.lateral(), angles.axial()}, 1e-12);
        }
        // Nodding brings the crown forward; bending to the right brings it to the right, which is -y.
        Orientation nod = new Orientation();
        nod.turn(0, 0.2, 0);
        assertTrue(outward(nod, 0, 0, 1)[0] > 0 && JointAngles.between(new Orientation(), nod).flexion() > 0);
        Orientation right = new Orientation();
        right.turn(0.2, 0, 0);
        assertTrue(outward(right, 0, 0, 1)[1] < 0 && JointAngles.between(new Orientation(), right).lateral() > 0);
    }

    /** A sensor worn turned by any rotation, told by gravity, and its heading by a lean forward. */
    @Test
    void aStillPoseAndALeanShowHowASensorIsWorn() {
        Random source = new Random(4);
        for (int i = 0; i < 20; i++) {
            Orientation worn = about(random(source), source.nextGaussian());
            StillPose pose = new StillPose("head", 60);
            double[] up = {0, 0, G};
            worn.inward(up, up);
            double[] bias = {0.01, -0.02, 0.015};
            for (int n = 0; n < 120; n++) {
                double[] f = up.clone();
                double[] w = bias.clone();
                for (int j = 0; j < 3; j++) {
                    f[j] += 0.01 * source.nextGaussian();
                    w[j] += 0.001 * source.nextGaussian();
                }
                pose.accept(f, w);
            }
            StillPose.Worn found = pose.worn();
            assertArrayEquals(new double[] {0, 0, 1}, outward(found.alignment(), up[0] / G, up[1] / G, up[2] / G), 1e-3);
            assertEquals(0, found.alignment().heading(), 1e-9);
            assertArrayEquals(bias, found.bias(), 5e-4);
            assertEquals(G, found.gravity(), 0.01);
            double[] lean = {0, 0.7, 0};
            worn.inward(lean, lean);
            Orientation whole = found.leaning(lean).alignment();
            double[] v = random(source);
            assertArrayEquals(outward(worn, v), outward(whole, v), 5e-3 * Vectors.length(v));
        }
    }

    @Test
    void aPoseThatIsNoneIsRefused() {
        StillPose shaking = new StillPose("head", 60);
        StillPose free = new StillPose("head", 60);
        StillPose brief = new StillPose("head", 60);
        for (int n = 0; n < 120; n++) {
            shaking.accept(new double[] {Math.sin(n), 0, G}, new double[3]);
            free.accept(new double[] {0, 0, 0.1}, new double[3]);
            if (n < 30) {
                brief.accept(new double[] {0, 0, G}, new double[3]);
            }
        }
        assertTrue(assertThrows(DataFault.class, shaking::worn).getMessage().contains("should be still"));
        assertTrue(assertThrows(DataFault.class, free::worn).getMessage().contains("not gravity"));
        assertTrue(assertThrows(DataFault.class, brief::worn).getMessage().contains("too few"));
    }
}
