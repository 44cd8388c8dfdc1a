package wbv.body.simulate;

import java.util.Arrays;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import wbv.body.Spectra;
import wbv.body.Structure;

/**
 * Brings bodies that no spring holds back to rest in the silence after the record, so that a periodic response is the one from rest.
 *
 * <p>A spectrum stands for what repeats. What springs and dashpots hold is at rest again before the record comes round; a motion φ with
 * K φ = 0, such as that of a mass without a spring to the ground, is not: it goes on wherever the force has sent it. So two smooth
 * forces M φ g act along each such motion in the silence only, and a constant displacement φ β is free, such that at the first sample
 * displacement and velocity along φ are 0 and the forces along φ have no mean. What happens in the silence is not looked at.
 *
 * <p>What force there is at the record's ends is led in and out in the silence, so that it makes no jump there, which would ring.
 */
final class Brakes {

    /** Part of the largest ω² below which a motion is held by no spring. */
    private static final double UNHELD = 1e-12;
    /** Exponent of the sine that shapes a force in the silence: its spectrum falls off by the power of 9 beyond a few lines. */
    private static final int SMOOTH = 8;

    private final Excitation excitation;
    private final int bodies;
    /** Motions that no spring holds, by motion and body, φᵀ M φ = 1. */
    private final double[][] motions;
    private final double[] mass;
    /** Answer to a mean force, along what springs hold. */
    private final double[][] balanced;
    /** What each brake does: by brake and body. */
    private final double[][][] answers;
    /** Brakes and displacements for what is amiss. */
    private final RealMatrix correction;
    private final double[] leadIn;
    private final double[] leadOut;
    private final double[] end;
    private final double seconds;

    private Brakes(Excitation excitation, Structure structure, RealMatrix stiffness, double[][] motions, double[][] inverse) {
        this.excitation = excitation;
        this.motions = motions;
        this.bodies = structure.bodies();
        this.mass = structure.mass();
        this.seconds = (excitation.padded() - excitation.samples()) / excitation.rate();
        this.balanced = balanced(stiffness);
        leadIn = lead(true);
        leadOut = lead(false);
        end = new double[2 * excitation.omega().length];
        for (int k = 0; k < end.length / 2; k++) {
            double turn = excitation.omega()[k] * (excitation.samples() - 1) / excitation.rate();
            end[2 * k] = Math.cos(turn);
            end[2 * k + 1] = -Math.sin(turn);
        }
        int r = motions.length;
        answers = new double[2 * r][][];
        RealMatrix amiss = new Array2DRowRealMatrix(3 * r, 3 * r);
        for (int b = 0; b < 2 * r; b++) {
            double[] shape = shape(b % 2);
            double[][] q = new double[bodies][end.length];
            for (int body = 0; body < bodies; body++) {
                add(body, shape, mass[body] * motions[b / 2][body], inverse, q);
            }
            answers[b] = q;
            double[] mean = new double[r];
            mean[b / 2] = shape[0];
            amiss.setColumn(b, amiss(q, mean));
        }
        for (int i = 0; i < r; i++) {
            double[][] q = new double[bodies][end.length];
            shift(i, 1, q);
            amiss.setColumn(2 * r + i, amiss(q, new double[r]));
        }
        correction = new SingularValueDecomposition(amiss).getSolver().getInverse().scalarMultiply(-1);
    }

