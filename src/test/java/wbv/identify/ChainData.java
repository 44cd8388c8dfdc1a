package wbv.identify;

import java.util.Random;

/** Closed forms of what is identified: lines of a random spectrum, answered exactly, in steady motion, under white noise of the sensors. */
final class ChainData {

    /** Seat, pelvis, torso, head: modes at 2.199, 12.097 and 12.568 Hz, damping ratios 0.287, 0.313 and 0.679; two real poles. */
    static final double[][] PERSON = {{12, 24, 32, 5.5}, {1.6e4, 9e4, 1.1e5, 3e4}, {750, 1400, 1700, 210}};

    private ChainData() {}

    /** Acceleration of the base [m/s²], 1.5 rms from 0.6 to 18 Hz, and of the highest body, at 60 Hz, both with 0.02 m/s² of noise. */
    static Samples head(double[][] chain, double seconds, long seed) {
        Random random = new Random(seed);
        double rate = 60;
        int n = (int) (seconds * rate);
        double[] u = new double[n];
        double[] y = new double[n];
        for (int line = (int) Math.ceil(0.6 * seconds); line <= 18 * seconds; line++) {
            double f = line / seconds;
            double size = Math.min(1, 3 / f);
            double[] h = answer(chain, 2 * Math.PI * f);
            add(random, size, f / rate, h, u, y);
        }
        double scale = 1.5 / rms(u);
        for (int t = 0; t < n; t++) {
            u[t] = scale * u[t] + 0.02 * random.nextGaussian();
            y[t] = scale * y[t] + 0.02 * random.nextGaussian();
        }
        return Samples.of(rate, u, y);
    }

    /** Motion of 9 mm rms, 0.4 to 25 Hz, and the force of 2 kN/m and 1.8 kNs/m; noise of 3 µm and 6 N. */
    static Samples springAndDashpot(double seconds, double rate, long seed) {
        Random random = new Random(seed);
        int n = (int) (seconds * rate);
        double[] x = new double[n];
        double[] force = new double[n];
        for (int line = (int) (0.4 * seconds); line <= 25 * seconds; line++) {
            double f = line / seconds;
            add(random, Math.pow(Math.max(1, f), -1.2), f / rate, new double[] {2000, 1800 * 2 * Math.PI * f}, x, force);
        }
        double scale = 0.009 / rms(x);
        for (int t = 0; t < n; t++) {
            x[t] = scale * x[t] + 3e-6 * random.nextGaussian();
            force[t] = scale * force[t] + 6 * random.nextGaussian();
        }
        return Samples.of(rate, x, force);
    }

    private static void add(Random random, double size, double step, double[] h, double[] u, double[] y) {
        double a = size * random.nextGaussian();
        double b = size * random.nextGaussian();
        for (int t = 0; t < u.length; t++) {
            double cos = Math.cos(2 * Math.PI * step * t);
            double sin = Math.sin(2 * Math.PI * step * t);
            u[t] += a * cos - b * sin;
            y[t] += (a * h[0] - b * h[1]) * cos - (a * h[1] + b * h[0]) * sin;
        }
    }

    private static double rms(double[] x) {
        double sum = 0;
        for (double each : x) {
            sum += each * each;
        }
        return Math.sqrt(sum / x.length);
    }

    /** Highest body over base, from the top down: what hangs on a link is a mass of a complex size. */
    private static double[] answer(double[][] chain, double w) {
        double[] product = {1, 0};
        double[] above = {0, 0}; // apparent mass of all above
        for (int i = chain[0].length - 1; i >= 0; i--) {
            double[] mass = {chain[0][i] + above[0], above[1]};
            double[] link = {chain[1][i], w * chain[2][i]};
            double[] over = ratio(link, new double[] {link[0] - w * w * mass[0], link[1] - w * w * mass[1]});
            product = times(product, over);
            above = times(mass, over);
        }
        return product;
    }

    private static double[] times(double[] a, double[] b) {
        return new double[] {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
    }

    private static double[] ratio(double[] a, double[] b) {
        double size = b[0] * b[0] + b[1] * b[1];
        return new double[] {(a[0] * b[0] + a[1] * b[1]) / size, (a[1] * b[0] - a[0] * b[1]) / size};
    }
}
