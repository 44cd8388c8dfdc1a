package wbv.bench;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.identify.EquivalentBodies;
import wbv.identify.EquivalentBody;
import wbv.identify.MotionWindow;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * How often ±2σ holds what it claims, on the rig's four people in all regimes, as tables for {@code docs/thesis.md}: {@code whole
 * SECONDS SEEDS} of what {@code analyze} and {@code track} print of a recording, {@code streams SECONDS DRAW METHOD…} of the streaming
 * estimators, every ten seconds from the thirtieth on; draws are 0 to 3, since 4 is that of the truth.
 *
 * <p>What is claimed is the body of one mode that simulates the same path of the same person best had the regime gone on: it is
 * fitted to ten minutes of the noise-free plant under another draw of the same regime.
 */
public final class BodyProof {

    private static final double RATE = 60;
    private static final int PEOPLE = 4;
    private static final int REGIMES = 8;
    private static final double LONG = 600;
    private static final List<String> PLACES = List.of("seat", "left_thigh", "right_thigh", "pelvis", "lumbar", "sternum", "left_shoulder",
            "right_shoulder", "head");
    private static final List<String> MOTIONS = List.of("platform.acc.x", "platform.acc.y", "platform.gyr.x", "platform.gyr.y",
            "platform.gyr.z");
    private static final String FREE = "usual,-noise,-bias,-drift,-tilt,-resolution";

    private BodyProof() {}

    public static void main(String[] words) {
        double seconds = Double.parseDouble(words[1]);
        if (words[0].equals("whole")) {
            whole(seconds, Integer.parseInt(words[2]));
        } else if (words[0].equals("streams")) {
            streams(seconds, Integer.parseInt(words[2]),
                    Arrays.stream(words).skip(3).map(word -> Method.named(word).orElseThrow()).toList());
        } else {
            throw new IllegalArgumentException("whole or streams: " + words[0]);
        }
    }

    /** Counts of what is printed and what of it holds. */
    private record Count(int paths, int printed, int frequency, int damping, double share) {

        Count plus(Count other) {
            return new Count(paths + other.paths, printed + other.printed, frequency + other.frequency, damping + other.damping,
                    share + other.share);
        }

        String row(String name) {
            return String.format(Locale.ROOT, "| %s | %d | %d | %.1f %% | %.1f %% | %.0f %% |", name, paths, printed,
                    100.0 * frequency / printed, 100.0 * damping / printed, 100 * share / printed);
        }
    }

    private static Recording recording(int subject, int regime, double seconds, long seed, String effects) {
        return RigSpec.parse(String.format(Locale.ROOT, "subject=%d regime=%d seconds=%s seed=%d effects=%s", subject, regime, seconds,
                seed, effects)).recording();
    }

    private static List<Optional<EquivalentBody>> bodies(Recording recording, int degrees) {
        List<double[]> inputs = Stream.concat(Stream.of("platform.acc.z"), MOTIONS.stream()).map(Channel::parse).map(recording::values)
                .toList();
        MotionWindow window = new MotionWindow(RATE, inputs.size(), inputs.get(0).length);
        double[] row = new double[inputs.size()];
        for (int t = 0; t < inputs.get(0).length; t++) {
            for (int i = 0; i < row.length; i++) {
                row[i] = inputs.get(i)[t];
            }
            window.accept(row);
        }
        EquivalentBodies fits = new EquivalentBodies(window, MOTIONS.size());
        return PLACES.stream().map(place -> fits.of(recording.values(Channel.parse(place + ".acc.z")), degrees)).toList();
    }

    private static void whole(double seconds, int seeds) {
        System.out.println("| regime | paths | printed | frequency inside | damping inside | explained, mean |\n|---|---|---|---|---|---|");
        Count all = new Count(0, 0, 0, 0, 0);
        for (int g = 1; g <= REGIMES; g++) {
            int regime = g;
            Count sum = IntStream.rangeClosed(1, PEOPLE).parallel().mapToObj(subject -> cell(subject, regime, seconds, seeds))
                    .reduce(new Count(0, 0, 0, 0, 0), Count::plus);
            System.out.println(sum.row(Integer.toString(regime)));
            all = all.plus(sum);
        }
        System.out.println(all.row("all"));
    }

