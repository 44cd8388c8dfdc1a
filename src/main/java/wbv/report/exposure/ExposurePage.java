package wbv.report.exposure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import wbv.exposure.Comfort;
import wbv.exposure.ComfortAxis;
import wbv.exposure.DailyExposure;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.Vibration;
import wbv.recording.Metadata;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.Figures;
import wbv.report.page.Findings;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.study.ExposureRequest;
import wbv.study.ExposureStudy;
import wbv.study.JudgedExposure;

/** The report of a day's exposure: one sheet to be printed and filed, and behind it what it rests on. */
public final class ExposurePage {

    static final String DOSE = JudgedExposure.DOSE;
    private static final String SICKNESS_DOSE = "m/s¹·⁵";
    /** Tasks of which every axis has room on the sheet. */
    private static final int ROOM = 5;
    private static final List<String> ASKED = List.of("operator", "machine", "workplace", "instrument");

    private final ExposureStudy exposure;
    private final DailyExposure day;

    ExposurePage(ExposureStudy exposure) {
        this.exposure = exposure;
        this.day = exposure.day();
    }

    /** Writes {@code report.html}. */
    public static void write(ExposureStudy exposure, OutputFolder out) throws IOException {
        HtmlWriter.write(new ExposurePage(exposure).page(), out.file("report.html"));
    }

