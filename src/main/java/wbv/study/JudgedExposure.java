package wbv.study;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import wbv.exposure.CoveredBand;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.result.Digits;

/** The exposure of one recording, judged for the hours a day that it stands for. */
public final class JudgedExposure {

    /** Unit of a vibration dose value. */
    public static final String DOSE = "m/s¹·⁷⁵";
    private static final double EIGHT_HOURS = 480;

    private final SeatMeasurement measured;
    private final DailyTask task;
    private final SeatAxis worst;
    private final boolean known;
    private final CoveredBand band;

    /** Takes the minutes that the recording's metadata state, or eight hours. */
    public JudgedExposure(SeatMeasurement measured) {
        this.measured = measured;
        OptionalDouble daily = measured.metadata().dailyMinutes();
        known = daily.isPresent();
        task = measured.task("recording", daily.orElse(EIGHT_HOURS));
        worst = task.worst();
        band = measured.band(worst);
    }

    /** A(8) on the worst axis [m/s²]. */
    public double a8() {
        return task.a8(worst);
    }

    /** Dose of the day on the axis where it is greatest [m/s^1.75]. */
    public double dose() {
        return measured.axes().keySet().stream().mapToDouble(task::vdv).max().orElse(Double.NaN);
    }

    /** Whether the dose is graver than A(8). */
    public boolean doseDecides() {
        Directive.Verdict byDose = Directive.Verdict.ofVdv(dose());
        return byDose != Directive.Verdict.UNKNOWN && byDose.compareTo(Directive.Verdict.ofA8(a8())) > 0;
    }

    /** The graver verdict of A(8) and dose. */
    public Directive.Verdict verdict() {
        return doseDecides() ? Directive.Verdict.ofVdv(dose()) : Directive.Verdict.ofA8(a8());
    }

    /** Half a sentence, its unit after the number. */
    public String words() {
        return (known ? duration(task.minutes()) : "eight hours") + " a day of it are " + verdict().words() + (doseDecides()
                ? " by their shocks (dose " + atLeast() + Digits.significant(dose(), 2) + "\u00a0" + DOSE + ")"
                : " (A(8) " + atLeast() + Digits.significant(a8(), 2) + "\u00a0m/s²)");
    }

    private String atLeast() {
        return band.lowerBound() ? "at least " : "";
    }

    /** The same for machines. */
    AnalysisResults.ExposureFacts facts() {
        Map<String, Double> levels = new LinkedHashMap<>();
        Map<String, Double> doses = new LinkedHashMap<>();
        measured.axes().forEach((axis, vibration) -> {
            levels.put(String.valueOf(axis.letter()), vibration.rms());
            doses.put(String.valueOf(axis.letter()), vibration.vdv());
        });
        return new AnalysisResults.ExposureFacts(measured.place(), levels, doses, measured.axes().get(worst).seconds(),
                String.valueOf(worst.letter()), task.minutes(), !known, a8(), verdict().words(),
                task.minutesUntilA8(Directive.ACTION), task.minutesUntilVdv(Directive.ACTION), band.lowerBound(), band.from(),
                band.to());
    }

    /** A time of day [min] in hours and minutes. */
    public static String duration(double minutes) {
        long whole = Math.round(minutes);
        return whole < 60 ? whole + "\u00a0min"
                : whole % 60 == 0 ? whole / 60 + "\u00a0h" : whole / 60 + "\u00a0h\u00a0" + whole % 60 + "\u00a0min";
    }

    /** What was measured. */
    public SeatMeasurement measured() {
        return measured;
    }

    /** The recording as a task of the day. */
    public DailyTask task() {
        return task;
    }

    /** The axis along which A(8) is greatest. */
    public SeatAxis worst() {
        return worst;
    }

    /** Whether the hours a day are stated rather than assumed. */
    public boolean known() {
        return known;
    }

    /** What of the weighting's band the sampling rate shows, along the worst axis. */
    public CoveredBand band() {
        return band;
    }
}
