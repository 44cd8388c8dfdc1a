package wbv.body;

import java.util.Arrays;
import java.util.OptionalDouble;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.ejml.data.DMatrixRMaj;

/**
 * A net of n bodies and L linear links in numbers. Body -1 is the base. Parameters are counted as stiffness of links 0..L-1,
 * damping of links 0..L-1, mass of bodies 0..n-1.
 *
 * @param from      body at the lower end of each link, -1 for the base. Not copied
 * @param to        body at the upper end of each link. Not copied
 * @param stiffness [N/m] by link. Not copied
 * @param damping   [N s/m] by link. Not copied
 * @param mass      [kg] by body, &gt; 0. Not copied
 * @param held      whether all bodies are held at rest, so that the base's motion is the motion of the links and nothing swings
 */
public record Structure(int[] from, int[] to, double[] stiffness, double[] damping, double[] mass, boolean held) {

    /** Square of a frequency over that of the fastest, below which it is rounding. */
    private static final double LOOSE = 1e-12;

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
    }

    /** A net whose bodies are free to move. */
    public Structure(int[] from, int[] to, double[] stiffness, double[] damping, double[] mass) {
        this(from, to, stiffness, damping, mass, false);
    }

    public int bodies() {
        return mass.length;
    }

    public int links() {
        return from.length;
    }

    /** Number of parameters: 2 L + n. */
    public int parameters() {
        return 2 * links() + bodies();
    }

    /** Incidence of a body in a link: +1 at its upper end, -1 at its lower, else 0. */
    public int incidence(int body, int link) {
        return (to[link] == body ? 1 : 0) - (from[link] == body ? 1 : 0);
    }

    /** Bodies that no chain of springs joins to the base, and so go on wherever they are sent. */
    public boolean[] unheld() {
        boolean[] out = new boolean[bodies()];
        java.util.Arrays.fill(out, true);
        for (int round = 0; round < bodies(); round++) {
            for (int l = 0; l < links(); l++) {
                boolean heldBelow = from[l] < 0 || !out[from[l]];
                if (stiffness[l] > 0 && (heldBelow || !out[to[l]])) {
                    out[to[l]] = false;
                    if (from[l] >= 0) {
                        out[from[l]] = false;
                    }
                }
            }
        }
        return out;
    }

    /** The lowest natural frequency without damping [Hz], what no spring holds left out; empty where nothing swings. */
    public OptionalDouble slowestMode() {
        int n = bodies();
        double[][] k = new double[n][n];
        for (int l = 0; l < links() && !held; l++) {
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    k[i][j] += incidence(i, l) * incidence(j, l) * stiffness[l] / Math.sqrt(mass[i] * mass[j]);
                }
            }
        }
        double[] squares = new EigenDecomposition(new Array2DRowRealMatrix(k)).getRealEigenvalues();
        double largest = Arrays.stream(squares).max().orElse(0);
        return Arrays.stream(squares).filter(square -> square > LOOSE * largest).map(square -> Math.sqrt(square) / (2 * Math.PI)).min();
    }

    /** The same net with other values. @param values 2 L + n parameters. Not modified. */
    public Structure with(double[] values) {
        int links = links();
        double[] k = java.util.Arrays.copyOfRange(values, 0, links);
        double[] c = java.util.Arrays.copyOfRange(values, links, 2 * links);
        double[] m = java.util.Arrays.copyOfRange(values, 2 * links, 2 * links + bodies());
        return new Structure(from, to, k, c, m, held);
    }

    /** The 2 L + n parameters, a new array. */
    public double[] values() {
        double[] out = new double[parameters()];
        System.arraycopy(stiffness, 0, out, 0, links());
        System.arraycopy(damping, 0, out, links(), links());
        System.arraycopy(mass, 0, out, 2 * links(), bodies());
        return out;
    }

    /** A speed that balances displacements and velocities in the state [Ω q, q'] [rad/s]. */
    double balance() {
        double largest = 1;
        for (int l = 0; l < links(); l++) {
            largest = Math.max(largest, stiffness[l] / mass[to[l]]);
        }
        return Math.sqrt(largest);
    }

    /** State matrix of [Ω q, q'], 2n by 2n. */
    DMatrixRMaj stateMatrix(double omega) {
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

    /** Input matrix, 2n by 1 + L + n: base acceleration, force in each link (pulling its ends together), force on each body. */
    DMatrixRMaj inputMatrix() {
        int n = bodies();
        DMatrixRMaj b = new DMatrixRMaj(2 * n, 1 + links() + n);
        for (int i = 0; i < n; i++) {
            b.set(n + i, 0, -1);
            for (int l = 0; l < links(); l++) {
                b.set(n + i, 1 + l, -incidence(i, l) / mass[i]);
            }
            b.set(n + i, 1 + links() + i, 1 / mass[i]);
        }
        return b;
    }

    /** Derivative of {@link #stateMatrix} to a parameter at constant Ω. */
    DMatrixRMaj stateSlope(int parameter, double omega) {
        int n = bodies();
        DMatrixRMaj d = new DMatrixRMaj(2 * n, 2 * n);
        if (parameter < links()) {
            addLink(d, parameter, 1 / omega, 0);
        } else if (parameter < 2 * links()) {
            addLink(d, parameter - links(), 0, 1);
        } else {
            massRow(d, stateMatrix(omega), parameter - 2 * links());
        }
        return d;
    }

    /** Derivative of {@link #inputMatrix} to a parameter: only masses enter, and not in the base's column. */
    DMatrixRMaj inputSlope(int parameter) {
        DMatrixRMaj d = new DMatrixRMaj(2 * bodies(), 1 + links() + bodies());
        if (parameter >= 2 * links()) {
            massRow(d, inputMatrix(), parameter - 2 * links());
            d.set(bodies() + parameter - 2 * links(), 0, 0);
        }
        return d;
    }

    /** Adds -M⁻¹ E_l [k/Ω, c] E_lᵀ to the velocity rows. */
    private void addLink(DMatrixRMaj a, int l, double kOverOmega, double c) {
        int n = bodies();
        for (int i = 0; i < n; i++) {
            int ei = incidence(i, l);
            for (int j = 0; ei != 0 && j < n; j++) {
                int ej = incidence(j, l);
                if (ej != 0) {
                    a.add(n + i, j, -ei * ej * kOverOmega / mass[i]);
                    a.add(n + i, n + j, -ei * ej * c / mass[i]);
                }
            }
        }
    }

    /** Every entry of a body's velocity row goes with 1/m. */
    private void massRow(DMatrixRMaj target, DMatrixRMaj source, int body) {
        int row = bodies() + body;
        for (int j = 0; j < source.numCols; j++) {
            target.set(row, j, -source.get(row, j) / mass[body]);
        }
    }
}
