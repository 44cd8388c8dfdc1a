package wbv.learn;

import com.yahoo.labs.samoa.instances.Instance;
import moa.classifiers.AbstractClassifier;
import moa.core.Measurement;
import moa.core.StringUtils;
import wbv.filter.BodyEstimate;
import wbv.filter.ShareExplained;
import wbv.filter.model.Spec;

/** What MOA asks of every body learner: it hands instances on to an {@link InstanceFeed}, which its options make. */
abstract sealed class BodyRegressor extends AbstractClassifier implements BodyLearner permits AdwinKalman, BodyTracker {

    private static final long serialVersionUID = 1;

    private InstanceFeed feed;

    /** A feed at its start, as the options now say. */
    abstract InstanceFeed freshFeed();

    /** The feed; made when it is first asked for, since options are there only after construction. */
    final InstanceFeed feed() {
        if (feed == null) {
            feed = freshFeed();
        }
        return feed;
    }

    @Override
    public final void resetLearningImpl() {
        feed = freshFeed();
    }

    @Override
    public final void trainOnInstanceImpl(Instance instance) {
        feed().train(instance);
    }

    /** The output as foreseen from the input of this instance and everything before it. */
    @Override
    public final double[] getVotesForInstance(Instance instance) {
        return new double[] {feed().predict(instance)};
    }

    @Override
    public final BodyEstimate track() {
        return feed().estimator().track();
    }

    @Override
    public final ShareExplained explained() {
        return feed().explained();
    }

    @Override
    public final Spec spec() {
        return feed().estimator().spec();
    }

    /**
     * |H(f)| of the body as now known.
     *
     * @param f [Hz]
     */
    public final double modulus(double f) {
        return feed().estimator().modulus(f);
    }

    /** Covariance of the estimator's state, row by row. A copy. */
    public final double[] covariance() {
        return feed().estimator().covariance();
    }

    @Override
    protected final Measurement[] getModelMeasurementsImpl() {
        return TrackMeasurements.of(track(), explained());
    }

    @Override
    public final void getModelDescription(StringBuilder out, int indent) {
        StringUtils.appendIndented(out, indent, TrackMeasurements.sentence(track(), explained(), spec()));
    }

    @Override
    public final boolean isRandomizable() {
        return false;
    }
}
