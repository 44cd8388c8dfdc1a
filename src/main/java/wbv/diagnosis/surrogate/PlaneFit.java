package wbv.diagnosis.surrogate;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.DampedEquations;

/**
 * Moves the numbers of a {@link PlaneNet} until its sensors read what was computed: Levenberg (1944) and Marquardt (1963) on spectra, with
 * derivatives that are exact but for those of the matrices. What is missed of an output, as a share of it, counts once a mode, not by line:
 * an arrangement that is not the right one errs by mode. The numbers are expected where they are usual.
 *
 * <p>By how much the arrangement will miss is not known before: bodies in a plane that stand for a simulation of many more never come as
 * near as ones that are the simulation's own. So that share is a number that the fit finds too (its likelihood at its greatest over the
 * share: the logarithm of what is missed). Were it given, and too small, then numbers that no person has would be bought with a percent.
 */
final class PlaneFit {

    /** Steps at most: about twice what fits of twelve motions take. */
    private static final int STEPS = 150;
    /** A step that lowers the cost [1] by less is the last: the square of a tenth of a number's standard deviation. */
    private static final double SETTLED = 0.01;
    /** Times a number's own curvature: a step is then nothing beside any number's spread. */
    private static final double MOST_DAMPING = 1e8;

    private final PlaneSpectra spectra;
    private final double least;

    /**
     * @param spectra what bodies are to do
     * @param least   share of an output that even the right arrangement misses
     */
    PlaneFit(PlaneSpectra spectra, double least) {
        this.spectra = spectra;
        this.least = least;
    }

    FittedPlane fit(PlaneNet start) {
        return fit(start, STEPS);
    }

    /** @param steps at most */
    FittedPlane fit(PlaneNet start, int steps) {
        PlaneNet net = start;
        PlaneNormal now = PlaneNormal.of(spectra, net, least);
        double damping = 1e-2;
        boolean settled = false;
        for (int step = 0; step < steps && damping < MOST_DAMPING && !settled; step++) {
            PlaneNet trial = moved(net, now, damping);
            PlaneNormal then = PlaneNormal.of(spectra, trial, least);
            if (then.cost() < now.cost()) {
                settled = then.cost() > now.cost() - SETTLED && damping <= 1;
                net = trial;
                now = then;
                damping /= 5;
            } else {
                damping *= 5;
            }
        }
        return new FittedPlane(net, Arrays.stream(now.missed()).map(Math::sqrt).toArray(), now.cost(), now.evidence(net));
    }

    private static PlaneNet moved(PlaneNet net, PlaneNormal normal, double damping) {
        double[] at = net.at();
        double[] move = DampedEquations.solve(normal.square(), normal.slope(), new boolean[at.length], damping);
        double[] spread = net.spread();
        double longest = IntStream.range(0, at.length).mapToDouble(i -> Math.abs(move[i]) / spread[i]).max().orElse(0);
        double shortened = Math.min(1, 1 / longest);   // no number goes farther at once than it is spread
        Arrays.setAll(at, i -> at[i] + shortened * move[i]);
        return net.at(at);
    }
}
