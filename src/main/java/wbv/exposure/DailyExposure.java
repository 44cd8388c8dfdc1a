package wbv.exposure;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import wbv.recording.DataFault;

/**
 * Exposure of a day made of tasks: per axis, the highest axis decides (2002/44/EC Annex B; ISO 2631-1 7.2).
 *
 * <p>{@code A(8) = k √(1/8 Σ a_i² t_i)} with t in hours, {@code VDV = k (Σ VDV_i⁴ t_i/T_i)^¼}.
 *
 * @param tasks at least one, 24 hours in all at most
 */
public record DailyExposure(List<DailyTask> tasks) {

    private static final double EIGHT_HOURS = 480;

    /** @throws DataFault if the tasks last longer than a day */
    public DailyExposure {
        tasks = List.copyOf(tasks);
        if (tasks.isEmpty()) {
            throw new IllegalArgumentException("a day needs at least one task");
        }
        double total = tasks.stream().mapToDouble(DailyTask::minutes).sum();
        if (total > DailyTask.DAY) {
            throw new DataFault("the tasks add up to " + RoundedNumber.text(total, 6)
                    + " minutes; a day has 1440: correct --task, --hours or the sidecars' daily_minutes");
        }
    }

    /** Duration of all tasks [min]. */
    public double minutes() {
        return tasks.stream().mapToDouble(DailyTask::minutes).sum();
    }

    /** Daily exposure along an axis, with k [m/s²]. Thesis: Eq. 2-4. */
    public double a8(SeatAxis axis) {
        return Math.sqrt(tasks.stream().mapToDouble(task -> task.a8(axis) * task.a8(axis)).sum());
    }

    /** Daily dose along an axis, with k [m/s^1.75]. Thesis: Eq. 2-2. */
    public double vdv(SeatAxis axis) {
        return Math.sqrt(Math.sqrt(tasks.stream().mapToDouble(task -> Math.pow(task.vdv(axis), 4)).sum()));
    }

    /** {@code 1.4 k (Σ a_i⁴ t_i)^¼}: the dose that the r.m.s. values alone would give along an axis [m/s^1.75]. */
    public double estimatedVdv(SeatAxis axis) {
        return Math.sqrt(Math.sqrt(tasks.stream()
                .mapToDouble(task -> Math.pow(Vibration.estimatedDose(task.factored(axis), 60 * task.minutes()), 4)).sum()));
    }

    /** The axis with the highest A(8). */
    public SeatAxis worstA8() {
        return worst(this::a8);
    }

    /** The axis with the highest dose. */
    public SeatAxis worstVdv() {
        return worst(this::vdv);
    }

    private static SeatAxis worst(ToDoubleFunction<SeatAxis> value) {
        return Arrays.stream(SeatAxis.values()).max(Comparator.comparingDouble(value)).orElseThrow();
    }

    /** The daily exposure: A(8) of the worst axis [m/s²]. */
    public double a8() {
        return a8(worstA8());
    }

    /** The daily dose: that of the worst axis [m/s^1.75]; NaN where one is not known. */
    public double vdv() {
        return vdv(worstVdv());
    }

    /** Points of the HSE's count on the worst axis [1]. */
    public double points() {
        return Directive.points(a8());
    }

    /** Verdict by A(8). */
    public Directive.Verdict verdict() {
        return Directive.Verdict.ofA8(a8());
    }

    /** Verdict by the dose. */
    public Directive.Verdict verdictByDose() {
        return Directive.Verdict.ofVdv(vdv());
    }

    /** Relative standard deviation of A(8) along an axis by the scatter within the recordings [1]; NaN where not known. */
    public double deviation(SeatAxis axis) {
        double variance = 0;
        for (DailyTask task : tasks) {
            double square = task.a8(axis) * task.a8(axis);
            if (square > 0) {
                variance += Math.pow(2 * square * task.levels().get(axis).deviation(), 2);
            }
        }
        return Math.sqrt(variance) / (2 * a8(axis) * a8(axis));
    }

    /** Time a day of this mix of tasks until A(8) reaches a value [min]; infinite for no vibration. */
    public double minutesUntilA8(Directive value) {
        double ratio = value.a8() / a8();
        return minutes() * ratio * ratio;
    }

    /** Time a day of this mix of tasks until the dose reaches a value [min]; infinite for no vibration, NaN where not known. */
    public double minutesUntilVdv(Directive value) {
        double ratio = value.vdv() / vdv();
        return minutes() * ratio * ratio * ratio * ratio;
    }

    /** Minutes a day of this mix of tasks until A(8) or the dose, where it is known, reaches a value, whichever is first. */
    public double minutesUntil(Directive value) {
        double byDose = minutesUntilVdv(value);
        return Double.isNaN(byDose) ? minutesUntilA8(value) : Math.min(minutesUntilA8(value), byDose);
    }

    /** The steady weighted acceleration, with k, that gives the same A(8) in the same time [m/s²]. */
    public double equivalent() {
        return a8() * Math.sqrt(EIGHT_HOURS / minutes());
    }
}
