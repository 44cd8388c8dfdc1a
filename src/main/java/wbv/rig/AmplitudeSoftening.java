package wbv.rig;

/**
 * Softening with memory: natural frequencies fall as a^-0.18 with the magnitude a of the platform, root mean square of all its
 * translations together over the last seconds (Mansfield and Maeda 2007: the total counts, not the axis).
 *
 * <p>The exponent is fitted to resonances from 6 to 4 Hz at 0.25 to 2.0 m/s² (Fairley and Griffin 1989) and from 5.25 to 4.25 Hz
 * at 0.35 to 1.4 m/s² (Matsumoto and Griffin 2002); reference magnitude, memory and rest are assumed.
 */
final class AmplitudeSoftening {

    /** p in f ∝ a^-p. */
    static final double EXPONENT = 0.18;
    /** Magnitude at which the sitter has his stated frequencies [m/s²]. */
    static final double REFERENCE = 1;
    private static final double MEMORY = 5;
    private static final double REST = 0.05;

    private final boolean on;
    private final double forget;
    private double meanSquare;
    private double stiffness;
    private double damping;

    /**
     * A sitter who has been at rest.
     *
     * @param on false for one who never softens
     * @param h step [s]
     */
    AmplitudeSoftening(boolean on, double h) {
        this.on = on;
        this.forget = 1 - StrictMath.exp(-h / MEMORY);
        update();
    }

    /**
     * One step.
     *
     * @param a acceleration of the platform [m/s²], length 3. Not modified.
     */
    void feel(double[] a) {
        meanSquare += forget * (a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - meanSquare);
        update();
    }

    /** Magnitude remembered, root mean square [m/s²]. */
    double magnitude() {
        return Math.sqrt(meanSquare);
    }

    /** Factor on all stiffnesses. */
    double stiffness() {
        return stiffness;
    }

    /** Factor on all dampings, the root of the other, which keeps damping ratios. */
    double damping() {
        return damping;
    }

    private void update() {
        double ratio = (meanSquare + REST * REST) / (REFERENCE * REFERENCE);
        stiffness = on ? StrictMath.pow(ratio, -EXPONENT) : 1;
        damping = Math.sqrt(stiffness);
    }
}
