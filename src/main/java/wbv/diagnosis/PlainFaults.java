package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.SensorFault;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.measured.Rounding;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.SensorBias;
import wbv.diagnosis.mechanism.SensorDropouts;
import wbv.diagnosis.mechanism.SensorQuantised;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/** Faults of sensors that show without any fit: dropouts, steps, and a gross bias or one that drifts. */
final class PlainFaults {

    /** What has no mean in the long run. */
    private static final Set<Quantity> CENTRED = Set.of(Quantity.ACCELERATION, Quantity.ANGULAR_RATE);
    /** Repeated samples that happen. */
    private static final int REPEATED = 2;
    /** A bias that sensors have [m/s² or rad/s]. */
    private static final double USUAL = 0.05;
    /** Standard deviations of a mean that are no bias. */
    private static final double SURE = 8;
    /** From here on it is gravity, or a unit, and no bias. */
    private static final double ABSURD = 5;
    /** Parts of a recording in which a zero may be another, an effort: with so many {@link #isSlow} has room below its bound. */
    private static final int PARTS = 16;
    /** Standard deviations by which what drifts differs from what does not. */
    private static final double SLOW = 3;

    private final Evidence evidence;

    PlainFaults(Evidence evidence) {
        this.evidence = evidence;
    }

    /**
     * @param base without anything added
     * @param best a sensor that clips in it has no other fault here
     */
    List<Diagnosis.Named> in(Fitter.State base, Fitter.State best) {
        List<Diagnosis.Named> out = new ArrayList<>();
        double[] modelled = modelled(best);
        if (evidence.onRig()) {
            evidence.model().excitations().forEach(input -> steps(input, Double.POSITIVE_INFINITY, base).ifPresent(out::add));
        }
        for (int o = 0; o < evidence.outputs().size(); o++) {
            String where = evidence.outputs().get(o).toString();
            if (evidence.measured().repeated(o) > REPEATED) {
                Map<String, Double> count = Map.of("samples", (double) evidence.measured().repeated(o));
                out.add(new Diagnosis.Named(new SensorDropouts().word(), where, 0.98, count, Map.of(), base.reduced()));
            }
            if (evidence.onRig()) {
                steps(evidence.outputs().get(o), Math.sqrt(2), base).ifPresent(out::add);
            }
            boolean clipped = clips(best, o);
            double bias = evidence.measured().mean(o) - shared(o) - modelled[o];
            double bound = USUAL + SURE * evidence.noise()[o] / Math.sqrt(evidence.recording().length());
            boolean centred = CENTRED.contains(evidence.outputs().get(o).quantity());
            if (centred && !clipped && Math.abs(bias) < ABSURD) {
                double[] course = course(o, bias);
                double range = Arrays.stream(course).max().orElseThrow() - Arrays.stream(course).min().orElseThrow();
                boolean drifts = range > 2 * bound && isSlow(course);
                if (drifts || Math.abs(bias) > bound) {
                    double second = evidence.noise()[o] / Math.sqrt(evidence.recording().clock().rate());
                    out.add(new Diagnosis.Named(new SensorBias().word(), where, 0.95,
                            drifts ? Map.of("bias", bias, SensorBias.RANGE, range) : Map.of("bias", bias),
                            Map.of("bias", Interval.normal(bias, drifts ? range / Math.sqrt(PARTS) : second)), base.reduced()));
                }
            }
        }
        return out;
    }

    /**
     * What an output reads on average in parts of the recording beyond what the others do, in its unit.
     *
     * @param bias of the whole
     */
    private double[] course(int output, double bias) {
        List<double[]> others = alike(output).map(other -> parts(evidence.recording().values(other))).toList();
        double[] course = parts(evidence.recording().values(evidence.outputs().get(output)));
        double[] out = new double[PARTS];
        Arrays.setAll(out, k -> course[k] - median(others.stream().mapToDouble(parts -> parts[k])));
        double mean = Arrays.stream(out).filter(Double::isFinite).average().orElse(0);
        Arrays.setAll(out, k -> bias + (Double.isFinite(out[k]) ? out[k] - mean : 0));
        return out;
    }

