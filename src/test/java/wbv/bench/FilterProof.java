package wbv.bench;

import java.util.Arrays;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import wbv.filter.Estimator;
import wbv.filter.Method;
import wbv.filter.Recipe;
import wbv.filter.Spec;
import wbv.filter.Track;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * The long proof of the streaming estimators on the rig's data, as tables for {@code docs/thesis.md}:
 * {@code starts COUNT SNR_DB METHOD…}, {@code steps COUNT SNR_DB METHOD…}, {@code quiet MINUTES METHOD…}.
 */
public final class FilterProof {

    private static final double RATE = 60;
    private static final double RMS = 0.8;

    private FilterProof() { }

    public static void main(String[] words) {
        switch (words[0]) {
            case "starts" -> each(words, 3, method -> starts(method, integer(words, 1), Double.parseDouble(words[2])));
            case "steps" -> each(words, 3, method -> steps(method, integer(words, 1), Double.parseDouble(words[2])));
            case "quiet" -> each(words, 2, method -> quiet(method, integer(words, 1)));
            default -> throw new IllegalArgumentException("starts, steps or quiet: " + words[0]);
        }
    }

    private static void each(String[] words, int from, java.util.function.Consumer<Method> task) {
        Arrays.stream(words).skip(from).forEach(word -> task.accept(Method.named(word).orElseThrow()));
    }

    private static int integer(String[] words, int at) {
        return Integer.parseInt(words[at]);
    }

    /** A linear sitter under random motion: ζ in 0.2 … 0.6, f0 in 3 … 7 Hz. */
    record Case(double frequency, double damping, double[] u, double[] y) {

        static Case of(int seed, double seconds, double snr, double factor, double change) {
            SplittableRandom random = new SplittableRandom(77_000 + seed);
            double frequency = 3 + 4 * random.nextDouble();
            double damping = 0.2 + 0.4 * random.nextDouble();
            RigSpec spec = RigSpec.oneDof(damping, frequency, RMS, seconds, seed);
            Recording recording = (factor == 1 ? spec : spec.withStiffnessStep(factor, change)).recording();
            double[] u = recording.values(Channel.parse("platform.acc.z")).clone();
            double[] y = recording.values(Channel.parse("head.acc.z")).clone();
            if (Double.isFinite(snr)) {
                soil(u, snr, random);
                soil(y, snr, random);
            }
            return new Case(frequency, damping, u, y);
        }

        private static void soil(double[] x, double snr, SplittableRandom random) {
            double power = Arrays.stream(x).map(v -> v * v).average().orElseThrow();
            double deviation = Math.sqrt(power) * Math.pow(10, -snr / 20);
            Arrays.setAll(x, i -> x[i] + deviation * random.nextGaussian());
        }
    }

    private static Estimator estimator(Method method, double f, double zeta, double snr, long seed) {
        double noise = Double.isFinite(snr) ? RMS * Math.pow(10, -snr / 20) : Spec.noise(RATE);
        return Recipe.of(method).withSeed(seed).estimator(new Spec(RATE, f, zeta, noise, noise, Spec.DRIFT), () -> new AdwinAlarm(0.002));
    }

    /** Random starts, ζ in 0.05 … 0.95 and f0 in 1 … 15 Hz: the share within 5 % of the truth after 30 s. */
    private static void starts(Method method, int count, double snr) {
        long before = System.nanoTime();
        double[] error = IntStream.range(0, count).parallel().mapToDouble(seed -> {
            Case one = Case.of(seed, 30, snr, 1, 0);
            SplittableRandom random = new SplittableRandom(99_000 + seed);
            double f = 1 + 14 * random.nextDouble();
            double zeta = 0.05 + 0.9 * random.nextDouble();
            Estimator estimator = estimator(method, f, zeta, snr, seed);
            for (int i = 0; i < one.u.length; i++) {
                estimator.step(one.u[i], one.y[i]);
            }
            Track track = estimator.track();
            double e = error(track, one.frequency, one.damping);
            if (e > 0.05 && System.getenv("VERBOSE") != null) {
                System.out.printf("  seed %d start %.2f %.2f truth %.2f %.2f got %.2f %.2f div %d chg %d noise %.3f settled %s sd %.3f %.3f%n", seed, f, zeta,
                        one.frequency, one.damping, track.frequency(), track.damping(), track.divergences(), track.changes(),
                        track.outputNoise(), track.settled(), track.frequencyDeviation(), track.dampingDeviation());
            }
            return e;
        }).toArray();
        long good = Arrays.stream(error).filter(e -> e <= 0.05).count();
        Arrays.sort(error);
        System.out.printf(Locale.ROOT, "| %s | %s | %d | %.1f %% | %.2f %% | %.2f %% | %.1f s |%n", method.word(), snr, count, 100.0 * good / count,
                100 * error[count / 2], 100 * error[(int) (0.99 * (count - 1))], (System.nanoTime() - before) * 1e-9);
    }

