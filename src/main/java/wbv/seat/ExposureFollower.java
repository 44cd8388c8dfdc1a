package wbv.seat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import wbv.exposure.Directive;
import wbv.exposure.Meter;
import wbv.exposure.SeatAxis;
import wbv.exposure.Vibration;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Exposure of one shift, which lasts 24 hours of the sensor's time at most; then the next begins.
 *
 * <p>Time left is reckoned as the exposure so far goes on: {@code A(8)² = k² a_w² T / 8 h} grows with T, {@code VDV⁴} likewise, so
 * that a value V is reached after {@code T ((V/A)² - 1)} and {@code T ((V/VDV)⁴ - 1)}.
 */
final class ExposureFollower implements Snapshot {

    private static final double EIGHT_HOURS = 8 * 3600;
    private static final double DAY = 24 * 3600;

    private final SeatPlan plan;
    private final List<SeatAxis> axes;
    private final int[] columns;
    private final Meter[] meters;
    private double since = Double.NaN;
    private long samples;
    private Directive.Verdict told = Directive.Verdict.BELOW_ACTION;

    ExposureFollower(SeatPlan plan) {
        this.plan = plan;
        this.axes = List.copyOf(plan.axes().keySet());
        this.columns = axes.stream().mapToInt(plan.axes()::get).toArray();
        this.meters = new Meter[columns.length];
        begin(Double.NaN);
    }

    /**
     * Another shift.
     *
     * @param time of its first sample [s], NaN if it is not known yet
     */
    void begin(double time) {
        for (int i = 0; i < meters.length; i++) {
            meters[i] = plan.meter(axes.get(i));
        }
        since = time;
        samples = 0;
        told = Directive.Verdict.BELOW_ACTION;
    }

    /**
     * Takes a sample.
     *
     * @param row NaN where missing. Not modified.
     * @param time of it [s]
     */
    void step(double[] row, double time) {
        if (samples >= DAY * plan.rate()) {
            begin(time);
        }
        since = samples == 0 ? time : since;
        samples++;
        for (int i = 0; i < meters.length; i++) {
            meters[i].accept(row[columns[i]]);
        }
    }

    SeatResult.Exposure now() {
        List<SeatResult.Axis> all = new ArrayList<>();
        double seconds = 0;
        double a8 = 0;
        double vdv = 0;
        double toAction = Double.POSITIVE_INFINITY;
        double toLimit = Double.POSITIVE_INFINITY;
        for (int i = 0; i < meters.length; i++) {
            Vibration vibration = meters[i].vibration();
            double k = axes.get(i).factor();
            double own = k * vibration.rms() * Math.sqrt(vibration.seconds() / EIGHT_HOURS);
            double dose = k * vibration.vdv();
            all.add(new SeatResult.Axis(axes.get(i), vibration.rms(), meters[i].running(), own, dose));
            seconds = Math.max(seconds, vibration.seconds());
            a8 = Math.max(a8, own);
            vdv = Math.max(vdv, dose);
            toAction = Math.min(toAction, minutesLeft(vibration.seconds(), own, dose, Directive.ACTION));
            toLimit = Math.min(toLimit, minutesLeft(vibration.seconds(), own, dose, Directive.LIMIT));
        }
        double gone = samples / plan.rate();
        return new SeatResult.Exposure(since, seconds, Math.max(0, gone - seconds), all, a8, vdv, toAction,
                toLimit);
    }

    private static double minutesLeft(double seconds, double a8, double vdv, Directive value) {
        double byMean = seconds * (Math.pow(value.a8() / a8, 2) - 1);
        double byDose = seconds * (Math.pow(value.vdv() / vdv, 4) - 1);
        double least = Math.min(a8 > 0 ? byMean : Double.POSITIVE_INFINITY, vdv > 0 ? byDose : Double.POSITIVE_INFINITY);
        return Math.max(0, least) / 60;
    }

    /**
     * Tells of a value that is reached for the first time in the shift.
     *
     * @param time now [s]
     */
    void tell(SeatResult.Exposure exposure, double time, Consumer<SeatAlarm> alarms) {
        Directive.Verdict verdict = exposure.verdict();
        if (verdict != Directive.Verdict.UNKNOWN && verdict.compareTo(told) > 0) {
            told = verdict;
            boolean limit = verdict == Directive.Verdict.ABOVE_LIMIT;
            alarms.accept(new SeatAlarm(limit ? SeatAlarm.Kind.LIMIT_VALUE : SeatAlarm.Kind.ACTION_VALUE, time,
                    String.format(Locale.ROOT, "the exposure %s value is reached after %.0f min: A(8) %.2f m/s², dose %.1f m/s^1.75",
                            limit ? "limit" : "action", exposure.seconds() / 60, exposure.a8(), exposure.vdv())));
        }
    }

    @Override
    public void save(StateWriter out) {
        out.put(since);
        out.put(samples);
        out.put(told.ordinal());
        out.put(meters);
    }

    @Override
    public void load(StateReader in) {
        since = in.number();
        samples = in.count();
        told = Directive.Verdict.values()[in.integer(0, Directive.Verdict.values().length - 1, "a verdict")];
        in.parts(meters);
    }
}
