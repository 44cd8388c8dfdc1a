package wbv.diagnosis.algebra;

import java.util.Arrays;
import java.util.stream.IntStream;
import wbv.signal.ScalarProduct;

/**
 * Products of directions with each other and with a residual. The last of them are numbers of which something is known beforehand, which
 * their own squares hold, and which have bounds: they follow whatever is added.
 *
 * @param each of two directions [1], n by n, symmetric
 * @param left of each with the residual [1], n long
 * @param most how large the last of them may be, either way [1], one a number that follows. None is copied, none modified
 */
public record DirectionProducts(double[][] each, double[] left, double[] most) {

    /**
     * Products of vectors within groups, and of all with those after the last group [1], by vector and vector; no numbers else.
     *
     * @param groups how many vectors there are in each, one a group. Not modified.
     */
    public static double[][] within(Columns columns, int[] groups) {
        double[][] out = new double[columns.count()][columns.count()];
        Arrays.stream(out).forEach(row -> Arrays.fill(row, Double.NaN));
        int from = 0;
        for (int size : groups) {
            for (int i = from; i < from + size; i++) {
                for (int j = from; j <= i; j++) {
                    out[i][j] = ScalarProduct.of(columns.get(i), columns.get(j));
                    out[j][i] = out[i][j];
                }
            }
            from += size;
        }
        double[][] after = columns.products(columns.only(IntStream.range(from, columns.count()).toArray()));
        for (int k = 0; k < after.length; k++) {
            for (int i = 0; i < columns.count(); i++) {
                out[from + k][i] = after[k][i];
                out[i][from + k] = after[k][i];
            }
        }
        return out;
    }

    /**
     * Some directions, and after them all numbers that follow.
     *
     * @param which their indices
     * @param joint as strong as leaves least
     */
    public record Together(int[] which, JointStrengths joint) {}

    /**
     * Some directions as strong as leaves least, the numbers following within their bounds: those that would be larger stay there.
     *
     * @param some indices of directions
     * @param none which of them take no part, as many. Neither is modified.
     */
    public Together together(int[] some, boolean[] none) {
        int[] which = Arrays.copyOf(some, some.length + most.length);
        double[] held = new double[which.length];
        for (int i = 0; i < which.length; i++) {
            which[i] = i < some.length ? some[i] : each.length - which.length + i;
            held[i] = i < some.length && none[i] ? 0 : Double.NaN;
        }
        JointStrengths joint = JointStrengths.of(each, left, which, held);
        while (isHeld(joint.strengths(), held, some.length)) {
            joint = JointStrengths.of(each, left, which, held);
        }
        return new Together(which, joint);
    }

    /**
     * Whether a number that was not held is larger than it may be, so that it is.
     *
     * @param held Modified.
     * @param from where the numbers begin
     */
    private boolean isHeld(double[] strengths, double[] held, int from) {
        boolean any = false;
        for (int i = from; i < held.length; i++) {
            double bound = most[i - from];
            if (Double.isNaN(held[i]) && Math.abs(strengths[i]) > bound) {
                held[i] = Math.copySign(bound, strengths[i]);
                any = true;
            }
        }
        return any;
    }

    /** Those of the directions where the numbers are whatever leaves least: no less can be left. */
    public DirectionProducts free() {
        int own = each.length - most.length;
        double[][] numbers = IntStream.range(own, each.length).mapToObj(i -> Arrays.copyOfRange(each[i], own, each.length))
                .toArray(double[][]::new);
        double[][] out = new double[own][];
        double[] rest = Arrays.copyOf(left, own);
        for (int i = 0; i < own; i++) {
            out[i] = Arrays.copyOf(each[i], own);
            double[] follow = DampedEquations.solve(numbers, Arrays.copyOfRange(each[i], own, each.length));
            for (int k = 0; k < follow.length; k++) {
                for (int j = 0; j < own; j++) {
                    out[i][j] -= follow[k] * each[own + k][j];
                }
                rest[i] -= follow[k] * left[own + k];
            }
        }
        return new DirectionProducts(out, rest, new double[0]);
    }

    /** Those of the directions where the numbers are what they are without any of them: no more can be left. */
    public DirectionProducts resting() {
        int own = each.length - most.length;
        Together nothing = together(new int[0], new boolean[0]);
        double[] rest = Arrays.copyOf(left, own);
        for (int i = 0; i < own; i++) {
            for (int k = 0; k < most.length; k++) {
                rest[i] += each[i][own + k] * nothing.joint().strengths()[k];
            }
        }
        return new DirectionProducts(each, rest, new double[0]);
    }
}
