package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_ZDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;
import wbv.diagnosis.algebra.DampedEquations;
import wbv.diagnosis.fit.Normal;
import wbv.diagnosis.fit.Parallel;
import wbv.signal.ScalarProduct;

/**
 * Moves the numbers of a {@link PlaneNet} until its sensors read what was computed: Levenberg (1944) and Marquardt (1963) on spectra, with
 * derivatives that are exact but for those of the matrices. What is missed of an output, as a share of it, counts once a mode, not by line:
 * an arrangement that is not the right one errs by mode. The numbers are expected where they are usual.
 *
 * <p>By how much the arrangement will miss is not known before: bodies in a plane that stand for a simulation of many more never come as
 * near as ones that are the simulation's own. So that share is a number that the fit finds too (its likelihood at its greatest over the
 * share: the logarithm of what is missed). Were it given, and too small, then numbers that no person has would be bought with a percent.
 */
final class PlaneFit {

    /** Steps at most: about twice what fits of twelve motions take. */
    private static final int STEPS = 150;
    /** A step that lowers the cost [1] by less is the last: the square of a tenth of a number's standard deviation. */
    private static final double SETTLED = 0.01;
    /** Times a number's own curvature: a step is then nothing beside any number's spread. */
    private static final double MOST_DAMPING = 1e8;
    /**
     * Of central differences of the matrices, over a number's spread: the cube root of what a double rounds by, nearly, where their two
     * errors are alike.
     */
    private static final double STEP = 1e-5;
    /** Work is dealt out in so many pieces, whatever the cores, so that sums do not hang on them. */
    private static final int PIECES = 8;

    /**
     * What is fitted.
     *
     * @param read index among the readings of a net: three for a measured part
     * @param rate whether it is an angular rate, not an acceleration
     * @param lines its spectrum. Not copied
     */
    record Output(int read, boolean rate, double[] lines) {}

    /**
     * A net that was fitted.
     *
     * @param missed share of each output
     * @param cost what the fit lowers: twice the negative logarithm of its likelihood times that of the numbers, but for a constant
     */
    record Fitted(PlaneNet net, double[] missed, double cost) {
        double worst() {
            return Arrays.stream(missed).max().orElseThrow();
        }
    }

    private final double[] omega;
    private final double[][] base;
    private final List<Output> outputs;
    private final double[] size;
    private final double least;

    /**
     * @param omega   angular frequency of each line [rad/s]
     * @param base spectra of its acceleration along x, along z and about y; real and imaginary part of a line side by side. Not modified.
     * @param least   share of an output that even the right arrangement misses
     */
    PlaneFit(double[] omega, double[][] base, List<Output> outputs, double least) {
        this.omega = omega;
        this.base = base;
        this.outputs = List.copyOf(outputs);
        this.least = least;
        size = outputs.stream().mapToDouble(output -> Math.sqrt(ScalarProduct.of(output.lines(), output.lines()))).toArray();
    }

    Fitted fit(PlaneNet start) {
        return fit(start, STEPS);
    }

    /** @param steps at most */
    Fitted fit(PlaneNet start, int steps) {
        PlaneNet net = start;
        Normal now = normal(net);
        double damping = 1e-2;
        for (int step = 0; step < steps && damping < MOST_DAMPING; step++) {
            double[] at = net.at();
            double[] move = DampedEquations.solve(now.square, now.slope, new boolean[at.length], damping);
            double[] spread = net.spread();
            double longest = IntStream.range(0, at.length).mapToDouble(i -> Math.abs(move[i]) / spread[i]).max().orElse(0);
            double shortened = Math.min(1, 1 / longest);   // no number goes farther at once than it is spread
            Arrays.setAll(at, i -> at[i] + shortened * move[i]);
            PlaneNet trial = net.at(at);
            Normal then = normal(trial);
            if (then.cost < now.cost) {
                boolean settled = then.cost > now.cost - SETTLED && damping <= 1;
                net = trial;
                now = then;
                damping /= 5;
                if (settled) {
                    break;
                }
            } else {
                damping *= 5;
            }
        }
        return new Fitted(net, Arrays.stream(now.missed).map(Math::sqrt).toArray(), now.cost);
    }

    /**
     * Normal equations.
     *
     * @param missed square of the share of each output that is missed
     */
    private record Normal(double[][] square, double[] slope, double[] missed, double cost) {}

    /** What the matrices change by with one number: entries of M, C, K; of T; of R. */
    private record Slope(List<Entry> entries, List<Single> carried, List<Single> read) {}

    private record Entry(int row, int column, double mass, double damping, double stiffness) {}

