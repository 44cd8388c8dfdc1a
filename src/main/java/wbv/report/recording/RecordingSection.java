package wbv.report.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import wbv.recording.Channel;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.Relay;
import wbv.report.page.Block;
import wbv.report.page.Findings;
import wbv.report.page.Folded;
import wbv.report.page.Section;
import wbv.report.page.Table;
import wbv.result.Digits;
import wbv.study.FoldedFindings;

/** What was read and what is wrong with it, as every report on a recording says it. */
public final class RecordingSection {

    private RecordingSection() {}

    /**
     * The section.
     *
     * @param relay what was done to the rows
     */
    public static Section of(Inspection seen, Relay relay) {
        Set<String> all = seen.summaries().keySet().stream().map(Channel::location).collect(Collectors.toSet());
        List<FoldedFindings.Line> findings = FoldedFindings.of(seen, all);
        List<Block> blocks = new ArrayList<>(List.of(findings(findings,
                "Nothing is wrong with the recording that a look at every sample could find.")));
        if (findings.size() < seen.findings().size()) {
            blocks.add(new Folded("All notes, one by one: " + seen.findings().size(), findings(FoldedFindings.each(seen), "")));
        }
        blocks.add(new Folded("All " + seen.summaries().size() + " channels: mean, r.m.s., range, missing samples", channels(seen)));
        return new Section("Recording", relay.sentence(), blocks);
    }

    /**
     * What was found, as a block.
     *
     * @param none what is said when there is nothing to report
     */
    public static Findings findings(List<FoldedFindings.Line> lines, String none) {
        return new Findings(
                lines.stream().map(line -> new Findings.Finding(Findings.Severity.valueOf(line.severity().name()), line.message(),
                        line.advice())).toList(),
                none);
    }

    /** What every channel amounts to. */
    public static Table channels(Inspection seen) {
        List<List<String>> rows = new ArrayList<>();
        seen.summaries().forEach((channel, s) -> rows.add(List.of(channel.toString(), channel.quantity().unit(),
                Digits.significant(s.mean(), 3), Digits.significant(s.rms(), 3), Digits.significant(s.min(), 3),
                Digits.significant(s.max(), 3), Long.toString(s.missing()))));
        return new Table("", List.of(Table.Column.words("Channel"), Table.Column.words("Unit"), Table.Column.numbers("Mean"),
                Table.Column.numbers("RMS about mean"), Table.Column.numbers("Min"), Table.Column.numbers("Max"),
                Table.Column.numbers("Missing")), rows);
    }
}
