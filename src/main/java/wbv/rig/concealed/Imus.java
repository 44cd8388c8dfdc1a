package wbv.rig.concealed;

import java.util.Map;
import wbv.rig.platform.Seeds;

/**
 * The five inertial sensors of a chain's scene: from motion to rows, usually at 60 Hz. Gravity is taken out in the axes of the sensor,
 * which turn with the platform.
 */
final class Imus {

    /** Rows per second of the usual ones [Hz]. */
    static final double RATE = InertialSensors.RATE;

    private final RideScene scene;
    private final InertialSensors sensors;

    /** @param boxcar whether a row is the mean over its interval; a linear-phase low-pass at 26 Hz otherwise */
    Imus(RideScene scene, boolean boxcar) {
        this(scene, boxcar, RATE);
    }

    /** @param rate rows per second [Hz], a whole part of {@link UniformSeries#RATE}; the low-pass goes with it */
    Imus(RideScene scene, boolean boxcar, double rate) {
        this.scene = scene;
        this.sensors = new InertialSensors(scene.setting(), boxcar, rate);
    }

    /** What perfect sensors but for the setup's faults would send: by place six channels of rows. */
    Map<String, double[][]> clean(Setup setup, ChainPlant.Trace trace) {
        return sensors.clean(setup.faults(), RideScene.PLACES, place -> motion(place, trace));
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
        return sent(setup, trace, seeds, seeds);
    }

    /**
     * What they send another time, mounted as they were.
     *
     * @param seeds of how they are mounted
     * @param noises of this time's noise
     */
    Map<String, double[][]> sent(Setup setup, ChainPlant.Trace trace, Seeds seeds, Seeds noises) {
        return sensors.sent(setup.faults(), RideScene.PLACES, place -> motion(place, trace), seeds, noises);
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
        return new double[][] {x.clone(), y.clone(), z, UniformSeries.rate(shaking.roll()), UniformSeries.rate(shaking.pitch()),
            UniformSeries.rate(shaking.yaw())};
    }

    /**
     * What moves at {@link UniformSeries#RATE}, as rows: past the filter that every channel passes.
     *
     * @param in Not modified.
     */
    double[] thinned(double[] in) {
        return sensors.thinned(in);
    }
}
