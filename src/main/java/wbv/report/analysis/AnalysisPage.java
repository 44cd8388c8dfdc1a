package wbv.report.analysis;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import wbv.recording.Channel;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;
import wbv.report.page.Beside;
import wbv.report.page.Block;
import wbv.report.page.Code;
import wbv.report.page.Folded;
import wbv.report.page.HtmlWriter;
import wbv.report.page.Lead;
import wbv.report.page.Page;
import wbv.report.page.Section;
import wbv.report.page.Table;
import wbv.report.recording.RecordingSection;
import wbv.report.recording.SensorsSeen;
import wbv.result.Digits;
import wbv.result.OutputFolder;
import wbv.study.Analysis;
import wbv.study.FoldedFindings;
import wbv.study.FollowedBody;
import wbv.study.Headline;

/** The report of an analysis: the finding, then pictures, then what they rest on. */
public final class AnalysisPage {

    private static final int MOST_FINDINGS = 3;

    private final Analysis analysis;
    private final AnalysisCharts charts;

    AnalysisPage(Analysis analysis) {
        this.analysis = analysis;
        this.charts = new AnalysisCharts(analysis);
    }

    /** Writes {@code report.html}. */
    public static void write(Analysis analysis, OutputFolder out) throws IOException {
        HtmlWriter.write(new AnalysisPage(analysis).page(), out.file("report.html"));
    }

    private Page page() {
        Inspection seen = analysis.inspection();
        long sensors = seen.summaries().keySet().stream().map(Channel::location).distinct().count();
        String subtitle = Digits.significant(seen.duration(), 4) + " s at " + Digits.significant(seen.clock().rate(), 5) + " Hz, "
                + seen.summaries().size() + " channels of " + sensors + (sensors == 1 ? " sensor" : " sensors")
                + analysis.metadata().source().map(source -> " — " + source.split(";")[0]).orElse("");
        List<Section> sections = new ArrayList<>(List.of(glance(), transmissibility(), spectra(), bodies(), signals(), spectrograms(),
                sensors(), details()));
        return new Page("Vibration of " + analysis.request().title(), subtitle, sections);
    }

    private Section glance() {
        List<Block> blocks = new ArrayList<>(List.of(new Lead(new Headline(analysis).sentence()), new AnalysisTiles(analysis).all()));
        List<FoldedFindings.Line> grave = analysis.findings().stream().filter(each -> each.severity() != Severity.NOTE)
                .limit(MOST_FINDINGS).toList();
        if (!grave.isEmpty()) {
            blocks.add(RecordingSection.findings(grave, ""));
        }
        return new Section("At a glance", "", blocks);
    }

    private Section transmissibility() {
        List<Block> blocks = new ArrayList<>();
        int leading = analysis.leading();
        blocks.add(charts.modulus(leading));
        charts.phase(leading).ifPresent(phase -> blocks.add(new Beside(phase, charts.coherence(leading).orElseThrow())));
        int[] others = others();
        if (others.length > 0) {
            charts.everyPlace().ifPresent(blocks::add);
            List<Block> each = new ArrayList<>();
            for (int i : others) {
                each.add(charts.modulus(i));
                charts.phase(i).ifPresent(phase -> each.add(new Beside(phase, charts.coherence(i).orElseThrow())));
            }
            blocks.add(new Folded("Every other output by itself: modulus, phase and coherence", each));
        }
        return new Section("Transmissibility", "", blocks);
    }

    private Section spectra() {
        return new Section("Spectra", "Welch averages: Hann window, segments of "
                + Digits.significant(analysis.segmentation().duration(), 3) + " s overlapping by half, resolution "
                + Digits.significant(analysis.segmentation().resolution(), 2) + " Hz." + charts.weighted().map(channel -> " Broken: "
                        + channel + " as ISO 2631-1 weights it, " + "of which a_w is the root of the area.").orElse(""),
                charts.spectra());
    }

    private Section bodies() {
        List<Block> blocks = new ArrayList<>();
        blocks.addAll(charts.body(analysis.leading()));
        int[] others = others();
        if (others.length > 0) {
            blocks.add(bodyTable());
            List<Block> each = new ArrayList<>();
            for (int i : others) {
                each.addAll(charts.body(i));
            }
            blocks.add(new Folded("Every other output over time", each));
        }
        return new Section("Body over time",
                "A body of one degree of freedom as an extended Kalman filter follows it, whose memory ADWIN sets; "
                        + "a cut marks where the body, or what disturbs it, has changed. The band is ±2σ by how the estimate really "
                        + "scatters. The table is of the body that simulates the whole recording best.",
                blocks);
    }

