package wbv.report;

import java.util.ArrayList;
import java.util.List;
import wbv.recording.Inspection;
import wbv.recording.Relay;

/** What was read and what is wrong with it, as every report on a recording says it. */
final class RecordingSection {

    private RecordingSection() { }

    /** @param relay what was done to the rows */
    static Section of(Inspection seen, Relay relay) {
        List<Findings.Finding> findings = seen.findings().stream().map(f ->
                new Findings.Finding(Findings.Severity.valueOf(f.severity().name()), f.message(), f.advice())).toList();
        List<List<String>> rows = new ArrayList<>();
        seen.summaries().forEach((channel, s) -> rows.add(List.of(channel.toString(), channel.quantity().unit(),
                Digits.significant(s.mean(), 3), Digits.significant(s.rms(), 3), Digits.significant(s.min(), 3),
                Digits.significant(s.max(), 3), Long.toString(s.missing()))));
        Table table = new Table("Channels", List.of(Table.Column.words("Channel"), Table.Column.words("Unit"),
                Table.Column.numbers("Mean"), Table.Column.numbers("RMS about mean"), Table.Column.numbers("Min"),
                Table.Column.numbers("Max"), Table.Column.numbers("Missing")), rows);
        return new Section("Recording", relay.sentence(),
                new Findings(findings, "Nothing is wrong with the recording that a look at every sample could find."), table);
    }
}
