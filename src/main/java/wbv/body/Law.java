package wbv.body;

/**
 * A force that a link carries beside its linear stiffness and damping: the physics that a linear model leaves out.
 *
 * <p>{@link #force} is what is added to {@code k r + c v}, positive when it pulls the two ends together. A law with memory
 * keeps one number, advanced in closed form over a step of monotone motion, so that it is exact for any step length.
 */
public sealed interface Law {

    /** The word of the mechanism vocabulary, such as {@code stiffness.softening}. */
    String mechanism();

    /** Force beside the linear one at the end of a step [N]. */
    double force(LinkMotion motion);

    /** The memory at the end of a step; a law without memory keeps 0. */
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
     * @param omega angular frequency [rad/s] @param out element 0 the real, element 1 the imaginary part [N/m]. Modified.
     * @throws IllegalStateException if the law is not linear
     */
    default void dynamicStiffness(double omega, double[] out) {
        throw new IllegalStateException(mechanism() + " is not linear");
    }

    /** Whether {@link #remember} keeps anything. */
    default boolean hasMemory() {
        return false;
    }

    /** The memory with which the law starts where it is known to carry a force at rest; 0 where it has none. @param force [N] */
    default double memoryOf(double force) {
        return 0;
    }

    /** How long ago the motion was that the law answers [s]; 0 for one that answers at once. */
    default double lateness() {
        return 0;
    }

    /**
     * The force along a given motion of the link.
     *
     * @param displacement by sample [m]. Not modified. @param velocity by sample [m/s]. Not modified.
     * @param stiffness of the link [N/m] @param damping of the link [N s/m] @param step time between samples [s]
     */
    default double[] series(double[] displacement, double[] velocity, double stiffness, double damping, double step) {
        double[] out = new double[displacement.length];
        LinkMotion motion = new LinkMotion();
        motion.stiffness = stiffness;
        motion.damping = damping;
        motion.step = step;
        for (int j = 1; j < out.length; j++) {
            motion.time = j * step;
            motion.before = displacement[j - 1];
            motion.displacement = displacement[j];
            motion.velocity = velocity[j];
            out[j] = force(motion);
            motion.memory = remember(motion);
        }
        return out;
    }

    /** A spring that saturates: k r becomes k r / sqrt(1 + (r/knee)²). @param knee where softening sets in [m], &gt; 0 */
    record SaturatingSpring(@Key("knee_m") double knee) implements Law {
        public SaturatingSpring {
            Check.positive("knee", "m", knee);
        }

        @Override
        public String mechanism() {
            return "stiffness.softening";
        }

        @Override
        public double force(LinkMotion m) {
            double r = m.displacement;
            double u = r / knee;
            return m.stiffness * r * (1 / Math.sqrt(1 + u * u) - 1);
        }
    }

    /**
     * A cubic term k3 r³. A softening one stops at the deflection where the whole spring would lose its stiffness, and stays
     * at that force: beyond it the polynomial is no physics.
     *
     * @param cubic [N/m³], negative softens, positive hardens
     */
    record CubicSpring(@Key("k3_N_per_m3") double cubic) implements Law {
        public CubicSpring {
            Check.finite("cubic stiffness", "N/m³", cubic);
        }

        @Override
        public String mechanism() {
            return cubic < 0 ? "stiffness.softening" : "stiffness.hardening";
        }

        @Override
        public double force(LinkMotion m) {
            double r = m.displacement;
            if (cubic < 0 && 3 * -cubic * r * r > m.stiffness) {
                double flat = Math.copySign(Math.sqrt(m.stiffness / (-3 * cubic)), r);
                return m.stiffness * flat + cubic * flat * flat * flat - m.stiffness * r;
            }
            return cubic * r * r * r;
        }
    }

