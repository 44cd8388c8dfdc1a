package wbv.diagnosis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import wbv.body.Assembly;
import wbv.body.Excitation;
import wbv.body.Simulator;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * What small errors of the input's sensor do: tilted, or away from where it should be, it reads what nobody drives the model with, and every
 * output lacks what the model makes of that. Its delay is among the outputs' errors, its gain in theirs.
 */
final class InputErrors {

    private InputErrors() { }

    /** One standard deviation of each, whitened. @param linear the model, made linear */
    static List<double[]> columns(Evidence evidence, Assembly linear, Whitening whitening) {
        List<double[]> out = new ArrayList<>();
        Optional<Channel> base = evidence.model().base().sensor();
        if (base.isEmpty() || base.get().quantity() != Quantity.ACCELERATION || evidence.isComputed()) {
            return out;
        }
        Excitation excitation = evidence.excitation();
        double[][] way = new Simulator(excitation).transmissibility(linear);
        for (Channel across : evidence.companions(base.get().location(), Quantity.ACCELERATION)) {
            out.add(column(evidence, way, spectrum(evidence, across), SmallError.Kind.TILT, whitening));
        }
        for (Channel rate : evidence.companions(base.get().location(), Quantity.ANGULAR_RATE)) {
            double[] spectrum = spectrum(evidence, rate);
            double[] turned = new double[spectrum.length];
            for (int k = 0; k < excitation.omega().length; k++) {
                turned[2 * k] = -excitation.omega()[k] * spectrum[2 * k + 1];
                turned[2 * k + 1] = excitation.omega()[k] * spectrum[2 * k];
            }
            out.add(column(evidence, way, turned, SmallError.Kind.ARM, whitening));
        }
        return out;
    }

    private static double[] spectrum(Evidence evidence, Channel channel) {
        return evidence.excitation().spectrum(Arrays.copyOf(evidence.series(channel), evidence.excitation().samples()));
    }

    private static double[] column(Evidence evidence, double[][] way, double[] read, SmallError.Kind kind, Whitening whitening) {
        double[][] seen = new double[way.length][2 * evidence.excitation().omega().length];
        for (int o = 0; o < way.length; o++) {
            Remainder.add(seen[o], way[o], read);
        }
        return evidence.whitened(evidence.excitation(), seen, kind.deviation(), whitening);
    }
}
