package wbv.diagnosis.search;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import wbv.body.SensorFault;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.FittedScene;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Motion;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A sensor that is later than sensors scatter. What a small delay does is taken for scatter as far as three standard deviations reach;
 * where a fit needs all of that from one sensor and not from the others, nothing is left to be explained, and yet that sensor is at fault.
 * The channels of a device have one clock: that they are late together is as rare as that one is, where the sum of their squares is.
 */
public final class OddSensor {

    /** How rarely one sensor's delay stands at its bound, on either side. */
    private static final double RARE = 2 * new NormalDistribution().cumulativeProbability(-SmallError.MOST);
    /** Part of its bound at which a delay stands that a fit holds there [1]. */
    private static final double AT_BOUND = 0.999;

    private final Evidence evidence;
    private final Refinement refinement;

    /** Among the outputs of this evidence. */
    public OddSensor(Evidence evidence, Refinement refinement) {
        this.evidence = evidence;
        this.refinement = refinement;
    }

    /** The fit with the one sensor late that is odd; empty where none is, or more than one, or where the others want more then. */
    public Optional<Fitter.State> in(Fitter.State base) {
        List<Integer> odd = odd(base);
        if (odd.size() != 1) {
            return Optional.empty();
        }
        Motion motion = new Motion(evidence, base.candidate().at(base.x()));
        return evidence.library().hypotheses(FittedScene.of(evidence, base.candidate().at(base.x()), motion)).stream()
                .filter(h -> h.additions().get(0) instanceof Addition.AtSensor at && at.output() == odd.get(0)
                        && at.fault() instanceof SensorFault.Delay && !h.byTheClock())
                .findFirst().map(h -> late(base, h)).filter(fit -> !fit.failed() && odd(fit).isEmpty());
    }

    private Fitter.State late(Fitter.State base, Hypothesis hypothesis) {
        Candidate with = base.candidate().with(hypothesis);
        double[] start = hypothesis.starts().get(0).values().clone();
        int output = ((Addition.AtSensor) hypothesis.additions().get(0)).output();
        start[0] = device(output).stream().mapToDouble(o -> base.frame().nuisances().delays().of(o, base.errors())).average().orElseThrow();
        return refinement.polish(with, base.candidate().extended(base.x(), with, hypothesis, start));
    }

    private List<Integer> device(int output) {
        return new Place(Place.Kind.DEVICE, output).channels(evidence);
    }

    /**
     * Sensors whose delays stand at their bounds, devices all of whose channels are late or early by as much together: first outputs of
     * them.
     */
    private List<Integer> odd(Fitter.State fit) {
        double deviation = SmallError.Kind.DELAY.deviation() * evidence.measured().sample();
        return IntStream.range(0, evidence.outputs().size()).filter(o -> device(o).get(0) == o).filter(o -> {
            double[] late = device(o).stream()
                    .mapToDouble(channel -> fit.frame().nuisances().delays().of(channel, fit.errors()) / deviation)
                    .toArray();
            double most = new ChiSquaredDistribution(late.length).inverseCumulativeProbability(1 - RARE);
            return Arrays.stream(late).map(z -> z * z).sum() > AT_BOUND * AT_BOUND * most
                    && Math.abs(Arrays.stream(late).map(Math::signum).sum()) == late.length;
        }).boxed().toList();
    }
}