    /**
     * A spring that turns from one stiffness to a higher one: added stiffness times {@code r³ / (r² + knee²)}, cubic at first, straight in the end.
     *
     * @param added stiffness far beyond the knee, above the linear one [N/m], &gt;= 0 @param knee deflection at which half of it works [m], &gt; 0
     */
    record ProgressiveSpring(@Key("added_stiffness_N_per_m") double added, @Key("knee_m") double knee) implements Law {
        public ProgressiveSpring {
            Check.notNegative("added stiffness", "N/m", added);
            Check.positive("knee", "m", knee);
        }

        @Override
        public String mechanism() {
            return "stiffness.hardening";
        }

        @Override
        public double force(LinkMotion m) {
            double r = m.displacement;
            return added * r * r * r / (r * r + knee * knee);
        }
    }

    /** A term that is even in the deflection, k2 r²: stiffer one way, softer the other. @param quadratic [N/m²] */
    record QuadraticSpring(@Key("k2_N_per_m2") double quadratic) implements Law {
        public QuadraticSpring {
            Check.finite("quadratic stiffness", "N/m²", quadratic);
        }

        @Override
        public String mechanism() {
            return "stiffness.asymmetric";
        }

        @Override
        public double force(LinkMotion m) {
            return quadratic * m.displacement * m.displacement;
        }
    }

    /**
     * A spring that stiffens with deflection, more so one way: k2 r² + k3 r³.
     *
     * @param quadratic k2 [N/m²] @param cubic k3 [N/m³], &gt;= 0, or the quadratic term would pull the ends apart
     */
    record PolynomialSpring(@Key("k2_N_per_m2") double quadratic, @Key("k3_N_per_m3") double cubic) implements Law {
        public PolynomialSpring {
            Check.finite("quadratic stiffness", "N/m²", quadratic);
            Check.notNegative("cubic stiffness", "N/m³", cubic);
        }

        @Override
        public String mechanism() {
            return "stiffness.hardening";
        }

        @Override
        public double force(LinkMotion m) {
            double r = m.displacement;
            return (quadratic + cubic * r) * r * r;
        }
    }

    /** A spring stiffer or softer in compression: ratio k r where r &lt; 0. @param ratio share of k added in compression, &gt; -1 */
    record AsymmetricSpring(@Key("compression_ratio") double ratio) implements Law {
        public AsymmetricSpring {
            Check.above("ratio of added compression stiffness", "1", ratio, -1);
        }

        @Override
        public String mechanism() {
            return "stiffness.asymmetric";
        }

        @Override
        public double force(LinkMotion m) {
            return m.displacement < 0 ? ratio * m.stiffness * m.displacement : 0;
        }
    }

    /** Quadratic damping c2 v |v|. @param quadratic [N s²/m²] */
    record QuadraticDamping(@Key("c2_Ns2_per_m2") double quadratic) implements Law {
        public QuadraticDamping {
            Check.finite("quadratic damping", "N s²/m²", quadratic);
        }

        @Override
        public String mechanism() {
            return "damping.quadratic";
        }

        @Override
        public double force(LinkMotion m) {
            return quadratic * m.velocity * Math.abs(m.velocity);
        }
    }

    /**
     * Dry friction F tanh(v / v0). @param friction F [N], &gt;= 0 @param transition velocity v0 below which it is viscous [m/s], &gt; 0
     */
    record CoulombFriction(@Key("friction_N") double friction, @Key("transition_m_per_s") double transition) implements Law {
        public CoulombFriction {
            Check.notNegative("friction", "N", friction);
            Check.positive("transition velocity", "m/s", transition);
        }

        @Override
        public String mechanism() {
            return "friction.coulomb";
        }

        @Override
        public double force(LinkMotion m) {
            return friction * Math.tanh(m.velocity / transition);
        }
    }

