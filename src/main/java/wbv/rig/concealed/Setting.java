package wbv.rig.concealed;

import java.util.Locale;

/**
 * Where a recording is made, with the ordinary scatter of its sensors and sitters.
 *
 * <p>Scatter is one standard deviation: of gains, of clocks in output samples, of tilts in degrees, of lever arms in mm.
 */
public enum Setting {
    /** The platform's program: two seconds of rest, then random and swept motion at several levels, about two minutes. */
    RIG(1, 0.005, 0.1, 0.5, 3, 0.5, 1),
    /** The same with strong rotation of the platform. */
    ROTATION(1, 0.005, 0.1, 0.5, 3, 0.5, 1),
    /**
     * A minute on a road: no sweeps, no levels, noisier sensors, a livelier sitter, half of them without a sensor on the sternum.
     */
    FIELD(3, 0.007, 0.1, 0.7, 4, 1, 2),
    /** A laboratory bench, of which nobody is a part: one or two masses moved by a measured force or a measured base, wired sensors. */
    BENCH(1, 0.003, 0.02, 0, 0, 0, 0),
    /** Such a bench at three levels, a recording each. */
    BENCH_LEVELS(1, 0.003, 0.02, 0, 0, 0, 0),
    /** A sitter on three rides of three levels, a recording each, with the sensors where they were. */
    RIDE_LEVELS(1, 0.005, 0.1, 0.5, 3, 0.5, 1),
    /** A person of rigid bodies in a plane, on a platform that moves along x and z and pitches. */
    PLANAR(1, 0.005, 0.1, 0.5, 3, 0.5, 1),
    /** The same person, of whom his user has a model of bodies in a plane, with their joints. */
    JOINTED(1, 0.005, 0.1, 0.5, 3, 0.5, 1);

    final double noise;
    final double gain;
    final double clock;
    final double tilt;
    final double lever;
    final double leastForce;
    final double mostForce;

    /**
     * @param leastForce
     * @param mostForce of a sitter who does not sit still, root mean square [N]
     */
    Setting(double noise, double gain, double clock, double tilt, double lever, double leastForce, double mostForce) {
        this.noise = noise;
        this.gain = gain;
        this.clock = clock;
        this.tilt = tilt;
        this.lever = lever;
        this.leastForce = leastForce;
        this.mostForce = mostForce;
    }

    /** Its name in small letters, as {@code rig} or {@code bench levels}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
}
