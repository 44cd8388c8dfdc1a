package wbv.report.response;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import wbv.recording.Channel;
import wbv.report.page.Band;
import wbv.report.page.Block;
import wbv.report.page.ChartAxis;
import wbv.report.page.Code;
import wbv.report.page.Figures;
import wbv.report.page.Heatmap;
import wbv.report.page.HtmlWriter;
import wbv.report.page.LineChart;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Series;
import wbv.report.page.Table;
import wbv.report.recording.RecordingSection;
import wbv.report.recording.Shades;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.signal.AbsorbedPower;
import wbv.signal.ApparentMass;
import wbv.signal.Backing;
import wbv.signal.ComplexSeries;
import wbv.signal.FrequencyResponse.Excited;
import wbv.signal.Peak;
import wbv.signal.ResponseMatrix;
import wbv.study.MeasuredResponse;
import wbv.study.ResponseAnalysis;
import wbv.study.ResponseCurve;
import wbv.study.Unbacked;

/** The report of frequency responses. */
public final class ResponsePage {

    private static final double LEAST_FREQUENCY = 0.3;
    private static final String ONE_INPUT = ". H1 is right where only the output is noisy, H2 where only the input is, Hv where both are "
            + "equally so; they agree where the coherence is near 1. ";
    private static final String SHADED = "Shaded frequencies are not to be used: either the input has too little power there, or it "
            + "has power, but other motion, noise or what is not linear makes the output (a low coherence).";
    private static final String SEVERAL_INPUTS = "From all inputs at once. The multiple coherence is what they explain together, a "
            + "partial one what one input adds to the others. ";

    private final ResponseAnalysis analysis;
    private final MeasuredResponse measured;
    private final List<ResponseCurve> curves;
    private final ResponseTables tables;
    private final int[] shown;
    private final double[] f;
    private final String percent;

    ResponsePage(ResponseAnalysis analysis) {
        this.analysis = analysis;
        this.measured = analysis.measured();
        this.curves = analysis.curves();
        this.tables = new ResponseTables(analysis);
        double[] all = measured.segmentation().frequencies();
        double least = Math.min(LEAST_FREQUENCY, 3 * all[1]);
        this.shown = IntStream.range(1, all.length).filter(k -> all[k] >= least).toArray();
        this.f = pick(all);
        this.percent = Digits.significant(100 * analysis.request().level(), 3) + " %";
    }

    /** Writes {@code report.html}. */
    public static void write(ResponseAnalysis analysis, OutputFolder out) throws IOException {
        HtmlWriter.write(new ResponsePage(analysis).page(), out.file("report.html"));
    }

    private Page page() {
        List<Section> sections = new ArrayList<>(List.of(summary()));
        measured.outputs().forEach(output -> sections.add(responses(of(output))));
        if (analysis.request().wavelet()) {
            sections.add(throughTime());
        }
        if (curves.stream().anyMatch(ResponseCurve::isApparentMass)) {
            sections.add(drivingPoint());
        }
        if (analysis.several()) {
            sections.add(people());
        }
        sections.add(inputs());
        sections.add(RecordingSection.of(measured.inspection(), measured.relay()));
        sections.add(provenance());
        return new Page("Frequency responses of " + analysis.request().title(), names(measured.inputs()) + " to "
                + names(measured.outputs()) + " — " + Digits.significant(measured.inspection().duration(), 4) + " s at "
                + Digits.significant(measured.segmentation().rate(), 5) + " Hz", sections);
    }

    private static String names(List<Channel> channels) {
        return channels.stream().map(Channel::toString).collect(Collectors.joining(", "));
    }

    private List<ResponseCurve> of(Channel output) {
        return curves.stream().filter(curve -> curve.output().equals(output)).toList();
    }