    /**
     * Dry friction with elastic bristles and a Stribeck curve (Canudas de Wit, Olsson, Åström, Lischinsky 1995): memory is the
     * bristle deflection [m].
     *
     * @param friction kinetic friction [N] @param breakaway static friction [N] @param stribeck Stribeck velocity [m/s]
     * @param bristle bristle stiffness [N/m]
     */
    record BristleFriction(@Key("friction_N") double friction, @Key("breakaway_N") double breakaway,
                           @Key("stribeck_m_per_s") double stribeck, @Key("bristle_N_per_m") double bristle) implements Law {
        public BristleFriction {
            Check.positive("friction", "N", friction);
            Check.positive("breakaway force", "N", breakaway);
            Check.positive("Stribeck velocity", "m/s", stribeck);
            Check.positive("bristle stiffness", "N/m", bristle);
        }

        @Override
        public String mechanism() {
            return "friction.coulomb";
        }

        @Override
        public double force(LinkMotion m) {
            return bristle * remember(m);
        }

        @Override
        public double memoryOf(double force) {
            return Math.max(-breakaway, Math.min(breakaway, force)) / bristle;
        }

        @Override
        public boolean hasMemory() {
            return true;
        }

        @Override
        public double remember(LinkMotion m) {
            // z' = v - |v| z σ0 / g(v) is linear in travelled distance at constant v: exact over a monotone step.
            double travel = m.displacement - m.before;
            double speed = travel / m.step;
            double g = friction + (breakaway - friction) * Math.exp(-(speed / stribeck) * (speed / stribeck));
            double steady = Math.copySign(g / bristle, travel);
            return steady + (m.memory - steady) * Math.exp(-Math.abs(travel) * bristle / g);
        }
    }

    /**
     * Dry friction that a reversal lets go and that has to build up again: self-energising contact, such as a band on a drum, whose pressure
     * grows with travel as a rope's pull on a capstan does (Euler 1769; Eytelwein 1808). Memory is the engagement z [m], which follows the
     * travel between ±{@code travel}; u = |z| / travel is how far that side has engaged, and the force is
     * F (e^(growth u) - 1) / (e^growth - 1). A great growth is play: no force over most of the travel.
     *
     * @param extension friction while the link extends [N], &gt;= 0 @param compression while it shortens [N], &gt;= 0
     * @param travel from disengaged to fully engaged [m], &gt; 0 @param growth [1], &gt; 0
     */
    record EngagingFriction(@Key("extension_friction_N") double extension, @Key("compression_friction_N") double compression,
                            @Key("engagement_m") double travel, @Key("growth") double growth) implements Law {
        public EngagingFriction {
            Check.notNegative("friction in extension", "N", extension);
            Check.notNegative("friction in compression", "N", compression);
            Check.positive("engagement travel", "m", travel);
            Check.positive("growth", "1", growth);
        }

        @Override
        public String mechanism() {
            return "contact.backlash";
        }

        @Override
        public double force(LinkMotion m) {
            double z = remember(m);
            double engaged = Math.expm1(growth * Math.abs(z) / travel) / Math.expm1(growth);
            return z > 0 ? extension * engaged : -compression * engaged;
        }

        @Override
        public boolean hasMemory() {
            return true;
        }

        @Override
        public double remember(LinkMotion m) {
            return Math.max(-travel, Math.min(travel, m.memory + m.displacement - m.before));
        }

        @Override
        public double memoryOf(double force) {
            double engaged = Math.min(1, Math.abs(force) / Math.max(force > 0 ? extension : compression, 1e-9));
            return Math.copySign(travel * Math.log1p(engaged * Math.expm1(growth)) / growth, force);
        }
    }

    /**
     * A share of the link's spring is elastoplastic (Bouc 1967, Wen 1976, with exponent 1 and β = γ = 1/2): share k (z - r) where
     * z follows r until it yields. Memory is z [m].
     *
     * @param share part of k that is hysteretic, 0 to 1 @param yield deflection at which it yields [m], &gt; 0
     */
    record BoucWen(@Key("share") double share, @Key("yield_m") double yield) implements Law {
        public BoucWen {
            Check.within("hysteretic share", "1", share, 0, 1);
            Check.positive("yield deflection", "m", yield);
        }

        @Override
        public String mechanism() {
            return "hysteresis";
        }

        @Override
        public double force(LinkMotion m) {
            return share * m.stiffness * (remember(m) - m.displacement);
        }

