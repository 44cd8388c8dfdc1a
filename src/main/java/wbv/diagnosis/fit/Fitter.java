package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Sensitivities;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.mechanism.Hypothesis;
import wbv.signal.ScalarProduct;

/**
 * Least squares of the whitened residual and the priors: Levenberg (1944) and Marquardt (1963), with steps projected into the
 * bounds and the exact sensitivities of the simulation.
 */
public final class Fitter {

    /** Steps without new derivatives after each with: a free run's derivatives cost as much as four looks, others hardly more than one. */
    private static final int CHORDS = 4;
    private static final int LINEAR_CHORDS = 1;
    private static final double LEAST_CHORD = 0.2;
    private static final int ATTEMPTS = 6;
    /** Numbers of a model from which on their derivatives are most of the work: a person in a plane has 30 to 40, a chain up to 15. */
    private static final int MANY = 24;
    private static final double[][] NO_SLOPES = new double[0][];

    private final Evidence evidence;
    private final Excitation excitation;
    private final Simulator simulator;
    /** What goes beyond small motions, where it is held. */
    private final Optional<Simulator.Bends> held;
    /** What was simulated last with nothing given. */
    private volatile Optional<Ran> ran = Optional.empty();

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
        this(evidence, excitation, Optional.empty());
    }

    private Fitter(Evidence evidence, Excitation excitation, Optional<Simulator.Bends> held) {
        this.evidence = evidence;
        this.excitation = excitation;
        this.simulator = new Simulator(excitation);
        this.held = held;
    }

    /**
     * What a candidate did at some numbers.
     *
     * @param x coordinates [1], one a knob. Not a copy
     * @param slopes derivatives that the response has
     */
    private record Ran(Candidate candidate, double[] x, Sensitivities slopes, Simulator.Response response) {
        private boolean is(Candidate asked, double[] where) {
            return candidate == asked && Arrays.equals(x, where);
        }

        private boolean has(Sensitivities asked) {
            return slopes.compareTo(asked) >= 0;
        }
    }

    /**
     * The same fitter for what lies near a fit: what goes beyond small motions, which is most of the work, stays as it is there. Hypotheses
     * are compared so before the best are fitted in full.
     */
    public Fitter about(State base) {
        return new Fitter(evidence, excitation,
                response(base.candidate(), base.x(), Sensitivities.NONE, Optional.empty()).flatMap(Simulator.Response::bends));
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
        Optional<Simulator.Response> ran = candidate.freeWays() ? response(candidate, x, Sensitivities.NONE, Optional.empty())
                : Optional.empty();
        ErrorShapes ways = ran.map(response -> WrongWay.of(excitation, candidate, x, () -> response))
                .orElseGet(() -> new ErrorShapes(List.of(), List.of()));
        Frame first = frame(candidate, x, window, ways, UnaryOperator.identity());
        if (first.nuisances().count() == 0) {
            return first;
        }
        State there = ran.or(() -> response(candidate, x, Sensitivities.NONE, Optional.empty()))
                .map(response -> state(candidate, x, first, response, NO_SLOPES, false)).orElseGet(() -> State.failed(candidate, x, first));
        if (there.failed()) {
            return first;
        }
        // A sensor that is late is late for what reaches all sensors too.
        Frame second = evidence.sources().areStrong()
                ? frame(candidate, x, window, ways, way -> first.nuisances().seen(way, there.errors()))
                : first;
        boolean[] off = first.nuisances().off(candidate);
        double[] errors = first.nuisances().likeliest(there.errors(), off);
        return new Frame(second.whitening(), second.nuisances().bounded(there.raw(), off).around(errors), x);
    }

    private Frame frame(Candidate candidate, double[] x, Window window, ErrorShapes ways, UnaryOperator<double[][]> seen) {
        Whitening whitening = evidence.sources().whitening(evidence, excitation, candidate.at(x), window, seen);
        return new Frame(whitening, Nuisances.of(evidence, whitening, ways), x);
    }

    /**
     * The residual at x, without derivatives.
     *
     * @param x coordinates [1], one a knob, not copied, not modified
     */
    public State look(Candidate candidate, double[] x, Frame frame) {
        return state(candidate, x, frame, Sensitivities.NONE, NO_SLOPES, Optional.empty());
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
        return state(candidate, x, frame, Sensitivities.ALL, NO_SLOPES, Optional.empty());
    }

    /**
     * Fits. Derivatives cost more than looks, so each set of them serves as long as steps with it still gain well; where a model has many
     * numbers, after the first set only those to what was added to it are worked out anew, and those to its own follow what the residual
     * did, until that gains nothing more. What goes beyond small motions hardly moves with a step: it stays what it was where the fit
     * began, and is found anew where it ends.
     *
     * @param start coordinates [1], one a knob. Not modified.
     * @param most iterations at most
     * @param tolerance relative gain below which a fit ends
     */
    public State fit(Candidate candidate, double[] start, Frame frame, int most, double tolerance) {
        return fit(candidate, start, frame, NO_SLOPES, most, tolerance);
    }

    /**
     * The same of a candidate that stands on a fit and begins there, whose derivatives serve first where it has any.
     *
     * @param start Not modified.
     * @param base at the numbers where it begins
     */
    public State fit(Candidate candidate, double[] start, State base, int most, double tolerance) {
        return fit(candidate, start, base.frame(), isApart(candidate) ? base.slopes() : NO_SLOPES, most, tolerance);
    }

    /** @param known derivatives to the first of the numbers; to none: they are worked out */
    private State fit(Candidate candidate, double[] start, Frame frame, double[][] known, int most, double tolerance) {
        Optional<Simulator.Response> begun = response(candidate, start, known.length > 0 ? Sensitivities.OWN : Sensitivities.ALL,
                Optional.empty());
        if (begun.isEmpty()) {
            return State.failed(candidate, start, frame);
        }
        State first = state(candidate, start.clone(), frame, begun.get(), known, true);
        Optional<Simulator.Bends> bends = begun.get().bends();
        State last = descended(first, known.length == 0, bends, most, tolerance);
        if (bends.isEmpty() || held.isPresent() || last == first) {
            return last;
        }
        State whole = look(candidate, last.x(), frame).withSlopes(last.slopes());
        return whole.cost() < first.cost() ? whole : first;
    }

    /**
     * The same, with what goes beyond small motions as it was where the fit began: to compare fits that all begin there.
     *
     * @param start coordinates [1], one a knob. Not modified.
     * @param tolerance relative gain below which a fit ends
     */
    public State glimpse(Candidate candidate, double[] start, Frame frame, int most, double tolerance) {
        Optional<Simulator.Response> begun = response(candidate, start, Sensitivities.ALL, Optional.empty());
        return begun
                .map(response -> descended(state(candidate, start.clone(), frame, response, NO_SLOPES, true), true, response.bends(), most,
                        tolerance))
                .orElseGet(() -> State.failed(candidate, start, frame));
    }

    /**
     * @param first with derivatives
     * @param exact whether all of these were worked out there
     */
    private State descended(State first, boolean exact, Optional<Simulator.Bends> bends, int most, double tolerance) {
        State state = first;
        boolean fresh = exact;
        Optional<Normal> earlier = Optional.empty();
        double damping = 1e-3;
        for (int iteration = 0; iteration < most && !state.failed(); iteration++) {
            State from = state;
            Normal normal = earlier.map(last -> last.renewed(from)).orElseGet(() -> new Normal(from));
            Step step = step(normal, damping, bends);
            Normal followed = step.to() == from ? normal : farther(step.to(), normal, step.damping(), bends);
            State better = followed.state();
            boolean settled = !(from.cost() - better.cost() >= tolerance * from.cost());
            if (settled && fresh || iteration + 1 == most) {
                return better == from ? from : better.withSlopes(NO_SLOPES);
            }
            damping = better == from ? 1e-3 : Math.max(step.damping() / 8, 1e-7);
            fresh = settled || !isApart(better.candidate());
            earlier = fresh ? Optional.empty() : Optional.of(followed);
            state = fresh || !better.candidate().added().isEmpty()
                    ? state(better.candidate(), better.x(), better.frame(), fresh ? Sensitivities.ALL : Sensitivities.OWN, better.slopes(),
                            bends)
                    : better;
        }
        return state;
    }

    /** Where a step leads that lowers the cost, and the damping that it takes. */
    private record Step(State to, double damping) {}

    /** To where the equations stand already, if no step lowers the cost. */
    private Step step(Normal normal, double first, Optional<Simulator.Bends> bends) {
        State from = normal.state();
        double damping = first;
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            State tried = look(from.candidate(), normal.step(damping), from.frame(), bends);
            if (tried.cost() < from.cost()) {
                return new Step(tried, damping);
            }
            damping *= 10;
        }
        return new Step(from, damping);
    }

    /**
     * Whether what was added to the user's model, if anything was, is all apart from its structure, as a hidden mass is not, and that has
     * so many numbers that it counts.
     */
    private static boolean isApart(Candidate candidate) {
        return candidate.given() >= MANY
                && IntStream.range(candidate.given(), candidate.knobs().size()).allMatch(i -> isOwn(candidate, i));
    }

    private static boolean isOwn(Candidate candidate, int knob) {
        return candidate.index(knob) >= candidate.template().structure().parameters();
    }

    /**
     * More steps without new derivatives, as long as each gains a good part of what the one before it did: the equations where they end.
     */
    private Normal farther(State first, Normal earlier, double damping, Optional<Simulator.Bends> bends) {
        Normal normal = earlier.followed(first);
        double gain = earlier.state().cost() - first.cost();
        boolean free = first.candidate().added().stream().anyMatch(Hypothesis::runsFree);
        for (int step = 0; step < (free ? CHORDS : LINEAR_CHORDS); step++) {
            State best = normal.state();
            State tried = look(best.candidate(), normal.step(damping), best.frame(), bends);
            double more = best.cost() - tried.cost();
            if (!(more > 0)) {
                break;
            }
            normal = normal.followed(tried);
            if (more < LEAST_CHORD * gain) {
                break;
            }
            gain = more;
        }
        return normal;
    }

    private State look(Candidate candidate, double[] x, Frame frame, Optional<Simulator.Bends> bends) {
        return state(candidate, x, frame, Sensitivities.NONE, NO_SLOPES, bends);
    }

    /** @param known derivatives that are not worked out, where some are */
    private State state(Candidate candidate, double[] x, Frame frame, Sensitivities sensitivities, double[][] known,
            Optional<Simulator.Bends> bends) {
        double[][] kept = sensitivities == Sensitivities.OWN ? known : NO_SLOPES;
        return response(candidate, x, sensitivities, bends)
                .map(response -> state(candidate, x, frame, response, kept, sensitivities != Sensitivities.NONE))
                .orElseGet(() -> State.failed(candidate, x, frame));
    }

    /** What a candidate does; empty where it left all bounds. */
    private Optional<Simulator.Response> response(Candidate candidate, double[] x, Sensitivities sensitivities,
            Optional<Simulator.Bends> bends) {
        Optional<Simulator.Bends> given = bends.or(() -> held);
        Optional<Ran> known = given.isPresent() ? Optional.empty() : ran.filter(last -> last.is(candidate, x));
        if (known.filter(last -> last.has(sensitivities)).isPresent()) {
            return known.map(Ran::response);
        }
        Assembly assembly;
        try {
            assembly = candidate.at(x);
        } catch (IllegalArgumentException outside) {
            return Optional.empty();
        }
        Simulator.Response response = simulator.run(assembly, sensitivities, given.or(() -> known.flatMap(last -> last.response.bends())));
        if (response.diverged()) {
            return Optional.empty();
        }
        if (given.isEmpty()) {
            ran = Optional.of(new Ran(candidate, x.clone(), sensitivities, response));
        }
        return Optional.of(response);
    }

    /**
     * @param known derivatives to the first of the structure's numbers, which count as they are
     * @param slopes whether derivatives are asked for
     */
    private State state(Candidate candidate, double[] x, Frame frame, Simulator.Response response, double[][] known, boolean slopes) {
        Nuisances small = frame.nuisances();
        boolean[] off = small.off(candidate);
        Nuisances.Lateness late = small.lateness(excitation.omega(), off, response.outputs().length);
        double[] raw = evidence.spectra().residual(excitation, late.of(response), frame.whitening());
        small.restore(raw, off);
        Nuisances.Explained explained = small.explain(raw, off);
        double cost = candidate.withPriors(explained.square() + ScalarProduct.of(explained.errors(), explained.errors()), x);
        double[][] columns = new double[slopes ? x.length : 0][];
        Parallel.each(columns.length, i -> columns[i] = i < known.length && !isOwn(candidate, i) ? known[i]
                : evidence.spectra().whitened(excitation, late.of(candidate.slope(response.slopes(), i)),
                        -candidate.knobs().get(i).slope(x[i]),
                        frame.whitening()));
        return Double.isNaN(cost) ? State.failed(candidate, x, frame)
                : new State(candidate, x, cost, explained.square(), raw, explained.errors(), columns, frame);
    }
}
