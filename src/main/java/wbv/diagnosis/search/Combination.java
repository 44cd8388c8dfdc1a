package wbv.diagnosis.search;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import wbv.diagnosis.algebra.DampedEquations;

/** Directions of which the best combination is asked: their products are worked out once, whatever joins them. */
public final class Combination {

    private final List<PartialledOut.Rest> rests;
    /** Of each two directions [1], symmetric. */
    private final double[][] products;

    private Combination(List<PartialledOut.Rest> rests, double[][] products) {
        this.rests = rests;
        this.products = products;
    }

    /** Of some directions. */
    public static Combination of(List<PartialledOut.Rest> rests) {
        double[][] products = new double[rests.size()][rests.size()];
        for (int i = 0; i < products.length; i++) {
            for (int j = 0; j <= i; j++) {
                products[i][j] = rests.get(i).product(rests.get(j));
                products[j][i] = products[i][j];
            }
        }
        return new Combination(List.copyOf(rests), products);
    }

    /**
     * These and those of another after them.
     *
     * @param shared how many both begin with, which are not taken twice
     */
    public Combination with(Combination other, int shared) {
        int own = count();
        List<PartialledOut.Rest> all = Stream.concat(rests.stream(), other.rests.stream().skip(shared)).toList();
        double[][] out = new double[all.size()][all.size()];
        for (int i = 0; i < out.length; i++) {
            for (int j = 0; j <= i; j++) {
                boolean theirs = j < shared || j >= own;
                out[i][j] = i < own ? products[i][j]
                        : theirs ? other.products[i - own + shared][j < shared ? j : j - own + shared]
                                : all.get(i).product(all.get(j));
                out[j][i] = out[i][j];
            }
        }
        return new Combination(all, out);
    }

    /** How many they are. */
    public int count() {
        return rests.size();
    }

    /** How many numbers those after the first so many hold. */
    public int numbersAfter(int first) {
        return rests.stream().skip(first).mapToInt(rest -> rest.direction().length).sum();
    }

    /** How strong each direction is in the best combination [1], one a direction. A new array. */
    public double[] strengths() {
        double[] solved = DampedEquations.solve(products, rests.stream().mapToDouble(PartialledOut.Rest::gradient).toArray());
        return IntStream.range(0, count()).mapToDouble(i -> -solved[i]).toArray();
    }

    /** Gain of the best combination [1]. */
    public double gain() {
        double[] strengths = strengths();
        double gain = -IntStream.range(0, count()).mapToDouble(i -> strengths[i] * rests.get(i).gradient()).sum();
        return Double.isFinite(gain) ? gain : 0;
    }
}
