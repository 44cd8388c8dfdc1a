package wbv.diagnosis.surrogate;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import wbv.body.Model;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Augmented;
import wbv.diagnosis.fit.Baseline;
import wbv.diagnosis.fit.Candidate;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Slot;
import wbv.recording.Channel;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/** Moves masses and springs of bodies along one axis, far from where they start if need be: each round begins where the last one ended. */
final class ChainFit {

    private static final int ROUNDS = 10;
    /** A round that lowers the cost by less than this factor is the last. */
    private static final double SETTLED = 0.9;
    private static final int STEPS = 20;
    /** Part of its cost by which the last step of a round lowers it. */
    private static final double TOLERANCE = 1e-4;

    private final OptionalDouble noise;
    private final Model.Subject subject;

    /**
     * Of any bodies along one axis.
     *
     * @param noise   standard deviation by which what is missed of an output counts, in the outputs' unit
     * @param subject that they simulate
     */
    ChainFit(double noise, Model.Subject subject) {
        this.noise = OptionalDouble.of(noise);
        this.subject = subject;
    }

    /**
     * A model fitted.
     *
     * @param to     what its bodies are to do
     * @param masses what is expected of them
     */
    FittedChain of(Model start, Recording to, MassPrior masses) {
        Model model = start.declaredAs(subject);
        double cost = Double.POSITIVE_INFINITY;
        boolean settled = false;
        for (int round = 0; round < ROUNDS && !settled; round++) {
            List<Model.Body> bodies = model.bodies();
            Evidence evidence = Evidence.computed(model, to, noise);
            Candidate baseline = masses.of(Baseline.of(evidence), model);
            double[] at = baseline.knobs().stream().mapToDouble(knob -> knob.slot().kind() == Slot.Kind.MASS
                    ? knob.coordinate(bodies.get(knob.slot().at()).mass()) : 0).toArray();
            Fitter fitter = new Fitter(evidence);
            Fitter.State state = fitter.fit(baseline, at, fitter.frame(baseline, at, evidence.fit()), STEPS, TOLERANCE);
            settled = !(state.square() < SETTLED * cost);
            if (!settled) {
                cost = state.square();
                model = Augmented.of(model, baseline.at(state.x()));
            }
        }
        return new FittedChain(model, errors(model, Evidence.computed(model, to, noise)), cost, masses);
    }

    private static Map<Channel, Double> errors(Model model, Evidence evidence) {
        double[][] simulated = new Simulator(evidence.whole()).outputs(model.assembly());
        Map<Channel, Double> errors = new LinkedHashMap<>();
        for (int o = 0; o < simulated.length; o++) {
            errors.put(evidence.outputs().get(o), Missed.settledShare(LostSamples.marked(evidence.measured(o), evidence.valid(o)),
                    simulated[o], evidence.recording().clock().rate()));
        }
        return errors;
    }
}
