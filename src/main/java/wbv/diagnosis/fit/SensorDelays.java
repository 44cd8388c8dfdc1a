package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import wbv.diagnosis.measured.SmallError;
import wbv.signal.ScalarProduct;

/**
 * How late sensors are: one delay for all outputs that are late together. Delays alone of all small errors are not linear up to
 * the highest line that counts: they are exact about where a fit has them, and only what they are more or less counts to first order.
 */
public final class SensorDelays {

    private final List<SmallError> errors;
    /** First of the outputs that are late with it, by output: the owner of what all have. */
    private final List<Integer> clocks;
    private final double sample;
    /** Delays that are exact, in standard deviations; 0 for all other errors. */
    private final double[] exact;

    /** None yet. */
    static SensorDelays of(Evidence evidence, List<SmallError> errors) {
        return new SensorDelays(errors, IntStream.range(0, evidence.outputs().size()).mapToObj(o -> Place.late(evidence, o).get(0))
                .toList(), evidence.measured().sample());
    }

    /**
     * None yet.
     *
     * @param clocks by output, the first of those that are late with it
     * @param sample time between two samples as they were recorded [s]
     */
    SensorDelays(List<SmallError> errors, List<Integer> clocks, double sample) {
        this(errors, clocks, sample, new double[errors.size()]);
    }

    private SensorDelays(List<SmallError> errors, List<Integer> clocks, double sample, double[] exact) {
        this.errors = errors;
        this.clocks = clocks;
        this.sample = sample;
        this.exact = exact;
    }

    /**
     * The same, exact about these sizes.
     *
     * @param sizes of all errors, in standard deviations. Not modified.
     */
    SensorDelays about(double[] sizes) {
        return new SensorDelays(errors, clocks, sample,
                IntStream.range(0, sizes.length).mapToDouble(i -> errors.get(i).isDelay() ? sizes[i] : 0).toArray());
    }

    /**
     * The same delays of sensors against the input's, its own being what is likeliest beside them. Beside a sensor whose delay is at fault,
     * which takes any share of what all have in common, nothing but this tells how late the input is.
     *
     * @param sizes in standard deviations. Not modified.
     * @param off errors that are not asked, see {@link Nuisances#off}
     */
    double[] likeliest(double[] sizes, boolean[] off) {
        int[] delayed = IntStream.range(0, sizes.length).filter(i -> errors.get(i).isDelay() && !errors.get(i).isInput()).toArray();
        double[] out = sizes.clone();
        if (IntStream.range(0, sizes.length).anyMatch(i -> off[i] && errors.get(i).isInput())) {
            // All that the outputs have in common is the input's.
            double common = IntStream.of(delayed).mapToDouble(i -> sizes[i]).average().orElse(0);
            IntStream.of(delayed).forEach(i -> out[i] -= common);
        } else if (IntStream.of(delayed).anyMatch(i -> off[i])) {
            int input = IntStream.range(0, sizes.length).filter(i -> errors.get(i).isInput()).findFirst().orElseThrow();
            int[] own = IntStream.of(delayed).filter(i -> !off[i]).toArray();
            // Least Σ (d + input)² + input² over the others' delays d against the input's.
            out[input] = -IntStream.of(own).mapToDouble(i -> sizes[i] - sizes[input]).sum() / (own.length + 1);
            IntStream.of(own).forEach(i -> out[i] = sizes[i] - sizes[input] + out[input]);
        }
        return out;
    }

    /**
     * How late the sensors are for whose delays the errors are exact.
     *
     * @param omega by line of what is simulated [rad/s]
     * @param off errors that are not asked, see {@link Nuisances#off}. Neither is modified.
     */
    public Lateness lateness(double[] omega, boolean[] off, int outputs) {
        double[] delay = new double[outputs];
        for (int i = 0; i < exact.length; i++) {
            double own = off[i] || exact[i] == 0 ? 0 : errors.get(i).deviation(sample) * exact[i];
            for (int o = 0; o < outputs; o++) {
                delay[o] += errors.get(i).isInput() ? -own : isOf(errors.get(i), o) ? own : 0;
            }
        }
        return new Lateness(Arrays.stream(delay)
                .mapToObj(late -> late == 0 ? new double[0] : Lateness.factor(omega.length, k -> omega[k], 1, late))
                .toArray(double[][]::new));
    }

    /** Sizes of errors, in standard deviations, that take back what is exact, where they are asked. */
    double[] takenBack(boolean[] off) {
        return IntStream.range(0, exact.length).mapToDouble(i -> off[i] ? 0 : -exact[i]).toArray();
    }

    /**
     * How odd it is [1] that a clock is as late as it is against the input's and all others: by how much less the squares of all delays add
     * up to at least, in standard deviations, if its own were not scatter; in the mean of its outputs, where these have delays of their
     * own. Of sensors that only scatter it is distributed as χ² of one degree of freedom, however many there are beside it; data tell no
     * delay but against the input's.
     *
     * @param outputs of this clock
     * @param sizes one an error, in standard deviations [1]. Not modified.
     * @param off errors that are not asked, see {@link Nuisances#off}. Not modified.
     * @return [1]
     */
    public double oddness(List<Integer> outputs, double[] sizes, boolean[] off) {
        long delays = outputs.stream().map(clocks::get).distinct().count();
        Predicate<SmallError> others = error -> outputs.stream().noneMatch(output -> isOf(error, output));
        return (least(sizes, off, error -> true) - least(sizes, off, others)) / delays;
    }

    /** Least sum of squares of the delays of the input's sensor and of some others [1]. */
    private double least(double[] sizes, boolean[] off, Predicate<SmallError> scatters) {
        int[] inputs = delays(off).filter(i -> errors.get(i).isInput()).toArray();
        double input = IntStream.of(inputs).mapToDouble(i -> sizes[i]).sum();
        double[] against = delays(off).filter(i -> !errors.get(i).isInput() && scatters.test(errors.get(i)))
                .mapToDouble(i -> sizes[i] - input).toArray();
        double sum = Arrays.stream(against).sum();
        // Least Σ (d + u)² + u² over the input's delay u.
        return ScalarProduct.of(against, against) - inputs.length * sum * sum / (against.length + 1);
    }

    /** Whether an error is the delay of an output's clock. */
    private boolean isOf(SmallError error, int output) {
        return error.isDelay() && error.owner() == clocks.get(output);
    }

    /** Those outputs. */
    IntStream outputs(SmallError error) {
        return IntStream.range(0, clocks.size()).filter(output -> isOf(error, output));
    }

    private IntStream delays(boolean[] off) {
        return IntStream.range(0, off.length).filter(i -> errors.get(i).isDelay() && !off[i]);
    }

    /**
     * How late an output's sensor is [s].
     *
     * @param sizes one an error, in standard deviations [1]. Not modified.
     */
    public double of(int output, double[] sizes) {
        return IntStream.range(0, sizes.length).filter(i -> isOf(errors.get(i), output))
                .mapToDouble(i -> errors.get(i).deviation(sample) * sizes[i]).sum();
    }
}
