package wbv.diagnosis;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.function.ToDoubleFunction;

/** Sums of probabilities that are known by their logarithms. */
final class LogSum {

    /** What lies so far below the greatest adds less than a millionth of it. */
    private static final double NOTHING = 14;

    private LogSum() { }

    /** log Σ exp x; negative infinity for none. */
    static double of(double... x) {
        double most = Arrays.stream(x).max().orElse(Double.NEGATIVE_INFINITY);
        return most == Double.NEGATIVE_INFINITY ? most : most + Math.log(Arrays.stream(x).map(v -> Math.exp(v - most)).sum());
    }

    /** A sum over a grid. @param best node with the greatest term @param value log of the sum */
    record OverGrid(List<Integer> best, double value) { }

    /**
     * log Σ exp over a grid of two indices, visited from a node uphill and then around as long as nodes add anything: for terms with one hill.
     *
     * @param sizes number of nodes by index
     */
    static OverGrid overGrid(int[] sizes, List<Integer> start, ToDoubleFunction<List<Integer>> term) {
        Map<List<Integer>, Double> known = new HashMap<>();
        PriorityQueue<List<Integer>> open = new PriorityQueue<>(Comparator.comparingDouble((List<Integer> node) -> known.get(node)).reversed());
        known.put(start, term.applyAsDouble(start));
        open.add(start);
        List<Integer> best = start;
        while (!open.isEmpty() && known.get(open.peek()) > known.get(best) - NOTHING) {
            List<Integer> at = open.poll();
            for (int[] step : new int[][] {{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                List<Integer> next = List.of(at.get(0) + step[0], at.get(1) + step[1]);
                boolean inside = next.get(0) >= 0 && next.get(0) < sizes[0] && next.get(1) >= 0 && next.get(1) < sizes[1];
                if (inside && !known.containsKey(next)) {
                    known.put(next, term.applyAsDouble(next));
                    open.add(next);
                    best = known.get(next) > known.get(best) ? next : best;
                }
            }
        }
        return new OverGrid(best, of(known.values().stream().mapToDouble(Double::doubleValue).toArray()));
    }
}
