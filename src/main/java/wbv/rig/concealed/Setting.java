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
    FIELD(3, 0.007, 0.1, 0.7, 4, 1, 2);

    final double noise;
    final double gain;
    final double clock;
    final double tilt;
    final double lever;
    final double leastForce;
    final double mostForce;

    /** @param leastForce @param mostForce of a sitter who does not sit still, root mean square [N] */
    Setting(double noise, double gain, double clock, double tilt, double lever, double leastForce, double mostForce) {
        this.noise = noise;
        this.gain = gain;
        this.clock = clock;
        this.tilt = tilt;
        this.lever = lever;
        this.leastForce = leastForce;
        this.mostForce = mostForce;
    }

    /** {@code rig}, {@code rotation} or {@code field}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
