package wbv.rig.platform;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;

/**
 * One of the nine regimes of the thesis' experiment, in which the platform shakes all six axes at once; the first is rest.
 *
 * <p>Levels are its Table 3-3: what was measured at the platform, root mean square. Two things are read into the print: its
 * "m/sec" of an acceleration is m/s², and its rates, broken over lines, belong to x, y and z in the order in which they stand.
 * Bands are its Figures 3-14 and 3-15: energy from 5 to 8 Hz on the translations and from 3 to 4 Hz on the rotations, swept.
 * Every axis sweeps to and fro through its band at random paces of its own, and a fifth of its power is random in the rest of
 * 0.5 to 12 Hz (assumed), so that transmissibility is measurable there.
 *
 * @param number 0 to 8
 * @param x      fore-and-aft acceleration, root mean square [m/s²]
 * @param y      lateral [m/s²]
 * @param z      vertical [m/s²]
 * @param roll   rate about x, root mean square [°/s], as the table has it
 * @param pitch  rate about y [°/s]
 * @param yaw    rate about z [°/s]
 */
public record Regime(int number, double x, double y, double z, double roll, double pitch, double yaw) {

    /** All nine, in order. */
    public static final List<Regime> ALL = List.of(
            new Regime(0, 0, 0, 0, 0, 0, 0),
            new Regime(1, 0.160, 0.160, 0.931, 0.624, 0.672, 0.565),
            new Regime(2, 0.177, 0.138, 0.943, 0.634, 0.710, 0.573),
            new Regime(3, 0.191, 0.122, 0.956, 0.630, 0.743, 0.571),
            new Regime(4, 0.531, 0.127, 0.091, 0.619, 0.582, 0.577),
            new Regime(5, 0.186, 0.499, 0.156, 0.629, 0.604, 0.571),
            new Regime(6, 0.685, 1.035, 0.408, 1.218, 1.691, 7.862),
            new Regime(7, 0.288, 0.234, 0.803, 0.638, 5.887, 0.764),
            new Regime(8, 0.164, 0.142, 0.496, 0.617, 3.034, 0.677));

    /** The number of the last regime; the first is 0. */
    static final int LAST_NUMBER = 8;

    private static final double SPREAD = 0.2;
    private static final double FIRST = 0.5;
    private static final double LAST = 12;

    /**
     * One of the nine.
     *
     * @throws IllegalArgumentException if the number is not 0 to 8
     */
    public static Regime of(int number) {
        if (number < 0 || number > LAST_NUMBER) {
            throw new IllegalArgumentException("regime must be 0 to " + LAST_NUMBER + ": " + number);
        }
        return ALL.get(number);
    }

    /** Root mean square of an axis [m/s² or rad/s]. */
    public double rms(Axis axis) {
        return switch (axis) {
            case X -> x;
            case Y -> y;
            case Z -> z;
            case ROLL -> Math.toRadians(roll);
            case PITCH -> Math.toRadians(pitch);
            case YAW -> Math.toRadians(yaw);
        };
    }

    /**
     * Sweep in the main band, random below and above it: bands that do not overlap, or their product would add a level of its
     * own that takes minutes to average out.
     */
    public PlatformCommand drive(double h, Seeds seeds) {
        WanderingLines[][] bands = new WanderingLines[Axis.COUNT][];
        for (Axis axis : Axis.values()) {
            boolean linear = axis.ordinal() < 3;
            double low = linear ? 5 : 3;
            double high = linear ? 8 : 4;
            double perHertz = SPREAD * rms(axis) * rms(axis) / (LAST - FIRST - (high - low));
            Seeds own = seeds.of(axis.toString());
            bands[axis.ordinal()] = new WanderingLines[] {
                new WanderingLines(1, low, high, rms(axis) * Math.sqrt(1 - SPREAD), h, own.source("main")),
                random(FIRST, low, perHertz, h, own.source("below")),
                random(high, LAST, perHertz, h, own.source("above"))};
        }
        return (gain, command) -> {
            for (int i = 0; i < Axis.COUNT; i++) {
                for (WanderingLines band : bands[i]) {
                    command[i] += gain * band.next();
                }
            }
        };
    }

    private static WanderingLines random(double low, double high, double perHertz, double h, RandomGenerator source) {
        return new WanderingLines((int) Math.round(4 * (high - low)), low, high, Math.sqrt(perHertz * (high - low)), h, source);
    }
}
