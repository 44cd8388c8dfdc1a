package wbv.body.law;

import wbv.body.number.Modulator;

/**
 * A force that a link carries beside its linear stiffness and damping: the physics that a linear model leaves out.
 *
 * <p>{@link #force} is what is added to {@code k r + c v}, positive when it pulls the two ends together. A law with memory
 * keeps one number, advanced in closed form over a step of monotone motion, so that it is exact for any step length.
 */
public sealed interface Law permits
        Saturation, CubicSpring, ProgressiveSpring, GasSpring, QuadraticSpring, PolynomialSpring,
        AsymmetricSpring, BendingSpring, QuadraticDamping, CoulombFriction, BristleFriction, EngagingFriction,
        BoucWen, Slider, JenkinsElement, ContactLoss, RoundedContactLoss, BumpStop, HertzStop, Backlash, RoundedBacklash,
        StepChange, StepChange.Gradual, SlowDrift, Settling, MaxwellArm, Reflex, MuscleReflex, ScheduledLink, ScheduledFriction, Learned {

    /**
     * A spring that stiffens.
     *
     * @param cubic force over the cube of the deflection [N/m³], its only number
     */
    static Law stiffening(double cubic) {
        return new CubicSpring(cubic);
    }

    /** The word of the mechanism vocabulary, such as {@code stiffness.softening}. */
    String mechanism();

    /** Force beside the linear one at the end of a step [N]. */
    double force(LinkMotion motion);

    /** The memory at the end of a step, in a unit of the law's own; a law without memory keeps 0. */
    default double remember(LinkMotion motion) {
        return 0;
    }

    /** Whether the force is linear in the motion; then {@link #dynamicStiffness} says all of it. */
    default boolean isLinear() {
        return false;
    }

    /**
     * Force over displacement at a frequency, for a linear law.
     *
     * @param omega angular frequency [rad/s]
     * @param out two long: the real, then the imaginary part [N/m]. Modified.
     * @throws IllegalStateException if the law is not linear
     */
    default void dynamicStiffness(double omega, double[] out) {
        throw new IllegalStateException(mechanism() + " is not linear");
    }

    /** Whether {@link #remember} keeps anything. */
    default boolean hasMemory() {
        return false;
    }

    /**
     * The memory, in the law's own unit, with which it starts where it is known to carry a force at rest; 0 where it has none.
     *
     * @param force [N]
     */
    default double memoryOf(double force) {
        return 0;
    }

    /**
     * What its force is multiplied by beside the motion of its own link; the multiplication is the law's own, by
     * {@link LinkMotion#modulation}.
     */
    default Modulator modulator() {
        return Modulator.NONE;
    }

    /** How long ago the motion was that the law answers [s]; 0 for one that answers at once. */
    default double lateness() {
        return 0;
    }

    /**
     * The force along a given motion of the link, by sample [N]; nothing at the first.
     *
     * @param displacement by sample [m]. Not modified.
     * @param velocity by sample [m/s]. Not modified.
     * @param stiffness of the link [N/m]
     * @param damping of the link [N s/m]
     * @param step time between samples [s]
     * @param modulation by sample, in the modulator's unit; empty where nothing modulates. Not modified.
     */
    default double[] series(double[] displacement, double[] velocity, double stiffness, double damping, double step, double[] modulation) {
        double[] out = new double[displacement.length];
        LinkMotion motion = new LinkMotion();
        motion.stiffness = stiffness;
        motion.damping = damping;
        motion.step = step;
        double late = lateness() / step;
        for (int j = 1; j < out.length; j++) {
            motion.time = j * step;
            motion.before = displacement[j - 1];
            motion.displacement = displacement[j];
            motion.velocity = velocity[j];
            if (late > 0) {
                motion.lateDisplacement = LinkMotion.between(displacement, j - late, out.length);
                motion.lateVelocity = LinkMotion.between(velocity, j - late, out.length);
            }
            motion.modulation = modulation.length == 0 ? 1 : modulation[j];
            out[j] = force(motion);
            motion.memory = remember(motion);
        }
        return out;
    }

    /** Which way a stop or a muscle works. */
    enum Side { COMPRESSION, EXTENSION, BOTH }
}
