package wbv.diagnosis.algebra;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import wbv.signal.ScalarProduct;

/**
 * Least |r - D n|² + |n|² over numbers n within bounds, by the products of D alone. Those that would leave their bounds stay there, and are
 * let go again where they would come back (an active set: Stark and Parker 1995); exact, since columns of D may be as good as collinear.
 * Threads may share it.
 */
public final class BoundedLeastSquares {

    private static final int ROUNDS = 25;
    /** How near to its bound a number stands at it. */
    private static final double AT = 1e-9;

    /** DᵀD. */
    private final double[][] gram;
    /** The size that each may have. */
    private final double[] most;
    /** Where looks begin: at their bounds those that stood there, 0 for all others. */
    private final double[] begun;
    /** Factors by the numbers that are free, since the same few are asked again and again. */
    private final Map<BitSet, SymmetricFactor> factors = new ConcurrentHashMap<>();

    /**
     * Of numbers that nobody looked for yet.
     *
     * @param gram DᵀD [1], n by n
     * @param most size [1] that each number may have, n long; infinite where it has no bound. Neither is modified, nor copied.
     */
    public BoundedLeastSquares(double[][] gram, double[] most) {
        this(gram, most, new double[most.length]);
    }

    private BoundedLeastSquares(double[][] gram, double[] most, double[] begun) {
        this.gram = gram;
        this.most = most;
        this.begun = begun;
    }

    /**
     * The same, looked for from where numbers were.
     *
     * @param sizes of all of them [1], n long. Not modified.
     */
    public BoundedLeastSquares from(double[] sizes) {
        double[] bounds = new double[sizes.length];
        Arrays.setAll(bounds, i -> isHeld(i, sizes[i]) ? Math.copySign(most[i], sizes[i]) : 0);
        return new BoundedLeastSquares(gram, most, bounds);
    }

    /**
     * The same where the columns of D are greater.
     *
     * @param by factor of each, n long. Not modified.
     */
    public BoundedLeastSquares scaled(double[] by) {
        double[][] products = new double[by.length][by.length];
        for (int i = 0; i < by.length; i++) {
            for (int j = 0; j < by.length; j++) {
                products[i][j] = by[i] * by[j] * gram[i][j];
            }
        }
        return new BoundedLeastSquares(products, most, begun);
    }

    /**
     * The same where a part of everything is not seen.
     *
     * @param unseen products of that part of the columns [1], n by n. Not modified.
     */
    public BoundedLeastSquares less(double[][] unseen) {
        return new BoundedLeastSquares(difference(gram, unseen), most, begun);
    }

    /**
     * Products less those of a part, by row, in their unit. A new array.
     *
     * @param all by row, of any unit
     * @param some as many, in the same unit. Neither is modified.
     */
    public static double[][] difference(double[][] all, double[][] some) {
        double[][] out = new double[all.length][];
        for (int i = 0; i < out.length; i++) {
            out[i] = all[i].clone();
            for (int j = 0; j < out[i].length; j++) {
                out[i][j] -= some[i][j];
            }
        }
        return out;
    }

    /**
     * What the numbers make of a residual.
     *
     * @param errors what was found [1], n long. Not a copy
     * @param square what is left of the residual, as a sum of squares [1]
     */
    public record Explained(double[] errors, double square) {}

    /**
     * The numbers that explain a residual best.
     *
     * @param products Dᵀr [1], n long
     * @param square |r|² [1]
     * @param off numbers that stay 0, n long. None is modified.
     */
    public Explained explain(double[] products, double square, boolean[] off) {
        double[] n = new double[most.length];
        boolean[] held = off.clone();
        for (int i = 0; i < n.length; i++) {
            n[i] = off[i] ? 0 : begun[i];
            held[i] |= begun[i] != 0;
        }
        for (int round = 0; round < ROUNDS; round++) {
            solve(n, products, held);
            if (!hold(n, held) && !letGo(n, products, held, off)) {
                break;
            }
        }
        double[] left = gradient(n, products);
        // |r - D n|² = |r|² - n·(Dᵀr + Dᵀ(r - D n))
        return new Explained(n, Math.max(0, square - ScalarProduct.of(n, products) - ScalarProduct.of(n, left)));
    }

    /**
     * Solves for the numbers that are not held.
     *
     * @param n Modified.
     */
    private void solve(double[] n, double[] products, boolean[] held) {
        int[] free = IntStream.range(0, n.length).filter(i -> !held[i]).toArray();
        double[] b = new double[free.length];
        for (int i = 0; i < free.length; i++) {
            b[i] = products[free[i]];
            for (int j = 0; j < n.length; j++) {
                b[i] -= held[j] ? gram[free[i]][j] * n[j] : 0;
            }
        }
        double[] solved = factor(free).solve(b);
        for (int i = 0; i < free.length; i++) {
            n[free[i]] = solved[i];
        }
    }

    /**
     * Holds numbers at the bounds that they would leave, if any would.
     *
     * @param n Modified.
     * @param held Modified.
     */
    private boolean hold(double[] n, boolean[] held) {
        boolean any = false;
        for (int i = 0; i < n.length; i++) {
            if (!held[i] && Math.abs(n[i]) > most[i]) {
                n[i] = Math.copySign(most[i], n[i]);
                held[i] = true;
                any = true;
            }
        }
        return any;
    }

    /**
     * Frees numbers whose bound holds them against their will, if there are any.
     *
     * @param held Modified.
     */
    private boolean letGo(double[] n, double[] products, boolean[] held, boolean[] off) {
        double[] g = gradient(n, products);
        boolean any = false;
        for (int i = 0; i < n.length; i++) {
            if (held[i] && !off[i] && (g[i] - n[i]) * n[i] < 0) {
                held[i] = false;
                any = true;
            }
        }
        return any;
    }

    /**
     * Dᵀ(r - D n).
     *
     * @param products Dᵀr
     */
    private double[] gradient(double[] n, double[] products) {
        return IntStream.range(0, n.length).mapToDouble(i -> products[i] - ScalarProduct.of(gram[i], n)).toArray();
    }

    /** Whether number i of a size [1] stands at its bound and so takes no part in small changes; one without a bound never does. */
    public boolean isHeld(int i, double size) {
        return Math.abs(size) >= most[i] - AT;
    }

    /**
     * Those that follow small changes.
     *
     * @param sizes of all [1], n long
     * @param off that stay 0, n long. Neither is modified.
     */
    public int[] free(double[] sizes, boolean[] off) {
        return IntStream.range(0, sizes.length).filter(i -> !off[i] && !isHeld(i, sizes[i])).toArray();
    }

    /**
     * Of DᵀD + 1 for some of the numbers.
     *
     * @param which indices. Not modified.
     */
    public SymmetricFactor factor(int[] which) {
        BitSet asked = new BitSet();
        IntStream.of(which).forEach(asked::set);
        return factors.computeIfAbsent(asked, some -> factored(which));
    }

    private SymmetricFactor factored(int[] which) {
        DMatrixRMaj a = new DMatrixRMaj(which.length, which.length);
        for (int i = 0; i < which.length; i++) {
            for (int j = 0; j < which.length; j++) {
                a.set(i, j, gram[which[i]][which[j]] + (i == j ? 1 : 0));
            }
        }
        return SymmetricFactor.of(a).orElseThrow();
    }
}
