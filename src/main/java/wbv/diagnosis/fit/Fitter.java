package wbv.diagnosis.fit;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Sensitivities;
import wbv.body.simulate.Simulator;

/**
 * Least squares of the whitened residual and the priors, with the exact sensitivities of the simulation: the frame that a residual is seen
 * through, what it is there, and where a {@link Descent} leads.
 */
public final class Fitter {

    private final Evidence evidence;
    private final FreeRuns runs;
    private final Residuals residuals;
    /** Of the fit on which others stood last. */
    private Optional<SlopeProducts> products = Optional.empty();

    /** Fits on the evidence's fit window. */
    public Fitter(Evidence evidence) {
        this(evidence, evidence.excitation());
    }

    /**
     * A fitter in which nothing was simulated yet.
     *
     * @param excitation all of the input that the windows to be looked at need
     */
    public Fitter(Evidence evidence, Excitation excitation) {
        this(evidence, new FreeRuns(excitation, Optional.empty()));
    }

    private Fitter(Evidence evidence, FreeRuns runs) {
        this.evidence = evidence;
        this.runs = runs;
        this.residuals = new Residuals(evidence, runs);
    }

    /**
     * The same fitter for what lies near a fit: what goes beyond small motions, which is most of the work, stays as it is there. Hypotheses
     * are compared so before the best are fitted in full.
     */
    public Fitter about(State base) {
        return new Fitter(evidence,
                new FreeRuns(runs.excitation(), runs.of(base.candidate(), base.x()).flatMap(Simulator.Response::bends)));
    }

    /**
     * Where a fit stands.
     *
     * @param x      coordinates [1], one a knob. Not a copy
     * @param cost   sum of squares of the whitened residual, of the sensors' errors and of the priors
     * @param square sum of squares of the whitened residual alone
     * @param raw    whitened residual of the data by line, with what the sensors' errors explain
     * @param errors the sensors' errors, one an error, in standard deviations [1]
     * @param slopes whitened derivative of the residual by coordinate, then by line; empty where it was not asked for
     * @param frame  whitening and errors that all this stands in
     */
    public record State(Candidate candidate, double[] x, double cost, double square, double[] raw, double[] errors, double[][] slopes,
            Frame frame) {

        /**
         * Where a candidate cannot be simulated: its cost is infinite, all its arrays but x are empty.
         *
         * @param x coordinates [1], one a knob. Not copied, not modified
         */
        public static State failed(Candidate candidate, double[] x, Frame frame) {
            double never = Double.POSITIVE_INFINITY;
            return new State(candidate, x, never, never, new double[0], new double[0], new double[0][], frame);
        }

        /** Whitened residual of the data, by line, without what the sensors' errors explain. A new array. */
        public double[] residual() {
            return frame.nuisances().removed(raw, errors);
        }

        /** Mean square of the whitened residual: 1 where nothing is left but noise; infinite for a fit that failed. */
        public double reduced() {
            return square / frame.whitening().degrees();
        }

        /** Coordinates that stand at a bound, or have no room to move. */
        public boolean[] held() {
            boolean[] out = new boolean[x.length];
            for (int i = 0; i < x.length; i++) {
                Knob knob = candidate.knobs().get(i);
                out[i] = x[i] <= knob.low() + 1e-9 || x[i] >= knob.high() - 1e-9 || knob.high() - knob.low() < 1e-3;
            }
            return out;
        }

        /** Whether it could not be simulated there. */
        public boolean failed() {
            return !(cost < Double.MAX_VALUE);
        }

        State withSlopes(double[][] others) {
            return new State(candidate, x, cost, square, raw, errors, others, frame);
        }
    }

    /**
     * What a residual is seen through.
     *
     * @param x where it was made: coordinates [1], one a knob. Not a copy
     */
    public record Frame(Whitening whitening, Nuisances nuisances, double[] x) {}

    /**
     * The frame that belongs to a model, in a window: its noise, and its sensors' errors about where they are.
     *
     * @param x coordinates [1], one a knob. Not modified.
     */
    public Frame frame(Candidate candidate, double[] x, Window window) {
        // Where ways are free their errors take a run, which the look that follows needs too.
        Optional<Simulator.Response> ran = candidate.freeWays() ? runs.of(candidate, x) : Optional.empty();
        ErrorShapes ways = Beginnings.of(evidence, runs.excitation(), candidate, x)
                .and(ran.map(response -> WrongWay.of(runs.excitation(), candidate, x, () -> response))
                        .orElseGet(() -> new ErrorShapes(List.of(), List.of())));
        Frame first = frame(candidate, x, window, ways, UnaryOperator.identity());
        if (first.nuisances().count() == 0) {
            return first;
        }
        return ran.or(() -> runs.of(candidate, x)).flatMap(response -> Optional.of(residuals.of(candidate, x, first, response))
                .filter(there -> !there.failed()).map(there -> refined(there, response, window, ways))).orElse(first);
    }

