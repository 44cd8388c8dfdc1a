package wbv.state;

import java.util.Arrays;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.state.markov.Rows;

/** The features of a whole recording, every row at the time of its sample: the delay of the stream is taken out. */
final class FeatureRows {

    private FeatureRows() {}

    /**
     * Length by {@link FeatureSpec#NAMES}, NaN where a sample that is needed is missing.
     *
     * @throws DataFault if the recording lacks a channel or has another rate
     */
    static double[][] of(FeatureSpec spec, Recording recording, String where) {
        spec.require(recording.channels(), recording.clock().rate(), where);
        FeatureStream stream = new FeatureStream(spec);
        double[][] columns = spec.channels().stream().map(recording::values).toArray(double[][]::new);
        double[][] rows = new double[recording.length()][FeatureSpec.NAMES.size()];
        double[] sample = new double[columns.length];
        double[] spare = new double[FeatureSpec.NAMES.size()];
        for (int i = 0; i < rows.length + spec.delay(); i++) {
            for (int c = 0; c < columns.length; c++) {
                sample[c] = i < rows.length ? columns[c][i] : Double.NaN;
            }
            stream.step(sample, i >= spec.delay() ? rows[i - spec.delay()] : spare);
        }
        for (int i = 0; i < rows.length; i++) {
            if (!Rows.complete(rows[i])) {
                Arrays.fill(rows[i], Double.NaN);
            }
        }
        return rows;
    }
}
