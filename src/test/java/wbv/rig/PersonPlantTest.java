package wbv.rig;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.complex.ComplexField;
import org.apache.commons.math3.linear.Array2DRowFieldMatrix;
import org.apache.commons.math3.linear.ArrayFieldVector;
import org.apache.commons.math3.linear.FieldLUDecomposition;
import org.apache.commons.math3.linear.FieldVector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The whole person: against a frequency-domain solution written independently, and against what is known of people. */
class PersonPlantTest {

    private static final Sitter.Person FIRST = new Sitter.Person(Subject.of(1));
    private static final List<String> PLACES = FIRST.places();
    private static final int PELVIS = PLACES.indexOf("pelvis");
    private static final int SEAT = PLACES.indexOf("seat");
    private static final int HEAD = PLACES.indexOf("head");
    private static final int STERNUM = PLACES.indexOf("sternum");
    private static final int Z = 2;

    /** (-ω² M + jω C + K) u = (jω c0 + k0) for the vertical chain alone, the numbers of {@link Anatomy} read as it says. */
    @Test
    void verticalChainSolvesTheEquationOfMotion() {
        Response response = new Response(FIRST, Effects.NONE.with(Effect.CUSHION), 0.5, 1, 12, Z, 1, 20);
        for (int line = 0; line < 23; line++) {
            Complex[] expected = verticalChain(Subject.of(1), 2 * Math.PI * response.frequency(line));
            assertEquals(expected[Anatomy.HEAD].abs(), response.gain(HEAD, Z)[line], 2e-3, "head, line " + line);
            assertEquals(expected[Anatomy.TRUNK].abs(), response.gain(STERNUM, Z)[line], 2e-3, "sternum, line " + line);
            assertEquals(expected[Anatomy.PELVIS].abs(), response.gain(PELVIS, Z)[line], 2e-3, "pelvis, line " + line);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void headOverSeatHasOnePeakOf1point5To2Near5HzAndPelvisHasTwo(int subject) {
        Effects linear = Effects.USUAL.without(Effect.SOFTENING);
        Response response = new Response(new Sitter.Person(Subject.of(subject)), linear, 0.25, 2.5, 16, Z, 1, 20);
        double[] head = response.transmissibility(SEAT, HEAD);
        int peak = Response.peak(head);
        assertEquals(5, response.frequency(peak), 0.5, "Hz");
        assertEquals(1.75, head[peak], 0.25);
        assertEquals(1, Response.peaks(head), "peaks of the head");
        assertEquals(2, response.peaks(PELVIS, Z), "peaks of the pelvis");
    }

    /** Fairley and Griffin 1989: 60 people's apparent mass over sitting mass is one mass on 5 Hz and 0.475, 1.5 at 4 to 6 Hz. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4})
    void apparentMassIsThatOfPeople(int subject) {
        Effects linear = Effects.USUAL.without(Effect.SOFTENING);
        Response response = new Response(new Sitter.Person(Subject.of(subject)), linear, 0.25, 1, 16, Z, 1, 20);
        double[] apparent = response.apparentMass(SEAT);
        double sitting = 0.74 * Subject.of(subject).mass();
        int peak = Response.peak(apparent);
        assertEquals(1.5, apparent[peak] / sitting, 0.2);
        assertEquals(5, response.frequency(peak), 1, "Hz");
        for (int line = 0; line < apparent.length; line++) {
            double f = response.frequency(line) / 5 / Subject.of(subject).tautness();
            double publishedMass = Math.hypot(1, 0.95 * f) / Math.hypot(1 - f * f, 0.95 * f);
            assertEquals(publishedMass, apparent[line] / sitting, 0.25, "at " + response.frequency(line) + " Hz");
        }
    }

    @Test
    void theForceUnderTheSitterIsWhatMovesHim() {
        Response response = new Response(FIRST, Effects.NONE.with(Effect.CUSHION), 0.5, 1, 12, Z, 1, 20);
        Anatomy anatomy = new Anatomy(Subject.STATURE);
        for (int line = 0; line < 23; line++) {
            Complex[] u = verticalChain(Subject.of(1), 2 * Math.PI * response.frequency(line));
            Complex force = Complex.ZERO;
            for (int i = Anatomy.PELVIS; i < u.length; i++) {
                force = force.add(u[i].multiply(anatomy.bodies().get(i).share() * Subject.of(1).mass()));
            }
            double expected = force.divide(u[Anatomy.SEAT]).abs();
            assertEquals(expected, response.apparentMass(SEAT)[line], 3e-3 * expected, "line " + line);
        }
    }

    /** The head follows a slow turn about the upright, and no quick one. */
    @Test
    void theHeadTurnsLessTheQuickerThePlatformTurns() {
        assertEquals(1, yawOfTheHead(0.2), 0.05);
        assertTrue(yawOfTheHead(1.5) > 1.2, "a resonance");
        assertTrue(yawOfTheHead(5) < 0.5, "and less above it");
    }

    private static double yawOfTheHead(double f) {
        Plant plant = Plant.of(FIRST, Effects.USUAL.without(Effect.SOFTENING), 0.001, 0);
        PlaceMotion platform = new PlaceMotion();
        double w = 2 * Math.PI * f;
        double largest = 0;
        for (int k = 1; k <= 30_000; k++) {
            double t = k * 0.001;
            platform.angle[2] = 0.01 * Math.sin(w * t);
            platform.rate[2] = 0.01 * w * Math.cos(w * t);
            platform.spin[2] = -0.01 * w * w * Math.sin(w * t);
            plant.step(platform);
            largest = t > 20 ? Math.max(largest, Math.abs(plant.motion(HEAD).rate[2])) : 0;
        }
        return largest / (0.01 * w);
    }

    /** Fairley and Griffin 1989: from about 6 to about 4 Hz as the magnitude rises from 0.25 to 2.0 m/s². */
    @Test
    void resonanceFallsWithMagnitudeAsThePowerLawSays() {
        Response gentle = new Response(FIRST, Effects.USUAL, 0.125, 3, 7, Z, 0.25, 30);
        Response strong = new Response(FIRST, Effects.USUAL, 0.125, 3, 7, Z, 2, 30);
        double high = gentle.frequency(gentle.peak(HEAD, Z));
        double low = strong.frequency(strong.peak(HEAD, Z));
        assertEquals(6, high, 0.4);
        assertEquals(4, low, 0.4);
        assertEquals(Math.pow(2 / 0.25, -0.18), low / high, 0.03);
    }

    @Test
    void softeningOfOneAxisIsFeltInAnother() {
        Plant plant = Plant.of(FIRST, Effects.USUAL, 0.001, 0);
        PlaceMotion platform = new PlaceMotion();
        double[] truth = new double[6];
        plant.parameters(truth);
        double rested = truth[3];
        for (int k = 0; k < 20_000; k++) {
            platform.acceleration[1] = Math.sin(2 * Math.PI * 5 * k * 0.001);
            plant.step(platform);
        }
        plant.parameters(truth);
        assertEquals(Math.sqrt(0.5), truth[0], 0.02, "remembered magnitude");
        assertTrue(truth[3] < 0.7 * rested, "natural frequency of the vertical mode");
        for (int k = 0; k < 60_000; k++) {
            platform.acceleration[1] = 0;
            plant.step(platform);
        }
        plant.parameters(truth);
        assertEquals(rested, truth[3], 0.01 * rested, "a minute of rest stiffens again");
    }

    @Test
    void withoutSofteningTheParametersStay() {
        Plant plant = Plant.of(FIRST, Effects.USUAL.without(Effect.SOFTENING), 0.001, 0);
        PlaceMotion platform = new PlaceMotion();
        double[] before = new double[6];
        double[] after = new double[6];
        plant.parameters(before);
        for (int k = 0; k < 5_000; k++) {
            platform.acceleration[Z] = Math.sin(0.03 * k);
            plant.step(platform);
        }
        plant.parameters(after);
        assertEquals(before[3], after[3]);
        assertEquals(1, after[1]);
    }

    @Test
    void verticalMotionPitchesTheHeadOnlyWithCrossCoupling() {
        Response coupled = new Response(FIRST, Effects.USUAL, 0.5, 1, 8, Z, 0.7, 20);
        Response alone = new Response(FIRST, Effects.USUAL.without(Effect.CROSS), 0.5, 1, 8, Z, 0.7, 20);
        assertTrue(coupled.gain(HEAD, 0)[coupled.peak(HEAD, 0)] > 0.2, "fore-and-aft of the same order as vertical");
        assertEquals(0, alone.gain(HEAD, 0)[alone.peak(HEAD, 0)], 1e-12);
        assertEquals(0, alone.gain(HEAD, 4)[alone.peak(HEAD, 4)], 1e-12);
        assertEquals(0, coupled.gain(HEAD, 1)[coupled.peak(HEAD, 1)], 1e-12, "left and right are alike");
    }

    @Test
    void leversMoveOnlyWhatTurns() {
        Effects without = Effects.USUAL.without(Effect.LEVER);
        Response with = new Response(FIRST, Effects.USUAL, 0.5, 1, 8, 0, 0.7, 20);
        Response centre = new Response(FIRST, without, 0.5, 1, 8, 0, 0.7, 20);
        for (int line = 0; line < 15; line++) {
            assertEquals(centre.gain(HEAD, 4)[line], with.gain(HEAD, 4)[line], 1e-12, "the body itself moves the same");
        }
        int peak = with.peak(HEAD, 4);
        double lever = with.gain(HEAD, 4)[peak] * 0.08;
        assertTrue(with.gain(HEAD, Z)[peak] > 0.5 * lever, "pitch times lever is felt as vertical");
    }

    @Test
    void withoutCushionTheSeatIsThePlatform() {
        Response hard = new Response(FIRST, Effects.USUAL.without(Effect.CUSHION), 0.5, 1, 12, Z, 0.7, 15);
        for (double gain : hard.gain(PLACES.indexOf("seat"), Z)) {
            assertEquals(1, gain, 1e-9);
        }
    }

    @Test
    void aRigidTurnOfThePlatformAcceleratesEveryPlaceByItsHeight() {
        Plant plant = Plant.of(FIRST, Effects.NONE, 0.001, 0);
        PlaceMotion platform = new PlaceMotion();
        // So slow that the body follows as if rigid: 0.1 Hz.
        double w = 2 * Math.PI * 0.1;
        double largest = 0;
        for (int k = 1; k <= 30_000; k++) {
            platform.angle[1] = 0.01 * Math.sin(w * k * 0.001);
            platform.rate[1] = 0.01 * w * Math.cos(w * k * 0.001);
            platform.spin[1] = -0.01 * w * w * Math.sin(w * k * 0.001);
            plant.step(platform);
            if (k > 20_000) {
                largest = Math.max(largest, Math.abs(plant.motion(HEAD).acceleration[0]));
                assertEquals(platform.rate[1], plant.motion(HEAD).rate[1], 2e-4 * w);
            }
        }
        assertEquals(0.01 * w * w * 1.26, largest, 0.02 * largest);
    }

    private static Complex[] verticalChain(Subject subject, double w) {
        Anatomy anatomy = new Anatomy(subject.stature());
        int n = anatomy.bodies().size();
        Complex[][] a = new Complex[n][n];
        Complex[] b = new Complex[n];
        for (int i = 0; i < n; i++) {
            Arrays.fill(a[i], Complex.ZERO);
            a[i][i] = new Complex(-w * w * anatomy.bodies().get(i).share() * subject.mass());
            b[i] = Complex.ZERO;
        }
        for (Anatomy.Tissue tissue : anatomy.tissues()) {
            double carried = switch (tissue.to()) {
                case Anatomy.SEAT -> 0.84;
                case Anatomy.PELVIS -> 0.74;
                case Anatomy.VISCERA -> 0.12;
                case Anatomy.TRUNK -> 0.37;
                case Anatomy.HEAD -> 0.07;
                default -> 0.05;
            };
            double mass = carried * subject.mass();
            double w0 = 2 * Math.PI * tissue.frequency()[Z] * subject.tautnessAsHeSits();
            Complex z = new Complex(mass * w0 * w0, 2 * tissue.zeta()[Z] * subject.tightness() * mass * w0 * w);
            int j = tissue.to();
            a[j][j] = a[j][j].add(z);
            if (tissue.from() < 0) {
                b[j] = b[j].add(z);
            } else {
                int i = tissue.from();
                a[i][i] = a[i][i].add(z);
                a[i][j] = a[i][j].subtract(z);
                a[j][i] = a[j][i].subtract(z);
            }
        }
        FieldVector<Complex> u = new FieldLUDecomposition<>(new Array2DRowFieldMatrix<>(ComplexField.getInstance(), a))
                .getSolver().solve(new ArrayFieldVector<>(ComplexField.getInstance(), b));
        return u.toArray();
    }
}