    /**
     * The brakes of a structure; none if springs hold all of it.
     *
     * @param further stiffness at rest that linear laws add, by link
     * @param inverse Z⁻¹ as n·n spectra. Not copied.
     */
    static java.util.Optional<Brakes> of(Excitation excitation, Structure structure, double[] further, double[][] inverse) {
        int n = structure.bodies();
        RealMatrix stiffness = new Array2DRowRealMatrix(n, n);
        for (int l = 0; l < structure.links(); l++) {
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    stiffness.addToEntry(i, j,
                            structure.incidence(i, l) * structure.incidence(j, l) * (structure.stiffness()[l] + further[l]));
                }
            }
        }
        RealMatrix scaled = new Array2DRowRealMatrix(n, n);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                scaled.setEntry(i, j, stiffness.getEntry(i, j) / Math.sqrt(structure.mass()[i] * structure.mass()[j]));
            }
        }
        EigenDecomposition modes = new EigenDecomposition(scaled);
        double largest = Arrays.stream(modes.getRealEigenvalues()).map(Math::abs).max().orElse(0);
        double[][] motions = java.util.stream.IntStream.range(0, n)
                .filter(i -> Math.abs(modes.getRealEigenvalue(i)) <= UNHELD * largest)
                .mapToObj(i -> {
                    double[] motion = modes.getEigenvector(i).toArray();
                    Arrays.setAll(motion, body -> motion[body] / Math.sqrt(structure.mass()[body]));
                    return motion;
                }).toArray(double[][]::new);
        return motions.length == 0 ? java.util.Optional.empty()
                : java.util.Optional.of(new Brakes(excitation, structure, stiffness, motions, inverse));
    }

    /**
     * Adds to q what a force on a body does from rest.
     *
     * @param force spectrum. Not modified.
     * @param q by body. Modified.
     */
    void addForce(int body, double[] force, double factor, double[][] inverse, double[][] q) {
        double[] whole = force.clone();
        Spectra.add(whole, leadIn, first(force));
        Spectra.add(whole, leadOut, last(force));
        double[][] own = new double[bodies][end.length];
        add(body, whole, factor, inverse, own);
        double[] mean = new double[motions.length];
        Arrays.setAll(mean, i -> motions[i][body] * factor * whole[0]);
        double[] amount = correction.operate(amiss(own, mean));
        for (int b = 0; b < answers.length; b++) {
            for (int i = 0; i < bodies; i++) {
                Spectra.add(own[i], answers[b][i], amount[b]);
            }
        }
        for (int i = 0; i < motions.length; i++) {
            shift(i, amount[answers.length + i], own);
        }
        for (int i = 0; i < bodies; i++) {
            Spectra.add(q[i], own[i], 1);
        }
    }

    /** Part of a body's momentum that goes into another along the motions that no spring holds. */
    double carried(int to, int body) {
        double sum = 0;
        for (double[] motion : motions) {
            sum += mass[to] * motion[to] * motion[body];
        }
        return Math.abs(sum - (to == body ? 1 : 0)) < 1e-12 ? to == body ? 1 : 0 : sum;
    }

    /**
     * Adds to q the motion from a momentum of a body at the first sample, along what no spring holds.
     *
     * @param momentum [N s]
     */
    void addLaunch(int body, double momentum, double[][] q) {
        int r = motions.length;
        double[] wanted = new double[3 * r];
        for (int m = 0; m < r; m++) {
            wanted[2 * r + m] = -motions[m][body] * momentum / seconds;
        }
        double[] amount = correction.operate(wanted);
        for (int b = 0; b < answers.length; b++) {
            for (int i = 0; i < bodies; i++) {
                Spectra.add(q[i], answers[b][i], amount[b]);
            }
        }
        for (int i = 0; i < r; i++) {
            shift(i, amount[answers.length + i], q);
        }
    }

    /** What a force does that repeats, what no spring holds left out of its mean. */
    private void add(int body, double[] force, double factor, double[][] inverse, double[][] q) {
        for (int i = 0; i < bodies; i++) {
            double before = q[i][0];
            Spectra.addProduct(inverse[i * bodies + body], force, factor, q[i]);
            q[i][0] = before + factor * balanced[i][body] * force[0];
            q[i][1] = 0;
        }
    }

    /** Adds a constant displacement along a motion. */
    private void shift(int motion, double amount, double[][] q) {
        for (int i = 0; i < bodies; i++) {
            q[i][0] += amount * motions[motion][i] * excitation.padded();
        }
    }

    /** Mean force, displacement and velocity at the first sample along each motion, all as accelerations. */
    private double[] amiss(double[][] q, double[] mean) {
        int r = motions.length;
        double[] out = new double[3 * r];
        for (int i = 0; i < bodies; i++) {
            double at = first(q[i]);
            double speed = first(Spectra.timesJOmega(excitation.omega(), q[i]));
            for (int m = 0; m < r; m++) {
                out[r + m] += motions[m][i] * mass[i] * at / (seconds * seconds);
                out[2 * r + m] += motions[m][i] * mass[i] * speed / seconds;
            }
        }
        for (int m = 0; m < r; m++) {
            out[m] = mean[m] / excitation.padded();
        }
        return out;
    }

    /** The first sample of a spectrum's series. */
    private double first(double[] x) {
        double sum = x[0];
        for (int k = 2; k < x.length; k += 2) {
            sum += 2 * x[k];
        }
        return sum / excitation.padded();
    }

    /** The record's last sample. */
    private double last(double[] x) {
        double sum = x[0];
        for (int k = 2; k < x.length; k += 2) {
            sum += 2 * (x[k] * end[k] + x[k + 1] * end[k + 1]);
        }
        return sum / excitation.padded();
    }

    /** Answer to a mean force: K q + M φ λ = f with φᵀ M q = 0. */
    private double[][] balanced(RealMatrix stiffness) {
        int r = motions.length;
        RealMatrix all = new Array2DRowRealMatrix(bodies + r, bodies + r);
        all.setSubMatrix(stiffness.getData(), 0, 0);
        double size = Math.max(stiffness.getNorm(), 1);
        for (int i = 0; i < bodies; i++) {
            for (int m = 0; m < r; m++) {
                all.setEntry(i, bodies + m, size * mass[i] * motions[m][i]);
                all.setEntry(bodies + m, i, size * mass[i] * motions[m][i]);
            }
        }
        DecompositionSolver solver = new LUDecomposition(all, 0).getSolver();
        return solver.getInverse().getSubMatrix(0, bodies - 1, 0, bodies - 1).getData();
    }

    /** A smooth push in the silence, one way, or one way and the other. */
    private double[] shape(int which) {
        return silence(u -> Math.pow(Math.sin(Math.PI * u), SMOOTH) * (which == 0 ? 1 : 4 * (u - 0.5)));
    }

    /** From 0 to 1 at the end of the silence, or from 1 to 0 at its beginning, each in a quarter of it. */
    private double[] lead(boolean in) {
        return silence(u -> {
            double x = 1 - 4 * (in ? 1 - u : u);
            return x <= 0 ? 0 : x * x * x * x * (35 + x * (-84 + x * (70 - 20 * x)));
        });
    }

    private double[] silence(java.util.function.DoubleUnaryOperator of) {
        int from = excitation.samples();
        double[] series = new double[excitation.padded()];
        for (int n = from; n < series.length; n++) {
            series[n] = of.applyAsDouble((n - from + 1.0) / (series.length - from + 1));
        }
        return excitation.spectrum(series);
    }
}
