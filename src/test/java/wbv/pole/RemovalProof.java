package wbv.pole;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.filter.Alarm;
import wbv.filter.Method;
import wbv.filter.Recipe;
import wbv.filter.Spec;
import wbv.identify.Pole;
import wbv.identify.TransferModel;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * Sensor removal on subjects that were not trained on: the long proof, a command of its own.
 * {@code java -cp … wbv.pole.RemovalProof [subjects held out, as 1,2,3,4] [seconds]}
 */
public final class RemovalProof {

    private static final String CHANNELS = " channels=platform.acc.x,platform.acc.z,platform.gyr.y,seat.acc.z,sternum.acc.z,head.acc.z";
    private static final int SETTLED = 30;
    private static final int TRIED = 120;
    private static final List<String> LEARNED = List.of("regime=1", "regime=2", "regime=3", "regime=4", "regime=5", "regime=6",
            "regime=7", "regime=8", "regime=9");
    private static final List<String> TESTS = List.of("regime=1", "regime=2", "regime=3", "regime=4", "regime=5", "regime=6",
            "regime=7",
            "regime=8", "regime=9", "excitation=random:z:0.5-12:0.4", "excitation=random:z:0.5-12:0.8",
            "excitation=random:z:0.5-12:1.4");

    private RemovalProof() { }

    /** An alarm that hears nothing. */
    private static final class Deaf implements Alarm {
        private static final long serialVersionUID = 1;

        @Override
        public boolean feed(double value) {
            return false;
        }

        @Override
        public double mean() {
            return 0.5;
        }

        @Override
        public long width() {
            return 0;
        }

        @Override
        public void reset() { }
    }

    /** One method on one channel of one recording. */
    private record Score(String method, Channel channel, String test, double error, double frequency, double magnitude) { }

    public static void main(String[] arguments) {
        List<Integer> held = Arrays.stream((arguments.length > 0 ? arguments[0] : "1,2,3,4").split(",")).map(Integer::valueOf)
                .toList();
        int seconds = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 75;
        long start = System.nanoTime();
        Recording first = recording(1, "regime=1", 30, 1);
        Layout layout = Layout.along('z', "platform", "seat", List.of("sternum", "head"), first.channels());
        PoleWindows windows = new PoleWindows(25, 10, 4);
        PoleTraining examiner = new PoleTraining(layout, windows);
        Map<Integer, List<PoleTraining.Trial>> trials = new LinkedHashMap<>();
        for (int subject = 1; subject <= 4; subject++) {
            int s = subject;
            trials.put(subject, LEARNED.parallelStream().map(what -> examiner.examine("subject " + s + ", " + what,
                    recording(s, what, seconds, 1000 + 20 * s + LEARNED.indexOf(what)))).toList());
        }
        System.out.printf(Locale.ROOT, "trained windows examined after %.0f s%n", (System.nanoTime() - start) / 1e9);
        List<Score> scores = new ArrayList<>();
        for (int out : held) {
            PoleTraining training = new PoleTraining(layout, windows);
            trials.forEach((subject, list) -> {
                if (subject != out) {
                    list.forEach(training::add);
                }
            });
            PoleTraining.Result result = training.finish();
            for (PlaceClusters place : result.places()) {
                System.out.printf(Locale.ROOT,
                        "without subject %d: %s %d poles, epsilon %.3f, %d clusters of %s, %d noise; OPTICS %d clusters; EM %d%n",
                        out, place.place(), place.poles().size(), place.curve().epsilon(), place.count(), IntStream.range(0,
                        place.count())
                        .mapToObj(i -> place.members(i).size()).toList(), place.members(-1).size(),
                        Arrays.stream(place.optics()).max().orElse(-1) + 1, Arrays.stream(place.mixture()).max().orElse(-1) + 1);
            }
            TESTS.parallelStream().map(test -> score(result.trained(), out, test)).toList().forEach(scores::addAll);
        }
        print(scores);
        System.out.printf(Locale.ROOT, "%.0f s%n", (System.nanoTime() - start) / 1e9);
    }

    private static Recording recording(int subject, String what, int seconds, long seed) {
        return RigSpec.parse("subject=" + subject + " " + what + " seconds=" + seconds + " seed=" + seed + CHANNELS).recording();
    }

