package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import wbv.body.Excitation;
import wbv.body.Model;
import wbv.body.Simulator;
import wbv.diagnosis.Diagnosis;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.RecordingWriter;

/** Free runs of a model on a recording's input, as CSV. */
final class Prediction {

    private Prediction() { }

    /** The completed model on the held-out part: from the first sample of its window to the end of the recording. */
    static void write(Diagnosis diagnosis, Recording recording, Path file) throws IOException {
        write(diagnosis.model(), recording, recording.clock().nearest(recording.clock().start() + diagnosis.fit().heldOut()[0]), file);
    }

    /** A model run from the recording's start; samples from {@code first} on are written. */
    static void write(Model model, Recording recording, long first, Path file) throws IOException {
        double[][] outputs = new Simulator(Excitation.of(model, recording, recording.length())).outputs(model.assembly());
        List<Channel> channels = model.outputs();
        try (RecordingWriter writer = RecordingWriter.create(file, channels, recording.metadata())) {
            double[] row = new double[1 + channels.size()];
            for (int i = (int) first; i < recording.length(); i++) {
                row[0] = recording.clock().time(i);
                for (int o = 0; o < outputs.length; o++) {
                    row[1 + o] = outputs[o][i];
                }
                writer.write(row);
            }
            writer.finish();
        }
    }
}
