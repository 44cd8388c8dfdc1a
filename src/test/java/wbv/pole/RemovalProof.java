package wbv.pole;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Bounds.Attribute;
import wbv.filter.model.Spec;
import wbv.identify.Pole;
import wbv.identify.SkyhookBody;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * Sensor removal on subjects that were not trained on: the long proof, a command of its own.
 * {@code java -cp … wbv.pole.RemovalProof [people learned from] [people held out] [seconds]}
 */
public final class RemovalProof {

    private static final String CHANNELS = " channels=platform.acc.x,platform.acc.z,platform.gyr.y,seat.acc.z,sternum.acc.z,head.acc.z";
    private static final int SETTLED = 30;
    private static final int TRIED = 90;
    /** Two of the thesis' vertical regimes and two of others; the rest is held out, and so is vertical random motion. */
    private static final List<String> LEARNED = List.of("regime=1", "regime=3", "regime=5", "regime=7");
    private static final List<String> TESTS = List.of("regime=2", "regime=4", "regime=6", "regime=8",
            "excitation=random:z:0.5-12:0.4", "excitation=random:z:0.5-12:1.4");
    /** Seeds of people: those that are learned from, and those that are held out. */
    private static final int FIRST_LEARNED = 1;
    private static final int FIRST_HELD = 101;

    private RemovalProof() {}

    /** One method on one channel of one recording. */
    private record Score(String method, Channel channel, String test, double error, double frequency, double magnitude) {}

    /** How many windows' bodies, as the absent sensor shows them, lay within the bounds: by attribute, and the middle's error (ln). */
    private record Held(Channel channel, String test, Attribute attribute, int windows, int within, int over, double width, double off) {}

    public static void main(String[] arguments) {
        int learned = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 6;
        int held = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 6;
        int seconds = arguments.length > 2 ? Integer.parseInt(arguments[2]) : 55;
        long start = System.nanoTime();
        Layout layout = Layout.along('z', "platform", "seat", List.of("sternum", "head"), recording(1, "regime=1", 30, 1).channels());
        PoleTraining training = new PoleTraining(layout, new PoleWindows(25, 10, 4));
        for (int person = FIRST_LEARNED; person < FIRST_LEARNED + learned; person++) {
            int p = person;
            LEARNED.parallelStream().map(what -> training.examine("person " + p + ", " + what,
                    recording(p, what, seconds, 1000 + 20 * p + LEARNED.indexOf(what)))).toList().forEach(training::add);
        }
        PoleTraining.Result result = training.finish();
        for (PlaceClusters place : result.places()) {
            System.out.printf(Locale.ROOT, "%s %d poles, epsilon %.3f, %d clusters of %s, %d noise%n", place.place(), place.poles().size(),
                    place.curve().epsilon(), place.count(),
                    IntStream.range(0, place.count()).mapToObj(i -> place.members(i).size()).toList(), place.members(-1).size());
        }
        List<Score> scores = new ArrayList<>();
        List<Held> bounds = new ArrayList<>();
        for (int person = FIRST_HELD; person < FIRST_HELD + held; person++) {
            int p = person;
            TESTS.parallelStream().map(test -> score(result.trained(), p, test, bounds)).toList().forEach(scores::addAll);
        }
        print(scores);
        printHeld(bounds);
        System.out.printf(Locale.ROOT, "%.0f s%n", (System.nanoTime() - start) / 1e9);
    }

    private static Recording recording(int subject, String what, int seconds, long seed) {
        return RigSpec.parse("subject=random:" + subject + " " + what + " seconds=" + seconds + " seed=" + seed + CHANNELS).recording();
    }

    private static List<Score> score(TrainedPoles trained, int subject, String test, List<Held> held) {
        Recording recording = recording(subject, test, TRIED, 5000 + 10 * subject);
        SensorRemoval.Prediction prediction = new SensorRemoval(trained).predict(test, recording);
        List<Score> scores = new ArrayList<>();
        double rate = recording.clock().rate();
        double[] u = recording.values(trained.layout().base());
        for (Channel absent : trained.layout().absent()) {
            double[] truth = recording.values(absent);
            Map<String, double[]> methods = new LinkedHashMap<>();
            methods.put("response scaled by the pole", prediction.motion().get(absent));
            methods.put("polygons, constrained EKF", prediction.bodies().get(absent).motion());
            methods.put("population's mean body", trained.bodies().get(absent).simulate(centred(u), rate));
            for (double damping : new double[] {0.2, 0.4, 0.6}) {
                methods.put("unconstrained EKF, from 5 Hz and " + damping, estimator(u, rate, Pole.of(5, damping)));
            }
            Optional<TransmissibilityPeak> seen = TransmissibilityPeak
                    .of(TransmissibilityPeak.response(u, truth, (int) (SETTLED * rate), rate));
            methods.forEach((method, motion) -> {
                Optional<TransmissibilityPeak> said = TransmissibilityPeak
                        .of(TransmissibilityPeak.response(u, motion, (int) (SETTLED * rate), rate));
                boolean both = seen.isPresent() && said.isPresent();
                scores.add(new Score(method, absent, test, error(truth, motion, (int) (SETTLED * rate)),
                        both ? said.get().frequency() - seen.get().frequency() : Double.NaN,
                        both ? said.get().magnitude() - seen.get().magnitude() : Double.NaN));
            });
            synchronized (held) {
                held.addAll(held(trained, recording, prediction, absent, test));
            }
        }
        return scores;
    }