    private static List<Score> score(TrainedPoles trained, int subject, String test) {
        Recording recording = recording(subject, test, TRIED, 5000 + 10 * subject);
        SensorRemoval.Prediction prediction = new SensorRemoval(trained).predict(test, recording);
        List<Score> scores = new ArrayList<>();
        double rate = recording.clock().rate();
        double[] u = recording.values(trained.layout().base());
        for (Channel absent : trained.layout().absent()) {
            double[] truth = recording.values(absent);
            Map<String, double[]> methods = new LinkedHashMap<>();
            methods.put("response scaled by the pole", prediction.motion().get(absent));
            methods.put("polygons, constrained EKF", estimator(u, rate, Recipe.of(Method.CONSTRAINED)
                    .within(prediction.constraint(absent)), trained.bodies().get(absent)));
            methods.put("unconstrained EKF", estimator(u, rate, Recipe.of(Method.EKF_ADWIN), Pole.of(5, 0.4)));
            methods.put("population's mean body", body(u, rate, trained.bodies().get(absent)));
            methods.put("polygons, middle of the chord", chordBody(u, rate, prediction, trained, absent));
            Optional<Peak> seen = Peak.of(Peak.response(u, truth, (int) (SETTLED * rate), rate));
            methods.forEach((method, motion) -> {
                Optional<Peak> said = Peak.of(Peak.response(u, motion, (int) (SETTLED * rate), rate));
                boolean both = seen.isPresent() && said.isPresent();
                scores.add(new Score(method, absent, test, error(truth, motion, (int) (SETTLED * rate)),
                        both ? said.get().frequency() - seen.get().frequency() : Double.NaN,
                        both ? said.get().magnitude() - seen.get().magnitude() : Double.NaN));
            });
        }
        return scores;
    }

    private static double[] estimator(double[] u, double rate, Recipe recipe, Pole start) {
        var estimator = recipe.estimator(Spec.at(rate).startingAt(start.frequency(), start.damping()), Deaf::new);
        double[] out = new double[u.length];
        for (int k = 0; k < u.length; k++) {
            // The sensor is there for one sample, that gravity and bias are known.
            out[k] = estimator.step(u[k], k == 0 ? u[0] : Double.NaN).prediction();
        }
        return out;
    }

    private static TransferModel model(Pole pole) {
        double omega = 2 * Math.PI * pole.frequency();
        double[] a = {2 * pole.damping() * omega, omega * omega};
        return new TransferModel(a, new double[][] {a});
    }

    private static double[] body(double[] u, double rate, Pole pole) {
        return model(pole).simulate(new double[][] {u}, rate, new double[2]);
    }

    private static double[] chordBody(double[] u, double rate, SensorRemoval.Prediction prediction, TrainedPoles trained,
            Channel absent) {
        double[] out = new double[u.length];
        double[] whole = body(u, rate, trained.bodies().get(absent));
        System.arraycopy(whole, 0, out, 0, out.length);
        for (SensorRemoval.Seen seen : prediction.seen()) {
            double[] now = body(u, rate, Pole.of(seen.bounds().get(absent).get(0).middle(), Math.min(0.95, seen.bounds()
                    .get(absent).get(1).middle())));
            System.arraycopy(now, (int) seen.sample(), out, (int) seen.sample(), out.length - (int) seen.sample());
        }
        return out;
    }

    private static double error(double[] truth, double[] said, int from) {
        double mean = 0;
        double difference = 0;
        int n = truth.length - from;
        for (int k = from; k < truth.length; k++) {
            mean += truth[k] / n;
            difference += (truth[k] - said[k]) / n;
        }
        double squares = 0;
        double power = 0;
        for (int k = from; k < truth.length; k++) {
            squares += (truth[k] - said[k] - difference) * (truth[k] - said[k] - difference);
            power += (truth[k] - mean) * (truth[k] - mean);
        }
        return squares / power;
    }

    private static void print(List<Score> scores) {
        System.out.println("| channel | method | excitation | runs | with a peak | MSE over variance, mean (worst) | peak frequency off, median (worst) [Hz] | peak magnitude off, median (worst) |");
        System.out.println("|---|---|---|---|---|---|---|---|");
        for (String group : List.of("regime", "random")) {
            for (Channel channel : scores.stream().map(Score::channel).distinct().toList()) {
                for (String method : scores.stream().map(Score::method).distinct().toList()) {
                    List<Score> own = scores.stream().filter(s -> s.channel().equals(channel) && s.method().equals(method)
                            && s.test().contains(group)).toList();
                    double[] f = own.stream().mapToDouble(s -> Math.abs(s.frequency())).filter(Double::isFinite).sorted()
                            .toArray();
                    double[] m = own.stream().mapToDouble(s -> Math.abs(s.magnitude())).filter(Double::isFinite).sorted()
                            .toArray();
                    System.out.printf(Locale.ROOT, "| %s | %s | %s | %d | %d | %.4f (%.4f) | %.2f (%.2f) | %.3f (%.3f) |%n",
                            channel, method, group, own.size(), f.length,
                            own.stream().mapToDouble(Score::error).average().orElse(Double.NaN), own.stream()
                            .mapToDouble(Score::error).max().orElse(Double.NaN),
                            f[f.length / 2], f[f.length - 1], m[m.length / 2], m[m.length - 1]);
                }
            }
        }
    }
}
