package wbv.body.simulate;

import wbv.body.law.Law;
import wbv.body.law.LawAt;
import wbv.body.law.LinkMotion;
import wbv.body.number.Numbers;

/**
 * A law in one link with the slopes of its force and memory to everything it depends on, by central differences of the law
 * itself. The law is a closed expression, so these are exact to about nine digits wherever it is smooth; the free run's
 * sensitivities built from them are those of the discrete step.
 */
final class LawSlopes {

    private static final double DISPLACEMENT = 1e-9;
    private static final double VELOCITY = 1e-8;
    private static final double RELATIVE = 1e-6;

    /** The law whose slopes these are. */
    final Law law;
    /** Index of the link that it acts in. */
    final int link;
    /** Number of the law's own numbers. */
    final int parameters;
    private final boolean late;
    private final boolean remembers;
    private final Law[] higher;
    private final Law[] lower;
    private final double[] difference;

    /** Slopes of the force: to displacement, velocity, displacement before, memory, late displacement, late velocity, k, c, own. */
    final double[] force;
    /** Slopes of the memory, likewise. */
    final double[] memory;

    /** Index of the slope to the displacement at the end of the step: of the force [N/m]. */
    static final int DISPLACEMENT_NOW = 0;
    /** To the velocity at the end of the step [N s/m]. */
    static final int VELOCITY_NOW = 1;
    /** To the displacement at its beginning [N/m]; 0 for a law without memory. */
    static final int DISPLACEMENT_BEFORE = 2;
    /** To the memory at its beginning; 0 for a law without memory. */
    static final int MEMORY_BEFORE = 3;
    /** To the displacement as long ago as the law is late [N/m]; 0 for one that is not. */
    static final int LATE_DISPLACEMENT = 4;
    /** To the velocity as long ago as the law is late [N s/m]; 0 for one that is not. */
    static final int LATE_VELOCITY = 5;
    /** To the stiffness k of the link [m]. */
    static final int STIFFNESS = 6;
    /** To the damping c of the link [m/s]. */
    static final int DAMPING = 7;
    /** First of the slopes to the law's own numbers, in their order. */
    static final int OWN = 8;

    /** Fills in the motion of a law some time before a sample. */
    interface Past {
        /**
         * Sets a motion to what it was.
         *
         * @param law index of the law that asks
         * @param index of the sample
         * @param ago time before it [s]
         */
        void recall(LinkMotion motion, int law, int index, double ago);
    }

    /** Prepares the differences; slopes are 0 until {@link #take}. */
    LawSlopes(LawAt at) {
        law = at.law();
        link = at.link();
        late = law.lateness() > 0;
        remembers = law.hasMemory();
        Record record = (Record) law;
        double[] values = Numbers.values(record);
        parameters = values.length;
        higher = new Law[parameters];
        lower = new Law[parameters];
        difference = new double[parameters];
        for (int i = 0; i < parameters; i++) {
            double h = RELATIVE * Math.max(Math.abs(values[i]), 1e-3);
            double kept = values[i];
            difference[i] = 2 * h;
            values[i] = kept + h;
            higher[i] = shifted(record, values);
            values[i] = kept - h;
            lower[i] = shifted(record, values);
            values[i] = kept;
        }
        force = new double[OWN + parameters];
        memory = new double[OWN + parameters];
    }

    /** The law with shifted numbers; the law itself where the shift leaves its domain, which makes the difference one-sided. */
    private Law shifted(Record record, double[] values) {
        try {
            return (Law) Numbers.with(record, values);
        } catch (IllegalArgumentException outside) {
            return law;
        }
    }

    /** Whether the law answers late. */
    boolean late() {
        return late;
    }

    /**
     * What {@link Law#memoryOf} changes by, in its unit per that of what it changes with: as long as {@link #OWN} and the law's own
     * numbers, element 0 to the force, elements from {@link #OWN} on to the law's own numbers.
     *
     * @param start force from which the memory starts [N]
     */
    double[] startSlopes(double start) {
        double[] out = new double[OWN + parameters];
        double h = RELATIVE * Math.max(Math.abs(start), 1e-3);
        out[0] = (law.memoryOf(start + h) - law.memoryOf(start - h)) / (2 * h);
        for (int i = 0; i < parameters; i++) {
            out[OWN + i] = (higher[i].memoryOf(start) - lower[i].memoryOf(start)) / span(i);
        }
        return out;
    }

