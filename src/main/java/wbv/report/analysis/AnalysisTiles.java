package wbv.report.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import wbv.recording.Channel;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Severity;
import wbv.recording.inspect.Summary;
import wbv.report.page.Gauge;
import wbv.report.page.Tiles;
import wbv.result.Digits;
import wbv.signal.FrequencyResponse;
import wbv.study.Analysis;
import wbv.study.FoldedFindings;
import wbv.study.FollowedBody;
import wbv.study.Headline;
import wbv.study.JudgedExposure;
import wbv.study.PublishedRange;

/** The tiles of an analysis: exposure, transmissibility, body, motion states, data. What a recording does not tell has none. */
final class AnalysisTiles {

    private static final Set<String> SAT_ON = Set.of("seat", "platform", "floor");
    private static final int MOST_LINES = 3;

    private final Analysis analysis;

    AnalysisTiles(Analysis analysis) {
        this.analysis = analysis;
    }

    Tiles all() {
        List<Tiles.Tile> tiles = new ArrayList<>();
        exposure().ifPresent(tiles::add);
        tiles.add(transmissibility());
        FollowedBody leading = analysis.followed().get(analysis.leading());
        tiles.add(BodyTile.of(analysis.bodies().get(analysis.leading()))
                .tile(analysis.input().location() + " to " + leading.channel().location()));
        analysis.states().ifPresent(states -> tiles.add(new StateTile(states).tile()));
        tiles.add(data());
        return new Tiles(tiles);
    }

    private Optional<Tiles.Tile> exposure() {
        if (analysis.exposure().isPresent()) {
            return analysis.exposure().map(measured -> new ExposureTile(new JudgedExposure(measured)).tile());
        }
        boolean seat = analysis.inspection().summaries().keySet().stream().map(Channel::location).anyMatch(SAT_ON::contains);
        return seat ? Optional.of(new Tiles.Tile("Exposure", "not measured", "", Gauge.NONE,
                List.of("The recording " + analysis.noExposure() + "."), Tiles.Tone.PLAIN)) : Optional.empty();
    }

    private Tiles.Tile transmissibility() {
        Channel output = analysis.followed().get(analysis.leading()).channel();
        String path = analysis.input() + " to " + output;
        Optional<FrequencyResponse> response = analysis.frequencyResponse(analysis.leading());
        if (response.isEmpty() || Headline.peak(response.get()) < 0) {
            return new Tiles.Tile("Transmissibility", "no peak", "", Gauge.NONE, List.of(response.isEmpty()
                    ? "No stretch of " + Digits.significant(analysis.segmentation().duration(), 3) + " s is whole."
                    : "At no frequency does the input explain the output.", path + "."), Tiles.Tone.WARNING);
        }
        FrequencyResponse h = response.get();
        int at = Headline.peak(h);
        double peak = h.h1().magnitude(at);
        double spread = 2 * peak * h.error()[at];
        List<String> lines = new ArrayList<>();
        lines.add("± " + Digits.roundedUp(spread, 2) + "; coherence " + Digits.rounded(h.coherence()[at], 2) + ".");
        lines.add(path + ", H1.");
        Optional<PublishedRange> published = PublishedRange.of(analysis.input(), output, analysis.segmentation());
        List<Gauge.Range> ranges = new ArrayList<>();
        published.ifPresent(range -> {
            ranges.add(new Gauge.Range(range.leastPeak(), range.greatestPeak(), "published", range.words()));
            lines.add("Grey: " + range.shortly() + ".");
        });
        boolean ratio = analysis.input().quantity().unit().equals(output.quantity().unit());
        Gauge gauge = ratio ? new Gauge(0, Math.max(3, 1.2 * peak), ranges, List.of(new Gauge.Mark(1, "1")),
                List.of(new Gauge.Point(peak, peak - spread, peak + spread))) : Gauge.NONE;
        return new Tiles.Tile("Transmissibility", Digits.rounded(peak, 2), (ratio ? "" : output.quantity().unit() + "/("
                + analysis.input().quantity().unit() + ") ") + "at " + Digits.significant(h.frequency()[at], 2) + " Hz", gauge, lines,
                Tiles.Tone.PLAIN);
    }

    private Tiles.Tile data() {
        Inspection seen = analysis.inspection();
        List<FoldedFindings.Line> findings = analysis.findings();
        double present = seen.summaries().values().stream().mapToLong(Summary::count).sum();
        double all = present + seen.summaries().values().stream().mapToLong(Summary::missing).sum()
                + (seen.samples() - seen.rows() > 0 ? (double) (seen.samples() - seen.rows()) * seen.summaries().size() : 0);
        long sensors = seen.summaries().keySet().stream().map(Channel::location).distinct().count();
        long grave = findings.stream().filter(each -> each.severity() != Severity.NOTE).count();
        List<String> lines = new ArrayList<>();
        if (grave > 0) {
            lines.add(grave + (grave == 1 ? " warning, below." : " warnings, below."));
        }
        findings.stream().filter(each -> each.severity() == Severity.NOTE).limit(MOST_LINES)
                .forEach(each -> lines.add(BodyTile.capital(each.message()) + "."));
        if (findings.isEmpty()) {
            lines.add("Nothing is wrong that a look at every sample could find.");
        }
        lines.add(String.format(Locale.ROOT, "%d channels of %d sensor%s at %s Hz.", seen.summaries().size(), sensors,
                sensors == 1 ? "" : "s", Digits.significant(seen.clock().rate(), 5)));
        Severity worst = findings.isEmpty() ? Severity.NOTE : findings.get(0).severity();
        double share = 100 * present / all;
        return new Tiles.Tile("Data", share == 100 ? "100" : Digits.rounded(Math.min(share, 99.9), 1), "% of samples",
                new Gauge(0, 100, List.of(new Gauge.Range(0, share, "share", Digits.rounded(share, 1) + " % there")), List.of(), List.of()),
                lines, switch (worst) {
                    case NOTE -> Tiles.Tone.GOOD;
                    case WARNING -> Tiles.Tone.WARNING;
                    case FAULT -> Tiles.Tone.FAULT;
                });
    }
}
