package wbv.exposure;

import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.Map;
import wbv.recording.DataFault;

/**
 * One of the tasks of a day.
 *
 * @param name    what is done
 * @param minutes daily, 0 to 1440
 * @param levels  of the axes that were measured, without the factors k; at least one
 */
public record DailyTask(String name, double minutes, Map<SeatAxis, Vibration.Level> levels) {

    /** Minutes of a day. */
    public static final double DAY = 1440;
    private static final double EIGHT_HOURS = 480;

    public DailyTask {
        if (!(minutes >= 0 && minutes <= DAY)) {
            throw new DataFault("task '" + name + "' must last 0 to 1440 minutes a day: " + minutes);
        }
        if (levels.isEmpty()) {
            throw new IllegalArgumentException("a task needs at least one axis");
        }
        levels = new EnumMap<>(levels);
    }

    /** The axis with the highest level, the factor k in it. */
    public SeatAxis worst() {
        return Arrays.stream(SeatAxis.values()).filter(axis -> levels.isEmpty() || levels.containsKey(axis))
                .max(Comparator.comparingDouble(this::factored)).orElseThrow();
    }

    /** Level with the factor k [m/s²]; 0 where the axis was not measured. */
    public double factored(SeatAxis axis) {
        Vibration.Level level = levels.get(axis);
        return level == null ? 0 : axis.factor() * level.rms();
    }

    /** Partial exposure {@code A_i(8) = k a_w √(t/8 h)} [m/s²]; 0 where the axis was not measured. */
    public double a8(SeatAxis axis) {
        return factored(axis) * Math.sqrt(minutes / EIGHT_HOURS);
    }

    /** Dose of the task in a day, with k [m/s^1.75]; 0 where the axis was not measured, NaN where its dose is not known. */
    public double vdv(SeatAxis axis) {
        Vibration.Level level = levels.get(axis);
        return level == null ? 0 : minutes == 0 ? 0 : axis.factor() * level.dose(60 * minutes);
    }

    /** Time of this task alone until A(8) reaches a value on any axis [min]; infinite for no vibration. */
    public double minutesUntilA8(Directive value) {
        double worst = factored(worst());
        return EIGHT_HOURS * value.a8() * value.a8() / (worst * worst);
    }

    /** Time of this task alone until the dose reaches a value on any axis [min]; infinite for no vibration, NaN where not known. */
    public double minutesUntilVdv(Directive value) {
        double shortest = Double.POSITIVE_INFINITY;
        for (Map.Entry<SeatAxis, Vibration.Level> entry : levels.entrySet()) {
            Vibration.Level level = entry.getValue();
            double ratio = value.vdv() / (entry.getKey().factor() * level.vdv());
            shortest = Math.min(shortest, level.seconds() / 60 * ratio * ratio * ratio * ratio);
        }
        return shortest;
    }

    /** Points an hour of this task, on its worst axis [1/h]. */
    public double pointsAnHour() {
        double worst = factored(worst());
        return Directive.points(worst) / 8;
    }

    @Override
    public Map<SeatAxis, Vibration.Level> levels() {
        return new EnumMap<>(levels);
    }
}
