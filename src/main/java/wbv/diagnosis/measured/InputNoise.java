package wbv.diagnosis.measured;

/**
 * The noise of a sensor of the input.
 *
 * @param deviation of a sample, in its unit
 * @param order     how often what it reads is differentiated to be what enters: an acceleration, or a force
 */
public record InputNoise(double deviation, int order) {

    /**
     * Power of the noise as it enters, in the square of the unit of what enters.
     *
     * @param omega frequency [rad/s]
     */
    public double power(double omega) {
        return Math.pow(deviation * Math.pow(omega, order), 2);
    }
}
