package wbv.control;

/**
 * What is known of sitters before one sits down.
 *
 * @param middle    the middle sitter
 * @param frequency what the estimator of the body reads on the middle sitter [Hz], &gt; 0: between frame and trunk, which is not the
 *                  frequency of the apparent mass
 * @param damping   likewise the damping ratio, &gt; 0
 * @param masses    by how much sitters differ in mass, one standard deviation as a share
 * @param frequencies likewise in natural frequency
 * @param dampings  likewise in damping ratio
 */
public record SitterPrior(ApparentSitter middle, double frequency, double damping, double masses, double frequencies, double dampings) {

    public SitterPrior {
        if (!(frequency > 0 && damping > 0 && masses > 0 && frequencies > 0 && dampings > 0)) {
            throw new IllegalArgumentException(
                    "readings on the middle sitter and deviations of sitters must be > 0: " + frequency + " Hz, " + damping + ", "
                            + masses + ", " + frequencies + ", " + dampings);
        }
    }

    /** A wide population of drivers: mass ± 20 %, natural frequency ± 15 %, damping ratio ± 20 %; assumed. */
    public static SitterPrior wide(ApparentSitter middle, double frequency, double damping) {
        return new SitterPrior(middle, frequency, damping, 0.20, 0.15, 0.20);
    }
}
