package wbv.report.poles;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import wbv.filter.model.Bounds.Attribute;
import wbv.pole.Attributes;
import wbv.pole.Chord;
import wbv.pole.ConstraintPolygon;
import wbv.pole.Density;
import wbv.pole.PlaceClusters;
import wbv.pole.PoleLink;
import wbv.pole.PoleTraining;
import wbv.pole.RemovalCheck;
import wbv.pole.SensorRemoval;
import wbv.pole.TrainedPoles;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.report.page.Band;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.Chart;
import wbv.report.page.ChartAxis;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.report.page.Text;
import wbv.report.page.XyChart;
import wbv.report.page.XySeries;
import wbv.report.recording.Shades;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.study.PolesStudy;
import wbv.study.RemovalVerdict;

/** The report of trained poles: how they gather, what they bound, and how it serves on recordings that took no part. */
public final class PolesPage {

    /** Stretch of the time histories that is drawn [s]. */
    private static final double SHOWN = 10;

    private final PolesStudy study;
    private final PoleTraining.Result result;
    private final TrainedPoles trained;
    private final List<PolesStudy.HeldBack> heldBack;
    private final Map<String, String> provenance;

    private PolesPage(PolesStudy study, Map<String, String> provenance) {
        this.study = study;
        this.result = study.result();
        this.trained = result.trained();
        this.heldBack = study.heldBack();
        this.provenance = provenance;
    }

    /** Writes {@code report.html}. */
    public static void write(PolesStudy study, Map<String, String> provenance, OutputFolder out) throws IOException {
        HtmlWriter.write(new PolesPage(study, provenance).page(), out.file("report.html"));
    }

