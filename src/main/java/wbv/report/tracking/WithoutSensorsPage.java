package wbv.report.tracking;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import wbv.filter.model.Bounds.Attribute;
import wbv.pole.Attributes;
import wbv.pole.Chord;
import wbv.pole.SensorRemoval;
import wbv.pole.TrainedPoles;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.report.page.Band;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.result.OutputFolder;
import wbv.study.WithoutSensors;

/** The report of a recording without some of its sensors. */
public final class WithoutSensorsPage {

    private WithoutSensorsPage() {}

    /**
     * Writes {@code report.html}.
     *
     * @param provenance what, and from what, this was made, in the order in which it is shown
     */
    public static void write(WithoutSensors run, Map<String, String> provenance, OutputFolder out) throws IOException {
        HtmlWriter.write(page(run, provenance), out.file("report.html"));
    }

    private static Page page(WithoutSensors run, Map<String, String> provenance) {
        TrainedPoles trained = run.trained();
        Recording recording = run.recording();
        SensorRemoval.Prediction prediction = run.prediction();
        List<Channel> absent = run.absent();
        List<Section> sections = new ArrayList<>();
        List<Block> blocks = new ArrayList<>(List.of(new Lead(run.finding())));
        double[] time = prediction.seen().stream().mapToDouble(SensorRemoval.Seen::time).toArray();
        for (Channel channel : absent) {
            for (Attribute attribute : List.of(Attribute.FREQUENCY, Attribute.DAMPING)) {
                int index = Attributes.OF_A_BODY.indexOf(attribute);
                List<Chord> chords = prediction.seen().stream().map(seen -> seen.bounds().get(channel).get(index)).toList();
                double[] followed = prediction.seen().stream()
                        .mapToDouble(seen -> run.at(channel, attribute, (int) seen.sample())).toArray();
                blocks.add(new LineChart(channel.location() + ", " + (index == 0 ? "natural frequency" : "damping ratio"),
                        ChartAxis.linear("Time", "s"), ChartAxis.linear(index == 0 ? "Natural frequency" : "Damping ratio",
                                Attributes.unit(attribute)),
                        List.of(Series.line("constrained estimator", time, followed).with(new Band(Band.Kind.UNCERTAINTY,
                                chords.stream().mapToDouble(Chord::lower).toArray(), chords.stream().mapToDouble(Chord::upper)
                                        .toArray(),
                                "polygons' bounds"))))
                        .grouped("time"));
            }
        }
        sections.add(new Section("The constraint at work", "Bounds that the pole of " + trained.layout().measured().location()
                + " sets, and the estimator within them; no sample of the absent sensors was used.", blocks));
        List<Block> motions = new ArrayList<>();
        int from = Math.max(0, recording.length() - (int) (10 * recording.clock().rate()));
        double[] last = new double[recording.length() - from];
        Arrays.setAll(last, i -> recording.clock().time(from + i));
        for (Channel channel : absent) {
            List<Series> series = new ArrayList<>();
            if (recording.has(channel)) {
                series.add(Series.line("the sensor, for comparison", last, Arrays.copyOfRange(recording.values(channel), from,
                        recording.length())));
            }
            series.add(Series.dashed("predicted", last, Arrays.copyOfRange(prediction.motion().get(channel), from,
                    recording.length())));
            motions.add(new LineChart(channel + ", last seconds", ChartAxis.linear("Time", "s"), ChartAxis.linear("Acceleration", "m/s²"),
                    series));
        }
        sections.add(new Section("Predicted motion", "All of it is in prediction.csv.", motions));
        sections.add(new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                        provenance.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList())));
        return new Page(run.name() + " without " + String.join(", ", absent.stream().map(Channel::location).toList()), prediction.seen()
                .size()
                + " poles seen, " + prediction.lost() + " windows lost", sections);
    }
}
