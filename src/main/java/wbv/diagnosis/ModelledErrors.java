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
 * Small errors that act on what the model makes of the input. Tilted, or away from where it should be, the input's sensor reads what nobody drives
 * the model with, and every output lacks what the model makes of that; its delay is among the outputs' errors, its gain in theirs. And gains: taken
 * of what was measured they would act on the noise too, which is in the residual already, and a gain as a fault, which acts on what is simulated,
 * would be worth nats that it does not deserve.
 */
final class ModelledErrors {

    private ModelledErrors() { }

    /** One standard deviation of each, whitened. @param linear the fit's model, made linear */
    static List<double[]> columns(Evidence evidence, Fitter.State fit, Assembly linear) {
        Whitening whitening = fit.frame().whitening();
        List<double[]> out = gains(evidence, fit, whitening);
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

    private static List<double[]> gains(Evidence evidence, Fitter.State fit, Whitening whitening) {
        double[][] simulated = new Simulator(evidence.excitation()).run(fit.candidate().at(fit.x()), false).outputs();
        Nuisances small = fit.frame().nuisances();
        boolean[] off = small.off(fit.candidate());
        List<double[]> out = new ArrayList<>();
        for (int i = 0; i < small.count(); i++) {
            if (small.error(i).kind() == SmallError.Kind.GAIN && !off[i]) {
                double[][] own = new double[simulated.length][2 * evidence.excitation().omega().length];
                own[small.error(i).owner()] = simulated[small.error(i).owner()];
                out.add(evidence.whitened(evidence.excitation(), own, SmallError.Kind.GAIN.deviation(), whitening));
            }
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
