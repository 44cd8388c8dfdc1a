package moa.classifiers.wbv;

/** {@link wbv.learn.RecursiveArmaxLearner} where MOA's window looks for learners. */
public final class RecursiveArmaxLearner extends wbv.learn.RecursiveArmaxLearner {

    private static final long serialVersionUID = 1;
}
