package wbv.report.seat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import wbv.report.page.Band;
import wbv.report.page.ChartAxis;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.study.DampingTest;

/** A recorded seat's damping test. */
public final class DampingPage {

    private DampingPage() {}

    /**
     * Writes {@code report.html}.
     *
     * @param title what the page calls the recording
     */
    public static void write(DampingTest test, String title, Map<String, String> provenance, OutputFolder out) throws IOException {
        HtmlWriter.write(new Page("Damping of a seat", title, List.of(found(test), assumed(), new Section("Provenance", "", new Table("",
                List.of(Table.Column.words("What"), Table.Column.words("Value")),
                provenance.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList())))),
                out.file("report.html"));
    }

    private static Section found(DampingTest test) {
        DampingTest.Curve curve = test.curve();
        List<Series> series = new ArrayList<>();
        double[] lower = new double[curve.margin().length];
        double[] upper = new double[lower.length];
        for (int k = 0; k < lower.length; k++) {
            lower[k] = Math.max(0, curve.transmissibility()[k] - curve.margin()[k]);
            upper[k] = curve.transmissibility()[k] + curve.margin()[k];
        }
        series.add(new Series("measured", curve.frequency_hz(), curve.transmissibility(), Series.Style.LINE,
                new Band(Band.Kind.UNCERTAINTY, lower,
                        upper, "95 %")));
        if (test.fitted().isPresent()) {
            series.add(Series.dashed("mass on spring and damper", curve.frequency_hz(), curve.fitted()));
        }
        List<List<String>> rows = new ArrayList<>();
        test.measured().ifPresent(
                peak -> rows.add(List.of("measured", Digits.rounded(peak.resonance_hz(), 2), Digits.rounded(peak.transmissibility(), 2)
                        + " ± " + Digits.rounded(peak.margin(), 2), "–", "–", "–")));
        test.fitted()
                .ifPresent(body -> rows.add(List.of("fitted", Digits.rounded(body.resonance_hz(), 2),
                        Digits.rounded(body.transmissibility(), 2) + " ± "
                                + Digits.rounded(2 * body.transmissibility_deviation(), 2),
                        Digits.rounded(body.natural_frequency_hz(), 3) + " ± "
                                + Digits.rounded(2 * body.natural_frequency_deviation_hz(), 3),
                        Digits.rounded(body.damping_ratio(), 3) + " ± "
                                + Digits.rounded(2 * body.damping_ratio_deviation(), 3),
                        Digits.rounded(100 * body.explained(), 1))));
        return new Section("At resonance", "From " + test.floor() + " to " + test.seat() + ", " + Digits.rounded(test.seconds(), 1) + " s.",
                List.of(
                        new Lead(test.sentence()),
                        new Table("± holds 95 %", List.of(Table.Column.words("How"), Table.Column.numbers("Resonance [Hz]"),
                                Table.Column.numbers("Transmissibility there"), Table.Column.numbers("Natural frequency [Hz]"),
                                Table.Column.numbers("Damping ratio"), Table.Column.numbers("Explains [%]")), rows),
                        new LineChart("Transmissibility, floor to seat", ChartAxis.linear("frequency", "Hz"),
                                ChartAxis.linear("|H1|", "").within(0,
                                        Double.NaN),
                                series),
                        new Text("SEAT by r.m.s., Wk: " + Digits.rounded(test.seat_value(), 3) + ".")));
    }

    private static Section assumed() {
        return new Section("What is assumed", "", new Text("ISO 10326-1 and ISO 7096 were not at hand. "
                + "They are remembered to ask for an inert mass of 75 kg on "
                + "the seat, a sinusoidal floor that passes through the resonance, and a transmissibility there of less than "
                + Digits.rounded(DampingTest.LOW_LIMIT, 1) + " for seats of EM1 to EM4 and EM6, "
                + Digits.rounded(DampingTest.HIGH_LIMIT, 1)
                + " for the others; a SEAT value by them is the mean of three rides with a person. Whether the recording was made so is "
                + "not known to wbv.\n\nFriction damps the more, the less the seat moves: these numbers hold for the level at which it was "
                + "shaken."));
    }
}
