package wbv.learn;

import moa.classifiers.Classifier;
import moa.classifiers.Regressor;
import wbv.filter.BodyEstimate;
import wbv.filter.ShareExplained;
import wbv.filter.model.Spec;

/** A MOA regressor that predicts how a body moves, and knows the body's natural frequency and damping. */
public interface BodyLearner extends Classifier, Regressor {

    /** What is known after the last instance. The same object until learning is reset. */
    BodyEstimate track();

    /** What the predictions explained so far. The same object until learning is reset. */
    ShareExplained explained();

    /** What the estimator was told; the rate is the one that the instances showed. */
    Spec spec();
}