    /** The frame about the sensors' errors that were found in a first one. */
    private Frame refined(State there, Simulator.Response response, Window window, ErrorShapes ways) {
        Frame first = there.frame();
        // A sensor that is late is late for what reaches all sensors too.
        Frame second = evidence.sources().areStrong()
                ? frame(there.candidate(), there.x(), window, ways, way -> first.nuisances().seen(way, there.errors())) : first;
        boolean[] off = first.nuisances().off(there.candidate());
        double[] errors = first.nuisances().delays().likeliest(there.errors(), off);
        Nuisances heard = second.nuisances().withoutNoise(evidence, runs.excitation(), response.outputs(), second.whitening());
        return new Frame(second.whitening(), heard.bounded(there.raw(), off).around(errors), there.x());
    }

    private Frame frame(Candidate candidate, double[] x, Window window, ErrorShapes ways, UnaryOperator<double[][]> seen) {
        Whitening whitening = evidence.sources().whitening(evidence, runs.excitation(), candidate.at(x), window, seen);
        return new Frame(whitening, Nuisances.of(evidence, whitening, ways), x);
    }

    /**
     * The residual at x, without derivatives.
     *
     * @param x coordinates [1], one a knob, not copied, not modified
     */
    public State look(Candidate candidate, double[] x, Frame frame) {
        return residuals.of(candidate, x, frame, Optional.empty());
    }

    /**
     * The residual at x in the frame of the model at x.
     *
     * @param x coordinates [1], one a knob, not copied, not modified
     */
    public State look(Candidate candidate, double[] x, Window window) {
        return look(candidate, x, frame(candidate, x, window));
    }

    /**
     * The residual at x with its derivatives.
     *
     * @param x coordinates [1], one a knob, not copied, not modified
     */
    public State lookWithSlopes(Candidate candidate, double[] x, Frame frame) {
        return residuals.withSlopes(candidate, x, frame, Optional.empty());
    }

    /**
     * Fits. What goes beyond small motions hardly moves with a step: it stays what it was where the fit began, and is found anew where it
     * ends.
     *
     * @param start coordinates [1], one a knob. Not modified.
     * @param most iterations at most
     * @param tolerance relative gain below which a fit ends
     */
    public State fit(Candidate candidate, double[] start, Frame frame, int most, double tolerance) {
        return runs.of(candidate, start, Sensitivities.ALL, Optional.empty()).map(begun -> {
            State first = residuals.withSlopes(candidate, start.clone(), frame, begun, Residuals.NO_SLOPES);
            return ended(first, new Descent(residuals, begun.bends(), most, tolerance).from(first), begun);
        }).orElseGet(() -> State.failed(candidate, start, frame));
    }

    /**
     * The same of a candidate that stands on a fit and begins there, whose derivatives serve first where it has any.
     *
     * @param start Not modified.
     * @param base at the numbers where it begins
     */
    public State fit(Candidate candidate, double[] start, State base, int most, double tolerance) {
        if (base.slopes().length == 0 || !Descent.isApart(candidate)) {
            return fit(candidate, start, base.frame(), most, tolerance);
        }
        return runs.of(candidate, start, Sensitivities.OWN, Optional.empty()).map(begun -> {
            State first = residuals.withSlopes(candidate, start.clone(), base.frame(), begun, base.slopes());
            return first.failed() ? first
                    : ended(first, new Descent(residuals, begun.bends(), most, tolerance).from(first, productsOf(base)), begun);
        }).orElseGet(() -> State.failed(candidate, start, base.frame()));
    }

    /** Products of a fit's derivatives, found once for all that stands on it. */
    private synchronized SlopeProducts productsOf(State base) {
        SlopeProducts found = products.filter(known -> known.isOf(base)).orElseGet(() -> new SlopeProducts(base));
        products = Optional.of(found);
        return found;
    }

    private State ended(State first, State last, Simulator.Response begun) {
        return begun.bends().isEmpty() || runs.areHeld() || last == first ? last : better(first, last);
    }

    /** The last of a fit with what goes beyond small motions found anew, if it is better than the first so. */
    private State better(State first, State last) {
        State whole = look(first.candidate(), last.x(), first.frame()).withSlopes(last.slopes());
        return whole.cost() < first.cost() ? whole : first;
    }
}