    private Page page() {
        List<Section> sections = new ArrayList<>(List.of(finding(), clusters(), distances(), polygons()));
        if (!heldBack.isEmpty()) {
            sections.add(overTime());
            sections.add(against());
        }
        sections.add(new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")),
                        provenance.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList())));
        return new Page("Poles of " + trained.layout().measured().location() + " for " + String.join(", ",
                trained.layout().absent().stream().map(Channel::location).toList()), trained.trials().size()
                        + " recordings trained on, "
                        + heldBack.size() + " held back",
                sections);
    }

    private Section finding() {
        PlaceClusters measured = result.places().get(0);
        List<Block> blocks = new ArrayList<>();
        blocks.add(new Lead(RemovalVerdict.sentence(study.verdicts(), heldBack.size())));
        blocks.add(new Text(String.format(Locale.ROOT, "The pole of %s lies about %.2f Hz.", trained.layout().measured().location(),
                trained.typical().frequency())));
        List<List<String>> rows = new ArrayList<>();
        for (PlaceClusters place : result.places()) {
            rows.add(List.of(place.place().toString(), Integer.toString(place.poles().size()), Integer.toString(place.count()),
                    Integer.toString(place.members(Density.NOISE).size()), Integer.toString(number(place.optics())),
                    Integer.toString(number(place.mixture())), Digits.significant(place.curve().epsilon(), 3)));
        }
        blocks.add(new Table("Poles and how they gather", List.of(Table.Column.words("Place"), Table.Column.numbers("Poles"),
                Table.Column.numbers("DBSCAN clusters"), Table.Column.numbers("Noise"), Table.Column.numbers("OPTICS clusters"),
                Table.Column.numbers("EM components"), Table.Column.numbers("Epsilon [spreads]")), rows));
        if (!heldBack.isEmpty()) {
            blocks.add(checks());
        }
        blocks.add(new Text(measured.members(measured.largest()).size() + " windows of " + trained.windows().length()
                + " s hold the main pole of the place that stays measured."));
        return new Section("Finding", "", blocks);
    }

    private static int number(int[] labels) {
        return Arrays.stream(labels).max().orElse(-1) + 1;
    }

    private Table checks() {
        List<List<String>> rows = new ArrayList<>();
        for (PolesStudy.HeldBack held : heldBack) {
            for (RemovalCheck check : held.checks()) {
                rows.add(List.of(check.name(), check.channel().toString(), Digits.significant(check.error(), 3),
                        Digits.significant(check.meanError(), 3), check.frequencyOff().map(off -> Digits.rounded(off, 2))
                                .orElse("–"),
                        check.magnitudeOff().map(off -> Digits.rounded(off, 2)).orElse("–"),
                        Digits.rounded(100 * held.prediction().inside(), 0) + " %"));
            }
        }
        return new Table("Recordings that took no part", List.of(Table.Column.words("Recording"), Table.Column.words("Channel"),
                Table.Column.numbers("Error over variance"), Table.Column.numbers("Population's mean body"),
                Table.Column.numbers("Peak off [Hz]"), Table.Column.numbers("Peak off [ratio]"),
                Table.Column.numbers("Polygons cut inside")), rows);
    }

    private Section clusters() {
        List<Block> blocks = new ArrayList<>();
        for (PlaceClusters place : result.places()) {
            XyChart dbscan = poles("Poles of " + place.place() + ", DBSCAN", place, place.dbscan());
            if (place == result.places().get(0)) {
                List<XySeries> series = new ArrayList<>(List.of(area("outline of the main cluster", trained.outline())));
                series.addAll(dbscan.series());
                dbscan = new XyChart(dbscan.title(), dbscan.x(), dbscan.y(), series);
            }
            blocks.add(new Beside(dbscan, poles("OPTICS, cut at the same epsilon", place, place.optics()),
                    poles("Weka's EM", place, place.mixture())));
        }
        return new Section("Poles by cluster",
                "The s-plane: every point is a pole of one window. A sitter who softens moves his poles along "
                        + "an arc; density clusters follow it, a mixture cuts it into ellipses.",
                blocks);
    }

    private static XyChart poles(String title, PlaceClusters place, int[] labels) {
        List<XySeries> series = new ArrayList<>();
        for (int label = Density.NOISE; label <= number(labels) - 1; label++) {
            int wanted = label;
            int[] members = java.util.stream.IntStream.range(0, labels.length).filter(i -> labels[i] == wanted).toArray();
            if (members.length > 0) {
                series.add(new XySeries(label == Density.NOISE ? "noise" : "cluster " + label,
                        Arrays.stream(members).mapToDouble(i -> place.poles().get(i).re()).toArray(),
                        Arrays.stream(members).mapToDouble(i -> place.poles().get(i).im()).toArray(),
                        XySeries.Style.CLOUD).coloured(label == Density.NOISE ? 7 : label % 7));
            }
        }
        return new XyChart(title, ChartAxis.linear("Re s", "rad/s"), ChartAxis.linear("Im s", "rad/s"), series);
    }

    private static XySeries area(String name, ConstraintPolygon polygon) {
        return new XySeries(name, polygon.x(), polygon.y(), XySeries.Style.AREA);
    }

    private Section distances() {
        List<Block> blocks = new ArrayList<>();
        for (PlaceClusters place : result.places()) {
            double[] rank = new double[place.curve().distance().length];
            Arrays.setAll(rank, i -> i);
            blocks.add(new LineChart("Distance to neighbour " + place.curve().k() + ", " + place.place(),
                    ChartAxis.linear("Poles, by distance", ""),
                    ChartAxis.linear("Distance", "spreads"), List.of(Series.line("distance", rank, place.curve().distance())))
                    .marked(List.of(new LineChart.Marker(place.curve().knee(), "epsilon "
                            + Digits.significant(place.curve().epsilon(), 3)))));
        }
        return new Section("Choice of epsilon", "Epsilon is where the curve of distances bends: what lies further out is noise.",
                blocks);
    }

    private Section polygons() {
        List<Block> blocks = new ArrayList<>();
        for (PoleLink link : trained.links()) {
            if (!link.kind().equals(PoleLink.BODY)) {
                continue;
            }
            List<Chart> charts = new ArrayList<>();
            for (ConstraintPolygon polygon : link.polygons()) {
                boolean drawn = polygon.measured() == Attribute.FREQUENCY || polygon.measured() == polygon.absent();
                if (drawn) {
                    charts.add(new XyChart(link.absent().location() + ": " + word(polygon.absent()) + " over "
                            + trained.layout().measured().location() + "'s " + word(polygon.measured()),
                            axis(polygon.measured(),
                                    trained.layout().measured()),
                            axis(polygon.absent(), link.absent()), List.of(area("polygon", polygon),
                                    together(link.absent(), polygon))));
                }
            }
            for (int i = 0; i < charts.size(); i += 2) {
                blocks.add(i + 1 < charts.size() ? new Beside(charts.get(i), charts.get(i + 1)) : charts.get(i));
            }
        }
        return new Section("Constraint polygons",
                "Where an attribute of the measured pole (across) and one of the absent place's body (up) were "
                        + "seen together: alpha shapes of radius " + ConstraintPolygon.ALPHA
                        + " spread. The value measured now cuts the polygon; the "
                        + "chord is the bound. All " + trained.links().stream().mapToInt(link -> link.polygons().size()).sum()
                        + " polygons are in polygons.json.",
                blocks);
    }

    /** The windows that a polygon was drawn around. */
    private XySeries together(Channel absent, ConstraintPolygon polygon) {
        PoleTraining.Pairs pairs = result.pairs().stream().filter(each -> each.absent().equals(absent)).findFirst()
                .orElseThrow();
        return new XySeries("seen together, one window each",
                pairs.measured().stream().mapToDouble(pole -> Attributes.of(pole, polygon.measured())).toArray(),
                pairs.bodies().stream().mapToDouble(body -> Attributes.of(body, polygon.absent())).toArray(),
                XySeries.Style.CLOUD);
    }

    private static String word(Attribute attribute) {
        return switch (attribute) {
            case FREQUENCY -> "natural frequency";
            case DAMPING -> "damping ratio";
            case REAL -> "real part";
            case IMAGINARY -> "imaginary part";
            case BASE_SHARE -> "share of damping against the base";
            case OUTPUT -> "output";
        };
    }

    private static ChartAxis axis(Attribute attribute, Channel channel) {
        return ChartAxis.linear(channel.location() + ", " + word(attribute), Attributes.unit(attribute));
    }

    private Section overTime() {
        PolesStudy.HeldBack held = heldBack.get(0);
        List<Block> blocks = new ArrayList<>();
        List<SensorRemoval.Seen> seen = held.prediction().seen();
        double[] time = seen.stream().mapToDouble(SensorRemoval.Seen::time).toArray();
        for (Channel absent : trained.layout().absent()) {
            for (Attribute attribute : List.of(Attribute.FREQUENCY, Attribute.DAMPING)) {
                int index = Attributes.OF_A_BODY.indexOf(attribute);
                List<Chord> chords = seen.stream().map(each -> each.bounds().get(absent).get(index)).toList();
                Band band = new Band(Band.Kind.UNCERTAINTY, chords.stream().mapToDouble(Chord::lower).toArray(),
                        chords.stream().mapToDouble(Chord::upper).toArray(), "bounds");
                double[] mean = new double[time.length];
                Arrays.fill(mean, Attributes.of(trained.bodies().get(absent), attribute));
                blocks.add(new LineChart(absent + ", " + word(attribute), ChartAxis.linear("Time", "s"), ChartAxis.linear(word(attribute),
                        Attributes.unit(attribute)),
                        List.of(Series.line("middle of the chord", time,
                                chords.stream().mapToDouble(Chord::middle).toArray()).with(band),
                                Series.dashed("population's mean", time, mean)))
                        .grouped("bounds"));
            }
        }
        return new Section("The constraint at work", "On " + held.name() + ", without the sensors of "
                + String.join(", ", trained.layout().absent().stream().map(Channel::location).toList()) + ".", blocks);
    }

    private Section against() {
        PolesStudy.HeldBack held = heldBack.get(0);
        List<Block> blocks = new ArrayList<>();
        double rate = held.recording().clock().rate();
        for (RemovalCheck check : held.checks()) {
            int to = held.recording().length();
            int from = Math.max(check.from(), to - (int) (SHOWN * rate));
            double[] time = new double[to - from];
            Arrays.setAll(time, i -> held.recording().clock().time(from + i));
            double[] truth = Arrays.copyOfRange(held.recording().values(check.channel()), from, to);
            double[] said = Arrays.copyOfRange(held.prediction().motion().get(check.channel()), from, to);
            double level = Arrays.stream(truth).filter(Double::isFinite).average().orElse(0);
            Arrays.setAll(truth, i -> truth[i] - level);
            blocks.add(new LineChart(check.channel() + ", last seconds", ChartAxis.linear("Time", "s"), ChartAxis.linear("Acceleration",
                    "m/s²"),
                    List.of(Series.line("held back", time, truth), Series.dashed("predicted", time, said))));
            blocks.add(new LineChart(check.channel() + ", transmissibility from " + trained.layout().base(),
                    ChartAxis.linear("Frequency", "Hz")
                            .within(0.5, 15),
                    ChartAxis.linear("|H1|", ""), List.of(
                            Series.line("held back", check.measured().frequency(), check.measured().h1().magnitudes()),
                            Series.dashed("predicted", check.said().frequency(), check.said().h1().magnitudes())))
                    .shaded(Shades.of(check.measured().backing(), check.measured().frequency(), false)));
        }
        return new Section("Predicted against held back", "On " + held.name() + ".", blocks);
    }
}
