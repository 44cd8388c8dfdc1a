package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.SmallError;

/**
 * What the outputs' sensors read, over the whole recording, where a model is right: its free run, seen with the small errors that the
 * sensors were found to have beside it on the data of the fit.
 */
public final class Readings {

    private final Evidence evidence;
    private final ErrorShapes small;

    /** Of all outputs of the evidence. */
    public Readings(Evidence evidence) {
        this.evidence = evidence;
        this.small = ErrorShapes.of(evidence);
    }

    /** Series by output, in the unit of the output. With no errors where the fit failed. */
    public double[][] of(Fitter.State state) {
        Simulator.Response run = new Simulator(evidence.whole()).run(state.candidate().at(state.x()), false);
        Nuisances nuisances = state.frame().nuisances();
        double[] sizes = state.failed() ? new double[nuisances.count()] : sizes(state);
        Lateness late = nuisances.delays().about(sizes).lateness(evidence.whole().omega(), nuisances.off(state.candidate()),
                run.outputs().length);
        double[][] out = Arrays.stream(late.of(run)).map(evidence.whole()::series).toArray(double[][]::new);
        double[] framed = state.frame().x();
        ErrorShapes all = small.and(Beginnings.of(evidence, evidence.whole(), state.candidate(), framed))
                .and(WrongWay.of(evidence.whole(), state.candidate(), framed,
                        () -> new Simulator(evidence.whole()).run(state.candidate().at(framed), false)));
        double[] gain = new double[out.length];
        for (int i = 0; i < sizes.length; i++) {
            SmallError error = nuisances.error(i);
            switch (error.kind()) {
                case GAIN -> gain[error.owner()] = sizes[i] * error.kind().deviation();
                case DELAY -> {}   // exact, above
                case AXIS_GAIN, AXIS_DELAY, AXIS_TILT, AXIS_ARM, START -> {
                    for (int o = 0; o < out.length; o++) {
                        add(out[o], sizes[i], all.shapes().get(i)[o]);
                    }
                }
                case TILT, SWAY, HEIGHT, ARM, WAY ->
                    add(out[error.owner()], nuisances.scale(i) * sizes[i], all.shapes().get(i)[error.owner()]);
            }
        }
        for (int o = 0; o < out.length; o++) {
            for (int i = 0; i < out[o].length; i++) {
                out[o][i] /= 1 - gain[o];   // a gain is a part of what is read, not of what acts
            }
            level(o, out[o]);
        }
        return out;
    }

    /** Sizes of the errors as the data of the fit have them; of how a rig begins after these, as what follows has them. */
    private double[] sizes(Fitter.State state) {
        double[] out = state.errors().clone();
        Nuisances nuisances = state.frame().nuisances();
        int[] later = IntStream.range(0, out.length)
                .filter(i -> out[i] == 0 && nuisances.error(i).kind() == SmallError.Kind.START).toArray();
        if (later.length > 0) {
            double[] proof = new Fitter(evidence, evidence.whole()).look(state.candidate(), state.x(), evidence.heldOut()).errors();
            Arrays.stream(later).forEach(i -> out[i] = proof[i]);
        }
        return out;
    }

    /**
     * What was measured beyond readings: spectra by output at the lines of the whole recording, in the unit of the output. Faded in and out
     * for a second, so that its ends make no noise.
     *
     * @param read series by output, in its unit. Not modified.
     */
    public double[][] beyond(double[][] read) {
        double rate = evidence.whole().rate();
        double[][] out = new double[read.length][];
        for (int o = 0; o < out.length; o++) {
            double[] left = new double[read[o].length];
            for (int i = 0; i < left.length; i++) {
                double inside = Math.min(1, Math.min(i + 0.5, left.length - i - 0.5) / rate);
                double fading = Math.pow(Math.sin(Math.PI / 2 * inside), 2);
                left[i] = evidence.valid(o)[i] ? fading * (evidence.measured(o)[i] - read[o][i]) : 0;
            }
            out[o] = evidence.whole().spectrum(left);
        }
        return out;
    }

    /**
     * Where a constant does not count, it is what the data of the fit have.
     *
     * @param read modified
     */
    private void level(int output, double[] read) {
        Window fit = evidence.fit();
        double off = evidence.spectra().isLevelled(
                output) ? IntStream.range(fit.start(), fit.start() + fit.length()).filter(i -> evidence.valid(output)[i])
                        .mapToDouble(i -> evidence.measured(output)[i] - read[i]).average().orElse(0) : 0;
        for (int i = 0; i < read.length; i++) {
            read[i] += off;
        }
    }

    /**
     * Adds an error's share, without its constant part where constants do not count.
     *
     * @param to modified
     * @param shape empty where it adds nothing
     */
    private void add(double[] to, double size, double[] shape) {
        double mean = evidence.onRig() ? 0 : Arrays.stream(shape).average().orElse(0);
        for (int i = 0; i < shape.length; i++) {
            to[i] += size * (shape[i] - mean);
        }
    }

    /**
     * The errors found beside a model, by channel and name with unit; those of the input's sensor under {@code input}. None of a sensor
     * that is blamed for a large error of the same kind, or where the fit failed.
     */
    public static Map<String, Map<String, Double>> errors(Evidence evidence, Fitter.State state) {
        Nuisances nuisances = state.frame().nuisances();
        boolean[] off = nuisances.off(state.candidate());
        double sample = evidence.measured().sample();
        Map<String, Map<String, Double>> out = new LinkedHashMap<>();
        for (int i = 0; i < state.errors().length; i++) {
            SmallError error = nuisances.error(i);
            double size = state.errors()[i] * error.deviation(sample);
            Stream<String> owners = error.owner() == SmallError.INPUT ? Stream.of("input")
                    : nuisances.outputs(error).mapToObj(o -> evidence.outputs().get(o).toString());
            if (!off[i] && error.isOfSensor()) {
                owners.forEach(owner -> out.computeIfAbsent(owner, key -> new LinkedHashMap<>()).put(error.key(), size));
            }
        }
        return out;
    }
}
