package wbv.control;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;

/** A {@link SeatDesign} in use: its observer and its gain, in flat arrays. */
final class OptimalGains {

    private static final int N = SeatModel.N;
    private static final int SENSORS = SeatModel.SENSORS;

    private final double[] a = new double[N * N];
    private final double[] b = new double[N];
    private final double[] c = new double[SENSORS * N];
    private final double[] k = new double[N];
    private final double[] l = new double[N * SENSORS];
    private final double[] x = new double[N];
    private final double[] moved = new double[N];

    /** A design that is ready; the states stay. */
    void take(SeatModel model, SeatDesign design) {
        copy(design.foresight(), a);
        copy(model.b(), b);
        copy(model.c(), c);
        copy(design.gain(), k);
        copy(design.correction(), l);
    }

    private static void copy(DMatrixRMaj from, double[] to) {
        System.arraycopy(from.data, 0, to, 0, to.length);
    }

    /** Corrects the foreseen states by what the sensors read; NaN corrects nothing. */
    void correct(double deflection, double floor, double frame) {
        System.arraycopy(x, 0, moved, 0, N);
        correct(0, deflection);
        correct(1, floor);
        correct(2, frame);
        System.arraycopy(moved, 0, x, 0, N);
    }

    private void correct(int sensor, double reading) {
        double innovation = reading;
        for (int i = 0; i < N; i++) {
            innovation -= c[sensor * N + i] * x[i];
        }
        if (Double.isFinite(innovation)) {
            for (int i = 0; i < N; i++) {
                moved[i] += l[i * SENSORS + sensor] * innovation;
            }
        }
    }

    /** The force that the states ask for [N]. */
    double force() {
        double sum = 0;
        for (int i = 0; i < N; i++) {
            sum -= k[i] * x[i];
        }
        return sum;
    }

    /**
     * The states a sample later.
     *
     * @param force that was given [N]
     */
    void foresee(double force) {
        for (int i = 0; i < N; i++) {
            double sum = b[i] * force;
            for (int j = 0; j < N; j++) {
                sum += a[i * N + j] * x[j];
            }
            moved[i] = sum;
        }
        System.arraycopy(moved, 0, x, 0, N);
    }

    /** States at rest. */
    void rest() {
        Arrays.fill(x, 0);
    }
}
