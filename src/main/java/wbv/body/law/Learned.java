package wbv.body.law;

/** A term of a law that no library holds, learned from a recording. Several in one link add up to the law. */
public sealed interface Learned extends Law
        permits LearnedTerm, LearnedLimited, LearnedKnee, LearnedMemory, LearnedInertance, LearnedCourse, LearnedWave, LearnedTable {

    /** The word that stands for all of them. */
    String MECHANISM = "learned";

    @Override
    default String mechanism() {
        return MECHANISM;
    }

    /** What multiplies the shape, in its own unit, {@link #unit}. */
    double coefficient();

    /** Unit of the coefficient. */
    String unit();

    /** What the coefficient multiplies but for the modulator, without numbers: {@code |v|v}. */
    String kind();

    /** The same with its numbers. */
    default String formula() {
        return kind();
    }

    /** Whether its numbers mean something by the clock alone. */
    default boolean byTheClock() {
        return false;
    }
}
