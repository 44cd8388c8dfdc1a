package wbv.diagnosis.surrogate;

/**
 * A spring and a dashpot on which a mass swings.
 *
 * @param stiffness [N/m], &gt; 0
 * @param damping   [N s/m], &gt; 0
 */
record Suspension(double stiffness, double damping) {

    /** Damping ratio of a link under what it carries, where fits start: a sitter's is 0.2 to 0.5 (assumed). */
    private static final double RATIO = 0.3;

    Suspension {
        if (!(stiffness > 0 && damping > 0)) {
            throw new IllegalArgumentException("stiffness and damping of a suspension must be > 0: " + stiffness + ", " + damping);
        }
    }

    /**
     * With which fits start.
     *
     * @param mass      that swings on it [kg]
     * @param frequency natural frequency [Hz]
     */
    static Suspension of(double mass, double frequency) {
        double omega = 2 * Math.PI * frequency;
        return new Suspension(mass * omega * omega, 2 * RATIO * mass * omega);
    }
}
