package wbv.diagnosis.fit;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.diagnosis.algebra.Columns;
import wbv.diagnosis.algebra.SymmetricFactor;

/**
 * What the sensors' errors would take of a change of the residual: those that do not stand at a bound follow every change
 * (variable projection, Golub and Pereyra 1973). A change enters by its products with the errors' columns, since each is needed
 * often. Threads may share it.
 */
public final class Projection {

    private final int[] free;
    /** Those that are not asked. */
    private final boolean[] off;
    private final Nuisances nuisances;
    private final Columns columns;
    private final SymmetricFactor factor;

    /** Where those stand at a bound that do at a state. */
    public Projection(Fitter.State state) {
        this(state.frame().nuisances(), off(state), free(state));
    }

    /** Where none stands at a bound, whatever the state: all that its candidate asks. */
    public static Projection ofAll(Fitter.State state) {
        boolean[] off = off(state);
        return new Projection(state.frame().nuisances(), off, IntStream.range(0, off.length).filter(i -> !off[i]).toArray());
    }

    /** @param off those that are not asked */
    private Projection(Nuisances nuisances, boolean[] off, int[] free) {
        this.free = free;
        this.off = off;
        this.nuisances = nuisances;
        columns = nuisances.columns().only(free);
        factor = nuisances.squares().factor(free);
    }

    private static boolean[] off(Fitter.State state) {
        return state.frame().nuisances().off(state.candidate());
    }

    private static int[] free(Fitter.State state) {
        return state.frame().nuisances().squares().free(state.errors(), off(state));
    }

    /** Whether the same errors are free at another state of the same frame. */
    boolean suits(Fitter.State other) {
        return Arrays.equals(free, free(other));
    }

    private IntStream bound() {
        return IntStream.range(0, off.length).filter(i -> !off[i] && Arrays.binarySearch(free, i) < 0);
    }

    /** What one standard deviation of each error at a bound adds to the whitened residual, as long. Not copies, not to be modified. */
    public List<double[]> atBound() {
        return bound().mapToObj(nuisances.columns()::get).toList();
    }

    /** How large each error at a bound may be [1], in standard deviations, one an error there. A new array. */
    public double[] bounds() {
        return bound().mapToDouble(i -> nuisances.error(i).most()).toArray();
    }

    /**
     * Dᵀ v [1], by error that is free.
     *
     * @param vector whitened, as long as the residual. Not modified.
     */
    public double[] products(double[] vector) {
        return columns.products(vector);
    }

    /** Of products with all errors those with errors that are free. */
    double[] ofFree(double[] products) {
        return Arrays.stream(free).mapToDouble(i -> products[i]).toArray();
    }

    /** The same of several whitened vectors, by vector and by error that is free [1]. */
    public double[][] products(Columns vectors) {
        return columns.products(vectors);
    }

    /**
     * (DᵀD + 1)⁻¹ Dᵀ v [1], by error that is free: how they follow v.
     *
     * @param products of v [1], as long. Not modified.
     */
    public double[] errors(double[] products) {
        return factor.solve(products);
    }

    /**
     * What a whitened change of the residual leaves when the errors have followed it, as long. A new array.
     *
     * @param vector whitened, as long as the residual. Not modified.
     */
    public double[] without(double[] vector) {
        double[] out = vector.clone();
        columns.subtract(errors(products(vector)), out);
        return out;
    }
}
