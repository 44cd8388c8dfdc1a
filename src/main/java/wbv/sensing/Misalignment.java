package wbv.sensing;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import wbv.recording.DataFault;

/**
 * How one sensor stands to another on the same rigid body, from the same motion as both read it: the rotation of least squares
 * (Wahba's problem by Davenport's quaternion), and what of it the motion shows.
 *
 * <p>A sensor turned by Δθ reads {@code sin Δθ} of the motion of another axis, and loses {@code 1 - cos Δθ} of its own (thesis
 * Eq. 2-30, which gives the first for the second). Motion along one line does not show a turn about that line.
 */
public final class Misalignment {

    private final double[][] product = new double[3][3];
    private final double[][] own = new double[3][3];
    private double squares;
    private long count;

    /**
     * What was found.
     *
     * @param rotation  sensor to reference
     * @param deviation standard deviation of a turn about the reference's x, y and z axis [rad]; infinite where nothing shows it
     * @param residual  rms of what the rotation leaves of a component
     */
    public record Found(Orientation rotation, double[] deviation, double residual) { }

    /**
     * Takes the same moment in both; one with anything missing is passed over. @param sensor @param reference vectors. Not
     * modified.
     */
    public void accept(double[] sensor, double[] reference) {
        if (!Vectors.known(sensor) || !Vectors.known(reference)) {
            return;
        }
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                product[i][j] += reference[i] * sensor[j];
                own[i][j] += reference[i] * reference[j];
            }
        }
        squares += Vectors.dot(sensor, sensor) + Vectors.dot(reference, reference);
        count++;
    }

    /** The rotation. @throws DataFault if fewer than three moments, or nothing moved */
    public Found found() {
        if (count < 3 || !(squares > 0)) {
            throw new DataFault("a misalignment needs motion at three moments or more: " + count + " are known");
        }
        double trace = product[0][0] + product[1][1] + product[2][2];
        double[][] k = new double[4][4];
        k[0][0] = trace;
        for (int i = 0; i < 3; i++) {
            int a = (i + 1) % 3;
            int b = (i + 2) % 3;
            k[0][1 + i] = product[b][a] - product[a][b];
            k[1 + i][0] = k[0][1 + i];
            for (int j = 0; j < 3; j++) {
                k[1 + i][1 + j] = product[i][j] + product[j][i] - (i == j ? trace : 0);
            }
        }
        EigenDecomposition eigen = new EigenDecomposition(new Array2DRowRealMatrix(k));
        int best = 0;
        for (int i = 1; i < 4; i++) {
            best = eigen.getRealEigenvalue(i) > eigen.getRealEigenvalue(best) ? i : best;
        }
        double[] q = eigen.getEigenvector(best).toArray();
        double left = Math.max(0, squares - 2 * eigen.getRealEigenvalue(best));
        double variance = left / Math.max(1, 3 * count - 3);
        // A small turn ρ moves a reference vector b by ρ × b: information Σ (|b|² I - b bᵀ) over the variance.
        double total = own[0][0] + own[1][1] + own[2][2];
        RealMatrix information = new Array2DRowRealMatrix(3, 3);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                information.setEntry(i, j, (i == j ? total : 0) - own[i][j]);
            }
        }
        return new Found(Orientation.of(q[0], q[1], q[2], q[3]), deviations(information, total, variance),
                Math.sqrt(variance));
    }

    private static double[] deviations(RealMatrix information, double total, double variance) {
        EigenDecomposition eigen = new EigenDecomposition(information);
        double[] deviation = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            for (int e = 0; e < 3; e++) {
                double part = eigen.getEigenvector(e).getEntry(axis);
                double size = eigen.getRealEigenvalue(e);
                // Noise alone gives a line of motion a width of so much.
                boolean shown = size > 1e-9 * total && size > 20 * variance;
                if (part * part > 1e-9) {
                    sum += shown ? part * part * variance / size : Double.POSITIVE_INFINITY;
                }
            }
            deviation[axis] = Math.sqrt(sum);
        }
        return deviation;
    }
}
