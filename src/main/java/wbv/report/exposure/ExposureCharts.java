package wbv.report.exposure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import wbv.exposure.CautionZone;
import wbv.exposure.CoveredBand;
import wbv.exposure.DailyExposure;
import wbv.exposure.DailyTask;
import wbv.exposure.Directive;
import wbv.exposure.SeatAxis;
import wbv.exposure.SeatMeasurement;
import wbv.exposure.Vibration;
import wbv.exposure.Weighting;
import wbv.report.page.Band;
import wbv.report.page.BarChart;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.Chart;
import wbv.report.page.ChartAxis;
import wbv.report.page.LineChart;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;
import wbv.result.Digits;
import wbv.study.ExposureStudy;

/** The charts of an exposure. */
final class ExposureCharts {

    private static final List<SeatAxis> AXES = List.of(SeatAxis.values());
    private static final int POINTS = 200;
    private static final int NAMED = 5;

    private final ExposureStudy exposure;
    private final DailyExposure day;

    ExposureCharts(ExposureStudy exposure) {
        this.exposure = exposure;
        this.day = exposure.day();
    }

    /** A(8) by axis, the parts of the tasks beside it, against the Directive's values. */
    BarChart a8() {
        return bars("Daily exposure A(8)", ChartAxis.linear("", "m/s²").within(0, Double.NaN), DailyTask::a8, day::a8,
                Directive.ACTION.a8(), Directive.LIMIT.a8(), true);
    }

    /** Daily dose by axis. */
    BarChart dose() {
        return bars("Daily vibration dose value", ChartAxis.linear("", ExposurePage.DOSE).within(0, Double.NaN), DailyTask::vdv,
                day::vdv, Directive.ACTION.vdv(), Directive.LIMIT.vdv(), false);
    }

    private interface Part {
        double of(DailyTask task, SeatAxis axis);
    }

    private BarChart bars(String title, ChartAxis axis, Part part, ToDoubleFunction<SeatAxis> whole, double action,
            double limit, boolean whiskers) {
        List<BarChart.Bars> bars = new ArrayList<>();
        double[] all = AXES.stream().mapToDouble(whole).toArray();
        double[] spread = AXES.stream().mapToDouble(each -> 2 * day.deviation(each) * day.a8(each)).toArray();
        double[] low = new double[all.length];
        double[] high = new double[all.length];
        Arrays.setAll(low, i -> all[i] - spread[i]);
        Arrays.setAll(high, i -> all[i] + spread[i]);
        bars.add(whiskers ? new BarChart.Bars("day", all, low, high, 0) : new BarChart.Bars("day", all, 0));
        List<DailyTask> drawn = day.tasks().size() > 1 ? heaviest() : List.of();
        for (int i = 0; i < drawn.size(); i++) {
            DailyTask task = drawn.get(i);
            bars.add(new BarChart.Bars(task.name(), AXES.stream()
                    .mapToDouble(each -> task.levels().containsKey(each) ? part.of(task, each) : Double.NaN).toArray(), 1 + i));
        }
        return new BarChart(title, axis, AXES.stream().map(each -> each.letter() + (each.factor() == 1 ? "" : ", with k = "
                + each.factor()))
                .toList(), bars, List.of(new LineChart.Marker(action, "action"), new LineChart.Marker(limit, "limit")),
                rest().isEmpty() ? "" : "Beside the day: the " + drawn.size() + " tasks with the highest A(8).");
    }

    /** Levels against durations, with the bounds of the caution zone. */
    XyChart caution() {
        double[] hours = DoubleStream.iterate(0, i -> i + 1).limit(60).map(i -> 0.25 * Math.pow(96, i / 59)).toArray();
        List<XySeries> series = new ArrayList<>(List.of(
                new XySeries("bounds by Eq. B.1", twice(hours), bounds(hours, true), XySeries.Style.LINE).coloured(7),
                new XySeries("bounds by Eq. B.2", twice(hours), bounds(hours, false), XySeries.Style.DASHED).coloured(7)));
        List<DailyTask> drawn = heaviest();
        for (int i = 0; i < drawn.size(); i++) {
            series.add(points(drawn.get(i).name(), drawn.subList(i, i + 1)).coloured(1 + i));
        }
        if (!rest().isEmpty()) {
            series.add(points(rest().size() + " more", rest()).coloured(7));
        }
        if (day.tasks().size() > 1) {
            series.add(new XySeries("day", new double[] {day.minutes() / 60}, new double[] {day.equivalent()},
                    XySeries.Style.POINTS)
                    .coloured(0));
        }
        return new XyChart("Caution zone", ChartAxis.log("Daily duration", "h").within(0.25, 24),
                ChartAxis.log("k·a_w on the worst axis", "m/s²"), series);
    }

    private static XySeries points(String name, List<DailyTask> tasks) {
        return new XySeries(name, tasks.stream().mapToDouble(task -> task.minutes() / 60).toArray(),
                tasks.stream().mapToDouble(task -> task.factored(task.worst())).toArray(), XySeries.Style.POINTS);
    }

    /** The tasks that charts name: all if they are few, else those with the highest A(8). */
    private List<DailyTask> heaviest() {
        return ranked().subList(0, Math.min(NAMED, day.tasks().size()));
    }

    private List<DailyTask> rest() {
        return ranked().subList(heaviest().size(), day.tasks().size());
    }

    private List<DailyTask> ranked() {
        return day.tasks().size() <= NAMED ? day.tasks() : day.tasks().stream()
                .sorted(Comparator.comparingDouble((DailyTask task) -> task.a8(task.worst())).reversed()).toList();
    }

