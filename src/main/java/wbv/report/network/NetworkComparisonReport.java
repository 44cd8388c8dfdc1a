package wbv.report.network;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import wbv.network.Evaluation;
import wbv.network.Score;
import wbv.network.TrainedNetwork;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Table;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/**
 * Networks beside their peers, for people, {@code report.html}, and for machines, {@code evaluation.csv}.
 *
 * @param evaluations one for each kind of body
 * @param models      the networks asked
 * @param provenance  what, and from what, this was made, in the order in which it is shown
 */
public record NetworkComparisonReport(List<Evaluation> evaluations, List<TrainedNetwork> models, Map<String, String> provenance) {

    private static final double TAU = 2 * Math.PI;

    /** Writes both. */
    public void write(OutputFolder out) throws IOException {
        StringBuilder csv = new StringBuilder("bodies,method,target,unit,trials,missing,rmse,error_deviation,standardised_rmse,"
                + "deviation_over_seeds,covered_90,stated_deviation,unlike_training\n");
        for (Row row : rows()) {
            csv.append(String.join(",", row.bodies(), '"' + row.method().replace("\"", "\"\"") + '"', row.target(), row.unit(),
                    Integer.toString(row.trials()),
                    Integer.toString(row.missing()), plain(row.rmse()), plain(row.error_deviation()), plain(row.standardised_rmse()),
                    plain(row.deviation_over_seeds()), plain(row.covered_90()), plain(row.stated_deviation()),
                    plain(row.unlike_training()))).append('\n');
        }
        AtomicFile.write(out.file("evaluation.csv"), csv);
        HtmlWriter.write(page(), out.file("report.html"));
    }

    /**
     * A row of the tables.
     *
     * @param covered_90 share of 90 % intervals that hold
     */
    private record Row(String bodies, String method, String target, String unit, int trials, int missing, double rmse,
            double error_deviation,
            double standardised_rmse, double deviation_over_seeds, double covered_90, double stated_deviation, double unlike_training) {}

    private record Results(List<Row> rows, Map<String, String> provenance) {}

    /** The same rows for machines. */
    public String json() throws IOException {
        return ResultsJson.render(new Results(rows(), provenance));
    }

    private List<Row> rows() {
        List<Row> rows = new ArrayList<>();
        for (Evaluation evaluation : evaluations) {
            for (Evaluation.Row row : evaluation.rows()) {
                for (int j = 0; j < row.scores().size(); j++) {
                    Score score = row.scores().get(j);
                    rows.add(new Row(evaluation.bodies().word(), row.method(), target(j, row.scores().size()), j % 2 == 0 ? "1" : "Hz",
                            score.count(),
                            score.missing(), score.rmse() / unit(j), score.deviation() / unit(j), score.standardised(), row.spread()[j],
                            score.covered(), score.stated() / unit(j), row.unlike()));
                }
            }
        }
        return rows;
    }