    private static double error(Track track, double frequency, double damping) {
        return Math.max(Math.abs(track.frequency() / frequency - 1), Math.abs(track.damping() / damping - 1));
    }

    /** A stiffness step of 15 % at 30 s: when it is heard, and when the parameters are within 5 % again. */
    private static void steps(Method method, int count, double snr) {
        double[][] found = IntStream.range(0, count).parallel().mapToObj(seed -> {
            double factor = seed % 2 == 0 ? 1.15 : 1 / 1.15;
            Case one = Case.of(seed, 45, snr, factor, 30);
            Estimator estimator = estimator(method, 5, 0.4, snr, seed);
            double heard = Double.POSITIVE_INFINITY;
            double learned = Double.POSITIVE_INFINITY;
            long early = 0;
            double f = one.frequency * Math.sqrt(factor);
            double zeta = one.damping / Math.sqrt(factor);
            for (int i = 0; i < one.u.length; i++) {
                Track track = estimator.step(one.u[i], one.y[i]);
                double since = (i + 1) / RATE - 30;
                if (since < 0) {
                    early += track.changed() && i > 15 * RATE ? 1 : 0;
                } else if (track.changed()) {
                    heard = Math.min(heard, since);
                }
                if (since >= 0) {
                    double e = Math.abs(track.frequency() / f - 1);
                    learned = e > 0.03 ? Double.POSITIVE_INFINITY : Math.min(learned, since);
                }
            }
            return new double[] {heard, learned, early};
        }).toArray(double[][]::new);
        double[] heard = Arrays.stream(found).mapToDouble(x -> x[0]).sorted().toArray();
        double[] learned = Arrays.stream(found).mapToDouble(x -> x[1]).sorted().toArray();
        System.out.printf(Locale.ROOT, "| %s | %s | %d | heard ≤1 s %.1f %% | median %.2f s | 99 %% %.2f s | f within 3 %%: ≤1 s %.1f %% median %.2f s, 99 %% %.2f s | early %d |%n",
                method.word(), snr, count, 100.0 * Arrays.stream(heard).filter(t -> t <= 1).count() / count, heard[count / 2], heard[(int) (0.99 * (count - 1))],
                100.0 * Arrays.stream(learned).filter(t -> t <= 1).count() / count,
                learned[count / 2], learned[(int) (0.99 * (count - 1))], Arrays.stream(found).mapToLong(x -> (long) x[2]).sum());
    }

    /** False alarms on sitters that do not change. */
    private static void quiet(Method method, int minutes) {
        long alarms = IntStream.range(0, minutes / 6).parallel().mapToLong(seed -> {
            Case one = Case.of(5000 + seed, 390, Double.POSITIVE_INFINITY, 1, 0);
            Estimator estimator = estimator(method, 5, 0.4, Double.POSITIVE_INFINITY, seed);
            long changes = 0;
            for (int i = 0; i < one.u.length; i++) {
                changes += estimator.step(one.u[i], one.y[i]).changed() && i >= 30 * RATE ? 1 : 0;
            }
            return changes;
        }).sum();
        System.out.printf("| %s | %d min | %d false alarms |%n", method.word(), minutes / 6 * 6, alarms);
    }
}
