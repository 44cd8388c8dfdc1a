package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.BodyModel;
import wbv.filter.model.Bounds;
import wbv.filter.model.InputWindow;
import wbv.filter.model.Sensitivity;
import wbv.snapshot.Snapshot;

/** What follows motion and parameters of a body together, sample by sample, within a {@link BodyEstimator}. */
sealed interface BodyFilter extends Serializable, Snapshot permits Bank, JointFilter, ParticleFilter {

    /** As before the first sample, random source included. */
    void reset();

    /** Parameters and their uncertainty as at the start, the motion unknown. */
    void start();

    /**
     * Parameters as told, the motion unknown.
     *
     * @param xi        read where the parameters are. Not modified.
     * @param deviation of each parameter. Not modified.
     */
    void startAt(double[] xi, double[] deviation);

    /** The motion and the offset are unknown again; parameters stay. */
    void restartMotion();

    /** The body may have changed: parameters become uncertain, and with them the motion. */
    void doubt();

    /**
     * Time passes without samples.
     *
     * @param samples how many would have come
     */
    void rest(double samples);

    /** The output, offset included, that an input sample after those of the window goes with. Changes nothing. */
    double foresee(InputWindow window, double input);

    /**
     * Over one sampling interval.
     *
     * @param hold whether parameters are to be held at this sample
     */
    void advance(InputWindow window, boolean hold);

    /**
     * Takes the output that goes with the motion as advanced.
     *
     * @param samplesInOne how many innovations are worth one
     */
    void correct(double y, double variance, double samplesInOne);

    /**
     * Learns the parameters' process noise from the last correction.
     *
     * @param width of the alarm's window [samples]
     */
    void learnDrift(long width);

    /** What the output depends on just now. */
    Sensitivity sensitivity();

    /** What the last correction was told. The same object always. */
    Innovation innovation();

    /** Moves the estimate to where it satisfies bounds, and says whether it had to; where that is not foreseen, leaves it. */
    default boolean project(Bounds bounds) {
        return false;
    }

    /** Whether every number is one and the parameters are those of a body. */
    boolean sane();

    BodyModel model();

    /** The estimate. Not to be modified. */
    double[] mean();

    /** Standard deviation of a parameter. */
    double deviation(int parameter);

    /** Covariance of the estimate, row by row. A copy. */
    double[] covariance();

    /** Whether the last sample could tell about a parameter. */
    default boolean informed() {
        return sensitivity().informed();
    }

    /**
     * Whether the last correction could move a parameter. That it did not move says less, and that it did nothing: a mixture of
     * filters that all stay where they are moves by how its sum is rounded.
     */
    boolean learned(int parameter);

    /** What the sensors' offset now is. */
    default double offset() {
        return mean()[model().offset()];
    }
}
