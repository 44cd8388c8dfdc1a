import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.drift.Adwin;
import wbv.filter.drift.Alarm;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;

/**
 * A change detector of one's own, beside ADWIN on a stream and inside wbv's estimator: the newer half of a window against the older, by
 * Hoeffding's bound.
 *
 * <pre>java -cp "target/wbv.jar:target/lib/*" examples/OwnDetector.java</pre>
 */
public final class OwnDetector {

    private OwnDetector() {}

    /** Of fixed length, where ADWIN finds its own: simpler, and deaf to what is slower than it. */
    static final class Halves implements Alarm {

        private static final long serialVersionUID = 1;

        private final double[] window;
        private final double bound;
        private long fed;

        /**
         * @param length values in the window, even
         * @param chance that a half differs as much by chance
         */
        Halves(int length, double chance) {
            window = new double[length];
            bound = Math.sqrt(2.0 / length * Math.log(2 / chance));
        }

        @Override
        public boolean feed(double value) {
            window[(int) (fed++ % window.length)] = value;
            if (fed < window.length || fed % (window.length / 8) != 0 || Math.abs(mean(0) - mean(window.length / 2)) <= bound) {
                return false;
            }
            reset();
            return true;
        }

        /**
         * Mean of half the window.
         *
         * @param from values after the oldest
         */
        private double mean(int from) {
            double sum = 0;
            for (int i = 0; i < window.length / 2; i++) {
                sum += window[(int) ((fed + from + i) % window.length)];
            }
            return sum / (window.length / 2);
        }

        @Override
        public long width() {
            return Math.min(fed, window.length);
        }

        @Override
        public double mean() {
            double sum = 0;
            for (int i = 0; i < width(); i++) {
                sum += window[i];
            }
            return width() == 0 ? 0 : sum / width();
        }

        @Override
        public void reset() {
            fed = 0;
        }
    }

    /** @param arguments a recording with platform.acc.z and head.acc.z; one under three regimes, 50 s each, if none is named */
    public static void main(String[] arguments) throws Exception {
        Recording ride = new RecordingFile(Path.of(arguments.length > 0 ? arguments[0] : "data/arff/ride-subject1.arff")).load();
        double[] base = ride.values(Channel.parse("platform.acc.z"));
        double[] head = ride.values(Channel.parse("head.acc.z"));
        Map<String, Alarm> alarms = new LinkedHashMap<>();
        alarms.put("halves", new Halves(600, 1e-4));
        alarms.put("ADWIN", new Adwin(Adwin.USUAL));
        for (int i = 0; i < base.length; i++) {
            if (Double.isNaN(head[i])) {
                continue;   // lost
            }
            double level = Math.min(1, Math.abs(head[i]));
            for (Map.Entry<String, Alarm> each : alarms.entrySet()) {
                if (each.getValue().feed(level)) {
                    System.out.printf(Locale.ROOT, "%6.2f s: %s heard a change%n", ride.clock().time(i), each.getKey());
                }
            }
        }
        // The same detector inside an estimator, where it listens to how likely each innovation is, beside the estimator's own tests.
        Estimator estimator = EstimatorDesign.of(Method.EKF_ADWIN).estimator(Spec.at(ride.clock().rate()), () -> new Halves(600, 1e-4));
        for (int i = 0; i < base.length; i++) {
            BodyEstimate now = estimator.step(base[i], head[i]);
            if (now.changed()) {
                System.out.printf(Locale.ROOT, "%6.2f s: the body has changed, heard by %s%n", ride.clock().time(i), now.heardBy().word());
            }
        }
    }
}
