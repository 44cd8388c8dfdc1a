package moa.classifiers.wbv;

/** {@link wbv.learn.SensorRemover} where MOA's window looks for learners. */
public final class SensorRemover extends wbv.learn.SensorRemover {

    private static final long serialVersionUID = 1;
}
