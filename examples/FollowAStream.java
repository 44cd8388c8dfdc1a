import java.nio.file.Path;
import java.util.Locale;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.drift.Adwin;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.recording.RowReader;
import wbv.recording.format.RecordingFile;

/**
 * An extended Kalman filter on a stream: natural frequency and damping ratio after every sample, and the moment at which the body changes.
 *
 * <pre>java -cp "target/wbv.jar:target/lib/*" examples/FollowAStream.java</pre>
 */
public final class FollowAStream {

    private static final double RATE = 60;

    private FollowAStream() {}

    /** @param arguments a recording at 60 Hz; the one whose stiffness steps by a quarter after 60 s if none is named */
    public static void main(String[] arguments) throws Exception {
        Path file = Path.of(arguments.length > 0 ? arguments[0] : "data/arff/one-dof-step.arff");
        Estimator estimator = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(RATE), () -> new Adwin(Adwin.USUAL));
        try (RowReader rows = new RecordingFile(file).open()) {
            int base = 1 + rows.channels().indexOf(Channel.parse("platform.acc.z"));   // a row begins with its time
            int head = 1 + rows.channels().indexOf(Channel.parse("head.acc.z"));
            double[] row = new double[1 + rows.channels().size()];
            for (long n = 1; rows.read(row); n++) {
                BodyEstimate now = estimator.step(row[base], row[head]);
                if (now.changed()) {
                    System.out.printf(Locale.ROOT, "%6.2f s: the body has changed%n", row[0]);
                }
                if (n % (30 * RATE) == 0) {
                    System.out.printf(Locale.ROOT, "%6.2f s: natural frequency %.2f ± %.2f Hz, damping ratio %.3f ± %.3f%n", row[0],
                            now.frequency(), 2 * now.frequencyDeviation(), now.damping(), 2 * now.dampingDeviation());
                }
            }
        }
    }
}