    /** Means of parts of a series less that of the whole; no number where all of one is lost. */
    private static double[] parts(double[] x) {
        double whole = mean(x).orElse(0);
        double[] out = new double[PARTS];
        Arrays.setAll(out, k -> mean(Arrays.copyOfRange(x, k * x.length / PARTS, (k + 1) * x.length / PARTS)).orElse(Double.NaN) - whole);
        return out;
    }

    /**
     * Whether what follows is nearer than what does not: the mean square of successive differences over the variance, 2 with a variance of
     * 4 (n - 2) / (n² - 1) where nothing goes on (von Neumann 1941), less than that by three standard deviations. What a body's motion adds
     * to means of parts goes the other way: they sum up to nothing.
     */
    private static boolean isSlow(double[] course) {
        double mean = Arrays.stream(course).average().orElseThrow();
        double square = Arrays.stream(course).map(x -> (x - mean) * (x - mean)).sum();
        double steps = IntStream.range(1, course.length).mapToDouble(k -> course[k] - course[k - 1]).map(step -> step * step).sum();
        double n = course.length;
        return steps < (2 - SLOW * 2 * Math.sqrt((n - 2) / (n * n - 1))) * square;
    }

    /**
     * Steps that are coarse, and make at least half of a sensor's noise.
     *
     * @param most noise of the sensor over that of its steps, where it is known
     */
    private Optional<Diagnosis.Named> steps(Channel channel, double most, Fitter.State base) {
        int output = evidence.outputs().indexOf(channel);
        return Rounding.coarse(evidence.recording().values(channel))
                .filter(steps -> output < 0 || evidence.noise()[output] < most * steps.noise())
                .map(steps -> new Diagnosis.Named(new SensorQuantised().word(), channel.toString(), 0.98,
                        Map.of(key(channel), steps.step()), Map.of(), base.reduced()));
    }

    private static String key(Channel channel) {
        return switch (channel.quantity()) {
            case POSITION -> "step_m";
            case FORCE -> "step_N";
            case VELOCITY -> "step_m_per_s";
            default -> "step_[" + channel.quantity().unit() + "]";
        };
    }

    /** The mean that a model gives an output: of bodies that turn by whole angles, which are thrown about; of all others nothing. */
    private double[] modelled(Fitter.State fit) {
        double[] out = new double[evidence.outputs().size()];
        if (evidence.model().base().at().isPresent() && !fit.failed()) {
            double[][] spectra = new Simulator(evidence.whole()).run(fit.candidate().at(fit.x()), false).outputs();
            Arrays.setAll(out, o -> Arrays.stream(evidence.whole().series(spectra[o])).average().orElse(0));
        }
        return out;
    }

    private static boolean clips(Fitter.State fit, int output) {
        return fit.candidate().added().stream().flatMap(h -> h.additions().stream())
                .anyMatch(a -> a instanceof Addition.AtSensor at && at.output() == output
                        && at.fault() instanceof SensorFault.Clipping);
    }

    /**
     * The mean that an output shares with all other sensors of its kind: who ends a recording faster than he began it was accelerated on
     * average. The median of their means and of nothing, the nearer to nothing of two, so that no single bias is shared out.
     */
    private double shared(int output) {
        return median(alike(output).mapToDouble(other -> evidence.outputs().contains(other)
                ? evidence.measured().mean(evidence.outputs().indexOf(other))
                : mean(evidence.recording().values(other)).orElse(Double.NaN)));
    }

    /** The other sensors of an output's kind, of the base too. */
    private Stream<Channel> alike(int output) {
        Channel own = evidence.outputs().get(output);
        return Stream.concat(evidence.outputs().stream(), evidence.model().base().sensors().stream())
                .filter(other -> !other.equals(own) && other.quantity() == own.quantity() && other.axis() == own.axis());
    }

    /** Of some means and of nothing, the nearer to nothing of two. */
    private static double median(DoubleStream means) {
        double[] sorted = DoubleStream.concat(DoubleStream.of(0), means.filter(Double::isFinite)).sorted().toArray();
        double low = sorted[(sorted.length - 1) / 2];
        double high = sorted[sorted.length / 2];
        return Math.abs(low) < Math.abs(high) ? low : high;
    }

    private static OptionalDouble mean(double[] x) {
        return Arrays.stream(x).filter(value -> !Double.isNaN(value)).average();
    }
}