    private record Single(int row, int column, double value) {}

    private Normal normal(PlaneNet net) {
        double[] at = net.at();
        double[] usual = net.usual();
        double[] spread = net.spread();
        PlaneNet.Matrices matrices = net.matrices();
        List<Slope> slopes = slopes(net, at, spread);
        int piece = (omega.length + PIECES - 1) / PIECES;
        List<Normal> parts = Parallel.map(IntStream.range(0, PIECES).boxed().toList(),
                p -> part(matrices, slopes, p * piece, Math.min(omega.length, (p + 1) * piece)));
        double[][] square = new double[at.length][at.length];
        double[] slope = new double[at.length];
        double[] missed = new double[outputs.size()];
        for (Normal part : parts) {
            Arrays.setAll(slope, i -> slope[i] + part.slope[i]);
            Arrays.setAll(missed, o -> missed[o] + part.missed[o]);
            for (int i = 0; i < at.length; i++) {
                double[] row = square[i];
                double[] more = part.square[i];
                Arrays.setAll(row, j -> row[j] + more[j]);
            }
        }
        double variance = least * least + Arrays.stream(missed).average().orElseThrow();
        double cost = net.motions() * outputs.size() * Math.log(variance);
        double weight = net.motions() / variance;
        for (int i = 0; i < at.length; i++) {
            double pull = (at[i] - usual[i]) / spread[i];
            cost += pull * pull;
            for (int j = 0; j < at.length; j++) {
                square[i][j] *= weight;
            }
            square[i][i] += 1 / (spread[i] * spread[i]);
            slope[i] = weight * slope[i] - pull / spread[i];
        }
        return new Normal(square, slope, missed, Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost);
    }