    private Section summary() {
        ResponseCurve first = leading();
        Peak highest = first.highest();
        List<Figures.Figure> figures = new ArrayList<>();
        if (Double.isFinite(highest.height())) {
            figures.add(new Figures.Figure((first.peak().isPresent() ? "peak of " : "highest of ") + first.output(),
                    Digits.significant(highest.height(), 3), first.unit().equals("1") ? "" : first.unit(),
                    "± " + Digits.significant(first.highestMargin(), 2)));
            figures.add(Figures.Figure.of("at", highest.frequency(), "Hz"));
        } else {
            figures.add(new Figures.Figure(first.output().toString(), "not usable", "", ""));
        }
        figures.add(Figures.Figure.of("coherence, median", first.typical(first.all().multipleCoherence(0)), ""));
        figures.add(new Figures.Figure("independent averages", Digits.significant(first.all().averages(), 3), "", ""));
        analysis.power(first).ifPresent(power -> figures.add(Figures.Figure.of("absorbed power", power.total(), "W")));
        boolean several = measured.inputs().size() > 1;
        List<Block> blocks = new ArrayList<>(List.of(new Figures(figures)));
        if (several) {
            blocks.add(tables.matrix());
        }
        blocks.add(tables.responses(percent));
        return new Section("Summary", "H1 from " + names(measured.inputs())
                + (several ? ", each input's part told apart from what the others do at the same time." : "."), blocks);
    }

    /** What is shown first: the head's answer upwards to its own axis, if there is one, else the first answer along one axis. */
    private ResponseCurve leading() {
        List<ResponseCurve> along = curves.stream().filter(curve -> curve.output().axis() == curve.input().axis()).toList();
        return along.stream().filter(curve -> curve.output().location().equals("head") && curve.output().axis() == 'z')
                .findFirst()
                .orElse(along.isEmpty() ? curves.get(0) : along.get(0));
    }

    private Section responses(List<ResponseCurve> those) {
        Channel output = those.get(0).output();
        boolean single = those.size() == 1;
        List<Series> moduli = new ArrayList<>();
        List<Series> phases = new ArrayList<>();
        List<Series> coherences = new ArrayList<>();
        Backing[] backing = pick(Unbacked.any(those.stream().map(ResponseCurve::backing).toList()));
        double top = 0;
        coherences.add(Series.line(single ? "γ²" : "multiple", f, pick(those.get(0).all().multipleCoherence(0))));
        for (ResponseCurve curve : those) {
            String from = single ? "" : ", from " + curve.input();
            double[] h1 = pick(curve.h1().magnitudes());
            boolean[] own = new boolean[f.length];
            for (int k = 0; k < f.length; k++) {
                own[k] = curve.usable()[shown[k]];
                top = own[k] ? Math.max(top, h1[k]) : top;
            }
            moduli.add(Series.line("H1" + from, f, h1).with(band(h1, pick(curve.margin()), own)));
            curve.bareH2().filter(h2 -> single).ifPresent(h2 -> moduli.add(Series.line("H2", f, pick(h2.magnitudes()))));
            if (single) {
                moduli.add(Series.line("Hv", f, pick(curve.hv().magnitudes())));
            }
            double[] angle = degrees(curve.h1());
            // A phase that may be anything has no band.
            double[] turn = Arrays.stream(pick(curve.phaseMargin()))
                    .map(a -> a < Math.PI ? Math.toDegrees(a) : Double.NaN).toArray();
            phases.add(Series.line("H1" + from, f, angle).with(band(angle, turn, own)));
            curve.model().ifPresent(model -> {
                moduli.add(Series.dashed("model" + from, f, pick(model.magnitudes())));
                phases.add(Series.dashed("model" + from, f, degrees(model)));
            });
            if (!single) {
                coherences.add(Series.line("partial, " + curve.input(), f, pick(curve.all().partialCoherence(0, curve.index()))));
            }
        }
        String group = "response " + output;
        String unit = those.stream().map(ResponseCurve::unit).distinct().count() == 1 ? those.get(0).unit() : "output/input";
        ChartAxis frequency = ChartAxis.log("Frequency", "Hz");
        ChartAxis modulus = ChartAxis.linear("Modulus", unit).within(0, top > 0 ? 1.2 * top : Double.NaN);
        String title = names(those.stream().map(ResponseCurve::input).toList()) + " to " + output;
        List<LineChart.Shade> shades = Shades.of(backing, f, !single);
        String why = Unbacked.sentence(Unbacked.any(those.stream().map(ResponseCurve::backing).toList()), shown[0], !single,
                measured.others(), measured.outputs().indexOf(output));
        ResponseMatrix all = those.get(0).all();
        return new Section(output.toString(), (single ? "From " + those.get(0).input() + ONE_INPUT : SEVERAL_INPUTS) + SHADED
                + (why.isEmpty() ? "" : " Here: " + why + "."),
                new LineChart(title, frequency, modulus, moduli).shaded(shades).grouped(group),
                new LineChart("Phase", frequency, ChartAxis.linear("Phase", "°"), phases).shaded(shades).grouped(group),
                new LineChart("Coherence", frequency, ChartAxis.linear("Coherence", "1").within(0, 1.02), coherences)
                        .shaded(shades).grouped(group)
                        .noted(Digits.significant(all.averages(), 3) + " independent averages of "
                                + Digits.significant(measured.segmentation().duration(), 3) + " s; bands hold " + percent
                                + ". Unrelated signals would show a coherence of "
                                + Digits.significant(those.get(0).coherenceByChance(), 2)
                                + " on average; it is believed from "
                                + Digits.significant(Excited.USUAL.leastCoherence(all.averages(), all.inputs()), 2) + "."));
    }

