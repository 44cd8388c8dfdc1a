package wbv.filter;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.apache.commons.math3.complex.Complex;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.filter.model.InputWindow;
import wbv.filter.model.OneDegree;
import wbv.filter.model.Spec;

class ExactStepTest {

    private static final double T = 1.0 / 60;

    /** ẍ + 2ζω ẋ + ω² x = u, states [ẋ, x]. */
    private static ExactStep oscillator(double zeta, double omega, double time, int degree) {
        ExactStep step = new ExactStep(2, 0, degree);
        step.set(new double[] {-2 * zeta * omega, -omega * omega, 1, 0}, new double[0][], new double[] {1, 0}, time);
        return step;
    }

    /** Numbers: closed form of the underdamped case, ζ = 0.35, 5 Hz, 60 Hz. */
    @Test
    void anInputThatIsHeldStepsAsTheClosedForm() {
        ExactStep step = oscillator(0.35, 10 * Math.PI, T, 0);
        assertArrayEquals(new double[] {0.58787063, -13.15239707, 0.01332616, 0.88092829}, step.transition(), 5e-9);
        assertArrayEquals(new double[] {0.01332616, 0.00012064}, step.gain(0), 5e-9);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.2, 0.6, 0.999999, 1, 1.000001, 1.7, 3})
    void noCaseOfDampingIsSpecial(double zeta) {
        double omega = 2 * Math.PI * 25;
        ExactStep step = oscillator(zeta, omega, T, 0);
        assertArrayEquals(closedForm(zeta, omega, T), step.transition(), 1e-10);
        assertEquals(Math.exp(-2 * zeta * omega * T),
                step.transition()[0] * step.transition()[3] - step.transition()[1] * step.transition()[2], 1e-12);
    }

    private static double[] closedForm(double zeta, double omega, double t) {
        double sigma = zeta * omega;
        double squared = omega * omega * (1 - zeta * zeta);
        double root = Math.sqrt(Math.abs(squared));
        double c = squared > 0 ? Math.cos(root * t) : Math.cosh(root * t);
        double s = root == 0 ? t : (squared > 0 ? Math.sin(root * t) : Math.sinh(root * t)) / root;
        double e = Math.exp(-sigma * t);
        return new double[] {e * (c - sigma * s), -e * omega * omega * s, e * s, e * (c + sigma * s)};
    }

    /**
     * Torso 50.2 kg on 74300 N/m and 2807 N·s/m, head 5.5 kg on 41000 N/m and 318 N·s/m, excited through the base; derivative
     * to the neck's damper. Numbers: scipy 1.x linalg.expm and expm_frechet of the model with the input appended as
     * integrators.
     */
    @Test
    void aChainOfTwoBodiesStepsAsScipySays() {
        double m1 = 50.2;
        double m2 = 5.5;
        double[] a = {-(2807 + 318) / m1, -(74300 + 41000) / m1, 318 / m1, 41000 / m1, 1, 0, 0, 0,
            318 / m2, 41000 / m2, -318 / m2, -41000 / m2, 0, 0, 1, 0};
        double[] toDamper = {-1 / m1, 0, 1 / m1, 0, 0, 0, 0, 0, 1 / m2, 0, -1 / m2, 0, 0, 0, 0, 0};
        ExactStep step = new ExactStep(4, 1, 3);
        step.set(a, new double[][] {toDamper}, new double[] {-1, 0, -1, 0}, T);

        assertArrayEquals(new double[] {0.2503818541393579, -16.7935022129367, 0.06719052010538681, 2.5502419097093725,
            0.009623306422907298, 0.8082618016872032, 0.0007122406992006786, 0.047410595049592094, 0.6132662016891673,
            42.50581799362112, -0.03517830908493478, -52.12754234827748, 0.006500815109068008, 0.5724616508322783,
            0.007704959794701316, 0.36912799498219173}, step.transition(), 1e-12);
        assertArrayEquals(new double[] {4.0119617100368343e-05, 0.004906288038043472, -1.7218991147205433e-05,
            -0.004459784524323533, -3.016753215173718e-07, 5.086153717978218e-05, 5.652117005944813e-07, -4.482948946365655e-05,
            -0.00015716242828903894, -0.07450919243768372, -0.00020650880495111406, 0.06687369619147096, 5.158841339971441e-06,
            -0.0006214234894434789, -8.405649983627232e-06, 0.0005462157550340022}, step.transitionSlope(0), 1e-13);
        assertArrayEquals(new double[] {-0.010335547122107925, -0.00010183718212427082, -0.01420577490376927,
            -0.0001284172834927688}, step.gain(0), 1e-15);
        assertArrayEquals(new double[] {-0.00611023092745623, -3.6743043561199316e-05, -0.0077050370095661114,
            -4.418074960132572e-05}, step.gain(1), 1e-15);
        assertArrayEquals(new double[] {-0.0034646188591703994, -1.1910159022762987e-05, -0.004039094176612387,
            -1.3584397959737007e-05}, step.gain(3), 1e-15);
        assertArrayEquals(new double[] {-2.635363790771084e-07, -1.4917058398736758e-09, 3.246808643655782e-06,
            1.6892349809186167e-08}, step.gainSlope(0, 0), 1e-17);
        assertArrayEquals(new double[] {-2.3981251465320367e-08, -6.201501079623457e-11, 2.523904824026512e-07,
            6.39786961307323e-10}, step.gainSlope(0, 3), 1e-18);
    }

    /** x' = a x + s^j over [0, T]: integrating by parts, g_0 = (e^{aT} - 1)/a and g_j = (j g_{j-1}/T - 1)/a. */
    @Test
    void everyPowerOfTimeIsIntegratedExactly() {
        double a = -40;
        double time = 0.5;
        ExactStep step = new ExactStep(1, 0, 7);
        step.set(new double[] {a}, new double[0][], new double[] {1}, time);
        double expected = (Math.exp(a * time) - 1) / a;
        for (int j = 0; j <= 7; j++) {
            expected = j == 0 ? expected : (j * expected / time - 1) / a;
            assertEquals(expected, step.gain(j)[0], 1e-14, "power " + j);
        }
    }

    /** Body, hold and interpolation together against the analog transfer function. */
    @ParameterizedTest
    @ValueSource(doubles = {0.2, 0.35, 0.6})
    void theFilteredBodyIsTheAnalogBodyUpToTwelveHertz(double zeta) {
        for (double frequency : new double[] {3, 5, 7}) {
            OneDegree model = new OneDegree(Spec.at(60).startingAt(5, 0.4), true);
            model.set(Math.log(2 * Math.PI * frequency), Math.log(zeta));
            for (double f = 0.25; f <= 12; f += 0.25) {
                Complex exact = new SimulatedSitter(frequency, zeta).transfer(f);
                double error = response(model, f).subtract(exact).abs() / exact.abs();
                assertEquals(0, error, f <= 9 ? 0.001 : 0.0032, "ζ " + zeta + ", f0 " + frequency + " Hz, at " + f + " Hz");
            }
        }
    }

    /** y = H (zI - E)^-1 Σ_j g_j c_j(z) for the input z^n, counted from the end of the interval. */
    private static Complex response(OneDegree model, double f) {
        Complex z = new Complex(0, 2 * Math.PI * f * T).exp();
        double[] real = new double[InputWindow.POINTS];
        double[] imaginary = new double[InputWindow.POINTS];
        InputWindow window = new InputWindow(Spec.at(60));
        InputWindow quadrature = new InputWindow(Spec.at(60));
        for (int i = 0; i < InputWindow.POINTS; i++) {
            Complex sample = new Complex(0, 2 * Math.PI * f * T * (i - InputWindow.POINTS / 2)).exp();
            window.push(sample.getReal(), true);
            quadrature.push(sample.getImaginary(), true);
        }
        window.coefficients(real);
        quadrature.coefficients(imaginary);
        Complex[] forced = {Complex.ZERO, Complex.ZERO};
        for (int j = 0; j < InputWindow.POINTS; j++) {
            for (int r = 0; r < 2; r++) {
                forced[r] = forced[r].add(new Complex(real[j], imaginary[j]).multiply(model.step(0).gains()[2 * j + r]));
            }
        }
        double[] e = model.step(0).transition();
        // x_1 = E x_0 + forced with x_0 = x_1 / z
        Complex inverse = z.reciprocal();
        Complex m00 = inverse.multiply(-e[0]).add(1);
        Complex m01 = inverse.multiply(-e[1]);
        Complex m10 = inverse.multiply(-e[2]);
        Complex m11 = inverse.multiply(-e[3]).add(1);
        Complex determinant = m00.multiply(m11).subtract(m01.multiply(m10));
        Complex v = m11.multiply(forced[0]).subtract(m01.multiply(forced[1])).divide(determinant);
        Complex w = m00.multiply(forced[1]).subtract(m10.multiply(forced[0])).divide(determinant);
        return v.multiply(model.damper()).add(w.multiply(model.spring()));
    }

    @Test
    void whatIsNoNumberIsRefused() {
        ExactStep step = new ExactStep(1, 0, 0);
        assertThrows(IllegalArgumentException.class,
                () -> step.set(new double[] {Double.NaN}, new double[0][], new double[] {1}, 1));
        assertThrows(IllegalArgumentException.class, () -> new ExactStep(0, 0, 0));
    }
}
