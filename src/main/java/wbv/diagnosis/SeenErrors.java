package wbv.diagnosis;

import java.util.stream.IntStream;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.fit.Window;

/** Errors of fits on the data held out, through sensors with the errors found where the fit was made: those that a report claims. */
final class SeenErrors {

    private final Evidence evidence;
    private final Readings readings;

    SeenErrors(Evidence evidence) {
        this.evidence = evidence;
        this.readings = new Readings(evidence);
    }

    /** Sum over the outputs of the mean square error in units of the sensor's noise; infinite for a fit that failed. */
    double of(Fitter.State fit) {
        double[][] read = readings.of(fit);
        double sum = IntStream.range(0, read.length).mapToDouble(o -> square(o, read[o]) / Math.pow(evidence.noise()[o], 2)).sum();
        return fit.failed() || Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum;
    }

    /**
     * Part of the variance of an output that a fit explains, of the output of which it explains most; below 0 where it is worse than
     * nothing.
     */
    double explained(Fitter.State fit) {
        double[][] read = readings.of(fit);
        return IntStream.range(0, read.length).mapToDouble(o -> 1 - square(o, read[o]) / square(o, new double[read[o].length])).max()
                .orElseThrow();
    }

    private double square(int output, double[] read) {
        Window window = evidence.heldOut();
        boolean[] valid = evidence.valid(output);
        double[] measured = evidence.measured(output);
        return IntStream.range(window.start(), window.start() + window.length()).filter(i -> valid[i])
                .mapToDouble(i -> Math.pow(measured[i] - read[i], 2)).average().orElse(Double.NaN);
    }
}
