package moa.classifiers.wbv;

/** {@link wbv.learn.StateLearner} where MOA's window looks for learners. */
public final class StateLearner extends wbv.learn.StateLearner {

    private static final long serialVersionUID = 1;
}
