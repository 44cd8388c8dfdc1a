package wbv.state;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import wbv.recording.AtomicFile;

/**
 * Labels of a recording as files: {@code labels.csv}; {@code labels.arff} with a row a sample; {@code bags.arff} with a bag of
 * rows
 * for every second, as Weka's multi-instance learners take them. Numbers are exact; Weka's own writer would cut them to six
 * decimals.
 */
public final class StateFiles {

    private static final String STATES = Arrays.stream(MotionState.values()).map(MotionState::toString)
            .collect(Collectors.joining(",", "{", "}"));
    /** What a bag may be. */
    static final List<String> BAG_CLASSES = List.of("idle", "riding", "rocking", "jerk");

    private StateFiles() {}

    private static BufferedWriter writer(AtomicFile file) {
        return new BufferedWriter(new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8));
    }

    /** A row a sample: time, state, its probability, the state told live, forecasts. */
    public static void writeCsv(StateTrack track, Path file) throws IOException {
        try (AtomicFile whole = AtomicFile.begin(file); BufferedWriter out = writer(whole)) {
            out.write("t,state,probability,live,jerk_within_100ms,jerk_within_250ms,jerk_within_500ms\n");
            for (int i = 0; i < track.length(); i++) {
                out.write(time(track, i) + "," + track.state(i) + "," + track.probability(i) + "," + track.live(i));
                for (int h = 0; h < StateTrack.HORIZONS.length; h++) {
                    out.write("," + cell(track.forecast(h, i), ""));
                }
                out.write('\n');
            }
            out.flush();
            whole.finish();
        }
    }

    /** A row a sample: time, features, state; for classifiers and clusterers. */
    public static void writeArff(StateTrack track, Path file) throws IOException {
        try (AtomicFile whole = AtomicFile.begin(file); BufferedWriter out = writer(whole)) {
            out.write("% states of motion by wbv; the class is the likeliest state given the whole recording\n");
            out.write("@relation states\n\n@attribute t numeric\n");
            for (String name : FeatureSpec.NAMES) {
                out.write("@attribute " + name + " numeric\n");
            }
            out.write("@attribute state " + STATES + "\n\n@data\n");
            for (int i = 0; i < track.length(); i++) {
                out.write(time(track, i));
                for (double value : track.features()[i]) {
                    out.write("," + cell(value, "?"));
                }
                out.write("," + track.state(i) + "\n");
            }
            out.flush();
            whole.finish();
        }
    }

    /** A bag a second: its rows of features, and whether anything jerks in it, else the state of most of its rows. */
    public static void writeBags(StateTrack track, Path file) throws IOException {
        int width = Math.max(2, (int) Math.round(track.model().features().rate()));
        int bags = track.length() / width;
        try (AtomicFile whole = AtomicFile.begin(file); BufferedWriter out = writer(whole)) {
            out.write("% seconds of motion as bags of rows by wbv\n@relation seconds\n\n@attribute second {");
            for (int b = 0; b < bags; b++) {
                out.write((b > 0 ? "," : "") + "s" + b);
            }
            out.write((bags == 0 ? "s0" : "") + "}\n@attribute rows relational\n");
            for (String name : FeatureSpec.NAMES) {
                out.write("  @attribute " + name + " numeric\n");
            }
            out.write("@end rows\n@attribute class " + BAG_CLASSES.stream().collect(Collectors.joining(",", "{", "}"))
                    + "\n\n@data\n");
            for (int b = 0; b < bags; b++) {
                out.write("s" + b + ",\"");
                for (int i = b * width; i < (b + 1) * width; i++) {
                    out.write(i > b * width ? "\\n" : "");
                    double[] row = track.features()[i];
                    for (int j = 0; j < row.length; j++) {
                        out.write((j > 0 ? "," : "") + cell(row[j], "?"));
                    }
                }
                out.write("\"," + bagClass(track, b * width, width) + "\n");
            }
            out.flush();
            whole.finish();
        }
    }

    private static String bagClass(StateTrack track, int from, int width) {
        int[] counts = new int[BAG_CLASSES.size()];
        for (int i = from; i < from + width; i++) {
            counts[Math.min(counts.length - 1, track.state(i).ordinal())]++;
        }
        if (counts[counts.length - 1] > 0) {
            return BAG_CLASSES.get(counts.length - 1);
        }
        int most = 0;
        for (int c = 1; c < counts.length; c++) {
            most = counts[c] > counts[most] ? c : most;
        }
        return BAG_CLASSES.get(most);
    }

    private static String time(StateTrack track, int sample) {
        return Double.toString(track.recording().clock().time(sample));
    }

    private static String cell(double value, String missing) {
        return Double.isNaN(value) ? missing : Double.toString(value);
    }
}
