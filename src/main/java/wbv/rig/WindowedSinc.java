package wbv.rig;

import java.util.Arrays;

/** A linear-phase low-pass evaluated at any instant between inner samples: a sinc under a Blackman window. */
final class WindowedSinc implements Decimator {

    /** Corner (half amplitude) over output rate. */
    static final double CUTOFF = 0.4;
    private static final int INTERVALS = 24;
    private static final int PHASES = 60;

    private final Kernel kernel;
    private final double[] ring;
    private int newest;
    private boolean empty = true;

    WindowedSinc(Kernel kernel) {
        this.kernel = kernel;
        this.ring = new double[kernel.length];
    }

    @Override
    public void accept(double value) {
        if (empty) {
            Arrays.fill(ring, value);
            empty = false;
        }
        newest = newest + 1 == ring.length ? 0 : newest + 1;
        ring[newest] = value;
    }

    @Override
    public double take(double fraction) {
        double[] weights = kernel.weights[(int) Math.round((1 - fraction) * PHASES)];
        double sum = 0;
        int at = newest;
        for (double weight : weights) {
            sum += weight * ring[at];
            at = at == 0 ? ring.length - 1 : at - 1;
        }
        return sum;
    }

    /** Weights for sixty phases between two inner samples, newest sample first; made once, shared by all channels. */
    static final class Kernel {
        private final int length;
        private final double[][] weights;

        /** @param ticks inner samples in an output interval */
        Kernel(double ticks) {
            double half = INTERVALS * ticks / 2;
            length = (int) Math.ceil(2 * half) + 1;
            weights = new double[PHASES + 1][length];
            for (int phase = 0; phase <= PHASES; phase++) {
                double sum = 0;
                for (int j = 0; j < length; j++) {
                    // The newest sample lies phase/PHASES after the instant; the kernel's middle lies half before it.
                    double u = (double) phase / PHASES - j + half;
                    weights[phase][j] = Math.abs(u) < half ? value(u, half, ticks) : 0;
                    sum += weights[phase][j];
                }
                for (int j = 0; j < length; j++) {
                    weights[phase][j] /= sum;
                }
            }
        }

        private static double value(double u, double half, double ticks) {
            double angle = 2 * Math.PI * CUTOFF * u / ticks;
            double sinc = angle == 0 ? 1 : StrictMath.sin(angle) / angle;
            double w = Math.PI * u / half;
            return sinc * (0.42 + 0.5 * StrictMath.cos(w) + 0.08 * StrictMath.cos(2 * w));
        }
    }
}
