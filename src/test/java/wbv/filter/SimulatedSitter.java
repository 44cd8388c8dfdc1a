package wbv.filter;

import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;

/**
 * A linear body of one degree of freedom under band-limited random shaking, without any discretisation of ours: in the steady
 * state by its analog transfer function in the frequency domain, through a change by Runge-Kutta at 480 Hz.
 */
public record SimulatedSitter(double frequency, double damping) {

    public static final double RATE = 60;
    private static final int FINE = 16;

    /** A body as test seed number {@code seed}: ζ in 0.2 … 0.6, f0 in 3 … 7 Hz. */
    public static SimulatedSitter of(long seed) {
        Random random = new Random(1000 + seed);
        random.nextDouble();
        return new SimulatedSitter(3 + 4 * random.nextDouble(), 0.2 + 0.4 * random.nextDouble());
    }

    /** Same damper and mass on a spring that is stiffer by a factor. */
    public SimulatedSitter withStiffness(double factor) {
        return new SimulatedSitter(frequency * Math.sqrt(factor), damping / Math.sqrt(factor));
    }

    /** Platform and body acceleration [m/s²] at 60 Hz. */
    public record Motion(double[] u, double[] y) {

        /** With white noise of the sensors added. @param deviation [m/s²] */
        public Motion measured(double deviation, long seed) {
            Random random = new Random(2000 + seed);
            double[] nu = u.clone();
            double[] ny = y.clone();
            for (int i = 0; i < u.length; i++) {
                nu[i] += deviation * random.nextGaussian();
                ny[i] += deviation * random.nextGaussian();
            }
            return new Motion(nu, ny);
        }
    }

    public Complex transfer(double f) {
        Complex r = new Complex(0, f / frequency);
        Complex d = r.multiply(2 * damping);
        return d.add(1).divide(r.multiply(r).add(d).add(1));
    }

    /** Steady random motion, 0.5 to 12 Hz. @param rms of the platform [m/s²]  @param samples at most 65536 */
    public Motion steady(double rms, int samples, long seed) {
        Complex[] spectrum = band(1 << 16, RATE, rms, seed);
        Complex[] response = spectrum.clone();
        for (int k = 1; k < spectrum.length / 2; k++) {
            response[k] = spectrum[k].multiply(transfer(k * RATE / spectrum.length));
        }
        return new Motion(real(spectrum, samples), real(response, samples));
    }

    /** Random motion of this body that becomes another at a time. @param seconds at most 68  @param change [s] */
    public Motion becoming(SimulatedSitter other, double rms, double seconds, double change, long seed) {
        int fine = (int) (seconds * RATE) * FINE;
        return integrate(real(band(1 << 16, FINE * RATE, rms, seed), fine + 1), other, change);
    }

    /** Random motion of this body that the platform ends within a second. @param seconds at most 68  @param end [s] */
    public Motion fading(double rms, double seconds, double end, long seed) {
        int fine = (int) (seconds * RATE) * FINE;
        double[] u = real(band(1 << 16, FINE * RATE, rms, seed), fine + 1);
        for (int i = 0; i <= fine; i++) {
            double late = Math.max(0, Math.min(1, i / (FINE * RATE) - end));
            u[i] *= 0.5 + 0.5 * Math.cos(Math.PI * late);
        }
        return integrate(u, this, seconds);
    }

    /**
     * Random motion of this body while its spring changes.
     *
     * @param factor  stiffness over this body's, at a time [s]
     * @param seconds at most 136
     */
    public Motion changing(DoubleUnaryOperator factor, double rms, double seconds, long seed) {
        int fine = (int) (seconds * RATE) * FINE;
        return integrate(real(band(1 << 17, FINE * RATE, rms, seed), fine + 1), t -> withStiffness(factor.applyAsDouble(t)));
    }

    private Motion integrate(double[] u, SimulatedSitter other, double change) {
        return integrate(u, t -> t < change ? this : other);
    }

    private static Motion integrate(double[] u, DoubleFunction<SimulatedSitter> body) {
        int fine = u.length - 1;
        int samples = fine / FINE;
        double[] coarse = new double[samples];
        double[] y = new double[samples];
        double[] x = new double[2];
        double h = 2 / (FINE * RATE);
        for (int i = 0; i < fine; i += 2) {
            SimulatedSitter now = body.apply(i / (FINE * RATE));
            if (i % FINE == 0) {
                coarse[i / FINE] = u[i];
                y[i / FINE] = u[i] - now.derivative(x, u[i]);
            }
            now.rungeKutta(x, u, i, h);
        }
        return new Motion(coarse, y);
    }

    /** q̈ of q̈ = -2ζω q̇ - ω² q + u, x = [q̇, q]. */
    private double derivative(double[] x, double u) {
        double omega = 2 * Math.PI * frequency;
        return -2 * damping * omega * x[0] - omega * omega * x[1] + u;
    }

    private void rungeKutta(double[] x, double[] u, int i, double h) {
        double a1 = derivative(x, u[i]);
        double v1 = x[0];
        double[] mid = {x[0] + h / 2 * a1, x[1] + h / 2 * v1};
        double a2 = derivative(mid, u[i + 1]);
        double v2 = mid[0];
        mid[0] = x[0] + h / 2 * a2;
        mid[1] = x[1] + h / 2 * v2;
        double a3 = derivative(mid, u[i + 1]);
        double v3 = mid[0];
        mid[0] = x[0] + h * a3;
        mid[1] = x[1] + h * v3;
        double a4 = derivative(mid, u[i + 2]);
        double v4 = mid[0];
        x[0] += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        x[1] += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    }

    private static Complex[] band(int points, double rate, double rms, long seed) {
        Random random = new Random(3000 + seed);
        Complex[] spectrum = new Complex[points];
        Arrays.fill(spectrum, Complex.ZERO);
        int first = (int) Math.ceil(0.5 * points / rate);
        int last = (int) (12 * points / rate);
        double power = 0;
        for (int k = first; k <= last; k++) {
            spectrum[k] = new Complex(random.nextGaussian(), random.nextGaussian());
            power += 2 * spectrum[k].abs() * spectrum[k].abs();
        }
        for (int k = first; k <= last; k++) {
            spectrum[k] = spectrum[k].multiply(rms / Math.sqrt(power));
        }
        return spectrum;
    }

    /** Samples of Σ 2 Re(X_k e^{iω_k t}). */
    private static double[] real(Complex[] half, int samples) {
        Complex[] full = half.clone();
        for (int k = 1; k < half.length / 2; k++) {
            full[half.length - k] = half[k].conjugate();
        }
        Complex[] time = new FastFourierTransformer(DftNormalization.UNITARY).transform(full, TransformType.INVERSE);
        double[] out = new double[samples];
        for (int i = 0; i < samples; i++) {
            out[i] = time[i].getReal() * Math.sqrt(half.length);
        }
        return out;
    }
}
