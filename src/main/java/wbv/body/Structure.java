package wbv.body;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import wbv.body.number.Check;

/**
 * A net of n bodies and L linear links in numbers. Body -1 is the base. Parameters are counted as stiffness of links 0..L-1,
 * damping of links 0..L-1, mass of bodies 0..n-1. A body here is one coordinate: one that moves along two axes and turns is three
 * of them, and their {@link Kinematics} say how they go together.
 * Thesis: Eq. 2-38.
 *
 * @param from       body at the lower end of each link, -1 for the base. Not copied
 * @param to         body at the upper end of each link. Not copied
 * @param stiffness  [N/m] by link, [N m/rad] about a joint. Not copied
 * @param damping    [N s/m] by link. Not copied
 * @param mass       [kg] by body, &gt; 0; a moment of inertia [kg m²] for what turns. Not copied
 * @param held       whether all bodies are held at rest, so that the base's motion is the motion of the links and nothing swings
 * @param kinematics how the coordinates go together
 */
public record Structure(int[] from, int[] to, double[] stiffness, double[] damping, double[] mass, boolean held, Kinematics kinematics) {

    /** Square of a frequency over that of the fastest, below which it is rounding. */
    private static final double LOOSE = 1e-12;
    /** Part of a motion of size 1 that a body has, below which it is rounding. */
    private static final double TAKES_PART = 1e-6;

    public Structure {
        int links = from.length;
        if (to.length != links || stiffness.length != links || damping.length != links) {
            throw new IllegalArgumentException("a structure's link arrays must have one length: " + links);
        }
        for (double m : mass) {
            Check.positive("mass", "kg", m);
        }
        for (int l = 0; l < links; l++) {
            if (to[l] < 0 || to[l] >= mass.length || from[l] < -1 || from[l] >= mass.length || from[l] == to[l]) {
                throw new IllegalArgumentException("link " + l + " joins bodies that are not there: " + from[l] + " to " + to[l]);
            }
        }
        if (kinematics.stretch().size() != links || kinematics.carried().length != mass.length) {
            throw new IllegalArgumentException("kinematics of " + kinematics.stretch().size() + " links and " + kinematics.carried().length
                    + " bodies for a net of " + links + " and " + mass.length);
        }
    }

    /**
     * A net whose bodies move along the base's one axis, each link between its two ends. Arrays are not copied and not modified.
     *
     * @param stiffness [N/m] by link
     * @param damping [N s/m] by link
     * @param mass [kg] by body, &gt; 0
     */
    public Structure(int[] from, int[] to, double[] stiffness, double[] damping, double[] mass, boolean held) {
        this(from, to, stiffness, damping, mass, held, Kinematics.along(from, to, mass.length));
    }

    /** The same, its bodies free to move. Arrays are not copied and not modified. */
    public Structure(int[] from, int[] to, double[] stiffness, double[] damping, double[] mass) {
        this(from, to, stiffness, damping, mass, false);
    }

    /** Number of coordinates n; the base is none of them. */
    public int bodies() {
        return mass.length;
    }

    /** Number of links L. */
    public int links() {
        return from.length;
    }

    /** Number of parameters: 2 L + n. */
    public int parameters() {
        return 2 * links() + bodies();
    }

    /** Axes along which the base moves, at least one. */
    public int axes() {
        return kinematics.axes();
    }

    /** What stretches a link. */
    public Row stretch(int link) {
        return kinematics.stretch().get(link);
    }

    /** Incidence of a body in a link: +1 at its upper end, -1 at its lower, a lever arm [m] where it turns, else 0. */
    public double incidence(int body, int link) {
        return stretch(link).factor(body);
    }

    /** Whether a link joins a body to the base and acts on nothing else: a force in it and one on the body are the same. */
    public boolean standsOnBase(int link, int body) {
        return from[link] < 0 && to[link] == body && stretch(link).at().length == 1;
    }

    /** The bodies of which a mass is a parameter: itself and those that share it; none where it has another's. */
    public int[] sharing(int body) {
        return IntStream.range(0, bodies()).filter(i -> kinematics.massOf()[i] == body).toArray();
    }

    /** Bodies that go on wherever they are sent, since no spring holds them. */
    public boolean[] unheld() {
        boolean[] out = new boolean[bodies()];
        EigenDecomposition modes = modes();
        double largest = Arrays.stream(modes.getRealEigenvalues()).max().orElse(0);
        for (int mode = 0; mode < out.length; mode++) {
            for (int b = 0; b < out.length && modes.getRealEigenvalue(mode) <= LOOSE * largest; b++) {
                out[b] |= Math.abs(modes.getEigenvector(mode).getEntry(b)) > TAKES_PART;
            }
        }
        return out;
    }

