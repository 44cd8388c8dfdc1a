package wbv.diagnosis.fit;

import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.mechanism.Hypothesis;

/**
 * The way down of a fit: Levenberg (1944) and Marquardt (1963), with steps projected into the bounds. Derivatives cost more than looks, so
 * each set of them serves as long as steps with it still gain well; where a model has many numbers, after the first set only those to what
 * was added to it are worked out anew, and those to its own follow what the residual did (Broyden 1965), until that gains nothing more.
 */
final class Descent {

    /** Steps without new derivatives after each with: a free run's derivatives cost as much as four looks, others hardly more than one. */
    private static final int CHORDS = 4;
    private static final int LINEAR_CHORDS = 1;
    /** Part of what the step before it gained that a step without new derivatives gains at least. */
    private static final double LEAST_CHORD = 0.2;
    /** Dampings that are tried, each ten times the one before. */
    private static final int ATTEMPTS = 6;
    private static final double FIRST_DAMPING = 1e-3;
    private static final double LEAST_DAMPING = 1e-7;
    /** Numbers of a model from which on their derivatives are most of the work: a person in a plane has 30 to 40, a chain up to 15. */
    private static final int MANY = 24;

    private final Residuals residuals;
    /** What goes beyond small motions, as it was where the fit began. */
    private final Optional<Simulator.Bends> bends;
    private final int most;
    private final double tolerance;

    /**
     * @param most iterations at most
     * @param tolerance relative gain below which it ends
     */
    Descent(Residuals residuals, Optional<Simulator.Bends> bends, int most, double tolerance) {
        this.residuals = residuals;
        this.bends = bends;
        this.most = most;
        this.tolerance = tolerance;
    }

    /**
     * Whether what was added to the user's model, if anything was, is all apart from its structure, as a hidden mass is not, and that has
     * so many numbers that it counts.
     */
    static boolean isApart(Candidate candidate) {
        return candidate.given() >= MANY
                && IntStream.range(candidate.given(), candidate.knobs().size()).allMatch(candidate::isApart);
    }

    /**
     * Where it ends.
     *
     * @param first with derivatives
     */
    Fitter.State from(Fitter.State first) {
        return from(first, true, Optional.empty());
    }

    /**
     * The same where some of the derivatives were not worked out there.
     *
     * @param known products of those
     */
    Fitter.State from(Fitter.State first, SlopeProducts known) {
        return from(first, false, Optional.of(Normal.of(first, known)));
    }

    private Fitter.State from(Fitter.State first, boolean exact, Optional<Normal> begun) {
        Fitter.State state = first;
        boolean fresh = exact;
        Optional<Normal> earlier = begun;
        double damping = FIRST_DAMPING;
        for (int iteration = 0; iteration < most && !state.failed(); iteration++) {
            Fitter.State from = state;
            Normal normal = earlier.map(last -> last.renewed(from)).orElseGet(() -> new Normal(from));
            Step step = step(normal, damping);
            Normal followed = step.to() == from ? normal : farther(step.to(), normal, step.damping());
            Fitter.State better = followed.state();
            boolean settled = !(from.cost() - better.cost() >= tolerance * from.cost());
            if (settled && fresh || iteration + 1 == most) {
                return better == from ? from : better.withSlopes(Residuals.NO_SLOPES);
            }
            damping = better == from ? FIRST_DAMPING : Math.max(step.damping() / 8, LEAST_DAMPING);
            fresh = settled || !isApart(better.candidate());
            earlier = fresh ? Optional.empty() : Optional.of(followed.settled());
            state = earlier.map(Normal::state)
                    .map(known -> known.candidate().added().isEmpty() ? known : residuals.renewed(known, bends))
                    .orElseGet(() -> residuals.withSlopes(better.candidate(), better.x(), better.frame(), bends));
        }
        return state;
    }

    /** Where a step leads that lowers the cost, and the damping that it takes. */
    private record Step(Fitter.State to, double damping) {}

    /**
     * To where the equations stand already, if no step lowers the cost. Where something changes at a moment the cost has a kink, and no
     * slope leads along it: at its bottom the rest moves by itself.
     */
    private Step step(Normal normal, double first) {
        Fitter.State from = normal.state();
        Step all = step(normal, first, false);
        boolean moment = all.to() == from && from.candidate().knobs().stream().anyMatch(Knob::isMoment);
        return moment ? step(normal, first, true) : all;
    }

    /** @param still whether moments stay where they are */
    private Step step(Normal normal, double first, boolean still) {
        double damping = first;
        for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
            Fitter.State tried = look(normal, damping, still);
            if (tried.cost() < normal.state().cost()) {
                return new Step(tried, damping);
            }
            damping *= 10;
        }
        return new Step(normal.state(), damping);
    }

    /**
     * More steps without new derivatives, as long as each gains a good part of what the one before it did: the equations where they end.
     */
    private Normal farther(Fitter.State first, Normal earlier, double damping) {
        Normal normal = earlier.followed(first);
        double gain = earlier.state().cost() - first.cost();
        boolean free = first.candidate().added().stream().anyMatch(Hypothesis::runsFree);
        for (int step = 0; step < (free ? CHORDS : LINEAR_CHORDS); step++) {
            Fitter.State tried = look(normal, damping, false);
            double more = normal.state().cost() - tried.cost();
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

    private Fitter.State look(Normal normal, double damping, boolean still) {
        Fitter.State from = normal.state();
        return residuals.of(from.candidate(), normal.step(damping, still), from.frame(), bends);
    }
}
