package wbv.report;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import wbv.network.Estimate;
import wbv.network.Model;
import wbv.network.Readings;

/**
 * What a network read from a recording, for people, {@code report.html}, and for machines, {@code readings.csv}.
 *
 * @param title      of the recording
 * @param channels   excitation and answer, in words
 * @param provenance what, and from what, this was made, in the order in which it is shown
 */
public record NetworkReadingReport(String title, String channels, Model model, Readings readings,
                                   Map<String, String> provenance) {

    private static final double TAU = 2 * Math.PI;

    /** Writes both. */
    public void write(OutputFolder out) throws IOException {
        StringBuilder csv = new StringBuilder("t");
        for (int i = 1; i <= readings.modes(); i++) {
            String mode = readings.modes() == 1 ? "" : Integer.toString(i);
            csv.append(String.format(",damping%s,damping%s_deviation,frequency%s_Hz,frequency%s_deviation_Hz", mode, mode, mode,
                    mode));
        }
        csv.append('\n');
        for (int i = 0; i < readings.time().length; i++) {
            Estimate estimate = readings.estimates().get(i);
            csv.append(readings.time()[i]);
            for (int j = 0; j < estimate.value().length; j++) {
                csv.append(',').append(cell(estimate.value()[j] / unit(j)));
                csv.append(',').append(cell(estimate.deviation()[j] / unit(j)));
            }
            csv.append('\n');
        }
        Files.writeString(out.file("readings.csv"), csv);
        HtmlWriter.write(page(), out.file("report.html"));
    }

    /** The medians in a few lines. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < readings.modes(); i++) {
            text.append(String.format(Locale.ROOT,
                    "%s: natural frequency %.2f ± %.2f Hz, damping ratio %.3f ± %.3f (medians of %d of %d "
                    + "windows)%n", channels, median(2 * i + 1, false), 2 * median(2 * i + 1, true), median(2 * i, false),
                    2 * median(2 * i, true), readings.read(), readings.time().length));
        }
        return text.toString();
    }

    private double median(int target, boolean deviation) {
        double[] sorted = readings.estimates().stream()
                .mapToDouble(each -> (deviation ? each.deviation() : each.value())[target] / unit(target))
                .filter(Double::isFinite).sorted().toArray();
        return sorted.length == 0 ? Double.NaN : sorted[sorted.length / 2];
    }

    private static String cell(double value) {
        return Double.isFinite(value) ? Double.toString(value) : "";
    }

    private static double unit(int target) {
        return target % 2 == 0 ? 1 : TAU;
    }

    private Page page() {
        List<Block> figures = new ArrayList<>();
        for (int i = 0; i < readings.modes(); i++) {
            String mode = readings.modes() == 1 ? "" : ", mode " + (i + 1);
            figures.add(new Figures(Figures.Figure.measured("Natural frequency" + mode, median(2 * i + 1, false),
                    median(2 * i + 1, true), "Hz"), Figures.Figure.measured("Damping ratio" + mode, median(2 * i, false),
                    median(2 * i, true), "")));
        }
        figures.add(new Text("Medians over " + readings.read() + " windows of 3.65 s, of " + readings.time().length
                + (readings.read() == readings.time().length ? "" : "; the rest lacks samples") + ". The network "
                + "was trained on simulated linear bodies; on what differs from those it may be wrong and not know it. "
                + "'wbv track' follows a body by its physics."));
        List<Block> charts = new ArrayList<>();
        for (int j = 0; j < 2 * readings.modes(); j++) {
            charts.add(track(j % 2 == 0 ? j + 1 : j - 1));
        }
        return new Page("What the network reads from " + title, channels, List.of(new Section("Finding", "", figures),
                new Section("Over time", "Each point looks at the 3.65 s about it; the band is ±2σ, as the network states it.",
                        charts),
                new Section("Card", "What the model's file says of itself.", table(model.card())),
                new Section("Provenance", "The same inputs, options and version give the same results.", table(provenance))));
    }

    private LineChart track(int target) {
        double[] value = values(target, 0);
        String name = (target % 2 == 0 ? "Damping ratio" : "Natural frequency") + (readings.modes() == 1 ? ""
                : ", mode " + (target / 2 + 1));
        return new LineChart(name, Axis.linear("Time", "s"), Axis.linear(name, target % 2 == 0 ? "" : "Hz"),
                List.of(Series.line(name, readings.time(), value).with(new Band(Band.Kind.UNCERTAINTY, values(target, -2),
                values(target, 2), "±2σ")))).grouped("time");
    }

    private double[] values(int target, int deviations) {
        return readings.estimates().stream()
                .mapToDouble(each -> (each.value()[target] + deviations * each.deviation()[target]) / unit(target)).toArray();
    }

    private static Table table(Map<String, String> entries) {
        return new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                entries.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList());
    }
}
