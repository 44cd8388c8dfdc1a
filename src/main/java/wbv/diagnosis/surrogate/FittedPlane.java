package wbv.diagnosis.surrogate;

import java.util.Arrays;

/**
 * Bodies in a plane that were fitted.
 *
 * @param missed share of each output
 * @param cost what the fit lowers: twice the negative logarithm of its likelihood times that of the numbers, but for a constant
 */
record FittedPlane(PlaneNet net, double[] missed, double cost) implements FittedNet {
    @Override
    public double worst() {
        return Arrays.stream(missed).max().orElseThrow();
    }
}
