package wbv.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import wbv.exposure.DailyExposure;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.SeatAxis;
import wbv.exposure.Vibration;

/**
 * The exposure of a day of which magnitudes and hours are typed in and nothing is recorded, as in the calculator of the HSE.
 *
 * @param day its tasks, of whose levels only the r.m.s. is known
 */
public record TypedExposure(DailyExposure day) {

    /**
     * A spell of vibration.
     *
     * @param levels weighted r.m.s. acceleration a_w [m/s²] by axis, without the factors k
     * @param hours a day
     */
    public record Spell(Map<SeatAxis, Double> levels, double hours) {}

    /**
     * The same for machines.
     *
     * @param a8 [m/s²]
     * @param points by the HSE's count [1]
     * @param minutesToAction a day of this mix of spells; NaN if never
     * @param estimatedDose [m/s^1.75]
     */
    public record Results(List<SpellResults> spells, Map<String, Double> a8ByAxis, String worstAxis, double a8, double points,
            String verdict, double minutesToAction, double minutesToLimit, double estimatedDose) {}

    /**
     * One spell for machines.
     *
     * @param levels a_w [m/s²] by axis
     * @param points by axis, which add up over the spells
     */
    public record SpellResults(double minutes, Map<String, Double> levels, Map<String, Double> a8, Map<String, Double> points,
            double minutesToActionAlone, double minutesToLimitAlone) {}

    /**
     * A day of such spells.
     *
     * @throws wbv.recording.DataFault if the spells last longer than a day
     */
    public static TypedExposure of(List<Spell> spells) {
        List<DailyTask> tasks = new ArrayList<>();
        for (int i = 0; i < spells.size(); i++) {
            Map<SeatAxis, Vibration.Level> levels = new LinkedHashMap<>();
            spells.get(i).levels().forEach((axis, rms) -> levels.put(axis, new Vibration.Level(rms)));
            tasks.add(new DailyTask("spell " + (i + 1), 60 * spells.get(i).hours(), levels));
        }
        return new TypedExposure(new DailyExposure(tasks));
    }

    /** What is written for machines. */
    public Results results() {
        List<SpellResults> spells = new ArrayList<>();
        for (DailyTask task : day.tasks()) {
            Map<String, Double> levels = new LinkedHashMap<>();
            Map<String, Double> a8 = new LinkedHashMap<>();
            Map<String, Double> points = new LinkedHashMap<>();
            task.levels().forEach((axis, level) -> {
                String letter = String.valueOf(axis.letter());
                levels.put(letter, level.rms());
                a8.put(letter, task.a8(axis));
                points.put(letter, Directive.points(task.a8(axis)));
            });
            spells.add(new SpellResults(task.minutes(), levels, a8, points, task.minutesUntilA8(Directive.ACTION),
                    task.minutesUntilA8(Directive.LIMIT)));
        }
        Map<String, Double> all = new LinkedHashMap<>();
        Arrays.stream(SeatAxis.values()).filter(this::given).forEach(axis -> all.put(String.valueOf(axis.letter()), day.a8(axis)));
        return new Results(spells, all, String.valueOf(day.worstA8().letter()), day.a8(), day.points(), day.verdict().words(),
                day.minutesUntilA8(Directive.ACTION), day.minutesUntilA8(Directive.LIMIT), estimatedDose());
    }

    private boolean given(SeatAxis axis) {
        return day.tasks().stream().anyMatch(task -> task.levels().containsKey(axis));
    }

    private double estimatedDose() {
        return Arrays.stream(SeatAxis.values()).mapToDouble(day::estimatedVdv).max().orElseThrow();
    }

    /** What matters, in a few lines of text. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        for (DailyTask task : day.tasks()) {
            text.append(String.format(Locale.ROOT, "%s: %s a day; alone it reaches the action value after %s, the limit value after %s%n",
                    task.name(), duration(task.minutes()), duration(task.minutesUntilA8(Directive.ACTION)),
                    duration(task.minutesUntilA8(Directive.LIMIT))));
            task.levels().forEach((axis, level) -> text.append(
                    String.format(Locale.ROOT, "  %s %s  a_w %.3f m/s², k a_w %.3f, A(8) %.3f, %.0f points%n", axis.letter(),
                            axis.weighting().symbol(), level.rms(), task.factored(axis), task.a8(axis), Directive.points(task.a8(axis)))));
        }
        String absent = Arrays.stream(SeatAxis.values())
                .filter(axis -> day.tasks().stream().anyMatch(task -> !task.levels().containsKey(axis)))
                .map(axis -> String.valueOf(axis.letter())).collect(Collectors.joining(" and "));
        text.append(String.format(Locale.ROOT,
                "A(8) is %.2f m/s² along %s: %s (%.0f points). %s value after %s a day, limit value after %s.%s%n", day.a8(),
                day.worstA8().letter(), day.verdict().words(), day.points(), day.tasks().size() > 1 ? "In this mix: action" : "Action",
                duration(day.minutesUntilA8(Directive.ACTION)), duration(day.minutesUntilA8(Directive.LIMIT)),
                absent.isEmpty() || day.verdict() == Directive.Verdict.ABOVE_LIMIT ? ""
                        : " Not given along " + absent + ": the whole may be higher."));
        double dose = estimatedDose();
        return text.append(
                String.format(Locale.ROOT, "The daily dose was not measured; without shocks it would be about %.1f m/s^1.75: %s.%n", dose,
                        Directive.Verdict.ofVdv(dose).words()))
                .toString();
    }

    private static String duration(double minutes) {
        long whole = Math.round(minutes);
        String hours = whole < 60 ? "" : whole / 60 + " h";
        String rest = whole >= 60 && whole % 60 == 0 ? "" : whole % 60 + " min";
        return minutes > DailyTask.DAY ? "more than a day" : (hours + " " + rest).strip();
    }
}
