package wbv.pole;

import java.util.Optional;
import wbv.identify.Pole;
import wbv.identify.TransferModel;

/**
 * The body of one degree of freedom, {@code (2ζω s + ω²)/(s² + 2ζω s + ω²)}, that best simulates a window: what an estimator of
 * one degree converges to. Output error by Gauss and Newton on ln ω and ln ζ.
 */
final class BodyFit {

    private static final int ITERATIONS = 20;
    private static final double SMALL = 1e-4;
    /** Motion of before the window that the fit leaves aside [s]. */
    private static final double SETTLING = 2;
    private static final double LARGEST_STEP = 0.3;

    private BodyFit() { }

    /**
     * Its pole; empty if none oscillates in the band of seated bodies. @param u input. Not modified. @param y output. Not
     * modified.
     */
    static Optional<Pole> pole(double[] u, double[] y, double rate) {
        double omega = Math.log(2 * Math.PI * 5);
        double damping = Math.log(0.35);
        int from = (int) (SETTLING * rate);
        for (int iteration = 0; iteration < ITERATIONS; iteration++) {
            double[] at = simulate(u, rate, omega, damping);
            double[] byOmega = simulate(u, rate, omega + SMALL, damping);
            double[] byDamping = simulate(u, rate, omega, damping + SMALL);
            double aa = 0;
            double ab = 0;
            double bb = 0;
            double ra = 0;
            double rb = 0;
            for (int k = from; k < y.length; k++) {
                double a = (byOmega[k] - at[k]) / SMALL;
                double b = (byDamping[k] - at[k]) / SMALL;
                double r = y[k] - at[k];
                aa += a * a;
                ab += a * b;
                bb += b * b;
                ra += a * r;
                rb += b * r;
            }
            double determinant = aa * bb - ab * ab;
            if (!(determinant > 0)) {
                return Optional.empty();
            }
            double stepOmega = limited((bb * ra - ab * rb) / determinant);
            double stepDamping = limited((aa * rb - ab * ra) / determinant);
            omega += stepOmega;
            damping += stepDamping;
            if (Math.abs(stepOmega) + Math.abs(stepDamping) < 1e-6) {
                break;
            }
        }
        double frequency = Math.exp(omega) / (2 * Math.PI);
        boolean sound = frequency >= PoleWindows.LEAST_FREQUENCY && frequency <= PoleWindows.MOST_FREQUENCY
                && Math.exp(damping) <= PoleWindows.MOST_DAMPING;
        return sound ? Optional.of(Pole.of(frequency, Math.exp(damping))) : Optional.empty();
    }

    private static double limited(double step) {
        return Math.max(-LARGEST_STEP, Math.min(LARGEST_STEP, step));
    }

    private static double[] simulate(double[] u, double rate, double logOmega, double logDamping) {
        double omega = Math.exp(logOmega);
        return model(omega, Math.exp(logDamping)).simulate(new double[][] {u}, rate, new double[2]);
    }

    /** The body of a pole. */
    static TransferModel model(Pole pole) {
        return model(2 * Math.PI * pole.frequency(), pole.damping());
    }

    private static TransferModel model(double omega, double damping) {
        double[] a = {2 * damping * omega, omega * omega};
        return new TransferModel(a, new double[][] {a});
    }
}
