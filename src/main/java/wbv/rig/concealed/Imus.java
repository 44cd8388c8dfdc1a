package wbv.rig.concealed;

import java.util.LinkedHashMap;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.ImuErrors;
import wbv.rig.Seeds;

/**
 * The five inertial sensors: from motion to rows, usually at 60 Hz. Gravity is taken out in the axes of the sensor, which turn with the
 * platform.
 */
final class Imus {

    /** Rows per second of the usual ones [Hz]. */
    static final double RATE = 60;
    /** Corner of the low-pass at the usual rate [Hz]. */
    private static final double CORNER = 26;
    /** Half the length of its kernel, in rows. */
    private static final int HALF = 12;
    private static final double ACC_STEP = 1e4;
    private static final double GYR_STEP = 1e5;

    private final Scene scene;
    private final boolean boxcar;
    private final double rate;
    private final int ticks;
    private final double[] kernel;

    /** @param boxcar whether a row is the mean over its interval; a linear-phase low-pass at 26 Hz otherwise */
    Imus(Scene scene, boolean boxcar) {
        this(scene, boxcar, RATE);
    }

    /** @param rate rows per second [Hz], a whole part of {@link Series#RATE}; the low-pass goes with it */
    Imus(Scene scene, boolean boxcar, double rate) {
        this.scene = scene;
        this.boxcar = boxcar;
        this.rate = rate;
        this.ticks = (int) (Series.RATE / rate);
        this.kernel = boxcar ? new double[0] : kernel();
    }

    private double corner() {
        return CORNER * (rate / RATE);
    }

    /** What perfect sensors but for the setup's faults would send: by place six channels of rows. */
    Map<String, double[][]> clean(Setup setup, ChainPlant.Trace trace) {
        Map<String, double[][]> out = new LinkedHashMap<>();
        for (String place : Scene.PLACES) {
            out.put(place, rows(setup, place, motion(place, trace), 0));
        }
        return out;
    }

    /** The vertical of one place alone, as {@link #clean} has it. */
    double[] vertical(Setup setup, ChainPlant.Trace trace, String place) {
        double[][] six = motion(place, trace);
        setup.faults().stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSensing(six));
        double[][] rows = new double[6][0];
        rows[Fault.Z] = thinned(six[Fault.Z]);
        setup.faults().stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSending(rows));
        return rows[Fault.Z];
    }

    /** What real ones send: with scatter and noise. */
    Map<String, double[][]> sent(Setup setup, ChainPlant.Trace trace, Seeds seeds) {
        Setting setting = scene.setting();
        Map<String, double[][]> out = new LinkedHashMap<>();
        double bandwidth = boxcar ? rate / 2 : corner();
        double acc = setting.noise * ImuErrors.TABLE_3_2.acceleration().noise() * Math.sqrt(bandwidth);
        double gyr = setting.noise * ImuErrors.TABLE_3_2.rate().noise() * Math.sqrt(bandwidth);
        for (String place : Scene.PLACES) {
            RandomGenerator random = seeds.source("imu " + place);
            double[][] six = motion(place, trace);
            double[] arm = {setting.lever * 1e-3 * random.nextGaussian(), setting.lever * 1e-3 * random.nextGaussian()};
            double[] tilt = {Math.toRadians(setting.tilt) * random.nextGaussian(),
                    Math.toRadians(setting.tilt) * random.nextGaussian()};
            double[] rollSpin = Series.rate(six[3]);
            double[] pitchSpin = Series.rate(six[4]);
            for (int i = 0; i < six[0].length; i++) {
                double x = six[0][i];
                double y = six[1][i];
                double z = six[2][i] + arm[1] * rollSpin[i] - arm[0] * pitchSpin[i];
                six[0][i] = x - tilt[1] * z;
                six[1][i] = y + tilt[0] * z;
                six[2][i] = z + tilt[1] * x - tilt[0] * y;
            }
            double[] gains = new double[6];
            for (int q = 0; q < 6; q++) {
                gains[q] = 1 + setting.gain * random.nextGaussian();
            }
            double[][] rows = rows(setup, place, six, setting.clock * random.nextGaussian() / rate);
            for (int q = 0; q < 6; q++) {
                double noise = q < 3 ? acc : gyr;
                double bias = (q < 3 ? ImuErrors.TABLE_3_2.acceleration().bias()
                        : ImuErrors.TABLE_3_2.rate().bias()) * random.nextGaussian();
                double step = q < 3 ? ACC_STEP : GYR_STEP;
                for (int i = 0; i < rows[q].length; i++) {
                    rows[q][i] = Math.rint((rows[q][i] * gains[q] + bias + noise * random.nextGaussian()) * step) / step + 0.0;
                }
            }
            // A row that was lost is the row before, noise and all.
            setup.faults().stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSending(rows));
            out.put(place, rows);
        }
        return out;
    }

    private double[][] rows(Setup setup, String place, double[][] six, double late) {
        setup.faults().stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSensing(six));
        double[][] rows = new double[6][];
        for (int q = 0; q < 6; q++) {
            double[] in = six[q];
            if (late != 0) {
                in = new double[in.length];
                for (int i = 0; i < in.length; i++) {
                    in[i] = Series.at(six[q], i - late * Series.RATE);
                }
            }
            rows[q] = thinned(in);
        }
        if (late == 0) {
            setup.faults().stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSending(rows));
        }
        return rows;
    }

    private double[][] motion(String place, ChainPlant.Trace trace) {
        Shaking shaking = scene.shaking();
        int body = scene.chain().rider(place);
        double[] x = scene.fore().get(place).acceleration();
        double[] y = scene.side().get(place).acceleration();
        double[] up = body < 0 ? shaking.z() : trace.acceleration()[body];
        double[] z = new double[up.length];
        for (int i = 0; i < z.length; i++) {
            z[i] = up[i] + shaking.pitch()[i] * x[i] - shaking.roll()[i] * y[i];
        }
        return new double[][] {x.clone(), y.clone(), z, Series.rate(shaking.roll()), Series.rate(shaking.pitch()),
                Series.rate(shaking.yaw())};
    }

    /** What moves at {@link Series#RATE}, as rows: past the filter that every channel passes. @param in Not modified. */
    double[] thinned(double[] in) {
        double[] out = new double[in.length / ticks];
        for (int i = 0; i < out.length; i++) {
            out[i] = boxcar ? mean(in, i * ticks) : filtered(in, i * ticks);
        }
        return out;
    }

    private double mean(double[] x, int at) {
        double sum = 0;
        for (int j = at - ticks + 1; j <= at; j++) {
            sum += x[Math.max(0, j)];
        }
        return sum / ticks;
    }

    private double filtered(double[] x, int at) {
        double sum = 0;
        int half = kernel.length / 2;
        for (int j = -half; j <= half; j++) {
            sum += kernel[j + half] * x[Math.max(0, Math.min(x.length - 1, at + j))];
        }
        return sum;
    }

    /** A sinc under a Blackman window, of unit gain at rest. */
    private double[] kernel() {
        int half = HALF * ticks;
        double[] out = new double[2 * half + 1];
        double sum = 0;
        for (int j = -half; j <= half; j++) {
            double angle = 2 * Math.PI * corner() * j / Series.RATE;
            double w = Math.PI * j / (half + 1);
            out[j + half] = (j == 0 ? 1 : Math.sin(angle) / angle) * (0.42 + 0.5 * Math.cos(w) + 0.08 * Math.cos(2 * w));
            sum += out[j + half];
        }
        for (int j = 0; j < out.length; j++) {
            out[j] /= sum;
        }
        return out;
    }
}
