package wbv.rig;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;

/**
 * One of the nine regimes in which the platform shakes all six axes at once.
 *
 * <p>What the thesis says of its regimes (chapter 3) is kept: nine of them, swept in frequency, energy from 5 to 8 Hz on the
 * translations and from 3 to 4 Hz on the rotations, levels of 0.3 to 0.9 m/s². The root mean squares axis by axis in
 * {@link #ALL} are <b>assumed</b>, not quoted from its Table 3-3: three levels of mainly vertical motion, of equal translation,
 * and of translation with strong rotation. Every axis sweeps to and fro through its band at random paces of its own, and a
 * fifth of its power is random in the rest of 0.5 to 12 Hz (assumed), so that transmissibility is measurable there.
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
    private static final double FIRST = 0.5;
    private static final double LAST = 12;

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

    /**
     * Sweep in the main band, random below and above it: bands that do not overlap, or their product would add a level of its
     * own that takes minutes to average out.
     */
    Drive drive(double h, Seeds seeds) {
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
