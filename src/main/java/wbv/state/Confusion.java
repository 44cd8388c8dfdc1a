package wbv.state;

import java.util.EnumMap;
import java.util.Map;

/** How often a state was said where another was true. */
public final class Confusion {

    private final Map<MotionState, Map<MotionState, Integer>> counts = new EnumMap<>(MotionState.class);
    private int all;
    private int right;

    /** Counts one sample. */
    public void add(MotionState truth, MotionState said) {
        counts.computeIfAbsent(truth, state -> new EnumMap<>(MotionState.class)).merge(said, 1, Integer::sum);
        all++;
        right += truth == said ? 1 : 0;
    }

    /** Samples. */
    public int all() {
        return all;
    }

    /** Samples of which one state is true and another, or the same, was said. */
    public int count(MotionState truth, MotionState said) {
        return counts.getOrDefault(truth, Map.of()).getOrDefault(said, 0);
    }

    /** Samples of which a state is true. */
    public int of(MotionState truth) {
        return counts.getOrDefault(truth, Map.of()).values().stream().mapToInt(Integer::intValue).sum();
    }

    /** Samples of which a state was said. */
    public int said(MotionState state) {
        return counts.values().stream().mapToInt(row -> row.getOrDefault(state, 0)).sum();
    }

    /** Share of samples that were said right. */
    public double accuracy() {
        return right / (double) all;
    }

    /** 2 × right / (true + said), 0 to 1; NaN where a state is neither. */
    public double f1(MotionState state) {
        return 2.0 * count(state, state) / (of(state) + said(state));
    }

    /** Mean F1, 0 to 1, of the states that are true anywhere. */
    public double macroF1() {
        return counts.keySet().stream().mapToDouble(this::f1).average().orElse(Double.NaN);
    }
}
