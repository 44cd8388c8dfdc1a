package wbv.filter;

import java.io.Serializable;

/**
 * Says when a stream of numbers in [0, 1] changed its mean: the port through which a change detector reaches a filter.
 *
 * <p>An alarm that is serialised and read back continues as the original would.
 */
public interface Alarm extends Serializable {

    /**
     * Takes the next value.
     *
     * @param value in [0, 1]
     * @return true if the mean has changed and the values before the change were dropped
     */
    boolean feed(double value);

    /** Number of values since the last change that the alarm still regards as one regime. */
    long width();

    /** Mean of the values in the window; 0 while it is empty. */
    double mean();

    /** Forgets every value. */
    void reset();
}
