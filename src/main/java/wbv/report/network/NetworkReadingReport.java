package wbv.report.network;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import wbv.network.Estimate;
import wbv.network.NetworkReadings;
import wbv.network.Reading;
import wbv.network.TrainedNetwork;
import wbv.recording.AtomicFile;
import wbv.report.page.Band;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Figures;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/**
 * What a network read from a recording, for people, {@code report.html}, and for machines, {@code readings.csv} and
 * {@code results.json}.
 *
 * @param title      of the recording
 * @param channels   excitation and answer, in words
 * @param provenance what, and from what, this was made, in the order in which it is shown
 */
public record NetworkReadingReport(String title, String channels, TrainedNetwork model, NetworkReadings readings,
        Map<String, String> provenance) {

    private static final double TAU = 2 * Math.PI;
    /** Share of windows that may be unlike those trained on by chance. */
    private static final double USUAL = 0.03;

    /** Writes all three. */
    public void write(OutputFolder out) throws IOException {
        StringBuilder csv = new StringBuilder("t");
        StringBuilder network = new StringBuilder();
        for (int i = 1; i <= readings.modes(); i++) {
            String mode = readings.modes() == 1 ? "" : Integer.toString(i);
            csv.append(String.format(",damping%s,damping%s_deviation,frequency%s_Hz,frequency%s_deviation_Hz", mode, mode, mode,
                    mode));
            network.append(String.format(",network_damping%s,network_damping%s_deviation,network_frequency%s_Hz,"
                    + "network_frequency%s_deviation_Hz", mode, mode, mode, mode));
        }
        csv.append(network).append(",misfit\n");
        for (int i = 0; i < readings.time().length; i++) {
            Reading reading = readings.readings().get(i);
            csv.append(readings.time()[i]);
            for (Estimate estimate : List.of(reading.fitted(), reading.network())) {
                for (int j = 0; j < estimate.value().length; j++) {
                    csv.append(',').append(cell(estimate.value()[j] / unit(j)));
                    csv.append(',').append(cell(estimate.deviation()[j] / unit(j)));
                }
            }
            csv.append(',').append(cell(reading.misfit())).append('\n');
        }
        AtomicFile.write(out.file("readings.csv"), csv);
        ResultsJson.write(results(), out.file("results.json"));
        HtmlWriter.write(page(), out.file("report.html"));
    }

    /**
     * Results for machines.
     *
     * @param windows looked at
     * @param read of these
     * @param unlike of these, anything that the network was trained on
     * @param holds   whether the medians hold
     * @param finding what is to be said of them first: a refusal with its reason where they do not hold
     * @param modes   medians of the windows that hold; empty where too few do
     */
    record Results(String recording, String channels, int windows, long read, long unlike, boolean holds, String finding,
            List<Mode> modes, Map<String, String> provenance) {}

    /** Medians over windows. */
    record Mode(double natural_frequency_hz, double natural_frequency_sd_hz, double damping_ratio, double damping_ratio_sd) {}

    private Results results() {
        List<Mode> modes = new ArrayList<>();
        for (int i = 0; i < (refused() ? 0 : readings.modes()); i++) {
            modes.add(new Mode(median(2 * i + 1, false), median(2 * i + 1, true), median(2 * i, false), median(2 * i, true)));
        }
        return new Results(title, channels, readings.time().length, readings.read(), readings.unlike(), holds(), judgement(), modes,
                provenance);
    }

    /** Whether no value is worth printing: most windows are unlike those trained on, or none was read. */
    private boolean refused() {
        return readings.read() == 0 || 2 * readings.unlike() > readings.read();
    }

    /** Whether the medians hold: the network sees what excites the body, and most windows are like those trained on. */
    private boolean holds() {
        return !refused() && model.architecture().excited();
    }

    /** What holds first: the medians, or why there are none. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        String judgement = judgement() + System.lineSeparator();
        if (!holds()) {
            text.append(judgement);
        }
        for (int i = 0; i < (refused() ? 0 : readings.modes()); i++) {
            text.append(String.format(Locale.ROOT,
                    "%s: natural frequency %.2f ± %.2f Hz, damping ratio %.3f ± %.3f (medians of %d of %d "
                            + "windows)%n",
                    channels, median(2 * i + 1, false), 2 * median(2 * i + 1, true), median(2 * i, false),
                    2 * median(2 * i, true), readings.read() - readings.unlike(), readings.time().length));
        }
        return holds() ? text.append(judgement).toString() : text.toString();
    }

    /** Whether the windows are like those trained on, in words. */
    private String judgement() {
        long unlike = readings.unlike();
        long read = readings.read();
        if (read == 0) {
            return "No value: no window could be read.";
        }
        if (!model.architecture().excited()) {
            return "Not checked: without the excitation nobody can say whether the windows are like those that the network was trained on.";
        }
        if (unlike <= USUAL * read + 1) {
            return "The windows are like those that the network was trained on: one linear body of " + modes()
                    + " explains them to the sensors' noise.";
        }
        double median = sorted(readings.readings().stream().mapToDouble(Reading::misfit))[(int) (read / 2)];
        String why = String.format(Locale.ROOT, "unlike anything that the network was trained on (%d of %d; 1 in 100 would be usual): "
                + "no linear body of %s explains them, or none that the network would say", unlike, read, modes());
        return refused() ? String.format(Locale.ROOT, "No value: %s windows are %s. The misfit is %.1f times what training had at most.",
                unlike == read ? "all" : "most", why, median) : "Some windows are left out, since they are " + why + ".";
    }

    private String modes() {
        return readings.modes() == 1 ? "one mode" : readings.modes() + " modes";
    }

    private double median(int target, boolean deviation) {
        double[] sorted = sorted(readings.readings().stream().filter(each -> !each.unlike()).map(Reading::fitted)
                .mapToDouble(each -> (deviation ? each.deviation() : each.value())[target] / unit(target)));
        return sorted.length == 0 ? Double.NaN : sorted[sorted.length / 2];
    }

    private static double[] sorted(DoubleStream values) {
        return values.filter(Double::isFinite).sorted().toArray();
    }

    private static String cell(double value) {
        return Double.isFinite(value) ? Double.toString(value) : "";
    }

    private static double unit(int target) {
        return target % 2 == 0 ? 1 : TAU;
    }

    private Page page() {
        List<Block> figures = new ArrayList<>();
        if (!holds()) {
            figures.add(new Lead(judgement()));
        }
        for (int i = 0; i < (holds() ? readings.modes() : 0); i++) {
            String mode = readings.modes() == 1 ? "" : ", mode " + (i + 1);
            figures.add(new Figures(Figures.Figure.measured("Natural frequency" + mode, median(2 * i + 1, false),
                    median(2 * i + 1, true), "Hz"),
                    Figures.Figure.measured("Damping ratio" + mode, median(2 * i, false),
                            median(2 * i, true), "")));
        }
        if (!refused()) {
            figures.add(
                    new Text((holds() ? "Medians" : summary().lines().skip(1).collect(Collectors.joining("; ")) + ": medians") + " over "
                            + (readings.read() - readings.unlike()) + " windows of 3.65 s, of " + readings.time().length
                            + (readings.read() == readings.time().length ? "" : "; the rest lacks samples or is unlike those trained on")
                            + ", of the linear body that explains a window best, with what the network says as what is known beforehand."));
        }
        if (holds()) {
            figures.add(new Text(judgement()));
        } else if (refused()) {
            figures.add(new Text("What was read from each window is drawn below and stands in readings.csv, with its misfit. 'wbv track' "
                    + "follows a body by its physics, 'wbv diagnose' finds what is missing."));
        }
        List<Block> charts = new ArrayList<>();
        for (int j = 0; j < 2 * readings.modes(); j++) {
            charts.add(track(j % 2 == 0 ? j + 1 : j - 1));
        }
        if (model.architecture().excited()) {
            charts.add(misfit());
        }
        return new Page("What the network reads from " + title, channels, List.of(new Section("Finding", "", figures),
                new Section("Over time", "Each point looks at the 3.65 s about it; the band is ±2σ, wide where a "
                        + "window is unlike those trained on.",
                        charts),
                new Section("Card", "What the model's file says of itself.", table(model.card())),
                new Section("Provenance", "The same inputs, options and version give the same results.", table(provenance))));
    }

    private LineChart track(int target) {
        double[] value = values(target, 0);
        String name = (target % 2 == 0 ? "Damping ratio" : "Natural frequency") + (readings.modes() == 1 ? ""
                : ", mode " + (target / 2 + 1));
        return new LineChart(name, ChartAxis.linear("Time", "s"), ChartAxis.linear(name, target % 2 == 0 ? "" : "Hz"),
                List.of(Series.line("fitted", readings.time(), value).with(new Band(Band.Kind.UNCERTAINTY, values(target, -2),
                        values(target, 2), "±2σ")), Series.line("network", readings.time(), network(target))))
                .grouped("time");
    }

    private double[] network(int target) {
        return readings.readings().stream().mapToDouble(each -> each.network().value()[target] / unit(target)).toArray();
    }

    private LineChart misfit() {
        double[] misfit = readings.readings().stream().mapToDouble(Reading::misfit).toArray();
        double[] limit = new double[misfit.length];
        Arrays.fill(limit, 1);
        return new LineChart("Misfit, over what training had at most", ChartAxis.linear("Time", "s"),
                ChartAxis.linear("Misfit", ""), List.of(Series.line("misfit", readings.time(), misfit),
                        Series.line("training's limit", readings.time(), limit)))
                .grouped("time");
    }

    private double[] values(int target, int deviations) {
        return readings.readings().stream().map(Reading::fitted)
                .mapToDouble(each -> (each.value()[target] + deviations * each.deviation()[target]) / unit(target)).toArray();
    }

    private static Table table(Map<String, String> entries) {
        return new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                entries.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList());
    }
}
