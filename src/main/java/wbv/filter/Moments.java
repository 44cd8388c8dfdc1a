package wbv.filter;

import java.io.Serializable;
import org.ejml.data.DMatrixRMaj;

/** How mean and covariance pass through a body's motion and through its output: what tells one Kalman filter from another. */
sealed interface Moments extends Serializable permits Linearised, Unscented {

    /**
     * Over one sampling interval, without process noise.
     *
     * @param c  coefficients of the input. Not modified.
     * @param xi mean. Modified.
     * @param p  covariance. Modified.
     */
    void advance(double[] c, double[] xi, DMatrixRMaj p);

    /**
     * Through the output.
     *
     * @param xi    mean. Not modified.
     * @param p     covariance. Not modified.
     * @param cross covariance of ξ with the output, n by 1. Modified.
     * @return mean of the output
     */
    double measure(double[] xi, DMatrixRMaj p, DMatrixRMaj cross);

    /** Variance of the output at the last {@link #measure}, the sensor's noise not counted. */
    double variance();

    /**
     * Takes from a covariance what a correction by a gain takes; right for any gain. After {@link #measure}.
     *
     * @param gain n by 1. Not modified.
     * @param r    variance of the output's noise
     * @param p    Modified.
     */
    void reduce(DMatrixRMaj gain, double r, DMatrixRMaj p);
}