    private static List<Held> held(TrainedPoles trained, Recording recording, SensorRemoval.Prediction prediction, Channel absent,
            String test) {
        double rate = recording.clock().rate();
        int window = (int) Math.round(trained.windows().length() * rate);
        List<Held> held = new ArrayList<>();
        double[][] u = trained.layout().inputs().stream().map(channel -> PoleWindows.quiet(recording.values(channel)))
                .toArray(double[][]::new);
        double[] y = PoleWindows.quiet(recording.values(absent));
        for (Attribute attribute : Attributes.OF_A_BODY) {
            int windows = 0;
            int within = 0;
            int over = 0;
            double width = 0;
            double off = 0;
            for (SensorRemoval.Seen seen : prediction.seen()) {
                int from = (int) seen.sample() - window;
                double[][] cut = Arrays.stream(u).map(each -> PoleWindows.centred(each, from, window)).toArray(double[][]::new);
                Optional<SkyhookBody> body = SkyhookBody.of(rate, cut[0], Arrays.copyOfRange(cut, 1, cut.length),
                        PoleWindows.centred(y, from, window));
                if (body.isPresent()) {
                    Chord chord = seen.bounds().get(absent).get(Attributes.OF_A_BODY.indexOf(attribute));
                    double value = Attributes.of(body.get(), attribute);
                    windows++;
                    within += value >= chord.lower() && value <= chord.upper() ? 1 : 0;
                    over += chord.inside() ? 1 : 0;
                    width += chord.upper() - chord.lower();
                    off += Math.abs(chord.middle() - value);
                }
            }
            held.add(new Held(absent, test, attribute, windows, within, over, width, off));
        }
        return held;
    }

    private static double[] centred(double[] u) {
        return PoleWindows.centred(PoleWindows.quiet(u), 0, u.length);
    }

    private static double[] estimator(double[] u, double rate, Pole start) {
        var estimator = EstimatorDesign.of(Method.EKF).estimator(Spec.at(rate).startingAt(start.frequency(), start.damping()),
                () -> new AdwinAlarm(0.002));
        double[] out = new double[u.length];
        for (int k = 0; k < u.length; k++) {
            // The sensor is there for one sample, that gravity and bias are known.
            out[k] = estimator.step(u[k], k == 0 ? u[0] : Double.NaN).prediction();
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
        System.out.println(
                "| channel | method | excitation | runs | with a peak | MSE over variance, mean (worst) | peak frequency off, median "
                        + "(worst) [Hz] | peak magnitude off, median (worst) |");
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

    private static void printHeld(List<Held> all) {
        System.out.println(
                "| channel | attribute | excitation | windows | body within the bounds | pole over the polygon | bounds apart, mean | "
                        + "middle off, mean |");
        System.out.println("|---|---|---|---|---|---|---|---|");
        for (String group : List.of("regime", "random")) {
            for (Channel channel : all.stream().map(Held::channel).distinct().sorted(java.util.Comparator.comparing(Channel::toString))
                    .toList()) {
                for (Attribute attribute : Attributes.OF_A_BODY) {
                    List<Held> own = all.stream().filter(h -> h.channel().equals(channel) && h.attribute() == attribute
                            && h.test().contains(group)).toList();
                    double windows = own.stream().mapToInt(Held::windows).sum();
                    System.out.printf(Locale.ROOT, "| %s | %s | %s | %.0f | %.0f %% | %.0f %% | %.3f | %.3f |%n", channel,
                            attribute.name().toLowerCase(Locale.ROOT).replace('_', ' '), group, windows,
                            100 * own.stream().mapToInt(Held::within).sum() / windows,
                            100 * own.stream().mapToInt(Held::over).sum() / windows,
                            own.stream().mapToDouble(Held::width).sum() / windows, own.stream().mapToDouble(Held::off).sum() / windows);
                }
            }
        }
    }
}
