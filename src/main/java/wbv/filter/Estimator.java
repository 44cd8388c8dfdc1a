package wbv.filter;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import wbv.filter.model.Spec;
import wbv.snapshot.Snapshot;

/**
 * What follows a body as a stream: natural frequency and damping ratio of its modes, sample by sample, from what shakes its
 * base and how it moves. Input and output are two accelerations [m/s²] or two angular rates [rad/s] along or about one axis;
 * the transfer function is the same.
 *
 * <p>The contract of every estimator:
 * <ul>
 * <li>{@link #reset} and the same samples give the same tracks again, number for number;</li>
 * <li>a {@link #copy} continues as the original would, and apart from it;</li>
 * <li>a missing sample is NaN; it is tolerated and counted, and a long gap keeps the parameters;</li>
 * <li>{@link #covariance} is symmetric and positive definite after every sample;</li>
 * <li>{@link #step} and {@link #predict} allocate nothing.</li>
 * </ul>
 */
public interface Estimator extends Serializable, Snapshot {

    /** What the estimator was told before the first sample. */
    Spec spec();

    /** How it works. */
    EstimatorDesign design();

    /** What is known after the last sample. The same object always. */
    BodyEstimate track();

    /** Covariance of the estimator's state, row by row, in the product of the two states' units. A copy. */
    double[] covariance();

    /**
     * The output that goes with the next input sample, from everything before it. Changes nothing.
     *
     * @param u input [m/s² or rad/s]; NaN if missing
     * @return predicted output, in the unit of u; NaN before the first sample if the input is missing
     */
    double predict(double u);

    /**
     * Takes the next sample.
     *
     * @param u motion of the base [m/s² or rad/s]; NaN if missing
     * @param y motion of the body, in the unit of u; NaN if missing
     * @return {@link #track}
     */
    BodyEstimate step(double u, double y);

    /** As before the first sample. */
    void reset();

    /**
     * |H(f)| of the body as now known [1].
     *
     * @param f [Hz]
     */
    double modulus(double f);

    /** An estimator that continues as this one would, independent of it. */
    default Estimator copy() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(this);
            out.flush();
            return (Estimator) new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray())).readObject();
        } catch (IOException | ClassNotFoundException impossible) {
            throw new IllegalStateException("an estimator, its alarm or its constraint does not serialise", impossible);
        }
    }
}
