package wbv.body;

/** Arithmetic of spectra held as arrays: real part of line k at 2k, imaginary part at 2k + 1. */
public final class Spectra {

    private Spectra() {}

    /**
     * Adds a multiple of one to another.
     *
     * @param target spectrum or series in its own unit, at least as long as the source. Modified.
     * @param source spectrum or series in a unit that the factor turns into the target's. Not modified.
     */
    public static void add(double[] target, double[] source, double factor) {
        for (int i = 0; i < source.length; i++) {
            target[i] += factor * source[i];
        }
    }

    /**
     * The product of two spectra, line by line, in the product of their units. A new array.
     *
     * @param x spectrum of any unit
     * @param y of any unit, as long. Neither is modified.
     */
    public static double[] product(double[] x, double[] y) {
        double[] out = new double[x.length];
        addProduct(x, y, 1, out);
        return out;
    }

    /**
     * Adds a multiple of the product of two spectra of any units, line by line.
     *
     * @param x spectrum of any unit
     * @param y of any unit, as long
     * @param out in the product of their units, a spectrum as long as they. Modified.
     */
    public static void addProduct(double[] x, double[] y, double factor, double[] out) {
        for (int i = 0; i < out.length; i += 2) {
            out[i] += factor * (x[i] * y[i] - x[i + 1] * y[i + 1]);
            out[i + 1] += factor * (x[i] * y[i + 1] + x[i + 1] * y[i]);
        }
    }

    /**
     * Derivative to time, by j ω: a spectrum, in the unit of x per second. A new array.
     *
     * @param omega by line [rad/s]
     * @param x spectrum of K lines, in its own unit. Neither is modified.
     */
    public static double[] timesJOmega(double[] omega, double[] x) {
        double[] out = new double[x.length];
        for (int k = 0; k < omega.length; k++) {
            out[2 * k] = -omega[k] * x[2 * k + 1];
            out[2 * k + 1] = omega[k] * x[2 * k];
        }
        return out;
    }

    /**
     * Integral over time, by 1/(j ω): a spectrum, in the unit of x times seconds; nothing at the first line. A new array.
     *
     * @param omega by line [rad/s]
     * @param x spectrum of K lines, in its own unit. Neither is modified.
     */
    public static double[] overJOmega(double[] omega, double[] x) {
        double[] out = new double[x.length];
        for (int k = 1; k < omega.length; k++) {
            out[2 * k] = x[2 * k + 1] / omega[k];
            out[2 * k + 1] = -x[2 * k] / omega[k];
        }
        return out;
    }

    /**
     * Two numbers, k [N/m] and c [N s/m], of which {@code (k + j ω c) stretch} comes nearest to a force, constants left out.
     *
     * @param omega by line [rad/s]
     * @param force spectrum [N]
     * @param stretch spectrum [m]. None is modified.
     */
    public static double[] stiffnessAndDamping(double[] omega, double[] force, double[] stretch) {
        double inPhase = 0;
        double ahead = 0;
        double size = 0;
        double speed = 0;
        for (int k = 1; k < omega.length; k++) {
            double re = stretch[2 * k];
            double im = stretch[2 * k + 1];
            double square = re * re + im * im;
            inPhase += force[2 * k] * re + force[2 * k + 1] * im;
            ahead += omega[k] * (force[2 * k + 1] * re - force[2 * k] * im);
            size += square;
            speed += omega[k] * omega[k] * square;
        }
        return size > 0 ? new double[] {inPhase / size, ahead / speed} : new double[2];
    }
}
