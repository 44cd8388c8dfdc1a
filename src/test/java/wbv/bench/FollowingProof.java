package wbv.bench;

import java.util.Arrays;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import wbv.filter.Estimator;
import wbv.filter.Method;
import wbv.filter.Recipe;
import wbv.filter.SimulatedSitter;
import wbv.filter.Spec;
import wbv.filter.Track;
import wbv.learn.AdwinAlarm;

/** How well estimators follow a sitter whose spring changes. */
public final class FollowingProof {

    private static final double RMS = 0.8;
    static final double AMP = Double.parseDouble(System.getProperty("amp", "0.25"));
    private static final double FROM = 15;

    /** How the stiffness goes. */
    enum Course { NONE, SINGLE, STEPS5, STEPS10, STEPS30, RAMPS, SINE;

        DoubleUnaryOperator of(long seed) {
            SplittableRandom random = new SplittableRandom(31_000 + seed);
            double first = 0;
            return switch (this) {
                case NONE -> t -> 1;
                case SINGLE -> {
                    double at = 30 + 20 * random.nextDouble();
                    double factor = random.nextBoolean() ? 1 + AMP : 1 - AMP;
                    yield t -> t < at ? 1 : factor;
                }
                case STEPS5 -> steps(5, random);
                case STEPS10 -> steps(10, random);
                case STEPS30 -> steps(30, random);
                case RAMPS -> {
                    double period = 10 + 20 * random.nextDouble();
                    double phase = random.nextDouble();
                    yield t -> {
                        double x = (t / period + phase) % 1;
                        return 1 + AMP * (x < 0.25 ? 4 * x : x < 0.5 ? 1 : x < 0.75 ? 1 - 8 * (x - 0.5) : -1 + 4 * (x - 0.75));
                    };
                }
                case SINE -> {
                    double period = 5 + 35 * random.nextDouble();
                    double phase = random.nextDouble();
                    yield t -> 1 + AMP * Math.sin(2 * Math.PI * (t / period + phase));
                }
            };
        }

        private static DoubleUnaryOperator steps(double every, SplittableRandom random) {
            double offset = every * random.nextDouble();
            double[] level = new double[64];
            int last = 1;
            for (int i = 0; i < level.length; i++) {
                last = (last + 1 + random.nextInt(2)) % 3;
                level[i] = 1 - AMP + AMP * last;
            }
            return t -> level[(int) ((t + offset) / every)];
        }
    }

    private FollowingProof() { }

    static Estimator estimator(String word, double noise, long seed) {
        Spec spec = new Spec(60, 5, 0.4, noise, noise, Spec.DRIFT);
        return Recipe.of(Method.named(word).orElseThrow()).withSeed(seed).estimator(spec, () -> new AdwinAlarm(0.002));
    }

    public static void main(String[] words) {
        int count = Integer.parseInt(words[0]);
        int base = Integer.parseInt(words[1]);
        double seconds = 95;
        String[] methods = Arrays.copyOfRange(words, 2, words.length);
        for (double snr : new double[] {Double.POSITIVE_INFINITY, 20, 10}) {
            double noise = Double.isFinite(snr) ? RMS * Math.pow(10, -snr / 20) : Spec.noise(60);
            for (Course course : Course.values()) { if (!System.getProperty("courses", course.name()).contains(course.name())) continue;
                double[][][] all = IntStream.range(0, count).parallel().mapToObj(i -> {
                    long seed = base + i;
                    SimulatedSitter sitter = SimulatedSitter.of(seed);
                    DoubleUnaryOperator factor = course.of(seed);
                    SimulatedSitter.Motion motion = sitter.changing(factor, RMS, seconds, seed).measured(noise, seed);
                    double[][] results = new double[methods.length][];
                    for (int m = 0; m < methods.length; m++) {
                        results[m] = follow(estimator(methods[m], noise, seed), sitter, factor, motion);
                    }
                    return results;
                }).toArray(double[][][]::new);
                StringBuilder line = new StringBuilder(String.format(Locale.ROOT, "%-4.0f %-8s", snr, course));
                double[] plain = null;
                for (int m = 0; m < methods.length; m++) {
                    int mm = m;
                    double[] rms = Arrays.stream(all).mapToDouble(r -> r[mm][0]).toArray();
                    double alarms = Arrays.stream(all).mapToDouble(r -> r[mm][1]).average().orElse(0);
                    double lost = Arrays.stream(all).mapToDouble(r -> r[mm][2]).sum();
                    double total = Math.sqrt(Arrays.stream(rms).map(v -> v * v).average().orElse(0));
                    if (m == 0) plain = rms;
                    double[] p = plain;
                    double[] ratio = IntStream.range(0, rms.length).mapToDouble(i -> rms[i] / p[i]).sorted().toArray();
                    line.append(String.format(Locale.ROOT, " | %6.3f%% r %.2f [%.2f %.2f %.2f] z %.2f%% al %.1f lost %.0f", 100 * total,
                            total / Math.sqrt(Arrays.stream(plain).map(v -> v * v).average().orElse(0)), ratio[ratio.length / 10], ratio[ratio.length / 2],
                            ratio[ratio.length * 9 / 10], 100 * Math.sqrt(Arrays.stream(all).mapToDouble(r -> r[mm][3] * r[mm][3]).average().orElse(0)), alarms, lost));
                }
                System.out.println(line);
            }
        }
    }

    private static double[] follow(Estimator estimator, SimulatedSitter sitter, DoubleUnaryOperator factor, SimulatedSitter.Motion motion) {
        double squares = 0;
        double zeta = 0;
        int n = 0;
        long before = 0;
        for (int i = 0; i < motion.u().length; i++) {
            Track track = estimator.step(motion.u()[i], motion.y()[i]);
            double t = i / 60.0;
            if (t < FROM) {
                before = track.changes();
                continue;
            }
            SimulatedSitter now = sitter.withStiffness(factor.applyAsDouble(t));
            double e = track.frequency() / now.frequency() - 1;
            double z = track.damping() / now.damping() - 1;
            squares += e * e;
            zeta += z * z;
            n++;
        }
        return new double[] {Math.sqrt(squares / n), estimator.track().changes() - before, estimator.track().divergences(), Math.sqrt(zeta / n)};
    }
}
