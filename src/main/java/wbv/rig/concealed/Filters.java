package wbv.rig.concealed;

import java.util.Arrays;
import org.ejml.interfaces.linsol.LinearSolverDense;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;

/**
 * What linear filters of several inputs together explain of an output: least squares over their present, their past and a little of their
 * future.
 */
final class Filters {

    /** Rows before and after which an input may act: 1.2 s and 0.1 s at 60 Hz. */
    private static final int PAST = 72;
    private static final int FUTURE = 6;
    /** Of the inputs' own power: what is not moved at all is not filtered. */
    private static final double RIDGE = 1e-7;

    private final double[][] inputs;
    private final LinearSolverDense<DMatrixRMaj> solver;
    private final int from;
    private final int to;

    /** @param inputs by row. Not modified. */
    Filters(double[][] inputs) {
        this.inputs = inputs;
        from = PAST;
        to = inputs[0].length - FUTURE;
        int each = PAST + FUTURE + 1;
        int n = inputs.length * each;
        DMatrixRMaj normal = new DMatrixRMaj(n, n);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                double sum = 0;
                for (int s = from; s < to; s++) {
                    sum += at(i, s) * at(j, s);
                }
                normal.set(i, j, sum);
                normal.set(j, i, sum);
            }
        }
        for (int i = 0; i < n; i++) {
            normal.add(i, i, RIDGE * normal.get(i, i) + Double.MIN_NORMAL);
        }
        solver = LinearSolverFactory_DDRM.chol(n);
        if (!solver.setA(normal)) {
            throw new IllegalArgumentException("the inputs do not differ");
        }
    }

    private double at(int weight, int s) {
        int each = PAST + FUTURE + 1;
        return inputs[weight / each][s + FUTURE - weight % each];
    }

    /** Variance of the output that they leave. */
    double left(double[] output) {
        int n = inputs.length * (PAST + FUTURE + 1);
        DMatrixRMaj right = new DMatrixRMaj(n, 1);
        double mean = Arrays.stream(output, from, to).average().orElse(0);
        double power = 0;
        for (int s = from; s < to; s++) {
            power += (output[s] - mean) * (output[s] - mean);
        }
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int s = from; s < to; s++) {
                sum += at(i, s) * (output[s] - mean);
            }
            right.set(i, 0, sum);
        }
        DMatrixRMaj weights = new DMatrixRMaj(n, 1);
        solver.solve(right, weights);
        double left = power;
        for (int s = from; s < to; s++) {
            double fit = 0;
            for (int i = 0; i < n; i++) {
                fit += weights.get(i) * at(i, s);
            }
            double mine = output[s] - mean;
            left += (mine - fit) * (mine - fit) - mine * mine;
        }
        // As many weights take as much of what is not theirs.
        return left / (to - from - n);
    }
}
