package wbv.filter.drift;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * Says when a stream of numbers in [0, 1] changed its mean: the port through which a change detector reaches a filter.
 *
 * <p>An alarm that is serialised and read back continues as the original would.
 */
public interface Alarm extends Serializable, Snapshot {

    /**
     * Takes the next value.
     *
     * @param value in [0, 1]
     * @return true if the mean has changed and the values before the change were dropped
     */
    boolean feed(double value);

    /** Number of values since the last change that the alarm still regards as one regime. */
    long width();

    /** Mean of the values in the window, in [0, 1]; 0 while it is empty. */
    double mean();

    /** Forgets every value. */
    void reset();

    /** @throws IllegalStateException where a detector of a host does not let its memory be kept */
    @Override
    default void save(StateWriter out) {
        throw new IllegalStateException(getClass().getName() + " cannot be kept; " + Adwin.class.getName() + " can");
    }

    @Override
    default void load(StateReader in) {
        throw new IllegalStateException(getClass().getName() + " cannot be kept; " + Adwin.class.getName() + " can");
    }
}
