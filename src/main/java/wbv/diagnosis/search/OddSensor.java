package wbv.diagnosis.search;

import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import wbv.body.Drive;
import wbv.body.SensorFault;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Nuisances;
import wbv.diagnosis.fit.Place;
import wbv.diagnosis.measured.SmallError;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * A sensor that is later than sensors scatter. What a small delay does is taken for scatter as far as three standard deviations reach, in a
 * sensor and in the input's; so nothing is left to be explained where one is later than that against all others, and yet it is at fault.
 */
public final class OddSensor {

    /** How rarely a recording has a sensor so odd by chance, on either side. */
    private static final double RARE = 2 * new NormalDistribution().cumulativeProbability(-SmallError.MOST);

    /** Of the oddness of one clock. */
    private static final ChiSquaredDistribution ONE_CLOCK = new ChiSquaredDistribution(1);

    private final Evidence evidence;
    private final Search search;

    /** Among the outputs of this evidence. */
    public OddSensor(Evidence evidence, Search search) {
        this.evidence = evidence;
        this.search = search;
    }

    /** The fit with the sensor late that is odd; empty where none is, or where others are beside it. */
    public Optional<Fitter.State> in(Fitter.State base) {
        return oddest(base).flatMap(output -> late(base, output)).filter(fit -> oddest(fit).isEmpty());
    }

    /** The best with that clock off: the sensor's, or the input's where there is no more than one of either and the sign says so. */
    private Optional<Fitter.State> late(Fitter.State base, int output) {
        return search.hypotheses(base).stream().filter(h -> isLate(h, output)).map(h -> late(base, h, output))
                .filter(fit -> !fit.failed() && !Refinement.extreme(fit)).min(Comparator.comparingDouble(Fitter.State::reduced));
    }

    private boolean isLate(Hypothesis hypothesis, int output) {
        Addition added = hypothesis.additions().get(0);
        boolean sensor = added instanceof Addition.AtSensor at && at.output() == output && at.fault() instanceof SensorFault.Delay;
        boolean alone = evidence.outputs().size() == 1 && evidence.model().inputs().size() == 1;
        return (sensor || alone && isInput(added)) && !hypothesis.byTheClock();
    }

    private static boolean isInput(Addition added) {
        return added instanceof Addition.Driven driven && driven.drive() instanceof Drive.Late;
    }

    private Fitter.State late(Fitter.State base, Hypothesis hypothesis, int output) {
        Candidate with = base.candidate().with(hypothesis);
        double delay = base.frame().nuisances().delays().of(output, base.errors());
        double[] start = hypothesis.starts().get(0).values().clone();
        start[0] = isInput(hypothesis.additions().get(0)) ? -delay : delay;
        return search.refinement().polish(with, base.candidate().extended(base.x(), with, hypothesis, start));
    }

    /** First output of the device that is odd, of several the oddest. */
    private Optional<Integer> oddest(Fitter.State fit) {
        int[] devices = IntStream.range(0, evidence.outputs().size())
                .filter(output -> Place.device(evidence, output).index() == output).toArray();
        return IntStream.of(devices).boxed().min(Comparator.comparingDouble(output -> rarity(output, fit)))
                .filter(output -> rarity(output, fit) * devices.length < RARE);
    }

    /** Probability that a device is by chance so much later, or earlier, than all others are. */
    private double rarity(int output, Fitter.State fit) {
        Nuisances nuisances = fit.frame().nuisances();
        return 1 - ONE_CLOCK.cumulativeProbability(nuisances.delays().oddness(Place.device(evidence, output).channels(evidence),
                fit.errors(), nuisances.off(fit.candidate())));
    }
}
