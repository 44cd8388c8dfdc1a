package wbv.filter;

import java.io.Serializable;

/**
 * How mean and covariance pass through a body's motion and through its output: what tells one Kalman filter from another.
 * Covariances are n by n, row by row, and symmetric to the last bit.
 */
sealed interface Moments extends Serializable permits Linearised, LinearisedOne, Unscented {

    /**
     * Over one sampling interval, without process noise.
     *
     * @param c      coefficients of the input. Not modified.
     * @param forced as {@link wbv.filter.model.BodyModel#forced} of it and of ξ. Not modified.
     * @param xi     mean. Modified.
     * @param p      covariance. Modified.
     */
    void advance(double[] c, double[] forced, double[] xi, double[] p);

    /**
     * Through the output.
     *
     * @param xi    mean. Not modified.
     * @param p     covariance. Not modified.
     * @param cross covariance of ξ with the output, n long. Modified.
     * @return mean of the output
     */
    double measure(double[] xi, double[] p, double[] cross);

    /** Variance of the output at the last {@link #measure}, the sensor's noise not counted. */
    double variance();

    /**
     * Takes from a covariance what a correction by a gain takes; right for any gain. After {@link #measure}.
     *
     * @param gain n long. Not modified.
     * @param r    variance of the output's noise
     * @param p    Modified.
     */
    void reduce(double[] gain, double r, double[] p);
}
