package wbv.report.tracking;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.filter.BodyEstimate;
import wbv.recording.Channel;
import wbv.report.page.Band;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Code;
import wbv.report.page.Findings;
import wbv.report.page.HtmlWriter;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.signal.Envelope;
import wbv.study.FollowedBody;
import wbv.study.Tracking;

/** The report of a tracking. */
public final class TrackingPage {

    private static final double HIGHEST = 30;
    private static final int RESPONSE_POINTS = 200;

    private final Tracking tracking;
    private final double rate;
    private final double start;

    TrackingPage(Tracking tracking) {
        this.tracking = tracking;
        this.rate = tracking.inspection().clock().rate();
        this.start = tracking.inspection().clock().start();
    }

    /** Writes {@code report.html}. */
    public static void write(Tracking tracking, OutputFolder out) throws IOException {
        HtmlWriter.write(new TrackingPage(tracking).page(), out.file("report.html"));
    }

    private Page page() {
        String methods = tracking.request().designs().stream().map(design -> design.method().word()).collect(Collectors.joining(", "));
        List<Section> sections = new ArrayList<>(List.of(summary()));
        tracking.outputs().forEach(output -> sections.add(tracks(output)));
        sections.add(responses());
        sections.add(histories());
        sections.add(provenance());
        return new Page("Tracks of " + tracking.request().title(), tracking.input() + " to " + tracking.outputs().stream()
                .map(Channel::toString).collect(Collectors.joining(", ")) + " by " + methods, sections);
    }

    private Section summary() {
        List<List<String>> rows = new ArrayList<>();
        List<Findings.Finding> cautions = new ArrayList<>();
        for (FollowedBody one : tracking.followed()) {
            BodyEstimate track = one.track();
            rows.add(List.of(one.channel().toString(), one.design().method().word(),
                    one.stands() ? modes(track, m -> track.frequency(m), m -> track.frequencyDeviation(m)) : "–",
                    one.stands() ? modes(track, m -> track.damping(m), m -> track.dampingDeviation(m)) : "–",
                    Digits.significant(one.meanSquareError(), 3), Digits.significant(100 * Math.sqrt(one.relativeError()), 3),
                    Long.toString(track.changes()), Long.toString(track.divergences()), Long.toString(track.missing())));
            if (!one.caution().isEmpty()) {
                cautions.add(new Findings.Finding(Findings.Severity.NOTE, one.name() + ": " + one.caution(), ""));
            }
        }
        Table table = new Table("After the last sample (± 2σ). Errors are those of the prediction from the present input and "
                + "everything before it, from ten seconds on",
                List.of(Table.Column.words("Output"),
                        Table.Column.words("Estimator"),
                        Table.Column.numbers("Natural frequency [Hz]"), Table.Column.numbers("Damping ratio"),
                        Table.Column.numbers("MSE"),
                        Table.Column.numbers("Error over signal, rms [%]"), Table.Column.numbers("Changes"),
                        Table.Column.numbers("Divergences"), Table.Column.numbers("Missing")),
                rows);
        List<List<String>> bodies = tracking.bodies().stream().map(body -> List.of(body.output().toString(), body.line())).toList();
        Table whole = new Table(
                "The equivalent body of each path over the recording (± 2σ): the linear body that would simulate the output from the "
                        + "input best",
                List.of(Table.Column.words("Output"), Table.Column.words("Body")), bodies);
        return new Section("Summary", "", whole, table, new Findings(cautions, "Every estimator found a body, and was excited to."));
    }

    private static String modes(BodyEstimate track, Function<Integer, Double> value, Function<Integer, Double> deviation) {
        return IntStream.range(0, track.modes()).mapToObj(m -> Digits.significant(value.apply(m), 3) + " ± "
                + Digits.significant(2 * deviation.apply(m), 2)).collect(Collectors.joining("; "));
    }

    private Section tracks(Channel output) {
        List<FollowedBody> those = of(output);
        List<LineChart.Marker> changes = Arrays.stream(those.get(those.size() - 1).changes())
                .mapToObj(t -> new LineChart.Marker(start + t, "change")).toList();
        List<Block> charts = new ArrayList<>();
        for (int m = 0; m < those.get(0).outlines().size(); m++) {
            int mode = m;
            String which = those.get(0).outlines().size() == 1 ? "" : mode == 0 ? ", slower mode" : ", faster mode";
            charts.add(chart("Natural frequency" + which, "Hz", those, one -> one.outlines().get(mode).frequency(),
                    one -> one.outlines().get(mode).frequencyDeviation()).marked(changes).grouped("time"));
            charts.add(chart("Damping ratio" + which, "1", those, one -> one.outlines().get(mode).damping(),
                    one -> one.outlines().get(mode).dampingDeviation()).marked(changes).grouped("time"));
        }
        charts.add(new LineChart("Output less prediction", ChartAxis.linear("Time", "s"),
                ChartAxis.linear("Error", output.quantity().unit()), those.stream().map(one -> Series.envelope(one.design().method().word(),
                        one.residual(), start, 1 / rate)).toList())
                .grouped("time"));
        return new Section(output.toString(),
                "Bands are ±2σ, by how the estimates really scatter; a change is where the last one heard the body "
                        + "change.",
                charts);
    }

    private List<FollowedBody> of(Channel output) {
        return tracking.followed().stream().filter(one -> one.channel().equals(output)).toList();
    }

    private LineChart chart(String title, String unit, List<FollowedBody> those, Function<FollowedBody, Envelope> value,
            Function<FollowedBody, Envelope> deviation) {
        List<Series> series = new ArrayList<>();
        for (FollowedBody one : those) {
            Envelope outline = value.apply(one);
            double[] y = IntStream.range(0, outline.size()).mapToDouble(outline::mean).toArray();
            double[] sd = IntStream.range(0, outline.size()).mapToDouble(deviation.apply(one)::mean).toArray();
            double[] x = IntStream.range(0, outline.size()).mapToDouble(i -> start + outline.centre(i) / rate).toArray();
            series.add(Series.line(one.design().method().word(), x, y).with(Band.deviations(y, sd, 2, "±2σ")));
        }
        return new LineChart(title, ChartAxis.linear("Time", "s"), ChartAxis.linear(title, unit), series);
    }

    private Section responses() {
        double[] f = IntStream.range(0, RESPONSE_POINTS).mapToDouble(i -> 0.3 * Math.pow(Math.min(HIGHEST, rate / 2) / 0.3,
                i / (RESPONSE_POINTS - 1.0))).toArray();
        List<Block> charts = new ArrayList<>();
        for (Channel output : tracking.outputs()) {
            charts.add(new LineChart(tracking.input() + " to " + output, ChartAxis.log("Frequency", "Hz"), ChartAxis.linear("Modulus", "1"),
                    of(output).stream().map(one -> Series.line(one.design().method().word(), f,
                            Arrays.stream(f).map(one::modulus).toArray())).toList()));
        }
        return new Section("Transmissibility", "Of the bodies that the estimators ended with.", charts);
    }

    private Section histories() {
        return new Section("Input", "", new LineChart(tracking.input().toString(), ChartAxis.linear("Time", "s"),
                ChartAxis.linear(tracking.input().toString(), tracking.input().quantity().unit()),
                List.of(Series.envelope(tracking.input().toString(), tracking.inputSamples(), start, 1 / rate))).grouped("time"));
    }

    private Section provenance() {
        List<List<String>> rows = new ArrayList<>();
        tracking.request().provenance().forEach((name, value) -> rows.add(List.of(name, value)));
        return new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")), rows),
                new Code("The last estimator on the first output as a MOA task:", tracking.taskString()));
    }
}