    private static List<Slope> slopes(PlaneNet net, double[] at, double[] spread) {
        return IntStream.range(0, at.length).mapToObj(p -> {
            double[] moved = at.clone();
            double h = STEP * spread[p];
            moved[p] = at[p] + h;
            PlaneNet.Matrices high = net.at(moved).matrices();
            moved[p] = at[p] - h;
            PlaneNet.Matrices low = net.at(moved).matrices();
            List<Entry> entries = new ArrayList<>();
            int n = high.mass().length;
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    double mass = i == j ? (high.mass()[i] - low.mass()[i]) / (2 * h) : 0;
                    double damping = (high.damping()[i][j] - low.damping()[i][j]) / (2 * h);
                    double stiffness = (high.stiffness()[i][j] - low.stiffness()[i][j]) / (2 * h);
                    if (mass != 0 || damping != 0 || stiffness != 0) {
                        entries.add(new Entry(i, j, mass, damping, stiffness));
                    }
                }
            }
            return new Slope(entries, singles(high.carried(), low.carried(), h), singles(high.read(), low.read(), h));
        }).toList();
    }

    private static List<Single> singles(double[][] high, double[][] low, double h) {
        List<Single> out = new ArrayList<>();
        for (int i = 0; i < high.length; i++) {
            for (int j = 0; j < high[i].length; j++) {
                if (high[i][j] != low[i][j]) {
                    out.add(new Single(i, j, (high[i][j] - low[i][j]) / (2 * h)));
                }
            }
        }
        return out;
    }

    /** The part of some lines. */
    private Normal part(PlaneNet.Matrices matrices, List<Slope> slopes, int from, int to) {
        int parameters = slopes.size();
        double[][] square = new double[parameters][parameters];
        double[] slope = new double[parameters];
        double[] missed = new double[outputs.size()];
        Line line = new Line(matrices, outputs.size());
        double[] re = new double[parameters];
        double[] im = new double[parameters];
        for (int k = from; k < to; k++) {
            line.solve(k);
            for (int o = 0; o < outputs.size(); o++) {
                line.residual(o, k);
                missed[o] += line.errorRe * line.errorRe + line.errorIm * line.errorIm;
                for (int p = 0; p < parameters; p++) {
                    line.slope(slopes.get(p), o, k);
                    re[p] = line.slopeRe;
                    im[p] = line.slopeIm;
                }
                for (int p = 0; p < parameters; p++) {
                    slope[p] -= re[p] * line.errorRe + im[p] * line.errorIm;
                    double[] row = square[p];
                    for (int q = 0; q <= p; q++) {
                        row[q] += re[p] * re[q] + im[p] * im[q];
                    }
                }
            }
        }
        for (int p = 0; p < parameters; p++) {
            for (int q = 0; q < p; q++) {
                square[q][p] = square[p][q];
            }
        }
        return new Normal(square, slope, missed, 0);
    }

    /** One line of the spectrum: what the base does there moves the bodies, and what a force would do at each of them. */
    private final class Line {
        private final PlaneNet.Matrices m;
        private final int n;
        private final ZMatrixRMaj d;
        private final ZMatrixRMaj right;
        private final ZMatrixRMaj solved;
        private final LinearSolverDense<ZMatrixRMaj> solver;
        /** T b: what the base alone gives each motion; and all that it does, both accelerations. */
        private final double[] carried;
        private final double[] felt;
        private double errorRe;
        private double errorIm;
        private double slopeRe;
        private double slopeIm;

        Line(PlaneNet.Matrices m, int outputs) {
            this.m = m;
            n = m.mass().length;
            d = new ZMatrixRMaj(n, n);
            right = new ZMatrixRMaj(n, outputs + 1);
            solved = new ZMatrixRMaj(n, outputs + 1);
            solver = LinearSolverFactory_ZDRM.lu(n);
            carried = new double[2 * n];
            felt = new double[2 * n];
        }

        void solve(int k) {
            double w = omega[k];
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    d.set(i, j, m.stiffness()[i][j] - (i == j ? w * w * m.mass()[i] : 0), w * m.damping()[i][j]);
                }
                carried[2 * i] = 0;
                carried[2 * i + 1] = 0;
                for (int axis = 0; axis < base.length; axis++) {
                    carried[2 * i] += m.carried()[i][axis] * base[axis][2 * k];
                    carried[2 * i + 1] += m.carried()[i][axis] * base[axis][2 * k + 1];
                }
                right.set(i, 0, -m.mass()[i] * carried[2 * i], -m.mass()[i] * carried[2 * i + 1]);
                for (int o = 0; o < outputs.size(); o++) {
                    right.set(i, o + 1, m.read()[outputs.get(o).read()][i], 0);
                }
            }
            solver.setA(d);
            solver.solve(right, solved);
            for (int i = 0; i < n; i++) {
                felt[2 * i] = carried[2 * i] - w * w * solved.getReal(i, 0);
                felt[2 * i + 1] = carried[2 * i + 1] - w * w * solved.getImag(i, 0);
            }
        }

        /** What is missed, over the output's size. */
        void residual(int o, int k) {
            Output output = outputs.get(o);
            double re = 0;
            double im = 0;
            double[] row = m.read()[output.read()];
            for (int i = 0; i < n; i++) {
                re += row[i] * felt[2 * i];
                im += row[i] * felt[2 * i + 1];
            }
            scaled(re, im, o, k);
            errorRe = slopeRe - output.lines()[2 * k] / size[o];
            errorIm = slopeIm - output.lines()[2 * k + 1] / size[o];
        }

        /** As the sensor reads an acceleration, over the output's size. */
        private void scaled(double re, double im, int o, int k) {
            boolean rate = outputs.get(o).rate();
            slopeRe = (rate ? im / omega[k] : re) / size[o];
            slopeIm = (rate ? -re / omega[k] : im) / size[o];
        }

        /** What an output changes by with one number, over its size. */
        void slope(Slope s, int o, int k) {
            double w = omega[k];
            double re = 0;
            double im = 0;
            for (Entry e : s.entries) {
                // -(dM a + dC v + dK x) at a row, which moves the output by -w² G
                double x = solved.getReal(e.column, 0);
                double y = solved.getImag(e.column, 0);
                double fr = -e.mass * felt[2 * e.column] - e.stiffness * x + w * e.damping * y;
                double fi = -e.mass * felt[2 * e.column + 1] - e.stiffness * y - w * e.damping * x;
                double gr = solved.getReal(e.row, o + 1);
                double gi = solved.getImag(e.row, o + 1);
                re -= w * w * (gr * fr - gi * fi);
                im -= w * w * (gr * fi + gi * fr);
            }
            double[] row = m.read()[outputs.get(o).read()];
            for (Single c : s.carried) {
                double br = c.value * base[c.column][2 * k];
                double bi = c.value * base[c.column][2 * k + 1];
                double gr = row[c.row] + w * w * m.mass()[c.row] * solved.getReal(c.row, o + 1);
                double gi = w * w * m.mass()[c.row] * solved.getImag(c.row, o + 1);
                re += gr * br - gi * bi;
                im += gr * bi + gi * br;
            }
            for (Single r : s.read) {
                if (r.row == outputs.get(o).read()) {
                    re += r.value * felt[2 * r.column];
                    im += r.value * felt[2 * r.column + 1];
                }
            }
            scaled(re, im, o, k);
        }
    }
}
