package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import wbv.recording.Finding;
import wbv.recording.Inspection;
import wbv.recording.RecordingWriter;
import wbv.recording.RowReader;
import wbv.recording.RowSource;
import wbv.recording.Sidecar;
import wbv.recording.UniformReader;

/** {@code wbv convert}: any recording as CSV or ARFF with our channel names, on a uniform clock. */
@Command(name = "convert", mixinStandardHelpOptions = true,
        description = "Writes a recording as CSV, CSV.gz or ARFF with channel names and SI units, on a uniform clock, and says what it found.",
        footer = {"", "Examples:", "  wbv convert data/arff/ride-subject1.arff --out ride.csv.gz",
            "  wbv convert MT_*.txt --location 00B42235=head \\", "      --location 00B42236=platform --out ride.arff"})
final class Convert implements Callable<Integer> {

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--out", paramLabel = "FILE", required = true, description = "name of the new file, ending in .csv, .csv.gz or .arff")
    private Path out;

    @Option(names = "--as-is", description = "keep rows and times as they stand instead of laying them on a uniform clock")
    private boolean asIs;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        Sidecar.requireReplaceable(out);
        RowSource source = recording.source();
        try (ProgressBar bar = new ProgressBar()) {
            Inspection inspection = source.inspect(share -> bar.at("reading", share));
            String done;
            if (asIs) {
                try (RowReader reader = source.open()) {
                    done = write(reader, bar) + " rows as they stand.";
                }
            } else {
                try (UniformReader reader = source.uniform(inspection)) {
                    write(reader, bar);
                    done = reader.relay().sentence();
                }
            }
            bar.close();
            for (Finding finding : inspection.findings()) {
                spec.commandLine().getErr().println(finding.severity() + ": " + finding.message());
            }
            spec.commandLine().getOut().println("Wrote " + out + ": " + done);
        }
        return 0;
    }

    private long write(RowReader reader, ProgressBar bar) throws IOException {
        long rows = 0;
        try (RecordingWriter writer = RecordingWriter.create(out, reader.channels(), reader.metadata())) {
            double[] row = new double[1 + reader.channels().size()];
            while (reader.read(row)) {
                writer.write(row);
                if (++rows % 2048 == 0) {
                    bar.at("writing", reader.fractionRead());
                }
            }
            writer.finish();
        }
        Sidecar.writeBeside(out, reader.metadata());
        return rows;
    }
}