    private static Count cell(int subject, int regime, double seconds, int seeds) {
        List<Optional<EquivalentBody>> truth = bodies(recording(subject, regime, LONG, 9000 + 10L * subject + regime, FREE), 1);
        int printed = 0;
        int frequency = 0;
        int damping = 0;
        double share = 0;
        for (int seed = 1; seed <= seeds; seed++) {
            List<Optional<EquivalentBody>> found = bodies(recording(subject, regime, seconds, 1000L * seed + 10L * subject + regime,
                    "usual,loss"), 0);
            for (int i = 0; i < found.size(); i++) {
                Optional<EquivalentBody> body = found.get(i).filter(EquivalentBody::carries)
                        .filter(one -> one.modes().get(0).oscillates() && one.modes().get(0).determined());
                if (body.isPresent()) {
                    EquivalentBody.Mode said = body.get().modes().get(0);
                    EquivalentBody.Mode claimed = truth.get(i).orElseThrow().modes().get(0);
                    printed++;
                    share += body.get().explained();
                    frequency += Math.abs(said.frequency() - claimed.frequency()) <= 2 * said.frequencyDeviation() ? 1 : 0;
                    damping += Math.abs(said.damping() - claimed.damping()) <= 2 * said.dampingDeviation() ? 1 : 0;
                }
            }
        }
        return new Count(seeds * PLACES.size(), printed, frequency, damping, share);
    }

    private static void streams(double seconds, int draw, List<Method> methods) {
        List<List<Count>> cells = IntStream.range(0, PEOPLE * REGIMES).parallel()
                .mapToObj(k -> streams(1 + k / REGIMES, 1 + k % REGIMES, seconds, draw, methods)).toList();
        System.out.println("| estimator | looks | frequency inside | damping inside |\n|---|---|---|---|");
        for (int m = 0; m < methods.size(); m++) {
            int method = m;
            Count sum = cells.stream().map(cell -> cell.get(method)).reduce(new Count(0, 0, 0, 0, 0), Count::plus);
            System.out.printf(Locale.ROOT, "| %s | %d | %.1f %% | %.1f %% |%n", methods.get(m).word(), sum.printed(),
                    100.0 * sum.frequency() / sum.printed(), 100.0 * sum.damping() / sum.printed());
        }
    }

    private static List<Count> streams(int subject, int regime, double seconds, int draw, List<Method> methods) {
        List<Optional<EquivalentBody>> truth = bodies(recording(subject, regime, LONG, 9000 + 10L * subject + regime, FREE), 1);
        Recording ride = recording(subject, regime, seconds, 5000 + 1000L * draw + 10L * subject + regime, "usual,loss");
        return methods.stream().map(method -> stream(truth, ride, method)).toList();
    }

    private static Count stream(List<Optional<EquivalentBody>> truth, Recording ride, Method method) {
        double[] u = ride.values(Channel.parse("platform.acc.z"));
        int looks = 0;
        int frequency = 0;
        int damping = 0;
        for (int i = 0; i < PLACES.size(); i++) {
            EquivalentBody.Mode claimed = truth.get(i).orElseThrow().modes().get(0);
            double[] y = ride.values(Channel.parse(PLACES.get(i) + ".acc.z"));
            Estimator estimator = EstimatorDesign.of(method).estimator(Spec.at(RATE), () -> new AdwinAlarm(0.002));
            for (int t = 0; t < u.length; t++) {
                BodyEstimate track = estimator.step(u[t], y[t]);
                if (claimed.oscillates() && t >= 30 * RATE && t % (10 * RATE) == 0) {
                    looks++;
                    frequency += Math.abs(track.frequency() - claimed.frequency()) <= 2 * track.frequencyDeviation() ? 1 : 0;
                    damping += Math.abs(track.damping() - claimed.damping()) <= 2 * track.dampingDeviation() ? 1 : 0;
                }
            }
        }
        return new Count(PLACES.size(), looks, frequency, damping, 0);
    }
}
