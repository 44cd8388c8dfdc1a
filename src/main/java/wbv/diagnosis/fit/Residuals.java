package wbv.diagnosis.fit;

import java.util.Optional;
import wbv.body.simulate.Sensitivities;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.algebra.BoundedLeastSquares;
import wbv.signal.ScalarProduct;

/**
 * What candidates leave of the evidence: what was measured less their runs as late sensors read them, whitened, and what the sensors' small
 * errors explain of that.
 */
final class Residuals {

    /** No derivatives. */
    static final double[][] NO_SLOPES = new double[0][];

    private final Evidence evidence;
    private final FreeRuns runs;

    Residuals(Evidence evidence, FreeRuns runs) {
        this.evidence = evidence;
        this.runs = runs;
    }

    /**
     * Without derivatives.
     *
     * @param x coordinates [1], one a knob. Not copied, not modified.
     * @param bends what goes beyond small motions, where it is given
     */
    Fitter.State of(Candidate candidate, double[] x, Fitter.Frame frame, Optional<Simulator.Bends> bends) {
        return runs.of(candidate, x, Sensitivities.NONE, bends).map(response -> of(candidate, x, frame, response))
                .orElseGet(() -> Fitter.State.failed(candidate, x, frame));
    }

    /** The same of what it is known to do there. */
    Fitter.State of(Candidate candidate, double[] x, Fitter.Frame frame, Simulator.Response response) {
        return read(candidate, x, frame, late(candidate, frame, response).of(response));
    }

    /** With all derivatives, worked out there. */
    Fitter.State withSlopes(Candidate candidate, double[] x, Fitter.Frame frame, Optional<Simulator.Bends> bends) {
        return runs.of(candidate, x, Sensitivities.ALL, bends).map(response -> withSlopes(candidate, x, frame, response, NO_SLOPES))
                .orElseGet(() -> Fitter.State.failed(candidate, x, frame));
    }

    /** With derivatives of which those to the model's own numbers are known: those to what was added to it are worked out there. */
    Fitter.State renewed(Fitter.State at, Optional<Simulator.Bends> bends) {
        return runs.of(at.candidate(), at.x(), Sensitivities.OWN, bends)
                .map(response -> withSlopes(at.candidate(), at.x(), at.frame(), response, at.slopes()))
                .orElseGet(() -> Fitter.State.failed(at.candidate(), at.x(), at.frame()));
    }

    /**
     * With derivatives.
     *
     * @param response with those that are not known
     * @param known derivatives to the first of the structure's numbers, which count as they are. Not modified.
     */
    Fitter.State withSlopes(Candidate candidate, double[] x, Fitter.Frame frame, Simulator.Response response, double[][] known) {
        Lateness late = late(candidate, frame, response);
        Fitter.State there = read(candidate, x, frame, late.of(response));
        double[][] slopes = new double[there.failed() ? 0 : x.length][];
        Parallel.each(slopes.length, i -> slopes[i] = i < known.length && !candidate.isApart(i) ? known[i]
                : evidence.spectra().whitened(runs.excitation(), late.of(candidate.slope(response.slopes(), i)),
                        -candidate.knobs().get(i).slope(x[i]), frame.whitening()));
        return there.withSlopes(slopes);
    }

    /** How late sensors are in a frame, but for those that the candidate holds at fault. */
    private Lateness late(Candidate candidate, Fitter.Frame frame, Simulator.Response response) {
        Nuisances small = frame.nuisances();
        return small.delays().lateness(runs.excitation().omega(), small.off(candidate), response.outputs().length);
    }

    /** @param outputs what late sensors read of a run, spectra by output. Not modified. */
    private Fitter.State read(Candidate candidate, double[] x, Fitter.Frame frame, double[][] outputs) {
        Nuisances small = frame.nuisances();
        boolean[] off = small.off(candidate);
        double[] raw = evidence.spectra().residual(runs.excitation(), outputs, frame.whitening());
        small.restore(raw, off);
        BoundedLeastSquares.Explained explained = small.explain(raw, off);
        double cost = candidate.withPriors(explained.square() + ScalarProduct.of(explained.errors(), explained.errors()), x);
        return Double.isNaN(cost) ? Fitter.State.failed(candidate, x, frame)
                : new Fitter.State(candidate, x, cost, explained.square(), raw, explained.errors(), NO_SLOPES, frame);
    }
}
