package moa.classifiers.wbv;

/** {@link wbv.learn.SpectrogramRegressor} where MOA's window looks for learners. */
public final class SpectrogramRegressor extends wbv.learn.SpectrogramRegressor {

    private static final long serialVersionUID = 1;
}
