package wbv.diagnosis.surrogate;

import java.util.List;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_ZDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * How a net answers its base, one line of the spectrum at a time: what the base does there moves the bodies, and what a force would do at
 * each of them tells what an output changes by with the matrices. Complex numbers are handed out as two, real and imaginary part, over the
 * output's size.
 */
final class PlaneResponse {

    private final double[] omega;
    private final double[][] base;
    private final List<PlaneSpectra.Output> outputs;
    private final PlaneMatrices matrices;
    private final int n;
    /** K + iωC - ω²M, and what it is solved for: first the base's motion, then a force in place of each output. */
    private final ZMatrixRMaj dynamic;
    private final ZMatrixRMaj right;
    private final ZMatrixRMaj solved;
    private final LinearSolverDense<ZMatrixRMaj> solver;
    /** T b: what the base alone gives each motion; and all that it does, both accelerations. */
    private final double[] carried;
    private final double[] felt;
    private int line;

    PlaneResponse(PlaneSpectra spectra, PlaneMatrices matrices) {
        this.omega = spectra.omega();
        this.base = spectra.base();
        this.outputs = spectra.outputs();
        this.matrices = matrices;
        n = matrices.mass().length;
        dynamic = new ZMatrixRMaj(n, n);
        right = new ZMatrixRMaj(n, outputs.size() + 1);
        solved = new ZMatrixRMaj(n, outputs.size() + 1);
        solver = LinearSolverFactory_ZDRM.lu(n);
        carried = new double[2 * n];
        felt = new double[2 * n];
    }

    /** Goes to a line, of which all else is asked then. */
    void at(int k) {
        line = k;
        double w = omega[k];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                dynamic.set(i, j, matrices.stiffness()[i][j] - (i == j ? w * w * matrices.mass()[i] : 0), w * matrices.damping()[i][j]);
            }
            carried[2 * i] = 0;
            carried[2 * i + 1] = 0;
            for (int axis = 0; axis < base.length; axis++) {
                carried[2 * i] += matrices.carried()[i][axis] * base[axis][2 * k];
                carried[2 * i + 1] += matrices.carried()[i][axis] * base[axis][2 * k + 1];
            }
            right.set(i, 0, -matrices.mass()[i] * carried[2 * i], -matrices.mass()[i] * carried[2 * i + 1]);
            for (int o = 0; o < outputs.size(); o++) {
                right.set(i, o + 1, matrices.read()[outputs.get(o).read()][i], 0);
            }
        }
        solver.setA(dynamic);
        solver.solve(right, solved);
        for (int i = 0; i < n; i++) {
            felt[2 * i] = carried[2 * i] - w * w * solved.getReal(i, 0);
            felt[2 * i + 1] = carried[2 * i + 1] - w * w * solved.getImag(i, 0);
        }
    }

    /**
     * What an output's sensor reads beyond what was computed of it.
     *
     * @param into two numbers. Modified.
     */
    void error(int output, double[] into) {
        double re = 0;
        double im = 0;
        double[] row = row(output);
        for (int i = 0; i < n; i++) {
            re += row[i] * felt[2 * i];
            im += row[i] * felt[2 * i + 1];
        }
        read(output, re, im, into, 0);
        PlaneSpectra.Output computed = outputs.get(output);
        into[0] -= computed.lines()[2 * line] / computed.size();
        into[1] -= computed.lines()[2 * line + 1] / computed.size();
    }

    /**
     * What an output changes by with one of the net's numbers.
     *
     * @param into two numbers for each of the net's. Modified.
     * @param number which one it is
     */
    void slope(MatrixSlope slope, int output, double[] into, int number) {
        double w = omega[line];
        double re = 0;
        double im = 0;
        for (MatrixSlope.Entry e : slope.entries()) {
            // -(dM a + dC v + dK x) at a row, which moves the output by -w² G
            double x = solved.getReal(e.column(), 0);
            double y = solved.getImag(e.column(), 0);
            double fr = -e.mass() * felt[2 * e.column()] - e.stiffness() * x + w * e.damping() * y;
            double fi = -e.mass() * felt[2 * e.column() + 1] - e.stiffness() * y - w * e.damping() * x;
            double gr = solved.getReal(e.row(), output + 1);
            double gi = solved.getImag(e.row(), output + 1);
            re -= w * w * (gr * fr - gi * fi);
            im -= w * w * (gr * fi + gi * fr);
        }
        double[] row = row(output);
        for (MatrixSlope.Single c : slope.carried()) {
            double br = c.value() * base[c.column()][2 * line];
            double bi = c.value() * base[c.column()][2 * line + 1];
            double gr = row[c.row()] + w * w * matrices.mass()[c.row()] * solved.getReal(c.row(), output + 1);
            double gi = w * w * matrices.mass()[c.row()] * solved.getImag(c.row(), output + 1);
            re += gr * br - gi * bi;
            im += gr * bi + gi * br;
        }
        for (MatrixSlope.Single r : slope.read()) {
            if (r.row() == outputs.get(output).read()) {
                re += r.value() * felt[2 * r.column()];
                im += r.value() * felt[2 * r.column() + 1];
            }
        }
        read(output, re, im, into, number);
    }

    private double[] row(int output) {
        return matrices.read()[outputs.get(output).read()];
    }

    /** As the sensor reads an acceleration, over the output's size. */
    private void read(int output, double re, double im, double[] into, int number) {
        PlaneSpectra.Output sensor = outputs.get(output);
        into[2 * number] = (sensor.rate() ? im / omega[line] : re) / sensor.size();
        into[2 * number + 1] = (sensor.rate() ? -re / omega[line] : im) / sensor.size();
    }
}