    private double span(int i) {
        return higher[i] == law || lower[i] == law ? difference[i] / 2 : difference[i];
    }

    /**
     * Fills {@link #force} and {@link #memory} at a motion.
     *
     * @param m restored on return.
     * @param past for the late motion
     */
    void take(LinkMotion m, Past past, int slot, int index) {
        double r = m.displacement;
        m.displacement = r + DISPLACEMENT;
        double f = law.force(m);
        double z = memoryOf(m);
        m.displacement = r - DISPLACEMENT;
        set(DISPLACEMENT_NOW, f, z, m, 2 * DISPLACEMENT);
        m.displacement = r;
        double v = m.velocity;
        m.velocity = v + VELOCITY;
        f = law.force(m);
        z = memoryOf(m);
        m.velocity = v - VELOCITY;
        set(VELOCITY_NOW, f, z, m, 2 * VELOCITY);
        m.velocity = v;
        double hk = RELATIVE * Math.max(m.stiffness, 1e-3);
        double k = m.stiffness;
        m.stiffness = k + hk;
        f = law.force(m);
        z = memoryOf(m);
        m.stiffness = k - hk;
        set(STIFFNESS, f, z, m, 2 * hk);
        m.stiffness = k;
        double hc = RELATIVE * Math.max(m.damping, 1e-3);
        double c = m.damping;
        m.damping = c + hc;
        f = law.force(m);
        z = memoryOf(m);
        m.damping = c - hc;
        set(DAMPING, f, z, m, 2 * hc);
        m.damping = c;
        if (remembers) {
            double before = m.before;
            m.before = before + DISPLACEMENT;
            f = law.force(m);
            z = memoryOf(m);
            m.before = before - DISPLACEMENT;
            set(DISPLACEMENT_BEFORE, f, z, m, 2 * DISPLACEMENT);
            m.before = before;
            double kept = m.memory;
            double h = RELATIVE * Math.max(Math.abs(kept), 1e-6);
            m.memory = kept + h;
            f = law.force(m);
            z = memoryOf(m);
            m.memory = kept - h;
            set(MEMORY_BEFORE, f, z, m, 2 * h);
            m.memory = kept;
        }
        if (late()) {
            double late = m.lateDisplacement;
            m.lateDisplacement = late + DISPLACEMENT;
            f = law.force(m);
            z = memoryOf(m);
            m.lateDisplacement = late - DISPLACEMENT;
            set(LATE_DISPLACEMENT, f, z, m, 2 * DISPLACEMENT);
            m.lateDisplacement = late;
            late = m.lateVelocity;
            m.lateVelocity = late + VELOCITY;
            f = law.force(m);
            z = memoryOf(m);
            m.lateVelocity = late - VELOCITY;
            set(LATE_VELOCITY, f, z, m, 2 * VELOCITY);
            m.lateVelocity = late;
        }
        for (int i = 0; i < parameters; i++) {
            double span = span(i);
            double late = m.lateDisplacement;
            double lateRate = m.lateVelocity;
            boolean later = late() && higher[i].lateness() != lower[i].lateness();
            if (later) {
                past.recall(m, slot, index, higher[i].lateness());
            }
            double high = higher[i].force(m);
            double highMemory = remembers ? higher[i].remember(m) : 0;
            if (later) {
                past.recall(m, slot, index, lower[i].lateness());
            }
            force[OWN + i] = (high - lower[i].force(m)) / span;
            memory[OWN + i] = remembers ? (highMemory - lower[i].remember(m)) / span : 0;
            m.lateDisplacement = late;
            m.lateVelocity = lateRate;
        }
    }

    private double memoryOf(LinkMotion m) {
        return remembers ? law.remember(m) : 0;
    }

    private void set(int slope, double highForce, double highMemory, LinkMotion m, double span) {
        force[slope] = (highForce - law.force(m)) / span;
        memory[slope] = remembers ? (highMemory - law.remember(m)) / span : 0;
    }
}
