package wbv.bench;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.SimulatedSitter;
import wbv.filter.drift.Alarm;
import wbv.filter.drift.ChangeTest;
import wbv.filter.model.Spec;
import wbv.learn.Detectors;

/**
 * How well estimators follow a sitter whose spring changes, as tables for {@code docs/thesis.md}: {@code following COUNT SEED METHOD…}
 * beside the plain filter, {@code detectors COUNT SEED SNR_DB METHOD DETECTOR…} with different change detectors, and {@code noise COUNT
 * SEED METHOD DETECTOR…} of a sitter who stays the same while the sensors become noisier.
 */
public final class FollowingProof {

    private static final double RATE = SimulatedSitter.RATE;
    private static final double RMS = 0.8;
    private static final double SECONDS = 95;
    /** Errors count from then on [s]. */
    private static final double FROM = 15;
    /** How far the stiffness goes, up and down, over that at rest. */
    private static final double SWING = 0.25;

    /** How the stiffness goes. */
    public enum Course {
        NONE, SINGLE, EVERY_30_S, EVERY_10_S, EVERY_5_S, RAMPS, SINE;

        /** Stiffness over that at rest, at a time [s]. */
        public DoubleUnaryOperator of(long seed) {
            SplittableRandom random = new SplittableRandom(31_000 + seed);
            double phase = random.nextDouble();
            double period = 5 + 35 * random.nextDouble();
            double swing = random.nextBoolean() ? SWING : -SWING;
            return switch (this) {
                case NONE -> t -> 1;
                case SINGLE -> t -> t < 30 + 20 * phase ? 1 : 1 + swing;
                case EVERY_30_S -> steps(30, phase, random);
                case EVERY_10_S -> steps(10, phase, random);
                case EVERY_5_S -> steps(5, phase, random);
                case RAMPS -> t -> 1 + SWING * ramp((t / (10 + period / 2) + phase) % 1);
                case SINE -> t -> 1 + SWING * Math.sin(2 * Math.PI * (t / period + phase));
            };
        }

        private static DoubleUnaryOperator steps(double every, double phase, SplittableRandom random) {
            int[] level = new int[64];
            level[0] = 1;
            for (int i = 1; i < level.length; i++) {
                level[i] = (level[i - 1] + 1 + random.nextInt(2)) % 3;
            }
            return t -> 1 + SWING * (level[(int) (t / every + phase)] - 1);
        }

        /** Up in a quarter of the period, held, down twice as fast, and back. */
        private static double ramp(double x) {
            return x < 0.25 ? 4 * x : x < 0.5 ? 1 : x < 0.75 ? 1 - 8 * (x - 0.5) : 4 * (x - 0.75) - 1;
        }
    }

    private FollowingProof() {}

    public static void main(String[] words) {
        int count = Integer.parseInt(words[1]);
        long seed = Long.parseLong(words[2]);
        switch (words[0]) {
            case "following" -> following(count, seed, Arrays.asList(words).subList(3, words.length));
            case "detectors" -> detectors(count, seed, Double.parseDouble(words[3]), Method.named(words[4]).orElseThrow(),
                    Arrays.asList(words).subList(5, words.length));
            case "noise" -> noise(count, seed, Method.named(words[3]).orElseThrow(), Arrays.asList(words).subList(4, words.length));
            default -> throw new IllegalArgumentException("following, detectors or noise: " + words[0]);
        }
    }

    /** Of one run: mean square errors of f0 and ζ, relative; changes heard, by test; divergences; delays of steps heard. */
    public record Run(double frequency, double damping, long[] heard, long divergences) {

        public double rms() {
            return Math.sqrt(frequency);
        }
    }

    /** One run by a fresh sitter. @param snr of both sensors [dB], +∞ for the sensors' own */
    public static Run run(Method method, Supplier<Alarm> alarms, Course course, double snr, long seed) {
        double noise = Double.isFinite(snr) ? RMS * Math.pow(10, -snr / 20) : Spec.noise(RATE);
        SimulatedSitter sitter = SimulatedSitter.of(seed);
        DoubleUnaryOperator factor = course.of(seed);
        SimulatedSitter.Motion motion = sitter.changing(factor, RMS, SECONDS, seed).measured(noise, seed);
        Estimator estimator = EstimatorDesign.of(method).withSeed(seed).estimator(new Spec(RATE, 5, 0.4, noise, noise, Spec.DRIFT), alarms);
        double frequency = 0;
        double damping = 0;
        int n = 0;
        long[] heard = new long[ChangeTest.values().length];
        for (int i = 0; i < motion.u().length; i++) {
            BodyEstimate track = estimator.step(motion.u()[i], motion.y()[i]);
            double t = i / RATE;
            if (t >= FROM) {
                SimulatedSitter now = sitter.withStiffness(factor.applyAsDouble(t));
                frequency += square(track.frequency() / now.frequency() - 1);
                damping += square(track.damping() / now.damping() - 1);
                heard[track.changed() ? track.heardBy().ordinal() : 0]++;
                n++;
            }
        }
        return new Run(frequency / n, damping / n, heard, estimator.track().divergences());
    }

    private static double square(double x) {
        return x * x;
    }

    private static Run[] runs(Method method, String detector, Course course, double snr, int count, long seed) {
        return IntStream.range(0, count).parallel().mapToObj(i -> run(method, Detectors.named(detector), course, snr, seed + i))
                .toArray(Run[]::new);
    }

    private static double rms(Run[] runs) {
        return Math.sqrt(Arrays.stream(runs).mapToDouble(Run::frequency).average().orElseThrow());
    }