    /** Of M^(-1/2) K M^(-1/2), springs alone. */
    private EigenDecomposition modes() {
        int n = bodies();
        double[][] k = new double[n][n];
        for (int l = 0; l < links(); l++) {
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    k[i][j] += incidence(i, l) * incidence(j, l) * stiffness[l] / Math.sqrt(mass[i] * mass[j]);
                }
            }
        }
        return new EigenDecomposition(new Array2DRowRealMatrix(k));
    }

    /** The lowest natural frequency without damping [Hz], what no spring holds left out; empty where nothing swings. */
    public OptionalDouble slowestMode() {
        double[] squares = held ? new double[0] : modes().getRealEigenvalues();
        double largest = Arrays.stream(squares).max().orElse(0);
        return Arrays.stream(squares).filter(square -> square > LOOSE * largest).map(square -> Math.sqrt(square) / (2 * Math.PI)).min();
    }

    /**
     * How fast whatever it was doing dies down at least [1/s]: the slowest real part of its poles. 0 where something goes on as it was
     * sent, infinite where nothing moves of its own accord.
     */
    public double slowestDecay() {
        if (held) {
            return Double.POSITIVE_INFINITY;
        }
        DMatrixRMaj state = stateMatrix(balance());
        EigenDecomposition_F64<DMatrixRMaj> poles = DecompositionFactory_DDRM.eig(state.numRows, false);
        if (!poles.decompose(state)) {
            return 0;
        }
        return Math.max(0, IntStream.range(0, state.numRows).mapToDouble(i -> -poles.getEigenvalue(i).getReal()).min().orElse(0));
    }

    /**
     * The same net with other values.
     *
     * @param values 2 L + n long, in the order and units of {@link #values}. Not modified.
     */
    public Structure with(double[] values) {
        int links = links();
        double[] k = Arrays.copyOfRange(values, 0, links);
        double[] c = Arrays.copyOfRange(values, links, 2 * links);
        double[] m = new double[bodies()];
        Arrays.setAll(m, b -> values[2 * links + kinematics.massOf()[b]]);
        return new Structure(from, to, k, c, m, held, kinematics);
    }

    /** The parameters, 2 L + n long: stiffness [N/m] by link, damping [N s/m] by link, mass [kg] by body. A new array. */
    public double[] values() {
        double[] out = new double[parameters()];
        System.arraycopy(stiffness, 0, out, 0, links());
        System.arraycopy(damping, 0, out, links(), links());
        System.arraycopy(mass, 0, out, 2 * links(), bodies());
        return out;
    }

    /** A speed that balances displacements and velocities in the state [Ω q, q'] [rad/s]. */
    public double balance() {
        double largest = 1;
        for (int l = 0; l < links(); l++) {
            largest = Math.max(largest, stiffness[l] / mass[to[l]]);
        }
        return Math.sqrt(largest);
    }

    /**
     * State matrix of [Ω q, q'], 2n by 2n. Thesis: Eq. 2-39, 2-41.
     *
     * @param omega Ω [rad/s]
     */
    public DMatrixRMaj stateMatrix(double omega) {
        int n = bodies();
        DMatrixRMaj a = new DMatrixRMaj(2 * n, 2 * n);
        for (int i = 0; i < n; i++) {
            a.set(i, n + i, omega);
        }
        for (int l = 0; l < links(); l++) {
            addLink(a, l, stiffness[l] / omega, damping[l]);
        }
        return a;
    }

    /**
     * Input matrix, 2n by A + L + n: acceleration of the base along each axis, force in each link (pulling its ends together), force on
     * each body. Thesis: Eq. 2-40.
     */
    public DMatrixRMaj inputMatrix() {
        int n = bodies();
        int axes = axes();
        DMatrixRMaj b = new DMatrixRMaj(2 * n, axes + links() + n);
        for (int i = 0; i < n; i++) {
            for (int a = 0; a < axes; a++) {
                b.set(n + i, a, -kinematics.carried()[i][a]);
            }
            for (int l = 0; l < links(); l++) {
                b.set(n + i, axes + l, -incidence(i, l) / mass[i]);
            }
            b.set(n + i, axes + links() + i, 1 / mass[i]);
        }
        return b;
    }

    /** Column of {@link #inputMatrix} for a force in a link. */
    public int linkInput(int link) {
        return axes() + link;
    }

    /** Column of {@link #inputMatrix} for a force on a body. */
    public int bodyInput(int body) {
        return axes() + links() + body;
    }

    /**
     * Derivative of {@link #stateMatrix} to a parameter at constant Ω.
     *
     * @param omega Ω [rad/s]
     */
    public DMatrixRMaj stateSlope(int parameter, double omega) {
        int n = bodies();
        DMatrixRMaj d = new DMatrixRMaj(2 * n, 2 * n);
        if (parameter < links()) {
            addLink(d, parameter, 1 / omega, 0);
        } else if (parameter < 2 * links()) {
            addLink(d, parameter - links(), 0, 1);
        } else {
            massRows(d, stateMatrix(omega), parameter - 2 * links());
        }
        return d;
    }

    /** Derivative of {@link #inputMatrix} to a parameter: only masses enter, and not in the base's columns. */
    public DMatrixRMaj inputSlope(int parameter) {
        DMatrixRMaj d = new DMatrixRMaj(2 * bodies(), axes() + links() + bodies());
        if (parameter >= 2 * links()) {
            massRows(d, inputMatrix(), parameter - 2 * links());
            for (int i = 0; i < bodies(); i++) {
                for (int a = 0; a < axes(); a++) {
                    d.set(bodies() + i, a, 0);
                }
            }
        }
        return d;
    }

    /** Adds -M⁻¹ E_l [k/Ω, c] E_lᵀ to the velocity rows. */
    private void addLink(DMatrixRMaj a, int l, double kOverOmega, double c) {
        int n = bodies();
        Row row = stretch(l);
        for (int i = 0; i < row.at().length; i++) {
            for (int j = 0; j < row.at().length; j++) {
                double part = row.by()[i] * row.by()[j];
                a.add(n + row.at()[i], row.at()[j], -part * kOverOmega / mass[row.at()[i]]);
                a.add(n + row.at()[i], n + row.at()[j], -part * c / mass[row.at()[i]]);
            }
        }
    }

    /** Every entry of a body's velocity row goes with 1/m. */
    private void massRows(DMatrixRMaj target, DMatrixRMaj source, int parameter) {
        for (int body : sharing(parameter)) {
            int row = bodies() + body;
            for (int j = 0; j < source.numCols; j++) {
                target.set(row, j, -source.get(row, j) / mass[body]);
            }
        }
    }
}
