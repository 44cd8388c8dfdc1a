package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.Bounds;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * What is known about a body from elsewhere, sample by sample: the port through which bounds reach the constrained estimator,
 * such as those that the pole of a place that is measured sets to the pole of a place that is not.
 *
 * <p>A constraint that is serialised, or saved, and read back continues as the original would.
 */
public interface Constraint extends Serializable, Snapshot {

    /**
     * Says what holds at the next sample. Called once for each, before the estimator corrects.
     *
     * @param sample number of the sample since {@link #reset}, from 0
     * @param bounds empty when called. Modified.
     */
    void at(long sample, Bounds bounds);

    /** As before the first sample. */
    void reset();

    /** Nothing is known. */
    enum Nothing implements Constraint {
        NOTHING;

        @Override
        public void at(long sample, Bounds bounds) {}

        @Override
        public void reset() {}

        @Override
        public void save(StateWriter out) {}

        @Override
        public void load(StateReader in) {}
    }

    /** Nothing is known. One object, even after it was serialised. */
    Constraint NONE = Nothing.NOTHING;
}