    private static double rmsOfDamping(Run[] runs) {
        return Math.sqrt(Arrays.stream(runs).mapToDouble(Run::damping).average().orElseThrow());
    }

    private static void following(int count, long seed, List<String> methods) {
        System.out.println(
                "| signal to noise | stiffness | estimator | f0, rms error | over ekf | over ekf, 9 of 10 runs below | ζ, rms error "
                        + "| over ekf | changes heard a run |\n|---|---|---|---|---|---|---|---|---|");
        for (double snr : new double[] {Double.POSITIVE_INFINITY, 20, 10}) {
            for (Course course : Course.values()) {
                Run[] plain = runs(Method.EKF, Detectors.USUAL, course, snr, count, seed);
                for (String method : methods) {
                    Run[] runs = runs(Method.named(method).orElseThrow(), Detectors.USUAL, course, snr, count, seed);
                    double[] ratio = IntStream.range(0, count).mapToDouble(i -> runs[i].rms() / plain[i].rms()).sorted().toArray();
                    System.out.printf(Locale.ROOT, "| %s | %s | %s | %.3f %% | %.2f | %.2f | %.2f %% | %.2f | %.1f |%n",
                            Double.isFinite(snr) ? String.format(Locale.ROOT, "%.0f dB", snr) : "the sensors'",
                            course.name().toLowerCase(Locale.ROOT).replace('_', ' '), method, 100 * rms(runs), rms(runs) / rms(plain),
                            ratio[(int) Math.ceil(0.9 * count) - 1], 100 * rmsOfDamping(runs), rmsOfDamping(runs) / rmsOfDamping(plain),
                            Arrays.stream(runs).mapToLong(FollowingProof::changes).average().orElseThrow());
                }
            }
        }
    }

    private static long changes(Run run) {
        return Arrays.stream(run.heard).skip(1).sum();
    }

    private static void detectors(int count, long seed, double snr, Method method, List<String> detectors) {
        System.out.println("| " + method.word() + " with | stiffness | f0, rms error | changes heard a run | of these by the detector "
                + "| by other tests |\n|---|---|---|---|---|---|");
        for (String detector : detectors) {
            for (Course course : List.of(Course.NONE, Course.EVERY_10_S, Course.RAMPS, Course.SINE)) {
                Run[] runs = runs(method, detector, course, snr, count, seed);
                double all = Arrays.stream(runs).mapToLong(FollowingProof::changes).average().orElseThrow();
                double own = Arrays.stream(runs).mapToLong(r -> r.heard[ChangeTest.DETECTOR.ordinal()]).average().orElseThrow();
                System.out.printf(Locale.ROOT, "| %s | %s | %.3f %% | %.2f | %.2f | %.2f |%n", detector,
                        course.name().toLowerCase(Locale.ROOT).replace('_', ' '), 100 * rms(runs), all, own, all - own);
            }
        }
    }

    /** What was heard of sensors whose noise grows by a factor at 45 s, in the 45 s after. */
    public record Noisier(double delay, boolean early, boolean takenForTheBody, double frequency) {}

    /** One run. @param factor of both sensors' noise, from 0.04 m/s² on */
    public static Noisier noisier(Method method, Supplier<Alarm> alarms, double factor, long seed) {
        double noise = 0.04;
        SimulatedSitter sitter = SimulatedSitter.of(seed);
        SimulatedSitter.Motion clean = sitter.steady(RMS, (int) (90 * RATE), seed);
        SimulatedSitter.Motion before = clean.measured(noise, seed);
        SimulatedSitter.Motion after = clean.measured(factor * noise, seed);
        Estimator estimator = EstimatorDesign.of(method).withSeed(seed).estimator(new Spec(RATE, 5, 0.4, noise, noise, Spec.DRIFT), alarms);
        double delay = Double.POSITIVE_INFINITY;
        boolean early = false;
        boolean body = false;
        double frequency = 0;
        for (int i = 0; i < clean.u().length; i++) {
            double since = i / RATE - 45;
            SimulatedSitter.Motion now = since < 0 ? before : after;
            BodyEstimate track = estimator.step(now.u()[i], now.y()[i]);
            early |= track.cut() && since < 0 && since > FROM - 45;
            body |= track.changed() && since >= 0;
            if (track.cut() && since >= 0) {
                delay = Math.min(delay, since);
            }
            if (since >= 0) {
                frequency += square(track.frequency() / sitter.frequency() - 1) / (45 * RATE);
            }
        }
        return new Noisier(delay, early, body, frequency);
    }

    private static void noise(int count, long seed, Method method, List<String> detectors) {
        System.out.println("| " + method.word() + " with | noise grows | runs | heard before | heard | median delay | taken for the body "
                + "| f0, rms error after |\n|---|---|---|---|---|---|---|---|");
        for (String detector : detectors) {
            for (double factor : new double[] {1, 1.3, 2}) {
                List<Noisier> all = IntStream.range(0, count).parallel().mapToObj(i -> noisier(method, Detectors.named(detector), factor,
                        seed + i)).toList();
                double[] delays = all.stream().mapToDouble(Noisier::delay).sorted().toArray();
                double median = delays[count / 2];
                System.out.printf(Locale.ROOT, "| %s | x %.1f | %d | %d | %d | %s | %d | %.3f %% |%n", detector, factor, count,
                        all.stream().filter(Noisier::early).count(), Arrays.stream(delays).filter(Double::isFinite).count(),
                        Double.isFinite(median) ? String.format(Locale.ROOT, "%.1f s", median) : "not in 45 s",
                        all.stream().filter(Noisier::takenForTheBody).count(),
                        100 * Math.sqrt(all.stream().mapToDouble(Noisier::frequency).average().orElseThrow()));
            }
        }
    }
}
