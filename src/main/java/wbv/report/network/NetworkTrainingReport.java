package wbv.report.network;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import wbv.network.Losses;
import wbv.network.Trainer;
import wbv.network.TrainingOrder;
import wbv.recording.AtomicFile;
import wbv.report.page.Beside;
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
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.result.ResultsJson;

/**
 * How a network was trained, for people, {@code report.html}, and for machines, {@code losses.csv}.
 *
 * @param order      what was to be trained
 * @param result     what came out
 * @param provenance what, and from what, this was made, in the order in which it is shown
 */
public record NetworkTrainingReport(TrainingOrder order, Trainer.Result result, Map<String, String> provenance) {

    /** Writes both. */
    public void write(OutputFolder out) throws IOException {
        StringBuilder csv = new StringBuilder("member,epoch,train_loss,held_back_loss,held_back_standardised_rmse\n");
        for (int i = 0; i < result.losses().size(); i++) {
            for (int e = 0; e < result.losses().get(i).size(); e++) {
                Losses each = result.losses().get(i).get(e);
                csv.append(i + 1).append(',').append(e + 1).append(',').append(each.train()).append(',').append(each.held())
                        .append(',').append(each.rmse()).append('\n');
            }
        }
        AtomicFile.write(out.file("losses.csv"), csv);
        HtmlWriter.write(page(), out.file("report.html"));
    }

    /** The result in a few lines. */
    public String summary() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < result.losses().size(); i++) {
            Losses last = last(i);
            text.append(String.format(Locale.ROOT, "%s %d: loss %.4f, held back %.4f, standardised RMSE %.4f%n",
                    order.architecture().word(), i + 1, last.train(), last.held(), last.rmse()));
        }
        return text.toString();
    }

    /** What came out of one member. */
    private record Member(String network, double train_loss, double held_back_loss, double held_back_standardised_rmse, int epochs) {}

    private record Results(List<Member> members, Map<String, String> provenance) {}

    /** The same for machines. */
    public String json() throws IOException {
        List<Member> members = new ArrayList<>();
        for (int i = 0; i < result.losses().size(); i++) {
            Losses last = last(i);
            members.add(new Member(order.architecture().word(), last.train(), last.held(), last.rmse(), result.losses().get(i).size()));
        }
        return ResultsJson.render(new Results(members, provenance));
    }

    private Losses last(int member) {
        List<Losses> losses = result.losses().get(member);
        return losses.get(losses.size() - 1);
    }

    private Page page() {
        double best = result.losses().stream().mapToDouble(each -> each.get(each.size() - 1).rmse()).min().orElseThrow();
        List<Block> blocks = new ArrayList<>();
        blocks.add(new Lead("On trials held back the network errs by " + Digits.significant(best, 3)
                + " standard deviations of what it was asked, over all targets."));
        blocks.add(new Figures(Figures.Figure.of("Images", order.data().images(), ""), Figures.Figure.of("held back",
                result.held(), ""), Figures.Figure.of("Epochs", order.settings().epochs(), ""),
                Figures.Figure.of("Members", order.members(), ""),
                Figures.Figure.of("Size of the model", result.model().bytes().length / 1024.0, "KiB")));
        return new Page("Training of the network '" + order.architecture().word() + "'", order.data().title(), List.of(
                new Section("Finding", "", blocks),
                new Section("Loss over the epochs",
                        "What was learned from (lines) and what was held back (dashed). Where the lines "
                                + "fall and the dashes do not, the network learns its trials by heart.",
                        new Beside(
                                curves("Loss", Losses::train, Losses::held), rmse())),
                new Section("Card", "What the model's file says of itself.", table(result.model().card())),
                new Section("Provenance", "The same seeds, options and version give the same network on the same kind of "
                        + "processor.", table(provenance))));
    }

    private LineChart curves(String title, ToDoubleFunction<Losses> train, ToDoubleFunction<Losses> held) {
        List<Series> series = new ArrayList<>();
        for (int i = 0; i < result.losses().size(); i++) {
            String name = result.losses().size() == 1 ? "" : " " + (i + 1);
            series.add(Series.line("learned from" + name, epochs(i), values(i, train)));
            series.add(Series.dashed("held back" + name, epochs(i), values(i, held)));
        }
        return new LineChart(title, ChartAxis.linear("Epoch", ""), ChartAxis.linear(title, ""), series);
    }

    private LineChart rmse() {
        List<Series> series = new ArrayList<>();
        for (int i = 0; i < result.losses().size(); i++) {
            series.add(Series.line("held back" + (result.losses().size() == 1 ? "" : " " + (i + 1)), epochs(i),
                    values(i, Losses::rmse)));
        }
        return new LineChart("Standardised root mean square error", ChartAxis.linear("Epoch", ""), ChartAxis.log("RMSE", ""), series);
    }

    private double[] epochs(int member) {
        double[] epochs = new double[result.losses().get(member).size()];
        Arrays.setAll(epochs, i -> i + 1);
        return epochs;
    }

    private double[] values(int member, ToDoubleFunction<Losses> what) {
        return result.losses().get(member).stream().mapToDouble(what).toArray();
    }

    private static Table table(Map<String, String> entries) {
        return new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                entries.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList());
    }
}
