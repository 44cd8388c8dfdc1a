package wbv.identify;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.QRDecomposition;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ModalBodyTest {

    private static final double[] HERTZ = {0.3, 1, 2, 3, 4, 5, 6, 8, 10, 13, 17, 22};

    /** A chain of two masses on a shaken base. */
    private record Chain(double m1, double k1, double c1, double m2, double k2, double c2) {

        static Chain of(long seed) {
            Random random = new Random(300 + seed);
            return new Chain(30 + 40 * random.nextDouble(), 3e4 + 6e4 * random.nextDouble(), 500 + 2000 * random.nextDouble(),
                    4 + 20 * random.nextDouble(), 1e4 + 4e4 * random.nextDouble(), 100 + 600 * random.nextDouble());
        }

        /** Motion of a mass over the base's, by solving the two equations of motion. @param mass 1 or 2 */
        Complex transfer(double omega, int mass) {
            Complex s = new Complex(0, omega);
            Complex below = s.multiply(c1).add(k1);
            Complex above = s.multiply(c2).add(k2);
            Complex first = s.multiply(s).multiply(m1).add(below).add(above);
            Complex second = s.multiply(s).multiply(m2).add(above);
            Complex determinant = first.multiply(second).subtract(above.multiply(above));
            return below.multiply(mass == 1 ? second : above).divide(determinant);
        }

        /** ln ω and ln ζ of both modes. */
        double[] modes() {
            EigenDecomposition found = new EigenDecomposition(new Array2DRowRealMatrix(new double[][] {{0, 0, 1, 0}, {0, 0, 0, 1},
                {-(k1 + k2) / m1, k2 / m1, -(c1 + c2) / m1, c2 / m1}, {k2 / m2, -k2 / m2, c2 / m2, -c2 / m2}}));
            double[] theta = new double[4];
            int n = 0;
            for (int i = 0; i < 4; i++) {
                if (found.getImagEigenvalue(i) > 0) {
                    double omega = Math.hypot(found.getRealEigenvalue(i), found.getImagEigenvalue(i));
                    theta[n++] = Math.log(omega);
                    theta[n++] = Math.log(-found.getRealEigenvalue(i) / omega);
                }
            }
            return n == 4 ? theta : new double[0];
        }
    }

    private static Complex at(ModalBody body, double[] theta, double omega) {
        body.at(theta, omega);
        return new Complex(body.re()[0], body.im()[0]);
    }

    /** With the chain's own modes, damped as they may be, two shares give the motion of either mass at all frequencies. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void itIsEveryChainOfTwoMasses(long seed) {
        Chain chain = Chain.of(seed);
        double[] modes = chain.modes();
        assertEquals(4, modes.length, "a chain of which a mode does not swing");
        ModalBody body = new ModalBody(2);
        for (int mass = 1; mass <= 2; mass++) {
            double[] theta = new double[6];
            System.arraycopy(modes, 0, theta, 0, 4);
            double[][] rows = new double[2 * HERTZ.length][2];
            double[] wanted = new double[rows.length];
            for (int i = 0; i < HERTZ.length; i++) {
                double omega = 2 * Math.PI * HERTZ[i];
                Complex none = at(body, with(theta, 0, 0), omega);
                Complex share = at(body, with(theta, 1, 0), omega).subtract(none);
                Complex cross = at(body, with(theta, 0, 1), omega).subtract(none);
                Complex apart = chain.transfer(omega, mass).subtract(none);
                rows[2 * i] = new double[] {share.getReal(), cross.getReal()};
                rows[2 * i + 1] = new double[] {share.getImaginary(), cross.getImaginary()};
                wanted[2 * i] = apart.getReal();
                wanted[2 * i + 1] = apart.getImaginary();
            }
            double[] shares = new QRDecomposition(new Array2DRowRealMatrix(rows)).getSolver()
                    .solve(new Array2DRowRealMatrix(wanted)).getColumn(0);
            for (double hertz : HERTZ) {
                double omega = 2 * Math.PI * hertz;
                Complex apart = at(body, with(theta, shares[0], shares[1]), omega).subtract(chain.transfer(omega, mass));
                assertEquals(0, apart.abs(), 1e-9, "mass " + mass + " at " + hertz + " Hz");
            }
        }
    }

    private static double[] with(double[] theta, double share, double cross) {
        double[] all = theta.clone();
        all[4] = share;
        all[5] = cross;
        return all;
    }
}
