package wbv.filter;

import java.io.Serializable;
import wbv.snapshot.Snapshot;
import wbv.snapshot.StateReader;
import wbv.snapshot.StateWriter;

/**
 * An estimator of a body whose base moves in other ways as well: what {@link CrossAxes} says that those do to the output is taken
 * away before the estimator sees it, and added again to what it foresees. Without other motions it is the estimator alone.
 */
public final class AccompaniedEstimator implements Serializable, Snapshot {

    private static final long serialVersionUID = 1;

    private final Estimator estimator;
    private final CrossAxes cross;

    /**
     * Nothing is known of the other motions at first.
     *
     * @param estimator at its start; owned by this from now on
     * @param others number of other motions, &gt;= 0
     */
    public AccompaniedEstimator(Estimator estimator, int others) {
        this.estimator = estimator;
        this.cross = new CrossAxes(estimator.spec(), others);
    }

    /** Of the body alone: what it predicts of itself lacks the other motions' part. */
    public Estimator estimator() {
        return estimator;
    }

    /**
     * The output that goes with the next samples of all inputs, from everything before them [m/s² or rad/s]. Changes nothing.
     *
     * @param u      input [m/s² or rad/s]; NaN if missing
     * @param others other motions, by motion, each in its own unit; NaN if missing. Not modified.
     */
    public double predict(double u, double[] others) {
        return estimator.predict(u) + cross.foresee(others);
    }

    /**
     * Takes the next sample.
     *
     * @param u      motion of the base [m/s² or rad/s]; NaN if missing
     * @param others other motions of the base, by motion, each in its own unit; NaN if missing. Not modified.
     * @param y      motion of the body, in the unit of u; NaN if missing
     * @return the estimator's track, its prediction that of the whole output
     */
    public BodyEstimate step(double u, double[] others, double y) {
        double part = cross.foresee(others);
        BodyEstimate track = estimator.step(u, y - part);
        track.foresee(track.prediction() + part);
        cross.learn(u, others, y);
        return track;
    }

    /** As before the first sample. */
    public void reset() {
        estimator.reset();
        cross.reset();
    }

    @Override
    public void save(StateWriter out) {
        out.put(estimator);
        out.put(cross);
    }

    @Override
    public void load(StateReader in) {
        in.part(estimator);
        in.part(cross);
    }
}
