package wbv.report.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.SeatMeasurement;
import wbv.report.page.Gauge;
import wbv.report.page.Tiles;
import wbv.result.Digits;
import wbv.study.JudgedExposure;

/** The exposure of one recording in a tile. */
final class ExposureTile {

    private final JudgedExposure judged;

    ExposureTile(JudgedExposure judged) {
        this.judged = judged;
    }

    Tiles.Tile tile() {
        SeatMeasurement measured = judged.measured();
        List<String> lines = new ArrayList<>();
        lines.add("A(8) of " + (judged.known() ? JudgedExposure.duration(judged.task().minutes()) : "eight hours") + " a day, along "
                + judged.worst().letter() + ": "
                + Directive.Verdict.ofA8(judged.a8()).words() + ".");
        if (judged.doseDecides()) {
            lines.add("By its shocks " + judged.verdict().words() + ": dose " + Digits.significant(judged.dose(), 2) + "\u00a0"
                    + JudgedExposure.DOSE + ".");
        }
        double minutes = judged.task().minutesUntilA8(Directive.ACTION);
        double byDose = judged.task().minutesUntilVdv(Directive.ACTION);
        lines.add(minutes > DailyTask.DAY && !(byDose < DailyTask.DAY) ? "The action value is not reached in a day." : "Action value after "
                + (judged.band().lowerBound() ? "at most " : "") + (minutes > DailyTask.DAY ? "a day" : JudgedExposure.duration(minutes))
                + (byDose < minutes ? "; by dose " + JudgedExposure.duration(byDose) : "") + ".");
        lines.add("a_w " + measured.axes().entrySet().stream().map(entry -> entry.getKey().letter() + "\u00a0"
                + Digits.significant(entry.getValue().rms(), 2)).collect(Collectors.joining(", ")) + "\u00a0m/s² at " + measured.place()
                + "; VDV " + Digits.significant(measured.axes().get(judged.worst()).vdv(), 2) + "\u00a0" + JudgedExposure.DOSE + " in "
                + Digits.significant(measured.axes().get(judged.worst()).seconds(), 3) + "\u00a0s.");
        if (judged.band().lowerBound()) {
            lines.add(
                    "A lower bound: " + Digits.significant(judged.band().to(), 3) + " of " + Digits.significant(judged.band().nominal(), 3)
                            + "\u00a0Hz are seen.");
        }
        Tiles.Tone tone = switch (judged.verdict()) {
            case BELOW_ACTION -> judged.band().lowerBound() ? Tiles.Tone.PLAIN : Tiles.Tone.GOOD;
            case ABOVE_ACTION -> Tiles.Tone.WARNING;
            case ABOVE_LIMIT -> Tiles.Tone.FAULT;
            case UNKNOWN -> Tiles.Tone.PLAIN;
        };
        double end = Math.max(1.5, 1.1 * judged.a8());
        double deviation = measured.axes().get(judged.worst()).deviation();
        double spread = Double.isNaN(deviation) ? 0 : 2 * deviation * judged.a8();
        Gauge gauge = new Gauge(0, end, List.of(new Gauge.Range(0, Directive.ACTION.a8(), "good", ""),
                new Gauge.Range(Directive.ACTION.a8(), Directive.LIMIT.a8(), "warning", ""),
                new Gauge.Range(Directive.LIMIT.a8(), end, "fault", "")),
                List.of(new Gauge.Mark(Directive.ACTION.a8(), "action 0.5"), new Gauge.Mark(Directive.LIMIT.a8(), "limit 1.15")),
                List.of(new Gauge.Point(judged.a8(), judged.a8() - spread, judged.a8() + spread)));
        return new Tiles.Tile("Exposure", (judged.band().lowerBound() ? "≥ " : "") + Digits.significant(judged.a8(), 2), "m/s²", gauge,
                lines, tone);
    }
}
