package wbv.rig;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * A person of the rig on something that he moves in turn, such as a suspension: his seat cushion and body along z alone, softening
 * with what shakes them. Who carries him integrates: this says what his links do.
 *
 * <p>It is the person of a {@link Skeleton} whose axes do not mix. Positions and speeds are relative to the frame that carries
 * him; the links' matrices are read off unit displacements and rates.
 */
public final class CarriedPerson {

    private final Subject subject;
    private final int n;
    private final double[] mass;
    private final double[] stiffness;
    private final double[] damping;
    private final double[] felt = new double[3];
    private final AmplitudeSoftening softening;

    /**
     * At rest on a cushion.
     *
     * @param h step of {@link #feel} [s]
     */
    public CarriedPerson(Subject subject, double h) {
        this.subject = subject;
        Skeleton skeleton = new Skeleton(subject, new Anatomy(subject.stature()), Effects.NONE.with(Effect.CUSHION));
        n = skeleton.bodies();
        mass = IntStream.range(0, n).mapToDouble(i -> 1 / skeleton.inverseMass(vertical(i))).toArray();
        stiffness = new double[n * n];
        damping = new double[n * n];
        softening = new AmplitudeSoftening(true, h);
        double[] x = new double[Skeleton.FREE * n];
        double[] v = new double[Skeleton.FREE * n];
        double[] force = new double[Skeleton.FREE * n];
        for (int j = 0; j < n; j++) {
            read(skeleton, x, v, x, j, force, stiffness);
            read(skeleton, x, v, v, j, force, damping);
        }
    }

    /** A column of a matrix: less the forces under a unit displacement or rate. */
    private void read(Skeleton skeleton, double[] x, double[] v, double[] unit, int j, double[] force, double[] into) {
        unit[vertical(j)] = 1;
        skeleton.forces(x, v, 1, 1, force);
        unit[vertical(j)] = 0;
        for (int i = 0; i < n; i++) {
            into[n * i + j] = -force[vertical(i)];
        }
    }

    private static int vertical(int body) {
        return Skeleton.FREE * body + 2;
    }

    /** Who is carried. */
    public Subject subject() {
        return subject;
    }

    /** Bodies that move. */
    public int bodies() {
        return n;
    }

    /** Index of the seat pan, on the cushion and under the person. */
    public int seat() {
        return Anatomy.SEAT;
    }

    /** Index of the trunk, where the sternum's sensor is. */
    public int trunk() {
        return Anatomy.TRUNK;
    }

    /** Index of the head. */
    public int head() {
        return Anatomy.HEAD;
    }

    /** All that the frame carries: the seat pan and the part of the body that sits [kg]. */
    public double carriedMass() {
        return Arrays.stream(mass).sum();
    }

    /**
     * One step of the softening's memory.
     *
     * @param acceleration of the frame [m/s²]
     */
    public void feel(double acceleration) {
        felt[2] = acceleration;
        softening.feel(felt);
    }

    /** Factor on all stiffnesses of the present; natural frequencies go with its root, damping ratios stay. */
    public double stiffnessFactor() {
        return softening.stiffness();
    }

    /**
     * What the links do.
     *
     * @param state as long as the whole's states, holds the place of every body less that of the frame [m] from {@code x} on, their rates
     *              [m/s] from {@code v} on. Not modified.
     * @param into  absolute acceleration of every body [m/s²], as long as {@link #bodies}. Modified.
     * @return force on the frame, upwards positive, without weight [N]
     */
    public double act(double[] state, int x, int v, double[] into) {
        double k = softening.stiffness();
        double c = softening.damping();
        double onFrame = 0;
        for (int i = 0; i < n; i++) {
            double spring = 0;
            double damper = 0;
            for (int j = 0; j < n; j++) {
                spring += stiffness[n * i + j] * state[x + j];
                damper += damping[n * i + j] * state[v + j];
            }
            double pull = k * spring + c * damper;
            into[i] = -pull / mass[i];
            onFrame += pull;
        }
        return onFrame;
    }

    /**
     * Force from the frame over the frame's acceleration, and acceleration of the trunk over it, at the reference magnitude of the
     * softening.
     *
     * @param frequency [Hz], &gt; 0
     * @param response four long: real and imaginary part of the apparent mass [kg], then of the trunk's transmissibility [1]. Modified.
     */
    public void respond(double frequency, double[] response) {
        double w = 2 * Math.PI * frequency;
        DMatrixRMaj left = new DMatrixRMaj(2 * n, 2 * n);
        DMatrixRMaj right = new DMatrixRMaj(2 * n, 1);
        DMatrixRMaj moved = new DMatrixRMaj(2 * n, 1);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                double real = stiffness[n * i + j] - (i == j ? w * w * mass[i] : 0);
                double imaginary = w * damping[n * i + j];
                left.set(i, j, real);
                left.set(n + i, n + j, real);
                left.set(i, n + j, -imaginary);
                left.set(n + i, j, imaginary);
            }
            right.set(i, 0, -mass[i]); // of a frame that accelerates with 1 m/s²
        }
        if (!CommonOps_DDRM.solve(left, right, moved)) {
            throw new IllegalStateException("a person without damping has no response at " + frequency + " Hz");
        }
        Arrays.fill(response, 0);
        for (int i = 0; i < n; i++) {
            response[0] += mass[i] * (1 - w * w * moved.get(i, 0));
            response[1] -= mass[i] * w * w * moved.get(n + i, 0);
        }
        response[2] = 1 - w * w * moved.get(Anatomy.TRUNK, 0);
        response[3] = -w * w * moved.get(n + Anatomy.TRUNK, 0);
    }
}
