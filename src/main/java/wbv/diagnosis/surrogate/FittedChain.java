package wbv.diagnosis.surrogate;

import java.util.Map;
import wbv.body.Model;
import wbv.recording.Channel;

/**
 * Bodies along one axis that were fitted.
 *
 * @param errors missed over signal, by channel
 * @param square what is missed over the noise, as a sum of squares
 * @param masses what was expected of masses
 */
record FittedChain(Model model, Map<Channel, Double> errors, double square, MassPrior masses) implements FittedNet {
    @Override
    public double worst() {
        return errors.values().stream().mapToDouble(Double::doubleValue).max().orElseThrow();
    }
}