    /** The tables as text. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        for (Evaluation evaluation : evaluations) {
            text.append("Bodies '").append(evaluation.bodies().word()).append("', ").append(evaluation.trials().size())
                    .append(" trials: standardised RMSE (RMSE in ζ or Hz; share of 90 % intervals that hold)\n");
            for (Evaluation.Row row : evaluation.rows()) {
                text.append(String.format(Locale.ROOT, "  %-46s", row.method()));
                for (int j = 0; j < row.scores().size(); j++) {
                    Score score = row.scores().get(j);
                    text.append(String.format(Locale.ROOT, " %s %.3f (%.4f%s)", target(j, row.scores().size()),
                            score.standardised(),
                            score.rmse() / unit(j), Double.isNaN(score.covered()) ? ""
                                    : String.format(Locale.ROOT, "; %.0f %%", 100 * score.covered())));
                }
                text.append(Double.isNaN(row.unlike()) ? "" : String.format(Locale.ROOT, "  unlike training %.0f %%",
                        100 * row.unlike())).append('\n');
            }
        }
        return text.toString();
    }

    private static String plain(double value) {
        return Double.isNaN(value) ? "" : Double.toString(value);
    }

    private static double unit(int target) {
        return target % 2 == 0 ? 1 : TAU;
    }

    private static String target(int target, int targets) {
        return (target % 2 == 0 ? "ζ" : "f") + (targets == 2 ? "" : Integer.toString(target / 2 + 1));
    }

    private Page page() {
        List<Section> sections = new ArrayList<>();
        for (Evaluation evaluation : evaluations) {
            List<Block> blocks = new ArrayList<>();
            for (int j = 0; j < evaluation.rows().get(0).scores().size(); j += 2) {
                blocks.add(table(evaluation, j));
                blocks.add(table(evaluation, j + 1));
                blocks.add(new Beside(cloud(evaluation, j), cloud(evaluation, j + 1)));
            }
            sections.add(new Section("Bodies '" + evaluation.bodies().word() + "'", "Fresh trials, " + evaluation.trials().size()
                    + ", of " + String.join(", ", evaluation.bodies().channels().stream().map(Channel::toString).toList())
                    + ". What a method gives nothing for counts as if it had said the mean of all.", blocks));
        }
        sections.add(new Section("Models", "What the models' files say of themselves.", models.stream()
                .map(model -> (Block) table(model.architecture().word() + ", " + model.modes() + " mode"
                        + (model.modes() == 1 ? "" : "s"), model.card()))
                .toList()));
        sections.add(new Section("Provenance", "The same models, options and version give the same results.",
                table("", provenance)));
        return new Page("Networks beside their peers", "Damping ratio and natural frequency from 3.65 s of motion", sections);
    }

    private static Table table(Evaluation evaluation, int target) {
        List<List<String>> rows = new ArrayList<>();
        for (Evaluation.Row row : evaluation.rows()) {
            Score score = row.scores().get(target);
            rows.add(List.of(row.method() + (score.missing() == 0 ? "" : " (nothing for " + score.missing() + ")"),
                    Digits.rounded(score.standardised(), 3) + (Double.isNaN(row.spread()[target]) ? ""
                            : " ± " + Digits.rounded(row.spread()[target], 3)),
                    Digits.significant(score.rmse() / unit(target), 3), Digits.significant(score.deviation() / unit(target), 3),
                    Double.isNaN(score.covered()) ? "–" : Digits.rounded(100 * score.covered(), 0) + " %",
                    Double.isNaN(score.stated()) || !Double.isFinite(score.stated()) ? "–"
                            : Digits.significant(score.stated() / unit(target), 3),
                    Double.isNaN(row.unlike()) ? "–" : Digits.rounded(100 * row.unlike(), 0) + " %"));
        }
        String unit = target % 2 == 0 ? "" : " [Hz]";
        return new Table(target(target, evaluation.rows().get(0).scores().size()) + ": error over the spread of what was "
                + "trained on (± over training seeds), error, its standard deviation, 90 % intervals that hold, the deviation "
                + "stated, trials found unlike any trained on",
                List.of(Table.Column.words("Method"), Table.Column.numbers("Std. RMSE"), Table.Column.numbers("RMSE" + unit),
                        Table.Column.numbers("SD" + unit), Table.Column.numbers("Hold"),
                        Table.Column.numbers("Stated" + unit), Table.Column.numbers("Unlike")),
                rows);
    }

    /** The first method and the fit that knows nothing beforehand, over the truth. */
    private static XyChart cloud(Evaluation evaluation, int target) {
        List<XySeries> series = new ArrayList<>();
        double[] truth = evaluation.trials().stream().mapToDouble(trial -> trial.truth()[target] / unit(target)).toArray();
        for (Evaluation.Row row : evaluation.rows()) {
            boolean shown = series.isEmpty() || row.method().equals("fit in frequency");
            if (shown && !row.estimates().isEmpty()) {
                double[] said = row.estimates().stream().mapToDouble(each -> each.value()[target] / unit(target)).toArray();
                series.add(new XySeries(row.method(), truth, said, XySeries.Style.CLOUD));
            }
        }
        double low = java.util.Arrays.stream(truth).min().orElse(0);
        double high = java.util.Arrays.stream(truth).max().orElse(1);
        series.add(new XySeries("right", new double[] {low, high}, new double[] {low, high}, XySeries.Style.DASHED));
        String name = (target % 2 == 0 ? "Damping ratio" : "Natural frequency") + (evaluation.bodies().modes() == 1 ? ""
                : ", mode " + (target / 2 + 1));
        String unit = target % 2 == 0 ? "" : "Hz";
        double margin = (high - low) / 4;
        ChartAxis said = ChartAxis.linear("said", unit).within(low - margin, high + margin);
        return new XyChart(name, ChartAxis.linear("truth", unit), said, series);
    }

    private static Table table(String caption, Map<String, String> entries) {
        return new Table(caption, List.of(Table.Column.words("What"), Table.Column.words("Value")),
                entries.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList());
    }
}
