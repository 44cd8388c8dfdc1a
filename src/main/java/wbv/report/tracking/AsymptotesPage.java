package wbv.report.tracking;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import wbv.filter.CorrectionFunction.Value;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Code;
import wbv.report.page.HtmlWriter;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.study.Asymptotes;
import wbv.study.Asymptotes.Portrait;
import wbv.study.TrackingRequest;

/** The report of {@link Asymptotes}. */
public final class AsymptotesPage {

    /** Length of the longest arrow in the plane: ln ω, ln ζ. */
    private static final double ARROW = 0.2;

    private final Asymptotes asymptotes;
    private final TrackingRequest request;

    AsymptotesPage(Asymptotes asymptotes, TrackingRequest request) {
        this.asymptotes = asymptotes;
        this.request = request;
    }

    /** Writes {@code report.html}. */
    public static void write(Asymptotes asymptotes, TrackingRequest request, OutputFolder out) throws IOException {
        HtmlWriter.write(new AsymptotesPage(asymptotes, request).page(), out.file("report.html"));
    }

    private Page page() {
        List<Block> blocks = new ArrayList<>();
        blocks.add(new Text("The curves are the mean of the corrections that each filter would make with its parameters held: a "
                + "filter can converge where its curve falls through zero, and nowhere else."));
        blocks.add(new Code("", asymptotes.summary()));
        blocks.add(curves("Correction of the natural frequency", "Natural frequency", "Hz", Portrait::alongFrequency,
                Value::frequency,
                0));
        blocks.add(curves("Correction of the damping ratio", "Damping ratio", "1", Portrait::alongDamping, Value::damping, 1));
        asymptotes.portraits().forEach(portrait -> blocks.add(plane(portrait)));
        List<List<String>> rows = new ArrayList<>();
        request.provenance().forEach((name, value) -> rows.add(List.of(name, value)));
        return new Page("Asymptotes of " + request.title(), asymptotes.input() + " to " + asymptotes.output() + ", "
                + Digits.significant(asymptotes.seconds(), 4) + " s",
                List.of(
                        new Section("Where the filters converge", "", blocks),
                        new Section("Provenance", "The same inputs, options and version give the same results.",
                                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")), rows))));
    }

    private LineChart curves(String title, String label, String unit, java.util.function.Function<Portrait, List<Value>> values,
            ToDoubleFunction<Value> x, int parameter) {
        List<Series> series = new ArrayList<>();
        List<LineChart.Marker> rests = new ArrayList<>();
        for (Portrait portrait : asymptotes.portraits()) {
            List<Value> points = values.apply(portrait);
            double largest = points.stream().mapToDouble(v -> Math.abs(v.correction()[parameter])).max().orElse(1);
            series.add(Series.line(portrait.name(), points.stream().mapToDouble(x).toArray(),
                    points.stream().mapToDouble(v -> v.correction()[parameter] / largest).toArray()));
            portrait.ends().stream().filter(Value::stable).findFirst()
                    .ifPresent(end -> rests.add(new LineChart.Marker(x.applyAsDouble(end), portrait.name() + " rests")));
        }
        return new LineChart(title, ChartAxis.log(label, unit), ChartAxis.linear("f over its largest value", "1").within(-1.05, 1.05),
                series)
                .marked(rests);
    }

    /** Arrows as short lines from each place to where the parameters go, with a dot at their beginning. */
    private XyChart plane(Portrait portrait) {
        int count = portrait.plane().size();
        double[] x = new double[3 * count];
        double[] y = new double[3 * count];
        double[] fromX = new double[count];
        double[] fromY = new double[count];
        for (int i = 0; i < count; i++) {
            Value v = portrait.plane().get(i);
            double length = Math.hypot(v.move()[0], v.move()[1]);
            double scale = length > ARROW ? ARROW / length : 1;
            fromX[i] = v.frequency();
            fromY[i] = v.damping();
            x[3 * i] = v.frequency();
            y[3 * i] = v.damping();
            x[3 * i + 1] = v.frequency() * Math.exp(scale * v.move()[0]);
            y[3 * i + 1] = v.damping() * Math.exp(scale * v.move()[1]);
            x[3 * i + 2] = Double.NaN;
            y[3 * i + 2] = Double.NaN;
        }
        List<Value> rests = portrait.ends().stream().filter(Value::stable).toList();
        return new XyChart("Where " + portrait.name() + " goes", ChartAxis.log("Natural frequency", "Hz"), ChartAxis.log("Damping ratio",
                "1"),
                List.of(new XySeries("from", fromX, fromY, XySeries.Style.CLOUD), new XySeries("goes", x, y, XySeries.Style.LINE),
                        new XySeries("rests", rests.stream().mapToDouble(Value::frequency).toArray(),
                                rests.stream().mapToDouble(Value::damping).toArray(), XySeries.Style.POINTS)))
                .noted("A line leads from each dot the way the parameters go; long ones are cut.");
    }
}
