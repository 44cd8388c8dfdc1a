package wbv.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import wbv.exposure.CoveredBand;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;

/** The exposure of one recording in a tile and in half a sentence. */
final class ExposureTile {

    private static final double EIGHT_HOURS = 480;

    private final SeatMeasurement measured;
    private final DailyTask task;
    private final SeatAxis worst;
    private final boolean known;
    private final CoveredBand band;

    ExposureTile(SeatMeasurement measured) {
        this.measured = measured;
        OptionalDouble daily = measured.metadata().dailyMinutes();
        known = daily.isPresent();
        task = measured.task("recording", daily.orElse(EIGHT_HOURS));
        worst = task.worst();
        band = measured.band(worst);
    }

    /** A(8) on the worst axis [m/s²]. */
    double a8() {
        return task.a8(worst);
    }

    /** Dose of the day on the axis where it is greatest [m/s^1.75]. */
    private double dose() {
        return measured.axes().keySet().stream().mapToDouble(task::vdv).max().orElse(Double.NaN);
    }

    /** Whether the dose is graver than A(8). */
    private boolean doseDecides() {
        Directive.Verdict byDose = Directive.Verdict.ofVdv(dose());
        return byDose != Directive.Verdict.UNKNOWN && byDose.compareTo(Directive.Verdict.ofA8(a8())) > 0;
    }

    /** The graver verdict of A(8) and dose. */
    Directive.Verdict verdict() {
        return doseDecides() ? Directive.Verdict.ofVdv(dose()) : Directive.Verdict.ofA8(a8());
    }

    /** Minutes a day until the action value, by A(8) or by dose, whichever comes first. */
    private double minutes() {
        double byDose = task.minutesUntilVdv(Directive.ACTION);
        double byLevel = task.minutesUntilA8(Directive.ACTION);
        return byDose < byLevel ? byDose : byLevel;
    }

    /** Half a sentence, its unit after the number. */
    String words() {
        return (known ? duration(task.minutes()) : "eight hours") + " a day of it are " + verdict().words() + (doseDecides()
                ? " by their shocks (dose " + atLeast() + Digits.significant(dose(), 2) + "\u00a0" + ExposurePage.DOSE + ")"
                : " (A(8) " + atLeast() + Digits.significant(a8(), 2) + "\u00a0m/s²)");
    }

    private String atLeast() {
        return band.lowerBound() ? "at least " : "";
    }

    Tiles.Tile tile() {
        List<String> lines = new ArrayList<>();
        lines.add("A(8) of " + (known ? duration(task.minutes()) : "eight hours") + " a day, along " + worst.letter() + ": "
                + Directive.Verdict.ofA8(a8()).words() + ".");
        if (doseDecides()) {
            lines.add("By its shocks " + verdict().words() + ": dose " + Digits.significant(dose(), 2) + "\u00a0" + ExposurePage.DOSE + ".");
        }
        double minutes = minutes();
        lines.add(minutes > DailyTask.DAY ? "The action value is not reached in a day." : "Action value after "
                + (band.lowerBound() ? "at most " : "") + duration(minutes) + ".");
        lines.add("a_w " + measured.axes().entrySet().stream().map(entry -> entry.getKey().letter() + "\u00a0"
                + Digits.significant(entry.getValue().rms(), 2)).collect(Collectors.joining(", ")) + "\u00a0m/s² at " + measured.place()
                + "; VDV " + Digits.significant(measured.axes().get(worst).vdv(), 2) + "\u00a0" + ExposurePage.DOSE + " in "
                + Digits.significant(measured.axes().get(worst).seconds(), 3) + "\u00a0s.");
        if (band.lowerBound()) {
            lines.add("A lower bound: " + Digits.significant(band.to(), 3) + " of " + Digits.significant(band.nominal(), 3)
                    + "\u00a0Hz are seen.");
        }
        Tiles.Tone tone = switch (verdict()) {
            case BELOW_ACTION -> band.lowerBound() ? Tiles.Tone.PLAIN : Tiles.Tone.GOOD;
            case ABOVE_ACTION -> Tiles.Tone.WARNING;
            case ABOVE_LIMIT -> Tiles.Tone.FAULT;
            case UNKNOWN -> Tiles.Tone.PLAIN;
        };
        double end = Math.max(1.5, 1.1 * a8());
        double deviation = measured.axes().get(worst).deviation();
        double spread = Double.isNaN(deviation) ? 0 : 2 * deviation * a8();
        Gauge gauge = new Gauge(0, end, List.of(new Gauge.Range(0, Directive.ACTION.a8(), "good", ""),
                new Gauge.Range(Directive.ACTION.a8(), Directive.LIMIT.a8(), "warning", ""),
                new Gauge.Range(Directive.LIMIT.a8(), end, "fault", "")),
                List.of(new Gauge.Mark(Directive.ACTION.a8(), "action 0.5"), new Gauge.Mark(Directive.LIMIT.a8(), "limit 1.15")),
                List.of(new Gauge.Point(a8(), a8() - spread, a8() + spread)));
        return new Tiles.Tile("Exposure", (band.lowerBound() ? "≥ " : "") + Digits.significant(a8(), 2), "m/s²", gauge, lines, tone);
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
                String.valueOf(worst.letter()), task.minutes(), !known, a8(), verdict().words(), minutes(), band.lowerBound(), band.from(),
                band.to());
    }

    /** A time of day in hours and minutes. */
    static String duration(double minutes) {
        long whole = Math.round(minutes);
        return whole < 60 ? whole + "\u00a0min" : String.format(Locale.ROOT, whole % 60 == 0 ? "%d\u00a0h" : "%d\u00a0h\u00a0%d\u00a0min", whole / 60,
                whole % 60);
    }
}
