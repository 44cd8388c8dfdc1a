package wbv.diagnosis.fit;

import wbv.diagnosis.algebra.Columns;

/**
 * Products of the whitened derivatives at a state with each other, and with what the sensors' errors do: what stands on it asks for them
 * again and again.
 */
final class SlopeProducts {

    private final double[][] slopes;
    private final double[][] gram;
    private final double[][] errors;

    /** @param state with its derivatives */
    SlopeProducts(Fitter.State state) {
        slopes = state.slopes();
        Columns columns = new Columns(slopes);
        gram = columns.gram();
        errors = state.frame().nuisances().columns().products(columns);
    }

    /** Whether they are those of a state. */
    boolean isOf(Fitter.State state) {
        return slopes == state.slopes();
    }

    int count() {
        return slopes.length;
    }

    /** A derivative, by line. Not a copy. */
    double[] slope(int i) {
        return slopes[i];
    }

    /** Products of each derivative with each [1]. Not copies. */
    double[][] gram() {
        return gram;
    }

    /** Products of each derivative with each error, free or not [1]. Not copies. */
    double[][] withErrors() {
        return errors;
    }
}
