package moa.classifiers.core.driftdetection.wbv;

/** {@link wbv.learn.TwoSidedAdwin} where MOA's window looks for change detectors. */
public final class TwoSidedAdwin extends wbv.learn.TwoSidedAdwin {

    private static final long serialVersionUID = 1;
}
