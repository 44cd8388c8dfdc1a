package wbv.identify;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;

/** Data of systems whose coefficients are known. */
final class KnownSystem {

    static final double RATE = 60;
    /** A body of 5 Hz and damping ratio 0.35 at 60 Hz, held by ZOH: a as in the closed form, b arbitrary. */
    static final double[] A = {-1.468799, 0.693143};
    static final double[] B = {0.02, 0.15, 0.04};
    static final double[] C = {-0.8, 0.3};

    private KnownSystem() {}

    /** Noise through a filter (1 + 0.5 q⁻¹)/(1 - 0.7 q⁻¹). */
    static double[] input(int length, RandomGenerator random) {
        double[] u = new double[length];
        double before = 0;
        for (int k = 0; k < length; k++) {
            double white = random.nextGaussian();
            u[k] = (k > 0 ? 0.7 * u[k - 1] : 0) + white + 0.5 * before;
            before = white;
        }
        return u;
    }

    /** ARMAX with equation noise so large that the noise-free output is this far above what the noise adds to it [dB]. */
    static Samples armax(double decibel, int length, long seed) {
        RandomGenerator random = new Well19937c(seed);
        double[] u = input(length, random);
        double[] e = new double[length];
        for (int k = 0; k < length; k++) {
            e[k] = random.nextGaussian();
        }
        double[] clean = run(u, new double[length]);
        double[] noise = run(new double[length], e);
        double scale = Math.sqrt(power(clean) / power(noise) / Math.pow(10, decibel / 10));
        double[] y = new double[length];
        for (int k = 0; k < length; k++) {
            y[k] = clean[k] + scale * noise[k];
        }
        return Samples.of(RATE, u, y);
    }

    /** The difference equation, term by term. */
    private static double[] run(double[] u, double[] e) {
        double[] y = new double[u.length];
        for (int k = 0; k < y.length; k++) {
            y[k] = e[k];
            for (int j = 0; j < B.length && j <= k; j++) {
                y[k] += B[j] * u[k - j];
            }
            for (int i = 0; i < A.length && i < k; i++) {
                y[k] += -A[i] * y[k - 1 - i] + C[i] * e[k - 1 - i];
            }
        }
        return y;
    }

    /**
     * A body on a shaken base, {@code (2ζω s + ω²)/(s² + 2ζω s + ω²)}, measured with white noise at its output. The input is a
     * sum of sines, so the answer is known in closed form; the body has been shaken for ever.
     */
    static Samples body(double frequency, double damping, double decibel, int length, long seed) {
        RandomGenerator random = new Well19937c(seed);
        double[] u = new double[length];
        double[] y = new double[length];
        for (int line = 0; line < 60; line++) {
            double f = 0.5 + 11 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            double r = f / frequency;
            double re = 1 - r * r;
            double im = 2 * damping * r;
            double modulus = Math.hypot(1, im) / Math.hypot(re, im);
            double angle = Math.atan2(im, 1) - Math.atan2(im, re);
            for (int k = 0; k < length; k++) {
                double at = 2 * Math.PI * f * k / RATE + phase;
                u[k] += Math.sin(at);
                y[k] += modulus * Math.sin(at + angle);
            }
        }
        double noise = Math.sqrt(power(y) / Math.pow(10, decibel / 10));
        for (int k = 0; k < length; k++) {
            y[k] += noise * random.nextGaussian();
        }
        return Samples.of(RATE, u, y);
    }

    static double power(double[] x) {
        double sum = 0;
        for (double value : x) {
            sum += value * value;
        }
        return sum / x.length;
    }
}
