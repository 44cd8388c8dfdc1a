package wbv.body.simulate;

import wbv.body.Drive;

/** How far what carries no sensor swings across. */
public final class Swing {

    /** Below it the drift of accelerometers integrated twice is more than people move; assumed [rad/s]. */
    private static final double CORNER = 2 * Math.PI * 0.6;

    private Swing() {}

    /**
     * Part that is told of a displacement from accelerations: below 0.6 Hz drift would drown it.
     *
     * @param omega [rad/s]
     */
    static double passed(double omega) {
        double u = Math.pow(omega / CORNER, 8);
        return u / (1 + u);
    }

    /**
     * Displacement against the base: u = hθ - (a + h s²θ) / (s² + 2ζω0 s + ω0²); above 0.6 Hz, as that of ends that are measured.
     *
     * @param omega by line [rad/s]
     * @param base spectrum of the base's acceleration a [m/s²], real and imaginary parts in turn
     * @param rate spectrum of its rate sθ [rad/s]. None is modified.
     * @return its spectrum [m]
     */
    public static double[] of(Drive.Swings swings, double[] omega, double[] base, double[] rate) {
        double own = 2 * Math.PI * swings.frequency();
        double[] out = new double[base.length];
        for (int k = 1; k < omega.length; k++) {
            double w = omega[k];
            // h θ = h rate / jω, and its second derivative h rate jω
            double re = swings.height() * rate[2 * k + 1] / w;
            double im = -swings.height() * rate[2 * k] / w;
            double pushedRe = base[2 * k] - w * w * re;
            double pushedIm = base[2 * k + 1] - w * w * im;
            double stiff = own * own - w * w;
            double loss = 2 * swings.damping() * own * w;
            double square = stiff * stiff + loss * loss;
            double passed = passed(w);
            out[2 * k] = passed * (re - (pushedRe * stiff + pushedIm * loss) / square);
            out[2 * k + 1] = passed * (im - (pushedIm * stiff - pushedRe * loss) / square);
        }
        return out;
    }
}
