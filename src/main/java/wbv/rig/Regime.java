package wbv.rig;

import java.util.List;

/**
 * One of the nine regimes in which the platform shakes all six axes at once.
 *
 * <p>What the thesis says of its regimes (chapter 3) is kept: nine of them, swept in frequency, energy from 5 to 8 Hz on the
 * translations and from 3 to 4 Hz on the rotations, levels of 0.3 to 0.9 m/s². The root mean squares axis by axis in {@link #ALL}
 * are <b>assumed</b>, not quoted from its Table 3-3: three levels of mainly vertical, of equal translation, and of translation with
 * strong rotation. Every axis sweeps to and fro through its band at random paces of its own, and a fifth of its power is
 * random from 0.5 to 12 Hz (assumed), so that transmissibility is measurable there.
 *
 * @param number 1 to 9
 * @param x      fore-and-aft acceleration, root mean square [m/s²]
 * @param y      lateral [m/s²]
 * @param z      vertical [m/s²]
 * @param roll   rate about x, root mean square [rad/s]
 * @param pitch  rate about y [rad/s]
 * @param yaw    rate about z [rad/s]
 */
public record Regime(int number, double x, double y, double z, double roll, double pitch, double yaw) {

    /** All nine, in order. */
    public static final List<Regime> ALL = List.of(
            new Regime(1, 0.10, 0.10, 0.30, 0.004, 0.004, 0.002),
            new Regime(2, 0.15, 0.15, 0.60, 0.006, 0.006, 0.003),
            new Regime(3, 0.20, 0.20, 0.90, 0.008, 0.008, 0.004),
            new Regime(4, 0.30, 0.30, 0.30, 0.004, 0.004, 0.004),
            new Regime(5, 0.60, 0.60, 0.60, 0.006, 0.006, 0.006),
            new Regime(6, 0.90, 0.90, 0.90, 0.008, 0.008, 0.008),
            new Regime(7, 0.20, 0.20, 0.30, 0.020, 0.020, 0.010),
            new Regime(8, 0.30, 0.30, 0.60, 0.030, 0.030, 0.015),
            new Regime(9, 0.40, 0.40, 0.90, 0.040, 0.040, 0.020));

    private static final double SPREAD = 0.2;

    /** @throws IllegalArgumentException if the number is not 1 to 9 */
    public static Regime of(int number) {
        if (number < 1 || number > ALL.size()) {
            throw new IllegalArgumentException("regime must be 1 to " + ALL.size() + ": " + number);
        }
        return ALL.get(number - 1);
    }

    /** Root mean square of an axis [m/s² or rad/s]. */
    public double rms(Axis axis) {
        return switch (axis) {
            case X -> x;
            case Y -> y;
            case Z -> z;
            case ROLL -> roll;
            case PITCH -> pitch;
            case YAW -> yaw;
        };
    }

    Drive drive(double h, Seeds seeds) {
        WanderingLines[] main = new WanderingLines[Axis.COUNT];
        WanderingLines[] spread = new WanderingLines[Axis.COUNT];
        for (Axis axis : Axis.values()) {
            int i = axis.ordinal();
            double low = i < 3 ? 5 : 3;
            double high = i < 3 ? 8 : 4;
            Seeds own = seeds.of(axis.toString());
            main[i] = new WanderingLines(1, low, high, rms(axis) * Math.sqrt(1 - SPREAD), h, own.source("main"));
            spread[i] = new WanderingLines(46, 0.5, 12, rms(axis) * Math.sqrt(SPREAD), h, own.source("spread"));
        }
        return (gain, command) -> {
            for (int i = 0; i < Axis.COUNT; i++) {
                command[i] += gain * (main[i].next() + spread[i].next());
            }
        };
    }
}
