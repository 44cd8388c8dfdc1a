package wbv.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.FoundForces;
import wbv.diagnosis.Predicted;
import wbv.recording.AtomicFile;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.recording.format.RecordingWriter;

/** Free runs of a model on a recording's input, as CSV. */
final class Prediction {

    private Prediction() {}

    /**
     * What was recorded on the held-out part, the last model there, and that model as its sensors read it: of each sensor three columns, in
     * its unit. {@code NAME recorded} is less its mean over the recording where constants do not count, and empty where it does not count;
     * {@code NAME model} is what {@code wbv simulate} makes of model.json; {@code NAME} is that with the small errors that diagnosis.json
     * lists as sensor_errors. The reported error is the root mean square of recorded less NAME over that of recorded, where both are there.
     */
    static void write(Predicted predicted, Path file) throws IOException {
        StringBuilder out = new StringBuilder("t");
        for (Channel channel : predicted.outputs()) {
            out.append(',').append(channel).append(" recorded,").append(channel).append(" model,").append(channel);
        }
        out.append('\n');
        for (int i = 0; i < predicted.time().length; i++) {
            out.append(number(predicted.time()[i]));
            for (int o = 0; o < predicted.outputs().size(); o++) {
                out.append(',').append(number(predicted.recorded()[o][i])).append(',').append(number(predicted.model()[o][i])).append(',')
                        .append(number(predicted.read()[o][i]));
            }
            out.append('\n');
        }
        AtomicFile.write(file, out);
    }

    /**
     * What the laws that were found do in their links, by column, over the whole recording [N], positive where it pulls the ends together.
     */
    static void write(FoundForces forces, Path file) throws IOException {
        StringBuilder out = new StringBuilder("t");
        forces.newtons().keySet().forEach(link -> out.append(',').append(link));
        out.append('\n');
        for (int i = 0; i < forces.time().length; i++) {
            out.append(number(forces.time()[i]));
            for (double[] force : forces.newtons().values()) {
                out.append(',').append(number(force[i]));
            }
            out.append('\n');
        }
        AtomicFile.write(file, out);
    }

    /** As recordings write it: what is missing is empty. */
    private static String number(double value) {
        boolean whole = value == (int) value && Double.doubleToRawLongBits(value) != Long.MIN_VALUE;
        return Double.isNaN(value) ? "" : whole ? Integer.toString((int) value) : Double.toString(value);
    }

    /**
     * A model run from the recording's start.
     *
     * @param first sample that is written
     * @param end the first that is not any more
     */
    static void write(Model model, Recording recording, long first, long end, Path file) throws IOException {
        if (model.outputs().isEmpty()) {
            throw new DataFault("the model '" + model.name() + "' has no sensor: give a body or a link one, whose motion is to be written");
        }
        double[][] outputs = new Simulator(Excitation.asDeclared(model, recording, recording.length())).outputs(model.assembly());
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
