package wbv.diagnosis;

import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;
import wbv.body.Stroke;

/**
 * How much of a driven link's force no law of its stroke explains: chatter, stick-slip, what changes from cycle to cycle. The force is
 * regressed on a rich family of hysteresis, stop operators of many widths (Prandtl 1928, Ishlinskii 1944) with even and odd shapes, and
 * on functions of velocity; the rest is the floor that a law has to reach, which the sensor's own noise is far below.
 */
final class Repeatable {

    private static final int WIDTHS = 12;
    private static final int SPEEDS = 4;
    private static final double RIDGE = 1e-8;

    private Repeatable() { }

    /** Standard deviation of the rest. @param force measured. Not modified. @param valid samples that count. Not modified. @param to end */
    static double rest(Stroke stroke, double[] force, boolean[] valid, int to) {
        List<double[]> columns = columns(stroke, to);
        int m = columns.size();
        DMatrixRMaj gram = new DMatrixRMaj(m, m);
        DMatrixRMaj right = new DMatrixRMaj(m, 1);
        int count = 0;
        for (int j = 0; j < to; j++) {
            count += valid[j] ? 1 : 0;
        }
        for (int a = 0; a < m; a++) {
            for (int b = 0; b <= a; b++) {
                double sum = 0;
                for (int j = 0; j < to; j++) {
                    sum += valid[j] ? columns.get(a)[j] * columns.get(b)[j] : 0;
                }
                gram.set(a, b, sum + (a == b ? RIDGE * count : 0));
                gram.set(b, a, gram.get(a, b));
            }
            double sum = 0;
            for (int j = 0; j < to; j++) {
                sum += valid[j] ? columns.get(a)[j] * force[j] : 0;
            }
            right.set(a, sum);
        }
        LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.symmPosDef(m);
        DMatrixRMaj weights = new DMatrixRMaj(m, 1);
        if (count <= 2 * m || !solver.setA(gram)) {
            return 0;
        }
        solver.solve(right, weights);
        double rest = 0;
        for (int j = 0; j < to; j++) {
            double fit = 0;
            for (int a = 0; a < m; a++) {
                fit += weights.get(a) * columns.get(a)[j];
            }
            rest += valid[j] ? (force[j] - fit) * (force[j] - fit) : 0;
        }
        return Math.sqrt(rest / (count - m));
    }

    private static List<double[]> columns(Stroke stroke, int to) {
        double[] x = stroke.position();
        double[] v = stroke.velocity();
        double range = range(x, to);
        double speed = range(v, to) / 2;
        List<double[]> columns = new ArrayList<>();
        columns.add(series(to, j -> 1));
        columns.add(series(to, j -> x[j] / range));
        columns.add(series(to, j -> x[j] * x[j] * x[j] / (range * range * range)));
        columns.add(series(to, j -> v[j] / speed));
        columns.add(series(to, j -> v[j] * Math.abs(v[j]) / (speed * speed)));
        for (int i = 0; i < SPEEDS; i++) {
            double scale = speed * Math.pow(0.2, i + 1.0);
            columns.add(series(to, j -> Math.tanh(v[j] / scale)));
        }
        for (int i = 0; i < WIDTHS; i++) {
            double width = range * Math.pow(0.6, i + 1.0);
            double[] stop = new double[to];
            for (int j = 1; j < to; j++) {
                stop[j] = Math.max(-1, Math.min(1, stop[j - 1] + (x[j] - x[j - 1]) / width));
            }
            columns.add(stop);
            columns.add(series(to, j -> stop[j] * stop[j]));
            columns.add(series(to, j -> stop[j] * stop[j] * stop[j]));
        }
        return columns;
    }

    private static double[] series(int to, java.util.function.IntToDoubleFunction value) {
        double[] out = new double[to];
        for (int j = 0; j < to; j++) {
            out[j] = value.applyAsDouble(j);
        }
        return out;
    }

    private static double range(double[] x, int to) {
        double low = x[0];
        double high = x[0];
        for (int j = 0; j < to; j++) {
            low = Math.min(low, x[j]);
            high = Math.max(high, x[j]);
        }
        return Math.max(high - low, 1e-12);
    }
}