        @Override
        public boolean hasMemory() {
            return true;
        }

        @Override
        public double remember(LinkMotion m) {
            double travel = m.displacement - m.before;
            double z = m.memory;
            double sign = Math.signum(travel);
            if (z * sign < 0) {   // unloading is elastic until z passes zero
                double free = Math.min(Math.abs(z), Math.abs(travel));
                z += sign * free;
                travel -= sign * free;
            }
            double steady = sign * yield;
            return steady + (z - steady) * Math.exp(-Math.abs(travel) / yield);
        }
    }

    /** The link can push but not pull more than its preload: contact is lost beyond. @param preload static force [N], &gt;= 0 */
    record ContactLoss(@Key("preload_N") double preload) implements Law {
        public ContactLoss {
            Check.notNegative("preload", "N", preload);
        }

        @Override
        public String mechanism() {
            return "contact.loss";
        }

        @Override
        public double force(LinkMotion m) {
            return Math.min(0, preload - m.stiffness * m.displacement - m.damping * m.velocity);
        }
    }

    /** Which way a stop works. */
    enum Side { COMPRESSION, EXTENSION, BOTH }

    /** A stop beyond a free travel. @param stop stiffness of the stop [N/m], &gt; 0 @param gap free travel [m], &gt;= 0 @param side where */
    record BumpStop(@Key("stop_stiffness_N_per_m") double stop, @Key("gap_m") double gap, @Key("side") Side side) implements Law {
        public BumpStop {
            Check.positive("stop stiffness", "N/m", stop);
            Check.notNegative("gap", "m", gap);
        }

        @Override
        public String mechanism() {
            return "contact.bumpstop";
        }

        @Override
        public double force(LinkMotion m) {
            double r = m.displacement;
            if (r < -gap && side != Side.EXTENSION) {
                return stop * (r + gap);
            }
            return r > gap && side != Side.COMPRESSION ? stop * (r - gap) : 0;
        }
    }

    /**
     * A rubber stop beyond a free travel: force over penetration to the power 3/2 (Hertz 1881). @param stop [N/m^1.5], &gt; 0
     *
     * @param gap free travel [m], &gt;= 0 @param side where
     */
    record HertzStop(@Key("stop_N_per_m1_5") double stop, @Key("gap_m") double gap, @Key("side") Side side) implements Law {
        public HertzStop {
            Check.positive("stop stiffness", "N/m^1.5", stop);
            Check.notNegative("gap", "m", gap);
        }

        @Override
        public String mechanism() {
            return "contact.bumpstop";
        }

        @Override
        public double force(LinkMotion m) {
            double r = m.displacement;
            if (r < -gap && side != Side.EXTENSION) {
                return -stop * Math.pow(-r - gap, 1.5);
            }
            return r > gap && side != Side.COMPRESSION ? stop * Math.pow(r - gap, 1.5) : 0;
        }
    }

    /** Play in the joint: the spring is slack within the gap. @param gap half the play [m], &gt;= 0 */
    record Backlash(@Key("gap_m") double gap) implements Law {
        public Backlash {
            Check.notNegative("gap", "m", gap);
        }

        @Override
        public String mechanism() {
            return "contact.backlash";
        }

        @Override
        public double force(LinkMotion m) {
            return -m.stiffness * Math.max(-gap, Math.min(gap, m.displacement));
        }
    }

    /**
     * Stiffness and damping change at one moment. @param time when [s] @param stiffnessFactor after over before, &gt; 0
     * @param dampingFactor likewise, &gt; 0
     */
    record Step(@Key("time_s") double time, @Key("stiffness_factor") double stiffnessFactor,
                @Key("damping_factor") double dampingFactor) implements Law {
        public Step {
            Check.finite("time", "s", time);
            Check.positive("stiffness factor", "1", stiffnessFactor);
            Check.positive("damping factor", "1", dampingFactor);
        }

        @Override
        public String mechanism() {
            return "drift.step";
        }

        @Override
        public double force(LinkMotion m) {
            // Within the step in which it happens the change counts in part, so that the force is continuous in its time.
            double share = Math.max(0, Math.min(1, (m.time - time) / m.step + 0.5));
            return share * ((stiffnessFactor - 1) * m.stiffness * m.displacement
                    + (dampingFactor - 1) * m.damping * m.velocity);
        }
    }

