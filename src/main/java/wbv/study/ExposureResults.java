package wbv.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.exposure.Comfort;
import wbv.exposure.ComfortAxis;
import wbv.exposure.CoveredBand;
import wbv.exposure.DailyExposure;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.Remark;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.Vibration;

/**
 * An exposure as {@code exposure.json} holds it: names carry their units, durations of a day are in minutes.
 *
 * @param provenance by name: command, version, SHA-256 of the inputs
 */
public record ExposureResults(Day day, List<Task> tasks, Optional<Spine> spine, List<Note> remarks,
        Map<String, String> provenance) {

    /**
     * The day and its verdicts.
     *
     * @param lower_bound true if a sampling rate was too low for the whole band
     * @param points the HSE's count [1]
     */
    public record Day(double minutes, boolean lower_bound, double a8_m_s2, double a8_standard_deviation_m_s2, String a8_axis,
            double points, String verdict, double vdv_m_s1_75, String vdv_axis, String verdict_by_dose, String caution_zone,
            String caution_zone_by_dose, double minutes_until_action_a8, double minutes_until_limit_a8,
            double minutes_until_action_vdv, double minutes_until_limit_vdv, Map<String, DayAxis> axes) {}

    /** Factors k are in these. */
    public record DayAxis(double a8_m_s2, double points, double vdv_m_s1_75, double estimated_vdv_m_s1_75) {}

    /** A task and the recording that it was measured by. */
    public record Task(String name, String recording, double minutes, String place, double rate_hz, double duration_s,
            boolean boxcar_undone, Map<String, TaskAxis> axes, Comforts comfort, OptionalDouble msdv_m_s1_5,
            double minutes_until_action_a8, double minutes_until_limit_a8, double minutes_until_action_vdv,
            double minutes_until_limit_vdv, OptionalDouble spinal_dose_m_s2) {}

    /**
     * An axis of a task. Only names that begin with k have the factor k in them, and daily and partial values.
     *
     * @param k the factor
     * @param partial_points number of points
     */
    public record TaskAxis(String weighting, double k, double band_from_hz, double band_to_hz, boolean lower_bound,
            double measured_s, double missing_s, double a_w_m_s2, double a_w_standard_deviation_m_s2, double k_a_w_m_s2,
            double peak_m_s2, double crest_factor, double mtvv_m_s2, double mtvv_at_s, double mtvv_exponential_m_s2,
            double mtvv_ratio, double vdv_measured_m_s1_75, double vdv_ratio, boolean shocks, double partial_a8_m_s2,
            double partial_points, double daily_vdv_m_s1_75, double estimated_daily_vdv_m_s1_75, OptionalDouble seat_rms,
            OptionalDouble seat_vdv, Optional<Bands> third_octaves) {}

    /** One-third-octave bands; arrays are as long as there are bands. */
    public record Bands(double[] nominal_hz, double[] measured_m_s2, double[] weighted_m_s2) {}

    /** Comfort: factors k are in the totals, not in the levels. */
    public record Comforts(double total_m_s2, String reaction, Map<String, Double> points_m_s2, Map<String, Double> levels) {}

    /**
     * ISO 2631-5.
     *
     * @param days_a_year number of days with this dose
     * @param risks by sex
     */
    public record Spine(double daily_dose_m_s2, int from_age, int years, double days_a_year, boolean indicative,
            Map<String, Risk> risks) {}

    /**
     * Daily stress Sd, stress variable R and probability of injury.
     *
     * @param stress_mpa Sd [MPa]
     * @param r R [1]
     */
    public record Risk(double stress_mpa, double r, double probability) {}

    /** Something to know. */
    public record Note(String severity, String message, String advice) {}

    static ExposureResults of(ExposureStudy exposure) {
        List<Task> tasks = new ArrayList<>();
        for (int i = 0; i < exposure.measured().size(); i++) {
            tasks.add(task(exposure.request().recordings().get(i).title(), exposure.day().tasks().get(i),
                    exposure.measured().get(i)));
        }
        return new ExposureResults(day(exposure), tasks, spine(exposure), exposure.remarks().stream().map(ExposureResults::note)
                .toList(),
                exposure.request().provenance());
    }

    private static Note note(Remark remark) {
        return new Note(remark.severity().name(), remark.message(), remark.advice());
    }

    private static Day day(ExposureStudy exposure) {
        DailyExposure day = exposure.day();
        Map<String, DayAxis> axes = new LinkedHashMap<>();
        for (SeatAxis axis : SeatAxis.values()) {
            if (exposure.measured().stream().anyMatch(one -> one.axes().containsKey(axis))) {
                axes.put(letter(axis), new DayAxis(day.a8(axis), Directive.points(day.a8(axis)), day.vdv(axis),
                        day.estimatedVdv(axis)));
            }
        }
        boolean bound = exposure.measured().stream().anyMatch(one -> one.band(SeatAxis.Z).lowerBound());
        return new Day(day.minutes(), bound, day.a8(), day.a8() * day.deviation(day.worstA8()), letter(day.worstA8()), day.points(),
                day.verdict().words(), day.vdv(), letter(day.worstVdv()), day.verdictByDose().words(), exposure.zone().words(),
                exposure.zoneByDose().words(), day.minutesUntilA8(Directive.ACTION), day.minutesUntilA8(Directive.LIMIT),
                day.minutesUntilVdv(Directive.ACTION), day.minutesUntilVdv(Directive.LIMIT), axes);
    }

    private static String letter(SeatAxis axis) {
        return String.valueOf(axis.letter());
    }

    private static Task task(String recording, DailyTask task, SeatMeasurement measured) {
        Map<String, TaskAxis> axes = new LinkedHashMap<>();
        measured.axes().forEach((axis, vibration) -> axes.put(letter(axis), axis(task, measured, axis, vibration)));
        Map<String, Double> points = new LinkedHashMap<>();
        Map<String, Double> levels = new LinkedHashMap<>();
        measured.comfort().forEach((axis, level) -> {
            levels.put(axis.name().toLowerCase(Locale.ROOT), level);
            points.put(axis.point(), ComfortAxis.total(axis.point(), measured.comfort()));
        });
        double total = ComfortAxis.total(measured.comfort());
        return new Task(task.name(), recording, task.minutes(), measured.place(), measured.inspection().clock().rate(),
                measured.inspection().duration(), measured.boxcar(), axes, new Comforts(total, Comfort.words(total), points,
                        levels),
                measured.sickness().map(z -> OptionalDouble.of(z.motionSicknessDose())).orElse(OptionalDouble.empty()),
                task.minutesUntilA8(Directive.ACTION), task.minutesUntilA8(Directive.LIMIT),
                task.minutesUntilVdv(Directive.ACTION),
                task.minutesUntilVdv(Directive.LIMIT),
                measured.spine().map(spine -> OptionalDouble.of(spine.dose())).orElse(OptionalDouble.empty()));
    }

    private static TaskAxis axis(DailyTask task, SeatMeasurement measured, SeatAxis axis, Vibration v) {
        CoveredBand band = measured.band(axis);
        Optional<Bands> bands = Optional.ofNullable(measured.spectra().get(axis)).map(spectrum -> {
            double[] nominal = new double[spectrum.measured().rms().length];
            Arrays.setAll(nominal, spectrum.measured()::nominal);
            return new Bands(nominal, spectrum.measured().rms(), spectrum.weighted().rms());
        });
        return new TaskAxis(axis.weighting().symbol(), axis.factor(), band.from(), band.to(), band.lowerBound(), v.seconds(),
                v.missing(),
                v.rms(), v.rms() * v.deviation(), axis.factor() * v.rms(), v.peak(), v.crestFactor(), v.mtvv(), v.mtvvTime(),
                v.mtvvExponential(), v.mtvvRatio(), v.vdv(), v.vdvRatio(), v.shocks(), task.a8(axis),
                Directive.points(task.a8(axis)),
                task.vdv(axis), axis.factor() * v.estimatedDose(60 * task.minutes()), measured.seatFactor(axis),
                measured.seatFactorByDose(axis), bands);
    }

    private static Optional<Spine> spine(ExposureStudy exposure) {
        return exposure.spinalDose().map(dose -> {
            Map<String, Risk> risks = new LinkedHashMap<>();
            exposure.risks().forEach((sex, risk) -> risks.put(sex.name().toLowerCase(Locale.ROOT),
                    new Risk(risk.stress(dose), risk.variable(dose), risk.probability(dose))));
            ExposureRequest.Career career = exposure.request().career();
            boolean indicative = exposure.measured().stream().anyMatch(one -> one.band(SeatAxis.Z).lowerBound());
            return new Spine(dose, career.from(), career.years(), career.days(), indicative, risks);
        });
    }
}