    private Band band(double[] values, double[] margin, boolean[] usable) {
        double[] shownMargin = margin.clone();
        for (int k = 0; k < shownMargin.length; k++) {
            shownMargin[k] = usable[k] ? shownMargin[k] : Double.NaN;
        }
        return Band.deviations(values, shownMargin, 1, percent);
    }

    private double[] degrees(ComplexSeries h) {
        return Arrays.stream(pick(h.phases())).map(Math::toDegrees).toArray();
    }

    private Section drivingPoint() {
        List<Block> blocks = new ArrayList<>();
        for (ResponseCurve curve : curves.stream().filter(ResponseCurve::isApparentMass).toList()) {
            ApparentMass mass = curve.apparentMass();
            OptionalDouble sitting = mass.sitting(curve.usable());
            AbsorbedPower power = analysis.power(curve).orElseThrow();
            blocks.add(new Figures(Figures.Figure.of("sitting mass, " + curve.output(), sitting.orElse(Double.NaN), "kg"),
                    Figures.Figure.of("absorbed power", power.total(), "W"),
                    Figures.Figure.of("plate taken off", curve.plate(), "kg")));
            List<LineChart.Shade> shades = Shades.of(pick(curve.backing()), f, measured.inputs().size() > 1);
            String group = "driving point " + curve.name();
            sitting.ifPresent(kilograms -> blocks.add(chart("Normalised apparent mass, " + curve.output(),
                    "|M| over sitting mass", "1",
                    mass.normalised(kilograms), shades, group)));
            blocks.add(chart("Driving-point impedance, " + curve.output(), "|Z|", "N·s/m", mass.impedance().magnitudes(), shades,
                    group));
            blocks.add(new LineChart("Absorbed power, " + curve.output(), ChartAxis.log("Frequency", "Hz"),
                    ChartAxis.linear("Power", "W/Hz"),
                    List.of(Series.line("Re G_Fv", f, pick(power.density())))).grouped(group)
                    .noted("With its sign: positive is taken in. Along the axis of this input, whatever else acts."));
        }
        return new Section("Driving point",
                "The apparent mass is the force over the acceleration at the seat; the sitting mass is its "
                        + "modulus near 0.5 Hz. The absorbed power is the mean of force times velocity, by frequency.",
                blocks);
    }

    private LineChart chart(String title, String label, String unit, double[] values, List<LineChart.Shade> shades, String group) {
        return new LineChart(title, ChartAxis.log("Frequency", "Hz"), ChartAxis.linear(label, unit), List.of(Series.line("H1", f,
                pick(values)))).shaded(shades).grouped(group);
    }

