package wbv.diagnosis.algebra;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import wbv.signal.ScalarProduct;

/**
 * Long vectors to each of which a part of some others has been added (corrections of rank one, Broyden 1965). The sums are not made: what
 * is asked of them is asked of both, since a correction serves for a step or two only, and as many new vectors cost more.
 */
public final class CorrectedColumns {

    private final Columns columns;
    private final List<Correction> corrections;

    /** @param weight how much of the vector goes to each */
    private record Correction(double[] vector, double[] weight) {}

    /** Vectors as they are. */
    public CorrectedColumns(Columns columns) {
        this(columns, List.of());
    }

    private CorrectedColumns(Columns columns, List<Correction> corrections) {
        this.columns = columns;
        this.corrections = corrections;
    }

    /**
     * The same with parts of another vector added.
     *
     * @param vector as long as each, in their unit. Not copied, not modified.
     * @param weight [1], one a vector. Not copied, not modified.
     */
    public CorrectedColumns plus(double[] vector, double[] weight) {
        List<Correction> all = new ArrayList<>(corrections);
        all.add(new Correction(vector, weight));
        return new CorrectedColumns(columns, all);
    }

    /** Whether nothing was added. */
    public boolean isPlain() {
        return corrections.isEmpty();
    }

    /**
     * Products with a vector: by vector, in their units multiplied.
     *
     * @param vector as long as each, in any unit. Not modified.
     */
    public double[] products(double[] vector) {
        double[] out = columns.products(vector);
        for (Correction correction : corrections) {
            double along = ScalarProduct.of(correction.vector(), vector);
            Arrays.setAll(out, i -> out[i] + correction.weight()[i] * along);
        }
        return out;
    }

    /**
     * Subtracts multiples of them.
     *
     * @param factors [1], one a vector. Not modified.
     * @param target as long as each, in the vectors' unit. Modified.
     */
    public void subtract(double[] factors, double[] target) {
        columns.subtract(factors, target);
        for (Correction correction : corrections) {
            double factor = ScalarProduct.of(correction.weight(), factors);
            Arrays.setAll(target, k -> target[k] - factor * correction.vector()[k]);
        }
    }

    /** The sums, by vector, in their unit. New arrays where something was added. */
    public double[][] sums() {
        double[][] out = new double[columns.count()][];
        for (int i = 0; i < out.length; i++) {
            double[] sum = isPlain() ? columns.get(i) : columns.get(i).clone();
            for (Correction correction : corrections) {
                double weight = correction.weight()[i];
                Arrays.setAll(sum, k -> sum[k] + weight * correction.vector()[k]);
            }
            out[i] = sum;
        }
        return out;
    }
}
