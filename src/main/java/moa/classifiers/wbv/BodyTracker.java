package moa.classifiers.wbv;

/** {@link wbv.learn.BodyTracker} where MOA's window looks for learners. */
public final class BodyTracker extends wbv.learn.BodyTracker {

    private static final long serialVersionUID = 1;
}
