package wbv.diagnosis;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.SensorFault;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A sensor that is later than sensors scatter. What a small delay does is taken for scatter as far as three standard deviations reach; where a
 * fit needs all of that from one sensor and not from the others, nothing is left to be explained, and yet that sensor is at fault.
 */
final class OddSensor {

    private final Evidence evidence;
    private final Refinement refinement;

    OddSensor(Evidence evidence, Refinement refinement) {
        this.evidence = evidence;
        this.refinement = refinement;
    }

    /** The fit with the one sensor late whose delay stands at its bound; empty where none does, or more than one, or where the others want more then. */
    Optional<Fitter.State> in(Fitter.State base) {
        List<Integer> odd = odd(base);
        if (evidence.onRig() || odd.size() != 1) {
            return Optional.empty();
        }
        Motion motion = new Motion(evidence, base.candidate().at(base.x()));
        return evidence.library().hypotheses(FittedScene.of(evidence, base.candidate().at(base.x()), motion)).stream()
                .filter(h -> h.additions().get(0) instanceof Hypothesis.Addition.AtSensor at && at.output() == odd.get(0)
                        && at.fault() instanceof SensorFault.Delay && !h.byTheClock())
                .findFirst().map(h -> late(base, h)).filter(fit -> !fit.failed() && odd(fit).isEmpty());
    }

    private Fitter.State late(Fitter.State base, Hypothesis hypothesis) {
        Candidate with = base.candidate().with(hypothesis);
        double[] start = hypothesis.starts().get(0).values().clone();
        int output = ((Hypothesis.Addition.AtSensor) hypothesis.additions().get(0)).output();
        start[0] = base.frame().nuisances().delay(output, base.errors());
        return refinement.polish(with, base.candidate().extended(base.x(), with, hypothesis, start));
    }

    /** Outputs whose sensors' delays stand at their bounds. */
    private List<Integer> odd(Fitter.State fit) {
        double most = SmallError.MOST * SmallError.Kind.DELAY.deviation() * evidence.sample();
        return IntStream.range(0, evidence.outputs().size())
                .filter(o -> Math.abs(fit.frame().nuisances().delay(o, fit.errors())) > 0.999 * most).boxed().toList();
    }
}
