package moa.classifiers.wbv;

/** {@link wbv.learn.AdwinKalman} where MOA's window looks for learners. */
public final class AdwinKalman extends wbv.learn.AdwinKalman {

    private static final long serialVersionUID = 1;
}