    /**
     * Stiffness and damping drift with time t as 1 + g, g = linear t + quadratic t² (t in units of 100 s), never below 3 % of the
     * linear value.
     *
     * @param linear [1/(100 s)] @param quadratic [1/(100 s)²] @param dampingShare part of g that the damping follows, 0 to 2
     */
    record Drift(@Key("linear_per_100s") double linear, @Key("quadratic_per_100s2") double quadratic,
                 @Key("damping_share") double dampingShare) implements Law {
        private static final double FLOOR = -0.97;

        public Drift {
            Check.finite("linear drift", "1/(100 s)", linear);
            Check.finite("quadratic drift", "1/(100 s)²", quadratic);
            Check.within("share of the drift in the damping", "1", dampingShare, 0, 2);
        }

        @Override
        public String mechanism() {
            return "drift.slow";
        }

        @Override
        public double force(LinkMotion m) {
            double t = m.time / 100;
            double g = Math.max(FLOOR, linear * t + quadratic * t * t);
            double gc = Math.max(FLOOR, dampingShare * g);
            return g * m.stiffness * m.displacement + gc * m.damping * m.velocity;
        }
    }

    /**
     * A spring and a dashpot in series beside the link. Memory is the arm's force [N].
     *
     * @param arm stiffness of the arm's spring [N/m], &gt; 0 @param relaxation time in which a held force decays to 1/e [s], &gt; 0
     */
    record MaxwellArm(@Key("arm_stiffness_N_per_m") double arm, @Key("relaxation_s") double relaxation) implements Law {
        public MaxwellArm {
            Check.positive("arm stiffness", "N/m", arm);
            Check.positive("relaxation time", "s", relaxation);
        }

        @Override
        public String mechanism() {
            return "memory.viscoelastic";
        }

        @Override
        public double force(LinkMotion m) {
            return remember(m);
        }

        @Override
        public boolean isLinear() {
            return true;
        }

        @Override
        public void dynamicStiffness(double omega, double[] out) {
            double u = omega * relaxation;
            out[0] = arm * u * u / (1 + u * u);
            out[1] = arm * u / (1 + u * u);
        }

        @Override
        public boolean hasMemory() {
            return true;
        }

        @Override
        public double remember(LinkMotion m) {
            // f' = k v - f/τ, exact for the mean velocity of the step.
            double u = m.step / relaxation;
            double decay = Math.exp(-u);
            return m.memory * decay + arm * (m.displacement - m.before) * (-Math.expm1(-u) / u);
        }
    }

    /**
     * Muscle that answers the link's motion late: force at t from displacement and velocity at t - delay.
     *
     * @param stiffness [N/m] @param damping [N s/m] @param delay [s], &gt; 0
     */
    record Reflex(@Key("reflex_N_per_m") double stiffness, @Key("reflex_Ns_per_m") double damping,
                  @Key("delay_s") double delay) implements Law {
        public Reflex {
            Check.finite("reflex stiffness", "N/m", stiffness);
            Check.finite("reflex damping", "N s/m", damping);
            Check.positive("delay", "s", delay);
        }

        @Override
        public String mechanism() {
            return "muscle.reflex";
        }

        @Override
        public double force(LinkMotion m) {
            return stiffness * m.lateDisplacement + damping * m.lateVelocity;
        }

        @Override
        public boolean isLinear() {
            return true;
        }

        @Override
        public void dynamicStiffness(double omega, double[] out) {
            double cos = Math.cos(omega * delay);
            double sin = Math.sin(omega * delay);
            out[0] = stiffness * cos + omega * damping * sin;
            out[1] = omega * damping * cos - stiffness * sin;
        }

        @Override
        public double lateness() {
            return delay;
        }
    }
}
