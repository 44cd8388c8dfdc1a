package wbv.body.simulate;

import wbv.body.LawAt;
import wbv.body.law.Law;
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
    /** Below these a number counts as this large, in its own unit: a step in proportion to nothing would be none. */
    private static final double LEAST = 1e-3;
    private static final double LEAST_MEMORY = 1e-6;
    /** In the modulator's unit: a thousandth of a link's usual deflection [m], a part in a billion of its load [N]. */
    private static final double LEAST_MODULATION = 1e-6;

    /** The law whose slopes these are. */
    final Law law;
    /** Index of the link that it acts in. */
    final int link;
    /** Number of the law's own numbers. */
    final int parameters;
    private final boolean late;
    private final boolean remembers;
    private final boolean follows;
    private final Law[] higher;
    private final Law[] lower;
    private final double[] difference;

    /**
     * Slopes of the force: to displacement, velocity, displacement before, memory, late displacement, late velocity, k, c, modulation,
     * own.
     */
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
    /** To what multiplies the law, per its unit; 0 for one that goes by no other link. */
    static final int MODULATION = 8;
    /** First of the slopes to the law's own numbers, in their order. */
    static final int OWN = 9;

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
        follows = law.modulator().otherLink().isPresent();
        Record record = (Record) law;
        double[] values = Numbers.values(record);
        parameters = values.length;
        higher = new Law[parameters];
        lower = new Law[parameters];
        difference = new double[parameters];
        for (int i = 0; i < parameters; i++) {
            double h = RELATIVE * Math.max(Math.abs(values[i]), LEAST);
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
        double h = RELATIVE * Math.max(Math.abs(start), LEAST);
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
        take(DISPLACEMENT_NOW, m, DISPLACEMENT);
        take(VELOCITY_NOW, m, VELOCITY);
        take(STIFFNESS, m, RELATIVE * Math.max(m.stiffness, LEAST));
        take(DAMPING, m, RELATIVE * Math.max(m.damping, LEAST));
        if (remembers) {
            take(DISPLACEMENT_BEFORE, m, DISPLACEMENT);
            take(MEMORY_BEFORE, m, RELATIVE * Math.max(Math.abs(m.memory), LEAST_MEMORY));
        }
        if (follows) {
            take(MODULATION, m, RELATIVE * Math.max(Math.abs(m.modulation), LEAST_MODULATION));
        }
        if (late) {
            take(LATE_DISPLACEMENT, m, DISPLACEMENT);
            take(LATE_VELOCITY, m, VELOCITY);
        }
        for (int i = 0; i < parameters; i++) {
            double span = span(i);
            double lateDisplacement = m.lateDisplacement;
            double lateVelocity = m.lateVelocity;
            boolean later = late && higher[i].lateness() != lower[i].lateness();
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
            m.lateDisplacement = lateDisplacement;
            m.lateVelocity = lateVelocity;
        }
    }

    /** @param step to either side */
    private void take(int slope, LinkMotion m, double step) {
        double at = of(m, slope);
        set(m, slope, at + step);
        double high = law.force(m);
        double highMemory = memoryOf(m);
        set(m, slope, at - step);
        force[slope] = (high - law.force(m)) / (2 * step);
        memory[slope] = remembers ? (highMemory - law.remember(m)) / (2 * step) : 0;
        set(m, slope, at);
    }

    private double memoryOf(LinkMotion m) {
        return remembers ? law.remember(m) : 0;
    }

    /** What a slope goes by. */
    private static double of(LinkMotion m, int slope) {
        return switch (slope) {
            case DISPLACEMENT_NOW -> m.displacement;
            case VELOCITY_NOW -> m.velocity;
            case DISPLACEMENT_BEFORE -> m.before;
            case MEMORY_BEFORE -> m.memory;
            case LATE_DISPLACEMENT -> m.lateDisplacement;
            case LATE_VELOCITY -> m.lateVelocity;
            case STIFFNESS -> m.stiffness;
            case DAMPING -> m.damping;
            case MODULATION -> m.modulation;
            default -> throw new IllegalArgumentException("no slope to a motion: " + slope);
        };
    }

    private static void set(LinkMotion m, int slope, double value) {
        switch (slope) {
            case DISPLACEMENT_NOW -> m.displacement = value;
            case VELOCITY_NOW -> m.velocity = value;
            case DISPLACEMENT_BEFORE -> m.before = value;
            case MEMORY_BEFORE -> m.memory = value;
            case LATE_DISPLACEMENT -> m.lateDisplacement = value;
            case LATE_VELOCITY -> m.lateVelocity = value;
            case STIFFNESS -> m.stiffness = value;
            case DAMPING -> m.damping = value;
            case MODULATION -> m.modulation = value;
            default -> throw new IllegalArgumentException("no slope to a motion: " + slope);
        }
    }
}