    private Page page() {
        String title = exposure.request().recordings().stream().map(ExposureRequest.Recorded::title)
                .collect(Collectors.joining(", "));
        ExposureCharts charts = new ExposureCharts(exposure);
        List<Section> sections = new ArrayList<>(List.of(sheet(charts)));
        if (crowded()) {
            sections.add(new Section("Every axis", "", axes(true)));
        }
        int printed = sections.size();
        sections.add(charts.histories());
        sections.add(charts.spectra());
        sections.add(charts.weightings());
        sections.add(new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                        exposure.request().provenance().entrySet()
                                .stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList())));
        return new Page("Whole-body vibration exposure", title, sections, printed);
    }

    /** Whether the tasks are too many for a sheet with all their axes. */
    private boolean crowded() {
        return day.tasks().size() > ROOM;
    }

    private Section sheet(ExposureCharts charts) {
        List<Block> blocks = new ArrayList<>(List.of(new Lead(exposure.sentence("\u00a0" + DOSE)), figures(), who(),
                axes(!crowded()), tasks()));
        blocks.add(new Beside(charts.a8(), charts.dose()));
        blocks.add(new Beside(charts.caution(), charts.thirdOctaves()));
        blocks.add(further());
        blocks.add(new Findings(exposure.remarks().stream().map(remark -> new Findings.Finding(
                Findings.Severity.valueOf(remark.severity().name()), remark.message(), remark.advice())).toList(),
                "Nothing was found that makes these values less than they look."));
        blocks.add(new Text(basis()));
        return new Section("Daily exposure", "", blocks);
    }

    private Figures figures() {
        double twice = 2 * day.a8() * day.deviation(day.worstA8());
        return new Figures(new Figures.Figure("A(8), axis " + day.worstA8().letter(), Digits.rounded(day.a8(), 3), "m/s²",
                Double.isNaN(twice) ? "" : "± " + Digits.roundedUp(twice, 3)),
                new Figures.Figure("daily dose VDV, axis " + day.worstVdv().letter(), Digits.significant(day.vdv(), 3),
                        DOSE, ""),
                new Figures.Figure("points, of 100 and 529", Digits.rounded(day.points(), 0), "", ""),
                new Figures.Figure("a day like this until action", ExposureStudy.minutes(day.minutesUntil(Directive.ACTION)),
                        "h:min", ""),
                new Figures.Figure("until limit", ExposureStudy.minutes(day.minutesUntil(Directive.LIMIT)), "h:min", ""));
    }

    /** Who, what and where, as far as the sidecars say. */
    private Table who() {
        Map<String, String> known = new LinkedHashMap<>();
        ASKED.forEach(name -> known.put(name, noted(name)));
        known.put("sensor", exposure.measured().stream().map(one -> one.place()
                + Optional.ofNullable(one.metadata().serials().get(one.place())).map(serial -> " " + serial).orElse(""))
                .distinct().collect(Collectors.joining(", ")));
        known.put("sampling rate", exposure.measured().stream().map(one -> Digits.significant(one.inspection().clock().rate(), 5)
                + " Hz")
                .distinct().collect(Collectors.joining(", ")));
        known.put("band", exposure.measured().stream().map(one -> Digits.significant(one.band(SeatAxis.Z).from(), 2) + "–"
                + Digits.significant(one.band(SeatAxis.Z).to(), 3) + " Hz").distinct().collect(Collectors.joining(", ")));
        known.put("sitter", exposure.measured().get(0).metadata().subject().map(ExposurePage::sitter)
                .filter(text -> !text.isEmpty()).orElse("–"));
        return new Table("", known.keySet().stream().map(Table.Column::words).toList(), List.of(List.copyOf(known.values())));
    }

    private String noted(String name) {
        String all = exposure.measured().stream().flatMap(one -> Optional.ofNullable(one.metadata().notes().get(name)).stream())
                .distinct()
                .collect(Collectors.joining(", "));
        return all.isEmpty() ? "–" : all;
    }

    private static String sitter(Metadata.Subject subject) {
        List<String> words = new ArrayList<>();
        subject.mass().ifPresent(mass -> words.add(Digits.significant(mass, 3) + " kg"));
        subject.age().ifPresent(age -> words.add(Digits.significant(age, 3) + " years"));
        subject.sex().ifPresent(words::add);
        return String.join(", ", words);
    }

    /** @param every false for the worst axis of each task alone */
    private Table axes(boolean every) {
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < exposure.measured().size(); i++) {
            SeatMeasurement one = exposure.measured().get(i);
            DailyTask task = day.tasks().get(i);
            SeatAxis worst = task.worst();
            one.axes().forEach((axis, v) -> {
                if (every || axis == worst) {
                    rows.add(row(one, task, axis, v));
                }
            });
        }
        return new Table((every ? "Measured, by axis" : "Measured, the axis of each task with the highest A(8); every axis"
                + " follows behind the sheet") + ": a_w ± 2σ, with k (1.4, 1.4, 1), crest factor (9), greatest running r.m.s. over"
                + " 1 s and its ratio (1.5), dose of the time measured and its ratio (1.75), dose of the day with k, SEAT by"
                + " r.m.s. / dose",
                List.of(Table.Column.words("Task"), Table.Column.words("Axis"), Table.Column.numbers("a_w [m/s²]"),
                        Table.Column.numbers("k·a_w"), Table.Column.numbers("Crest"), Table.Column.numbers("MTVV"),
                        Table.Column.numbers("/a_w"), Table.Column.numbers("VDV"), Table.Column.numbers("/(a_w T^¼)"),
                        Table.Column.numbers("Daily VDV"), Table.Column.numbers("SEAT")),
                rows);
    }

    private static List<String> row(SeatMeasurement one, DailyTask task, SeatAxis axis, Vibration v) {
        return List.of(task.name(), axis.letter() + ", " + axis.weighting().symbol(), uncertain(v),
                Digits.significant(axis.factor() * v.rms(), 3), Digits.significant(v.crestFactor(), 3),
                Digits.significant(v.mtvv(), 3), Digits.significant(v.mtvvRatio(), 3), Digits.significant(v.vdv(), 3),
                Digits.significant(v.vdvRatio(), 3), Digits.significant(task.vdv(axis), 3),
                one.seatFactor(axis).isEmpty() ? "–" : Digits.significant(one.seatFactor(axis).getAsDouble(), 3) + " / "
                        + Digits.significant(one.seatFactorByDose(axis).getAsDouble(), 3));
    }

    private static String uncertain(Vibration v) {
        return Double.isNaN(v.deviation()) ? Digits.significant(v.rms(), 3)
                : Digits.rounded(v.rms(), 3) + " ± " + Digits.roundedUp(2 * v.rms() * v.deviation(), 3);
    }

    private Table tasks() {
        List<List<String>> rows = new ArrayList<>();
        for (DailyTask task : day.tasks()) {
            SeatAxis worst = task.worst();
            rows.add(List.of(task.name(), ExposureStudy.minutes(task.minutes()), String.valueOf(worst.letter()),
                    Digits.significant(task.a8(worst), 3), Digits.rounded(Directive.points(task.a8(worst)), 0),
                    Digits.rounded(task.pointsAnHour(), 1), ExposureStudy.minutes(task.minutesUntilA8(Directive.ACTION)),
                    ExposureStudy.minutes(task.minutesUntilA8(Directive.LIMIT)),
                    ExposureStudy.minutes(task.minutesUntilVdv(Directive.ACTION)),
                    ExposureStudy.minutes(task.minutesUntilVdv(Directive.LIMIT))));
        }
        rows.add(List.of("all", ExposureStudy.minutes(day.minutes()), String.valueOf(day.worstA8().letter()),
                Digits.significant(day.a8(), 3),
                Digits.rounded(day.points(), 0), "", ExposureStudy.minutes(day.minutesUntilA8(Directive.ACTION)),
                ExposureStudy.minutes(day.minutesUntilA8(Directive.LIMIT)), ExposureStudy.minutes(day.minutesUntilVdv(Directive.ACTION)),
                ExposureStudy.minutes(day.minutesUntilVdv(Directive.LIMIT))));
        return new Table("Tasks, on their worst axis, and how long each alone may last [h:min] until A(8) and the"
                + " dose reach action value and limit value",
                List.of(Table.Column.words("Task"), Table.Column.numbers("Daily"), Table.Column.words("Axis"),
                        Table.Column.numbers("A(8) [m/s²]"), Table.Column.numbers("Points"), Table.Column.numbers("Points/h"),
                        Table.Column.numbers("Action, A(8)"), Table.Column.numbers("Limit, A(8)"),
                        Table.Column.numbers("Action, VDV"),
                        Table.Column.numbers("Limit, VDV")),
                rows);
    }

    private Table further() {
        List<List<String>> rows = new ArrayList<>();
        rows.add(List.of("Caution zone, ISO 2631-1 Annex B", "by A(8) (0.45 to 0.90 m/s²) " + exposure.zone().words()
                + "; by dose (8.5 to 17 " + DOSE + ") " + exposure.zoneByDose().words()));
        rows.add(List.of("Estimated dose, 1.4 a_w T^¼", Arrays.stream(SeatAxis.values())
                .filter(axis -> day.tasks().stream().anyMatch(task -> task.levels().containsKey(axis)))
                .map(axis -> axis.letter() + " " + Digits.significant(day.estimatedVdv(axis), 3))
                .collect(Collectors.joining(", ")) + " " + DOSE + ", with k: what the r.m.s. alone would give"));
        SeatMeasurement heaviest = exposure.measured().get(exposure.heaviest());
        double total = ComfortAxis.total(heaviest.comfort());
        String points = heaviest.comfort().keySet().stream().map(ComfortAxis::point).distinct().map(point -> point + " "
                + Digits.significant(ComfortAxis.total(point, heaviest.comfort()), 2)).collect(Collectors.joining(", "));
        rows.add(List.of("Comfort, ISO 2631-1 Annex C", "total value " + Digits.significant(total, 3) + " m/s² (" + points + "): "
                + Comfort.words(total)));
        heaviest.sickness().ifPresent(z -> rows.add(List.of("Motion sickness dose, Wf",
                Digits.significant(z.motionSicknessDose(), 3)
                        + " " + SICKNESS_DOSE + " in the " + Digits.significant(z.seconds(), 3) + " s measured"
                        + (z.missing() == 0 ? ""
                                : "; the " + Digits.significant(z.missing(), 2) + " s that are missing may have raised it"))));
        exposure.spinalDose().ifPresent(dose -> {
            ExposureRequest.Career career = exposure.request().career();
            boolean indicative = exposure.measured().stream().anyMatch(one -> one.band(SeatAxis.Z).lowerBound());
            rows.add(List.of("Lumbar spine, ISO 2631-5:2018" + (indicative ? ", indicative" : ""), String.format(Locale.ROOT,
                    "daily dose %s m/s²; from age %d for %d years of %.0f days: ", Digits.significant(dose, 3), career.from(),
                    career.years(),
                    career.days())
                    + exposure.risks().entrySet().stream().map(entry -> String.format(Locale.ROOT,
                            "%s R %.2f, probability of injury %s %%", entry.getKey().name().toLowerCase(Locale.ROOT),
                            entry.getValue().variable(dose), Digits.significant(100 * entry.getValue().probability(dose), 2)))
                            .collect(Collectors.joining("; "))));
        });
        return new Table("", List.of(Table.Column.words("Also"), Table.Column.words("What it is")), rows);
    }

    private String basis() {
        boolean bound = exposure.measured().stream().anyMatch(one -> one.band(SeatAxis.Z).lowerBound());
        return "Basis: r.m.s. and dose by ISO 2631-1:1997 with the weightings of ISO 8041-1:2017 (x, y Wd with k = 1.4; z Wk),"
                + " all frequencies up to half the sampling rate; A(8), action and limit values by Directive 2002/44/EC (0.5 and"
                + " 1.15 m/s², 9.1 and 21 " + DOSE + "), the highest axis decides; points as the HSE counts them. ± is twice the"
                + " standard"
                + " deviation by the scatter between blocks of 10 s of the recordings; sensors' calibration, mounting and what"
                + " differs from day to day are not in it."
                + (bound ? " Sampled too slowly for ISO 8041-1: lower bounds." : "") + " "
                + exposure.request().provenance().entrySet().stream().filter(entry -> entry.getKey().equals("wbv")
                        || entry.getKey().startsWith("SHA-256")).map(entry -> entry.getKey() + " " + shortened(entry.getValue()))
                        .collect(Collectors.joining("; "))
                + ".";
    }

    private static String shortened(String value) {
        return value.length() > 24 ? value.substring(0, 16) + "…" : value;
    }
}