    private Table bodyTable() {
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < analysis.followed().size(); i++) {
            FollowedBody followed = analysis.followed().get(i);
            BodyTile body = BodyTile.of(analysis.bodies().get(i));
            String peak = analysis.frequencyResponse(i).filter(h -> Headline.peak(h) >= 0).map(h -> Digits.significant(
                    h.h1().magnitude(Headline.peak(h)), 3) + " at " + Digits.significant(h.frequency()[Headline.peak(h)], 3) + " Hz")
                    .orElse("–");
            rows.add(List.of(followed.channel().toString(), body.frequencies(), body.dampings(), Double.isNaN(body.explained()) ? "–"
                    : BodyTile.percent(body.explained()), peak, body.remark()));
        }
        return new Table("The body between " + analysis.input() + " and each output, over the recording (± 2σ)",
                List.of(Table.Column.words("Output"), Table.Column.numbers("Natural frequency [Hz]"), Table.Column.numbers("Damping ratio"),
                        Table.Column.numbers("Explained"), Table.Column.numbers("Peak |H1|"), Table.Column.words("Remark")),
                rows);
    }

    private Section signals() {
        List<Block> blocks = new ArrayList<>();
        blocks.add(charts.history(analysis.input()));
        List<Block> folded = new ArrayList<>();
        for (int i : leadingFirst()) {
            Channel output = analysis.followed().get(i).channel();
            (analysis.shown(output) ? blocks : folded).add(charts.history(output));
        }
        analysis.states()
                .ifPresent(states -> blocks.add(new StateTile(states).chart(analysis.inspection().clock().start()).grouped("time")));
        if (!folded.isEmpty()) {
            blocks.add(new Folded("Every other output", folded));
        }
        int width = analysis.samplesAPoint();
        String zoom = "Zoom in down to single samples"
                + (width > 1 ? "; of the longest signals, to the range of " + width + " samples. " : ". ");
        return new Section(analysis.states().isPresent() ? "Signals and motion states" : "Signals",
                zoom + analysis.states().map(StateTile::new).map(StateTile::way).orElse(""), blocks);
    }

    private Section spectrograms() {
        return new Section("Spectrograms", "Power spectral density over time. Gaps of up to "
                + Digits.significant(analysis.pictured(), 2) + " s are bridged; hatched where more was lost in a row.",
                charts.spectrograms());
    }

    private Section sensors() {
        List<FoldedFindings.Line> findings = analysis.findings();
        return new Section("Sensors", "", SensorsSeen.of(analysis.inspection()),
                RecordingSection.findings(findings, "Nothing is wrong with the recording that a look at every sample could find."));
    }

    private Section details() {
        Inspection seen = analysis.inspection();
        Map<String, String> made = analysis.request().provenance();
        List<Block> blocks = new ArrayList<>();
        blocks.add(new Folded("All " + seen.summaries().size() + " channels: mean, r.m.s., range, missing samples",
                RecordingSection.channels(seen)));
        if (!seen.findings().isEmpty()) {
            blocks.add(new Folded("All notes, one by one: " + seen.findings().size(),
                    RecordingSection.findings(FoldedFindings.each(seen), "")));
        }
        blocks.add(new Folded("The same results again: command, version, checksums", new Table("", List.of(Table.Column.words("What"),
                Table.Column.words("Value")), made.entrySet().stream().map(entry -> List.of(entry.getKey(), entry.getValue())).toList()),
                new Code("The same estimate as a MOA task, for the output shown first:", analysis.taskString())));
        return new Section("Details",
                analysis.relay().sentence() + (made.containsKey("wbv") ? " Made by wbv " + made.get("wbv") + "." : ""), blocks);
    }

    private int[] others() {
        return IntStream.range(0, analysis.followed().size()).filter(i -> i != analysis.leading()).toArray();
    }

    /** The leading output, then the others in order. */
    private int[] leadingFirst() {
        return IntStream.concat(IntStream.of(analysis.leading()), IntStream.of(others())).toArray();
    }
}