    private Section throughTime() {
        List<Block> blocks = new ArrayList<>();
        for (ResponseCurve curve : curves) {
            analysis.through(curve.output()).ifPresent(through -> {
                blocks.add(new Heatmap(curve.name(), ChartAxis.linear("Time", "s"), ChartAxis.linear("Frequency", "Hz"),
                        ChartAxis.linear("Modulus", curve.unit()).within(0, Double.NaN), through.times(), through.frequencies(),
                        through.backed())
                        .grouped("through time"));
                blocks.add(new LineChart("Peak of " + curve.name(), ChartAxis.linear("Time", "s"), ChartAxis.linear("Frequency", "Hz"),
                        List.of(Series.line("peak", through.times(), through.ridge()))).grouped("through time"));
            });
        }
        return new Section("Through time", "By Morlet's wavelet of six radians, averaged over eight of its standard deviations about "
                + "each moment: what moves while the record lasts, a mean over the record would smear. Holes: the coherence could be "
                + "chance (once in twenty times), samples are missing, the record ends too near, or the input has no power there.", blocks);
    }

    private Section people() {
        List<Block> blocks = new ArrayList<>(List.of(tables.people()));
        for (int c = 0; c < curves.size(); c++) {
            ResponseCurve curve = curves.get(c);
            analysis.mean(c).ifPresent(mean -> blocks.add(new LineChart(curve.name(), ChartAxis.log("Frequency", "Hz"),
                    ChartAxis.linear(curve.isApparentMass() ? "Modulus over the sitting mass" : "Modulus",
                            curve.isApparentMass() ? "1" : curve.unit()),
                    List.of(Series.line("mean, peaks aligned", f, pick(mean.mean())).with(Band.deviations(pick(mean.mean()),
                            pick(mean.deviation()), 1, "±σ of people")),
                            Series.dashed("plain mean of curves", f, pick(mean.plain()))))));
        }
        return new Section("People",
                "Each curve is stretched so that its peak stands at the mean peak frequency before the mean is "
                        + "taken. The plain mean of the curves smears resonances that differ from person to person.",
                blocks);
    }

    private Section inputs() {
        List<Series> densities = new ArrayList<>();
        List<Series> among = new ArrayList<>();
        for (int i = 0; i < measured.inputs().size(); i++) {
            densities.add(Series.line(measured.inputs().get(i).toString(), f, pick(measured.response(0).inputDensity(i))));
            among.add(Series.line(measured.inputs().get(i).toString(), f, pick(measured.response(0).coherenceAmongInputs(i))));
        }
        List<Block> blocks = new ArrayList<>();
        String unit = measured.inputs().stream().map(input -> input.quantity().unit()).distinct().count() == 1
                ? "(" + measured.inputs().get(0).quantity().unit() + ")²/Hz" : "unit²/Hz";
        blocks.add(new LineChart("Power spectral density", ChartAxis.log("Frequency", "Hz"), ChartAxis.log("Density", unit), densities)
                .grouped("inputs"));
        if (among.size() > 1) {
            blocks.add(new LineChart("What the other inputs explain of each", ChartAxis.log("Frequency", "Hz"),
                    ChartAxis.linear("Coherence", "1").within(0, 1.02), among).grouped("inputs")
                    .noted("Where this is near 1 the inputs move as one and their answers cannot be told apart."));
        }
        return new Section("Inputs",
                String.format(Locale.ROOT, "Welch averages: Hann window, segments of %.3g s overlapping by half, "
                        + "resolution %.2g Hz; %d missing samples bridged.", measured.segmentation().duration(),
                        measured.segmentation().resolution(), measured.bridged()),
                blocks);
    }

    private Section provenance() {
        List<List<String>> rows = new ArrayList<>();
        analysis.request().skin().forEach((place, skin) -> rows.add(List.of("skin under " + place,
                Digits.significant(skin.frequency(), 4)
                        + " Hz, damping ratio " + Digits.significant(skin.damping(), 3) + ", taken out")));
        analysis.request().model().ifPresent(model -> rows.add(List.of("model", model.name() + ": its linear part is drawn")));
        analysis.request().provenance().forEach((name, value) -> rows.add(List.of(name, value)));
        return new Section("Provenance", "The same inputs, options and version give the same results.",
                new Table("", List.of(Table.Column.words("What"), Table.Column.words("Value")), rows),
                new Code("The first output as a MOA task, over time:", analysis.taskString()));
    }

    private Backing[] pick(Backing[] values) {
        return Arrays.stream(shown).mapToObj(k -> values[k]).toArray(Backing[]::new);
    }

    private double[] pick(double[] values) {
        return Arrays.stream(shown).mapToDouble(k -> values[k]).toArray();
    }
}
