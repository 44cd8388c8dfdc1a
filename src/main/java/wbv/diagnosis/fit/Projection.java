package wbv.diagnosis.fit;

import java.util.Arrays;
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
    private final Columns columns;
    private final SymmetricFactor factor;

    Projection(Fitter.State state) {
        this(state.frame().nuisances(), free(state));
    }

    /** Where none stands at a bound, whatever the state: all that its candidate asks. */
    public static Projection ofAll(Fitter.State state) {
        Nuisances all = state.frame().nuisances();
        boolean[] off = all.off(state.candidate());
        return new Projection(all, IntStream.range(0, off.length).filter(i -> !off[i]).toArray());
    }

    private Projection(Nuisances nuisances, int[] free) {
        this.free = free;
        columns = nuisances.columns().only(free);
        factor = nuisances.squares().factor(free);
    }

    private static int[] free(Fitter.State state) {
        Nuisances all = state.frame().nuisances();
        return all.squares().free(state.errors(), all.off(state.candidate()));
    }

    /** Whether the same errors are free at another state of the same frame. */
    boolean suits(Fitter.State other) {
        return Arrays.equals(free, free(other));
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
