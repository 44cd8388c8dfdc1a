package wbv.rig;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import wbv.recording.AtomicFile;
import wbv.recording.format.RecordingWriter;

/** Writes experiments to files: the recording, and the truth beside it. */
public final class RigFiles {

    private RigFiles() {}

    /**
     * Plays an experiment into {@code name.arff} (or {@code .csv}, {@code .csv.gz}) with {@code name.truth.json} and
     * {@code name.truth.csv.gz} beside it. The files appear when they are complete.
     *
     * @param full      whether states and ideal outputs are wanted in the truth, not the parameters alone
     * @return what was written, the recording first
     * @throws wbv.recording.DataFault if the name ends otherwise, or the folder is missing or may not be written to
     */
    public static List<Path> write(RigSpec spec, Path recording, boolean full) throws IOException {
        RigRun run = spec.run();
        Path json = beside(recording, ".truth.json");
        Path csv = beside(recording, ".truth.csv.gz");
        String constants = RigTruth.json(run);
        double[] row = new double[1 + run.channels().size()];
        try (RecordingWriter writer = RecordingWriter.create(recording, run.channels(), run.metadata());
                RigTruth truth = new RigTruth(run, csv, full)) {
            while (run.read(row)) {
                writer.write(row);
                truth.write(row[0]);
            }
            // The recording comes last: where it is, its truth is.
            truth.end();
            AtomicFile.write(json, constants);
            truth.finish();
            writer.finish();
        }
        return List.of(recording, csv, json);
    }

    private static Path beside(Path recording, String ending) {
        String name = recording.getFileName().toString();
        return recording.resolveSibling(name.replaceFirst("(?i)\\.(arff|csv)(\\.gz)?$", "") + ending);
    }
}
