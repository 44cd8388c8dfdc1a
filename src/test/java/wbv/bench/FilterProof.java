package wbv.bench;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import wbv.filter.AccompaniedEstimator;
import wbv.filter.BodyEstimate;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.Method;
import wbv.filter.model.Spec;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.rig.RigSpec;

/**
 * The long proof of the streaming estimators on the rig's data, as tables for {@code docs/thesis.md}: {@code starts COUNT
 * SNR_DB METHOD…}, {@code steps COUNT SNR_DB METHOD…}, {@code quiet MINUTES SNR_DB METHOD…}, and
 * {@code cells INPUT SECONDS NOISE PEOPLE VARIANT…}, from the {@code seat} or the {@code platform}, NOISE in times that of the sensors; a
 * variant is a method with its degrees of freedom, {@code particle/1}, or crossed by the input's other motions of the same plane,
 * {@code particle/1/plane}, or by all five others, {@code particle/1/all}.
 */
public final class FilterProof {

    private static final double RATE = 60;
    private static final double RMS = 0.8;

    private FilterProof() {}

    public static void main(String[] words) {
        switch (words[0]) {
            case "starts" -> each(words, 3, method -> starts(method, integer(words, 1), Double.parseDouble(words[2])));
            case "steps" -> each(words, 3, method -> steps(method, integer(words, 1), Double.parseDouble(words[2])));
            case "quiet" -> each(words, 3, method -> quiet(method, integer(words, 1), Double.parseDouble(words[2])));
            case "cells" -> cells(new Asked(words[1], integer(words, 2), Double.parseDouble(words[3]), integer(words, 4)),
                    Arrays.stream(words).skip(5).map(Variant::of).toList());
            default -> throw new IllegalArgumentException("starts, steps, quiet or cells: " + words[0]);
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
        return EstimatorDesign.of(method).withSeed(seed).estimator(new Spec(RATE, f, zeta, noise, noise, Spec.DRIFT),
                () -> new AdwinAlarm(0.002));
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
            BodyEstimate track = estimator.track();
            return error(track, one.frequency, one.damping);
        }).toArray();
        long good = Arrays.stream(error).filter(e -> e <= 0.05).count();
        Arrays.sort(error);
        System.out.printf(Locale.ROOT, "| %s | %s | %d | %.1f %% | %.2f %% | %.2f %% | %.1f s |%n", method.word(), snr, count,
                100.0 * good / count,
                100 * error[count / 2], 100 * error[(int) (0.99 * (count - 1))], (System.nanoTime() - before) * 1e-9);
    }

    private static double error(BodyEstimate track, double frequency, double damping) {
        return Math.max(Math.abs(track.frequency() / frequency - 1), Math.abs(track.damping() / damping - 1));
    }

    /** A stiffness step of 15 % at 30 s: when it is heard, and when the parameters are within 5 % again. */
    private static void steps(Method method, int count, double snr) {
        double[][] found = IntStream.range(0, count).parallel().mapToObj(seed -> {
            double factor = seed % 2 == 0 ? 1.15 : 1 / 1.15;
            Case one = Case.of(seed, Double.isFinite(snr) ? 68 : 45, snr, factor, 30);
            Estimator estimator = estimator(method, 5, 0.4, snr, seed);
            double heard = Double.POSITIVE_INFINITY;
            double learned = Double.POSITIVE_INFINITY;
            long early = 0;
            double f = one.frequency * Math.sqrt(factor);
            double zeta = one.damping / Math.sqrt(factor);
            for (int i = 0; i < one.u.length; i++) {
                BodyEstimate track = estimator.step(one.u[i], one.y[i]);
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
        System.out.printf(Locale.ROOT,
                "| %s | %s | %d | heard ≤1 s %.1f %% | median %.2f s | 99 %% %.2f s "
                        + "| f within 3 %%: ≤1 s %.1f %% median %.2f s, 99 %% %.2f s | early %d |%n",
                method.word(), snr, count, 100.0 * Arrays.stream(heard).filter(t -> t <= 1).count() / count, heard[count / 2],
                heard[(int) (0.99 * (count - 1))],
                100.0 * Arrays.stream(learned).filter(t -> t <= 1).count() / count,
                learned[count / 2], learned[(int) (0.99 * (count - 1))], Arrays.stream(found).mapToLong(x -> (long) x[2]).sum());
    }

    /** False alarms on sitters that do not change. */
    private static void quiet(Method method, int minutes, double snr) {
        long alarms = IntStream.range(0, minutes / 6).parallel().mapToLong(seed -> {
            Case one = Case.of(5000 + seed, 390, snr, 1, 0);
            Estimator estimator = estimator(method, 5, 0.4, snr, seed);
            long changes = 0;
            for (int i = 0; i < one.u.length; i++) {
                changes += estimator.step(one.u[i], one.y[i]).changed() && i >= 30 * RATE ? 1 : 0;
            }
            return changes;
        }).sum();
        System.out.printf("| %s | %s | %d min | %d false alarms |%n", method.word(), snr, minutes / 6 * 6, alarms);
    }

    /** As Tables 5-3 and 5-4 of the thesis name them, in their order. */
    private static final List<String> PLACES = List.of("pelvis", "sternum", "right_shoulder", "left_shoulder", "head");
    private static final List<String> PEOPLE = List.of("1", "2", "3", "4", "random:1", "random:2", "random:3", "random:4");
    /** All but the first, which is rest. */
    private static final int REGIMES = 8;
    /** Errors count over the last part of a recording [s]. */
    private static final double SCORED = 30;
    private static final int PARTICLES = 500;

    /** Motions of the base beside the input that move a place along or about an axis: those of the same plane. */
    private static final Map<String, List<String>> CROSSING = Map.of("acc.x", List.of("acc.z", "gyr.y"), "acc.y", List.of("gyr.x"),
            "acc.z", List.of("acc.x", "gyr.y"), "gyr.x", List.of("acc.y"), "gyr.y", List.of("acc.x", "acc.z"), "gyr.z", List.of());
    private static final List<String> MOTIONS = List.of("acc.x", "acc.y", "acc.z", "gyr.x", "gyr.y", "gyr.z");
    /** What is to be measured on. @param input place of it @param noise of the sensors, in times the usual @param people so many */
    private record Asked(String input, int seconds, double noise, int people) {

        Recording recording(int number) {
            String person = PEOPLE.get(number / REGIMES);
            int regime = 1 + number % REGIMES;
            return RigSpec.parse(String.format(Locale.ROOT, "subject=%s regime=%d seconds=%d seed=%d noise=%s", person, regime, seconds,
                    1000 * PEOPLE.indexOf(person) + 40 + regime, noise)).recording();
        }

        Spec spec(String quantity) {
            Spec usual = quantity.equals("gyr") ? Spec.rotary(RATE) : Spec.at(RATE);
            return usual.withNoise(noise * usual.inputNoise());
        }
    }

    /** By what it is measured. */
    private record Variant(Method method, int degrees, String crossed) {

        static Variant of(String word) {
            String[] part = word.split("/");
            return new Variant(Method.named(part[0]).orElseThrow(), Integer.parseInt(part[1]), part.length > 2 ? part[2] : "");
        }

        List<String> others(String motion) {
            return switch (crossed) {
                case "" -> List.of();
                case "plane" -> CROSSING.get(motion);
                case "all" -> MOTIONS.stream().filter(other -> !other.equals(motion)).toList();
                default -> throw new IllegalArgumentException("plane or all: " + crossed);
            };
        }
    }

    /**
     * What came of one cell of one recording.
     *
     * @param mse      mean square of what was foreseen amiss
     * @param relative the same over the output's variance
     * @param apart    mean square of what is between the place and the input, over that of both sensors' noise
     * @param failed   lost in the part that counts, or no better than foreseeing nothing
     * @param bodiless the samples did not tell frequency and damping ratio
     */
    private record Cell(double mse, double relative, double apart, boolean failed, boolean bodiless) {}

    /** Tables in the shape of 5-3 and 5-4 of the thesis: five places by three axes, people by regimes. */
    private static void cells(Asked asked, List<Variant> variants) {
        List<String> quantities = List.of("gyr", "acc");
        Cell[][][][][] all = new Cell[asked.people * REGIMES][][][][];
        IntStream.range(0, all.length).parallel().forEach(i -> {
            Recording recording = asked.recording(i);
            all[i] = variants.stream().map(variant -> quantities.stream().map(quantity -> cells(asked, variant, quantity, recording))
                    .toArray(Cell[][][]::new)).toArray(Cell[][][][]::new);
        });
        for (int v = 0; v < variants.size(); v++) {
            for (int q = 0; q < quantities.size(); q++) {
                System.out.printf(Locale.ROOT, "%n%s, from the %s, noise × %s, %s: median MSE; median over the output's variance; "
                        + "failures of %d; without a body; what is between place and input over the sensors' noise%n%n",
                        variants.get(v), asked.input, asked.noise, quantities.get(q), all.length);
                System.out.println("| | x | y | z |\n|---|---|---|---|");
                for (int place = 0; place < PLACES.size(); place++) {
                    StringBuilder line = new StringBuilder("| " + PLACES.get(place));
                    for (int axis = 0; axis < 3; axis++) {
                        int[] at = {v, q, place, axis};
                        List<Cell> cell = Arrays.stream(all).map(recording -> recording[at[0]][at[1]][at[2]][at[3]]).toList();
                        line.append(String.format(Locale.ROOT, " | %.2g; %.3f; %d; %d; %.2g", median(cell, Cell::mse),
                                median(cell, Cell::relative), cell.stream().filter(Cell::failed).count(),
                                cell.stream().filter(Cell::bodiless).count(), median(cell, Cell::apart)));
                    }
                    System.out.println(line + " |");
                }
            }
        }
    }

    private static double median(List<Cell> cells, ToDoubleFunction<Cell> what) {
        double[] sorted = cells.stream().mapToDouble(what).sorted().toArray();
        return sorted[sorted.length / 2];
    }

    private static Cell[][] cells(Asked asked, Variant variant, String quantity, Recording recording) {
        Spec spec = asked.spec(quantity);
        Cell[][] cells = new Cell[PLACES.size()][3];
        for (int axis = 0; axis < 3; axis++) {
            String suffix = "." + quantity + "." + "xyz".charAt(axis);
            double[] u = recording.values(Channel.parse(asked.input + suffix));
            double[][] others = variant.others(suffix.substring(1)).stream()
                    .map(other -> recording.values(Channel.parse(asked.input + "." + other))).toArray(double[][]::new);
            for (int place = 0; place < PLACES.size(); place++) {
                Estimator estimator = EstimatorDesign.of(variant.method).withDegrees(variant.degrees).withParticles(PARTICLES)
                        .estimator(spec, () -> new AdwinAlarm(0.002));
                cells[place][axis] = score(new AccompaniedEstimator(estimator, others.length), u, others,
                        recording.values(Channel.parse(PLACES.get(place) + suffix)), spec);
            }
        }
        return cells;
    }

    private static Cell score(AccompaniedEstimator estimator, double[] u, double[][] others, double[] y, Spec spec) {
        int from = (int) Math.max(0, u.length - SCORED * RATE);
        double errors = 0;
        double sum = 0;
        double squares = 0;
        int count = 0;
        long lostBefore = 0;
        double apart = 0;
        double apartSquares = 0;
        double[] now = new double[others.length];
        for (int i = 0; i < u.length; i++) {
            for (int j = 0; j < now.length; j++) {
                now[j] = others[j][i];
            }
            BodyEstimate track = estimator.step(u[i], now, y[i]);
            double error = y[i] - track.prediction();
            if (i == from) {
                lostBefore = track.divergences();
            }
            if (i >= from && Double.isFinite(error)) {
                errors += error * error;
                sum += y[i];
                squares += y[i] * y[i];
                apart += y[i] - u[i];
                apartSquares += (y[i] - u[i]) * (y[i] - u[i]);
                count++;
            }
        }
        double mse = errors / count;
        double relative = mse / (squares / count - sum / count * sum / count);
        double between = apartSquares / count - apart / count * apart / count;
        double noise = spec.inputNoise() * spec.inputNoise() + spec.outputNoise() * spec.outputNoise();
        BodyEstimate track = estimator.estimator().track();
        boolean failed = track.divergences() > lostBefore || !Double.isFinite(mse) || relative >= 1;
        return new Cell(mse, relative, between / noise, failed, !track.found());
    }
}
