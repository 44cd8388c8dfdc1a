package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import wbv.body.Excitation;
import wbv.body.Model;
import wbv.body.Simulator;
import wbv.diagnosis.Diagnosis;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.RecordingWriter;

/** Free runs of a model on a recording's input, as CSV. */
final class Prediction {

    private Prediction() { }

    /** The completed model on the held-out part. */
    static void write(Diagnosis diagnosis, Recording recording, Path file) throws IOException {
        double start = recording.clock().start();
        double[] heldOut = diagnosis.fit().heldOut();
        write(diagnosis.model(), recording, recording.clock().nearest(start + heldOut[0]), recording.clock().nearest(start + heldOut[1]), file);
    }

    /** A model run from the recording's start. @param first sample that is written @param end the first that is not any more */
    static void write(Model model, Recording recording, long first, long end, Path file) throws IOException {
        if (model.outputs().isEmpty()) {
            throw new DataFault("the model '" + model.name() + "' has no sensor: give a body or a link one, whose motion is to be written");
        }
        double[][] outputs = new Simulator(Excitation.of(model, recording, recording.length())).outputs(model.assembly());
        List<Channel> channels = model.outputs();
        try (RecordingWriter writer = RecordingWriter.create(file, channels, recording.metadata())) {
            double[] row = new double[1 + channels.size()];
            for (int i = (int) first; i < end; i++) {
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
