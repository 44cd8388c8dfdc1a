package wbv.report.diagnosis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import wbv.diagnosis.Diagnosis;
import wbv.report.page.BarChart;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Section;
import wbv.report.page.Table;
import wbv.result.Digits;

/**
 * Errors on data that took no part in the fit, before, after and of noise alone, by channel and by band, with where they may lie.
 */
final class HeldOutCharts {

    private static final String WHISKERS = "Whiskers hold 90 %: the stretch's own blocks, drawn anew a thousand times.";

    private final Diagnosis.Fit fit;
    private final boolean completed;
    private final String before;
    private final String after;

    /**
     * @param completed whether anything was found
     * @param before what the earlier model is
     * @param after what the later one is
     */
    HeldOutCharts(Diagnosis.Fit fit, boolean completed, String before, String after) {
        this.fit = fit;
        this.completed = completed;
        this.before = before;
        this.after = after;
    }

    /**
     * Bars by channel.
     *
     * @param given errors of the user's own values by channel, over the signal
     */
    BarChart channels(Map<String, Double> given) {
        List<Diagnosis.Proof> proofs = fit.channels();
        List<BarChart.Bars> bars = new ArrayList<>();
        bars.add(new BarChart.Bars("as given", proofs.stream().mapToDouble(p -> 100 * given.getOrDefault(p.channel(), Double.NaN))
                .toArray(), 3));
        bars.addAll(bars(proofs));
        return new BarChart("Error on data that took no part in the fit", ChartAxis.linear("Error over signal, rms", "%"),
                proofs.stream().map(Diagnosis.Proof::channel).toList(), bars,
                "Free run on the recorded input, seen with the small errors that every sensor has. The noise floor is what noise leaves "
                        + "of a perfect model, at most: where an error is less, so is the noise. " + WHISKERS);
    }

    Section bands() {
        List<Block> blocks = new ArrayList<>();
        List<BarChart> charts = new ArrayList<>();
        byChannel().forEach(
                (channel, proofs) -> charts.add(new BarChart(channel, ChartAxis.linear("Error over the channel's signal, rms", "%"),
                        proofs.stream().map(p -> band(p.band()) + " Hz").toList(), bars(proofs), "")));
        for (int i = 0; i < charts.size(); i += 2) {
            blocks.add(i + 1 < charts.size() ? new Beside(charts.get(i), charts.get(i + 1)) : charts.get(i));
        }
        if (completed) {
            blocks.add(removed());
        }
        return new Section("Held out, by band",
                "The same errors in bands, each over the channel's whole signal, so that their squares add up to that of all "
                        + "bands together. " + WHISKERS,
                blocks);
    }

    private Map<String, List<Diagnosis.Proof>> byChannel() {
        Map<String, List<Diagnosis.Proof>> out = new LinkedHashMap<>();
        fit.bands().forEach(p -> out.computeIfAbsent(p.channel(), channel -> new ArrayList<>()).add(p));
        return out;
    }

    private List<BarChart.Bars> bars(List<Diagnosis.Proof> proofs) {
        List<BarChart.Bars> bars = new ArrayList<>();
        if (completed) {
            bars.add(bars(before, proofs, Diagnosis.Proof::before, 1));
        }
        bars.add(bars(after, proofs, Diagnosis.Proof::after, 2));
        bars.add(new BarChart.Bars("noise floor", percent(proofs, Diagnosis.Proof::floor), 7));
        return bars;
    }

    private static BarChart.Bars bars(String name, List<Diagnosis.Proof> proofs, Function<Diagnosis.Proof,
            Diagnosis.Ranged> figure, int colour) {
        return new BarChart.Bars(name, percent(proofs, p -> figure.apply(p).value()), percent(proofs, p -> figure.apply(p).low()),
                percent(proofs, p -> figure.apply(p).high()), colour);
    }

    private static double[] percent(List<Diagnosis.Proof> proofs, ToDoubleFunction<Diagnosis.Proof> figure) {
        return proofs.stream().mapToDouble(p -> 100 * figure.applyAsDouble(p)).toArray();
    }

    private Table removed() {
        List<Table.Column> columns = new ArrayList<>(List.of(Table.Column.words("Channel"), Table.Column.numbers("All")));
        Map<String, List<Diagnosis.Proof>> bands = byChannel();
        bands.values().stream()
                .findFirst().orElse(List.of()).forEach(p -> columns.add(Table.Column.numbers(band(p.band()) + " Hz")));
        List<List<String>> rows = new ArrayList<>();
        for (Diagnosis.Proof all : fit.channels()) {
            List<String> row = new ArrayList<>(List.of(all.channel(), share(all.removed())));
            bands.get(all.channel()).forEach(p -> row.add(share(p.removed())));
            rows.add(row);
        }
        return new Table("Part of the error's power above the noise that went, %, with where 90 % of the draws lie", columns,
                rows);
    }

    private static String share(Diagnosis.Ranged ranged) {
        if (Double.isNaN(ranged.value()) || Double.isNaN(ranged.low())) {
            return "–";   // in one draw or another there was nothing to remove
        }
        return Digits.rounded(100 * ranged.value(), 0) + " (" + Digits.rounded(100 * ranged.low(), 0) + " to "
                + Digits.rounded(100 * ranged.high(), 0) + ")";
    }

    private static String band(double[] band) {
        return Digits.significant(band[0], 2) + " to " + Digits.significant(band[1], 2);
    }
}
