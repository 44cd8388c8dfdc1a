package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import wbv.recording.RowReader;
import wbv.recording.format.RecordingWriter;
import wbv.recording.format.Sidecar;
import wbv.recording.inspect.Inspection;
import wbv.recording.inspect.RowSource;
import wbv.recording.inspect.UniformReader;
import wbv.result.ResultsJson;
import wbv.sensing.Derivations;
import wbv.sensing.DerivedReader;
import wbv.sensing.StillPose;

/**
 * {@code wbv convert}: any recording as CSV, ARFF, UFF 58, MAT, Parquet or WAV with our channel names, on a uniform clock, with what
 * follows from it.
 */
@Command(name = "convert", mixinStandardHelpOptions = true,
        description = "Writes a recording as CSV, CSV.gz, ARFF, UFF 58, MAT, Parquet or WAV with channel names and SI units, on a uniform "
                + "clock, and says what it found.",
        footer = {"", "Examples:", "  wbv convert data/arff/ride-subject1.arff --out ride.csv.gz",
            "  wbv convert MT_*.txt --location 00B42235=head \\", "      --location 00B42236=platform --out ride.arff",
            "  wbv convert ride.csv --out ride.uff", "  wbv convert ride.uff --out - | head",
            "  wbv convert worn.csv --still 0:5 --free head,sternum \\", "      --joint sternum:head=neck --out derived.csv"})
final class Convert implements Callable<Integer> {

    private static final String STANDARD_OUTPUT = "-";

    /**
     * What was done, for machines.
     *
     * @param rows that were written
     * @param done what became of those read
     * @param findings about the recording
     */
    private record Converted(String wrote, long rows, String done, List<String> findings) {}

    @Mixin
    private RecordingOptions recording;

    @Option(names = "--out", paramLabel = "FILE", required = true,
            description = "name of the new file, ending in .csv, .csv.gz, .arff, .uff (58b, binary), .unv (58, text), .mat, .h5, .parquet "
                    + "or .wav; '-' writes CSV to standard output")
    private Path out;

    @Mixin
    private Answer answer;

    @Mixin
    private DerivationOptions derivations;

    @Option(names = "--as-is", description = "keep rows and times as they stand instead of laying them on a uniform clock")
    private boolean asIs;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws IOException {
        Derivations wanted = derivations.wanted();
        if (asIs && !wanted.isEmpty()) {
            throw new ParameterException(spec.commandLine(), "--as-is keeps rows as they stand: nothing can be derived from them");
        }
        boolean piped = out.toString().equals(STANDARD_OUTPUT);
        if (piped && answer.isJson()) {
            throw new ParameterException(spec.commandLine(), "--json and --out - both want standard output: leave one of them out");
        }
        if (!piped) {
            Sidecar.requireReplaceable(out);
        }
        RowSource source = recording.source();
        try (ProgressBar bar = answer.progress()) {
            Inspection inspection = source.inspect(share -> bar.at("reading", share));
            String done;
            long rows;
            if (asIs) {
                try (RowReader reader = source.open()) {
                    rows = write(reader, bar, piped);
                    done = rows + " rows as they stand.";
                }
            } else {
                try (UniformReader reader = source.uniform(inspection)) {
                    rows = write(wanted.isEmpty() ? reader : derived(reader, source, inspection, wanted), bar, piped);
                    done = reader.relay().sentence();
                }
            }
            bar.close();
            List<String> findings = inspection.findings().stream().map(finding -> finding.severity() + ": " + finding.message()).toList();
            findings.forEach(answer::remark);
            if (piped) {
                answer.remark(done);
            } else {
                answer.print("", "Wrote " + out + ": " + done + "\n",
                        () -> ResultsJson.render(new Converted(out.toString(), rows, done, findings)));
            }
        }
        return 0;
    }

    private static DerivedReader derived(UniformReader reader, RowSource source, Inspection inspection, Derivations wanted)
            throws IOException {
        double rate = inspection.clock().rate();
        Map<String, StillPose.Worn> worn = Map.of();
        if (wanted.still().isPresent()) {
            try (UniformReader pose = source.uniform(inspection)) {
                worn = DerivedReader.worn(pose, rate, wanted.still().get());
            }
        }
        return new DerivedReader(reader, rate, wanted, worn);
    }

    private long write(RowReader reader, ProgressBar bar, boolean piped) throws IOException {
        long rows = 0;
        try (RecordingWriter writer = piped ? RecordingWriter.csv(spec.commandLine().getOut(), reader.channels(), reader.metadata())
                : RecordingWriter.create(out, reader.channels(), reader.metadata())) {
            double[] row = new double[1 + reader.channels().size()];
            while (reader.read(row)) {
                writer.write(row);
                if (++rows % 2048 == 0) {
                    bar.at("writing", reader.fractionRead());
                }
            }
            writer.finishWithSidecar();
        }
        return rows;
    }
}
