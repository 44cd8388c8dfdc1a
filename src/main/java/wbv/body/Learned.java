package wbv.body;

/** A term of a law that no library holds, learned from a recording. Several in one link add up to the law. */
public sealed interface Learned extends Law permits LearnedTerm, LearnedKnee, LearnedMemory, LearnedInertance {

    /** The word that stands for all of them. */
    String MECHANISM = "learned";

    @Override
    default String mechanism() {
        return MECHANISM;
    }

    /** What multiplies the shape, in {@link #unit}. */
    double coefficient();

    /** Unit of the coefficient. */
    String unit();

    /** What the coefficient multiplies, without the modulator: {@code |v|v}. */
    String formula();

    @Override
    Modulator modulator();
}