    /** The lower and the upper bound one after the other, parted by a gap. */
    private static double[] bounds(double[] hours, boolean byRms) {
        double[] both = new double[2 * hours.length + 1];
        Arrays.fill(both, Double.NaN);
        for (int i = 0; i < hours.length; i++) {
            both[i] = byRms ? CautionZone.lower(hours[i]) : CautionZone.lowerByDose(hours[i]);
            both[hours.length + 1 + i] = byRms ? CautionZone.upper(hours[i]) : CautionZone.upperByDose(hours[i]);
        }
        return both;
    }

    private static double[] twice(double[] x) {
        double[] both = Arrays.copyOf(x, 2 * x.length + 1);
        both[x.length] = Double.NaN;
        System.arraycopy(x, 0, both, x.length + 1, x.length);
        return both;
    }

    /** Third octaves of the axis that decides, in the task that adds most. */
    Chart thirdOctaves() {
        SeatMeasurement heaviest = exposure.measured().get(exposure.heaviest());
        SeatAxis axis = heaviest.axes().containsKey(day.worstA8()) ? day.worstA8() : heaviest.axes().keySet().iterator().next();
        return thirdOctaves(heaviest, axis, "Third octaves, " + axis.letter()
                + (day.tasks().size() > 1 ? ", " + day.tasks().get(exposure.heaviest()).name() : ""));
    }

    private static Chart thirdOctaves(SeatMeasurement measured, SeatAxis axis, String title) {
        List<Series> series = new ArrayList<>();
        SeatMeasurement.Spectrum spectrum = measured.spectra().get(axis);
        if (spectrum != null) {
            series.add(Series.dashed("as measured", spectrum.measured().centres(), spectrum.measured().rms()));
            series.add(Series.line("weighted, " + axis.weighting().symbol(), spectrum.weighted().centres(),
                    spectrum.weighted().rms()));
        }
        CoveredBand band = measured.band(axis);
        LineChart chart = new LineChart(title, ChartAxis.log("Frequency", "Hz").within(0.4, 90),
                ChartAxis.log("R.m.s. of the band", "m/s²"), series);
        return band.lowerBound() ? chart.shaded(List.of(new LineChart.Shade(band.to(), 90, "not measured"))) : chart;
    }

    /** Running r.m.s. of every axis, with the moment of its greatest. */
    Section histories() {
        List<Block> blocks = new ArrayList<>();
        for (int i = 0; i < exposure.measured().size(); i++) {
            SeatMeasurement one = exposure.measured().get(i);
            String group = "history " + i;
            String task = day.tasks().get(i).name();
            one.histories().forEach((axis, history) -> {
                Vibration v = one.axes().get(axis);
                blocks.add(new LineChart(task + ", " + axis.letter() + ", weighted " + axis.weighting().symbol(),
                        ChartAxis.linear("Time", "s"),
                        ChartAxis.linear("Weighted acceleration", "m/s²"),
                        List.of(Series.envelope("weighted acceleration", history.weighted(), 0, history.step()),
                                Series.envelope("running r.m.s., 1 s", history.running(), 0, history.step())))
                        .marked(List.of(new LineChart.Marker(v.mtvvTime(), "MTVV " + Digits.significant(v.mtvv(), 3) + " m/s²")))
                        .grouped(group));
            });
        }
        return new Section("Time histories", "Weighted acceleration and its running r.m.s.; the mark is its greatest, MTVV.",
                blocks);
    }

    /** Third octaves of every axis. */
    Section spectra() {
        List<Block> blocks = new ArrayList<>();
        for (int i = 0; i < exposure.measured().size(); i++) {
            SeatMeasurement one = exposure.measured().get(i);
            String task = day.tasks().get(i).name();
            blocks.add(new Beside(one.axes().keySet().stream()
                    .<Block>map(axis -> thirdOctaves(one, axis, task + ", " + axis.letter())).toList()));
        }
        return new Section("One-third-octave spectra", "R.m.s. of the bands, as measured and weighted.", blocks);
    }

    /** The weightings with what an instrument may deviate. */
    Section weightings() {
        double[] frequency = DoubleStream.iterate(0, i -> i + 1).limit(POINTS).map(i -> 0.1 * Math.pow(4000, i / (POINTS - 1)))
                .toArray();
        double to = exposure.measured().stream().mapToDouble(one -> one.band(SeatAxis.Z).to()).min().orElse(80);
        List<Block> charts = new ArrayList<>();
        for (Weighting weighting : List.of(Weighting.WK, Weighting.WD)) {
            double[] factor = Arrays.stream(frequency).map(weighting::factor).toArray();
            double[] lower = new double[factor.length];
            double[] upper = new double[factor.length];
            for (int i = 0; i < factor.length; i++) {
                Weighting.Tolerance tolerance = weighting.tolerance(frequency[i]);
                lower[i] = factor[i] * (1 - tolerance.below());
                upper[i] = factor[i] * (1 + tolerance.above());
            }
            LineChart chart = new LineChart(weighting.symbol(), ChartAxis.log("Frequency", "Hz"), ChartAxis.log("Factor", "")
                    .within(1e-3, 2),
                    List.of(Series.line("factor", frequency, factor).with(new Band(Band.Kind.UNCERTAINTY, lower, upper,
                            "tolerance of ISO 8041-1"))));
            charts.add(to < weighting.nominalTo() ? chart.shaded(List.of(new LineChart.Shade(to, 400, "not measured"))) : chart);
        }
        return new Section("Frequency weightings",
                "What a meter may deviate by ISO 8041-1:2017 Table 5. The weighting used here is the curve"
                        + " itself, as far as the recording reaches.",
                new Beside(charts));
    }
}
