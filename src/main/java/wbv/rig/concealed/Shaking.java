package wbv.rig.concealed;

import java.util.OptionalDouble;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.platform.Seeds;

/**
 * What the platform does: accelerations along x, y, z [m/s²] and small angles about them [rad], by sample at
 * {@link UniformSeries#RATE}.
 */
record Shaking(double[] x, double[] y, double[] z, double[] roll, double[] pitch, double[] yaw) {

    private static final double REST = 2;
    private static final double FADE = 0.5;

    int length() {
        return z.length;
    }

    /**
     * @param level of all vertical motion; 1 is the usual
     * @param length how long it lasts [s], where that is not drawn
     */
    static Shaking of(Setting setting, double level, OptionalDouble length, Seeds seeds) {
        RandomGenerator random = seeds.source("program");
        boolean field = setting == Setting.FIELD || setting == Setting.RIDE_LEVELS;
        double seconds = field ? 45 + 15 * random.nextDouble() : 112 + 28 * random.nextDouble();
        // Whole output samples, and three seconds to come to rest.
        int samples = (int) Math.round(Math.rint(length.orElse(seconds) * 60) / 60 * UniformSeries.RATE);
        double[] z = new double[samples];
        int first = (int) (REST * UniformSeries.RATE);
        int last = samples - (int) (1.5 * UniformSeries.RATE);
        if (field) {
            double[] road = UniformSeries.lines(last - first, 0.5, 12, -0.6, level * (0.6 + 0.5 * random.nextDouble()), random);
            UniformSeries.fade(road, FADE);
            System.arraycopy(road, 0, z, first, road.length);
        } else {
            double[] levels = shuffled(new double[] {0.4, 0.8, 1.2}, random);
            for (int i = 0; i < 6; i++) {
                int from = first + (int) ((long) (last - first) * i / 6);
                int to = first + (int) ((long) (last - first) * (i + 1) / 6);
                double[] part = i % 2 == 0 ? UniformSeries.lines(to - from, 0.5, 10, 0, level * levels[i / 2], random)
                        : sweep(to - from, level * (0.5 + 1.7 * random.nextDouble()), random.nextBoolean());
                UniformSeries.fade(part, FADE);
                System.arraycopy(part, 0, z, from, part.length);
            }
        }
        boolean rotates = setting == Setting.ROTATION;
        return new Shaking(other(0.3, 6, 0, 0.16, samples, seeds.source("x")), other(0.3, 6, 0, 0.16, samples, seeds.source("y")),
                z,
                other(0.5, 5, -1, 0.0012, samples, seeds.source("roll")),
                other(0.5, 5, -1, rotates ? 0.005 : 0.0012, samples, seeds.source("pitch")),
                other(0.5, 5, -1, 0.0012, samples, seeds.source("yaw")));
    }

    private static double[] other(double low, double high, double slope, double rms, int length, RandomGenerator random) {
        int first = (int) (REST * UniformSeries.RATE);
        double[] out = new double[length];
        double[] part = UniformSeries.lines(length - first - (int) UniformSeries.RATE, low, high, slope, rms, random);
        UniformSeries.fade(part, FADE);
        System.arraycopy(part, 0, out, first, part.length);
        return out;
    }

    /** Half a hertz to ten and half the amplitude to all of it, or back. */
    private static double[] sweep(int length, double amplitude, boolean up) {
        double[] out = new double[length];
        double phase = 0;
        for (int i = 0; i < length; i++) {
            double share = (double) i / length;
            double along = up ? share : 1 - share;
            out[i] = amplitude * (0.5 + 0.5 * along) * StrictMath.sin(phase);
            phase += 2 * Math.PI * (0.5 + 9.5 * along) / UniformSeries.RATE;
        }
        return out;
    }

    private static double[] shuffled(double[] x, RandomGenerator random) {
        for (int i = x.length - 1; i > 0; i--) {
            int j = random.nextInt(i + 1);
            double keep = x[i];
            x[i] = x[j];
            x[j] = keep;
        }
        return x;
    }
}
