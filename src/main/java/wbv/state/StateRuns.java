package wbv.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import wbv.recording.Channel;
import wbv.state.markov.Rows;
import wbv.state.mixture.Gaussian;

/**
 * A recording's states as a stream, in memory that does not grow with the samples: which state when, from what had come. Where most
 * of the last second is unlike anything that the model was trained on, no state is told.
 */
public final class StateRuns {

    /** Squared distance that 0.1 % of rows exceed of a normal density in three dimensions (χ², 3 degrees of freedom). */
    private static final double FAR = 16.266;
    /** Runs kept at most, some hours of them; later ones are counted, but not kept. */
    private static final int MOST_RUNS = 20_000;

    private static final double WINDOW = 1;

    private final StateModel model;
    private final boolean[] strange;
    private final FeatureStream stream;
    private final StateFilter filter;
    private final Gaussian[] components;
    private final double[] peaks;
    private final double[] row = new double[FeatureSpec.NAMES.size()];
    private final double[] activity = new double[FeatureSpec.OF_ACTIVITY];
    private final double[] scratch = new double[FeatureSpec.OF_ACTIVITY];
    private final double[] named = new double[MotionState.values().length];
    private final long[] samples = new long[MotionState.values().length];
    private final List<Run> runs = new ArrayList<>();
    private Optional<MotionState> current = Optional.empty();
    private int strangers;
    private long began;
    private long taken;
    private long judged;
    private long silent;
    private long compared;
    private long agreed;

    /**
     * A state that lasted; empty where none is told.
     *
     * @param from first sample
     * @param to one beyond the last
     */
    public record Run(Optional<MotionState> state, long from, long to) {}

    /** Before the first sample. */
    public StateRuns(StateModel model) {
        this.model = model;
        stream = new FeatureStream(model.features());
        filter = new StateFilter(model);
        strange = new boolean[Math.max(1, (int) Math.round(WINDOW * model.features().rate()))];
        components = model.chain().emissions().stream().flatMap(each -> each.components().stream()).distinct().toArray(Gaussian[]::new);
        peaks = Arrays.stream(components).mapToDouble(each -> each.logDensity(each.mean(), scratch)).toArray();
    }

    /**
     * Whether a model can tell anything of a recording: all of its channels, and its rate.
     *
     * @param rate [Hz]
     */
    public static boolean canTell(StateModel model, List<Channel> channels, double rate) {
        return channels.containsAll(model.features().channels()) && Math.abs(rate / model.features().rate() - 1) <= 0.01;
    }

    /**
     * Takes a sample.
     *
     * @param sample one a channel of {@link FeatureSpec#channels}, in its unit; NaN is missing. Not modified.
     */
    public void accept(double[] sample) {
        stream.step(sample, row);
        long at = taken++ - model.features().delay();
        if (at < 0) {
            return;
        }
        filter.step(row);
        boolean complete = Rows.complete(row);
        if (complete) {
            int place = (int) (judged++ % strange.length);
            strangers -= strange[place] ? 1 : 0;
            strange[place] = far();
            strangers += strange[place] ? 1 : 0;
        }
        Optional<MotionState> state = Optional.empty();
        if (judged > 0 && 2 * strangers <= Math.min(judged, strange.length)) {
            state = Optional.of(likeliest());
            samples[state.get().ordinal()]++;
            compared += complete ? 1 : 0;
            agreed += complete && PhysicalLabels.of(row, model.thresholds()) == state.get() ? 1 : 0;
        } else {
            silent++;
        }
        if (at == 0 || !current.equals(state)) {
            end(at);
            current = state;
            began = at;
        }
    }

    private MotionState likeliest() {
        filter.byName(named);
        int best = 0;
        for (int j = 1; j < named.length; j++) {
            best = named[j] > named[best] ? j : best;
        }
        return MotionState.values()[best];
    }

    /** Whether no state of the model accounts for the row. */
    private boolean far() {
        StateModel.activity(row, activity);
        for (int k = 0; k < components.length; k++) {
            if (2 * (peaks[k] - components[k].logDensity(activity, scratch)) < FAR) {
                return false;
            }
        }
        return true;
    }

    private void end(long at) {
        if (at > began && runs.size() < MOST_RUNS) {
            runs.add(new Run(current, began, at));
        }
    }

    /** Ends the stream. Feed nothing afterwards. */
    public void finish() {
        end(Math.max(0, taken - model.features().delay()));
    }

    /** What the states are told by. */
    public StateModel model() {
        return model;
    }

    /** What followed what; the first twenty thousand. */
    public List<Run> runs() {
        return List.copyOf(runs);
    }

    /** Share of the told samples whose state is what the thresholds say of the sample alone; NaN if there are none. */
    public double agreement() {
        return agreed / (double) compared;
    }

    /** Time in which no state is told [s]. */
    public double silence() {
        return silent / model.features().rate();
    }

    /** Time in every state that was met [s]. */
    public Map<MotionState, Double> seconds() {
        Map<MotionState, Double> all = new EnumMap<>(MotionState.class);
        for (MotionState state : MotionState.values()) {
            if (samples[state.ordinal()] > 0) {
                all.put(state, samples[state.ordinal()] / model.features().rate());
            }
        }
        return all;
    }
}
