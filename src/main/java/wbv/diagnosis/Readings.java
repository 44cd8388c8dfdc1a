package wbv.diagnosis;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import wbv.body.Simulator;

/**
 * What the outputs' sensors read, over the whole recording, where a model is right: its free run, seen with the small errors that the
 * sensors were found to have beside it on the data of the fit.
 */
final class Readings {

    private final Evidence evidence;
    private final ErrorShapes small;

    Readings(Evidence evidence) {
        this.evidence = evidence;
        this.small = ErrorShapes.of(evidence);
    }

    /** Series by output, in the unit of the output. */
    double[][] of(Fitter.State state) {
        Nuisances nuisances = state.frame().nuisances();
        double[][] spectra = new Simulator(evidence.whole()).run(state.candidate().at(state.x()), false).outputs();
        Nuisances.Lateness late = nuisances.around(state.errors()).lateness(evidence.whole().omega(), nuisances.off(state.candidate()),
                spectra.length);
        double[][] out = Arrays.stream(late.of(spectra)).map(evidence.whole()::series).toArray(double[][]::new);
        for (int i = 0; i < nuisances.count(); i++) {
            if (!small.errors().get(i).isDelay()) {
                add(out, state.errors()[i], small.shapes().get(i));
            }
        }
        return out;
    }

    /** @param out modified */
    private static void add(double[][] out, double size, double[][] shapes) {
        for (int o = 0; o < out.length; o++) {
            for (int i = 0; i < shapes[o].length; i++) {
                out[o][i] += size * shapes[o][i];
            }
        }
    }

    /** The errors found beside a model, by channel and name with unit; those of the input's sensor under {@code input}. */
    Map<String, Map<String, Double>> errors(Fitter.State state) {
        double step = evidence.recording().clock().step();
        Map<String, Map<String, Double>> out = new LinkedHashMap<>();
        for (int i = 0; i < state.frame().nuisances().count(); i++) {
            SmallError error = small.errors().get(i);
            String owner = error.isInput() ? "input" : evidence.outputs().get(error.owner()).toString();
            out.computeIfAbsent(owner, key -> new LinkedHashMap<>()).put(error.key(), state.errors()[i] * error.deviation(step));
        }
        return out;
    }
}
