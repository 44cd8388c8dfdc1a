package wbv.diagnosis.surrogate;

import java.util.Arrays;

/**
 * Bodies in a plane that were fitted.
 *
 * @param missed share of each output
 * @param cost what the fit lowers: twice the negative logarithm of its likelihood times that of the numbers, but for a constant
 * @param evidence logarithm of the arrangement's probability where that of another is the same beforehand, but for the same constant [nat]:
 *                 Laplace's integral over the numbers about where they are
 */
record FittedPlane(PlaneNet net, double[] missed, double cost, double evidence) implements FittedNet {
    @Override
    public double worst() {
        return Arrays.stream(missed).max().orElseThrow();
    }
}
