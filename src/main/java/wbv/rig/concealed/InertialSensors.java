package wbv.rig.concealed;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.apache.commons.math3.random.RandomGenerator;
import wbv.rig.ImuErrors;
import wbv.rig.platform.Seeds;

/** Inertial sensors of six channels: from the motion of their places at {@link UniformSeries#RATE} to rows, usually at 60 Hz. */
final class InertialSensors {

    /** Rows per second of the usual ones [Hz]. */
    static final double RATE = 60;
    /** Corner of the low-pass at the usual rate [Hz]. */
    private static final double CORNER = 26;
    /** Half the length of its kernel, in rows. */
    private static final int HALF = 12;
    private static final double ACC_STEP = 1e4;
    private static final double GYR_STEP = 1e5;

    private final Setting setting;
    private final boolean boxcar;
    private final double rate;
    private final int ticks;
    private final double[] kernel;

    /**
     * @param boxcar whether a row is the mean over its interval; a linear-phase low-pass at 26 Hz otherwise
     * @param rate rows per second [Hz], a whole part of {@link UniformSeries#RATE}; the low-pass goes with it
     */
    InertialSensors(Setting setting, boolean boxcar, double rate) {
        this.setting = setting;
        this.boxcar = boxcar;
        this.rate = rate;
        this.ticks = (int) (UniformSeries.RATE / rate);
        this.kernel = boxcar ? new double[0] : kernel();
    }

    private double corner() {
        return CORNER * (rate / RATE);
    }

    /**
     * Standard deviation of a row's noise.
     *
     * @param q channel, 0 to 5
     */
    double noise(int q) {
        double bandwidth = boxcar ? rate / 2 : corner();
        return setting.noise * (q < 3 ? ImuErrors.TABLE_3_2.acceleration() : ImuErrors.TABLE_3_2.rate()).noise() * Math.sqrt(bandwidth);
    }

    /**
     * What perfect sensors but for the faults would send: by place six channels of rows.
     *
     * @param motion of a place, made anew for each call
     */
    Map<String, double[][]> clean(List<Setup.FaultAt> faults, List<String> places, Function<String, double[][]> motion) {
        Map<String, double[][]> out = new LinkedHashMap<>();
        for (String place : places) {
            out.put(place, rows(faults, place, motion.apply(place), 0));
        }
        return out;
    }

    /**
     * What real ones send: with scatter and noise.
     *
     * @param seeds of how they are mounted
     * @param noises of this time's noise
     */
    Map<String, double[][]> sent(List<Setup.FaultAt> faults, List<String> places, Function<String, double[][]> motion, Seeds seeds,
            Seeds noises) {
        Map<String, double[][]> out = new LinkedHashMap<>();
        for (String place : places) {
            RandomGenerator random = seeds.source("imu " + place);
            double[][] six = motion.apply(place);
            double[] arm = {setting.lever * 1e-3 * random.nextGaussian(), setting.lever * 1e-3 * random.nextGaussian()};
            double[] tilt = {Math.toRadians(setting.tilt) * random.nextGaussian(),
                Math.toRadians(setting.tilt) * random.nextGaussian()};
            double[] rollSpin = UniformSeries.rate(six[3]);
            double[] pitchSpin = UniformSeries.rate(six[4]);
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
            double[][] rows = rows(faults, place, six, setting.clock * random.nextGaussian() / rate);
            RandomGenerator later = noises.equals(seeds) ? random : noises.source("imu " + place);
            for (int q = 0; q < 6; q++) {
                double noise = noise(q);
                double bias = (q < 3 ? ImuErrors.TABLE_3_2.acceleration().bias()
                        : ImuErrors.TABLE_3_2.rate().bias()) * later.nextGaussian();
                double step = q < 3 ? ACC_STEP : GYR_STEP;
                for (int i = 0; i < rows[q].length; i++) {
                    rows[q][i] = Math.rint((rows[q][i] * gains[q] + bias + noise * later.nextGaussian()) * step) / step + 0.0;
                }
            }
            // A row that was lost is the row before, noise and all.
            faults.stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSending(rows));
            out.put(place, rows);
        }
        return out;
    }

    private double[][] rows(List<Setup.FaultAt> faults, String place, double[][] six, double late) {
        faults.stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSensing(six));
        double[][] rows = new double[6][];
        for (int q = 0; q < 6; q++) {
            double[] in = six[q];
            if (late != 0) {
                in = new double[in.length];
                for (int i = 0; i < in.length; i++) {
                    in[i] = UniformSeries.at(six[q], i - late * UniformSeries.RATE);
                }
            }
            rows[q] = thinned(in);
        }
        if (late == 0) {
            faults.stream().filter(at -> at.place().equals(place)).forEach(at -> at.fault().whileSending(rows));
        }
        return rows;
    }

    /**
     * What moves at {@link UniformSeries#RATE}, as rows: past the filter that every channel passes.
     *
     * @param in Not modified.
     */
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

    private double[] kernel() {
        return Kernel.lowPass(corner(), UniformSeries.RATE, HALF * ticks);
    }
}
