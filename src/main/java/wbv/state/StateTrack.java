package wbv.state;

import java.util.Arrays;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.state.markov.Forecast;
import wbv.state.markov.Rows;
import wbv.state.markov.Trellis;

/**
 * What a model says of a recording, sample by sample: the state given the whole recording and given only what had come, and how
 * likely a jerk was to come.
 */
public final class StateTrack {

    /** How far a forecast looks ahead [s]. */
    public static final double[] HORIZONS = {0.1, 0.25, 0.5};

    private final StateModel model;
    private final Recording recording;
    private final double[][] features;
    private final double[][] smoothed;
    private final MotionState[] states;
    private final MotionState[] live;
    private final double[][] forecast;
    private final double logLikelihood;

    /**
     * Tells the states of a whole recording.
     *
     * @param name of the recording, for messages
     * @throws DataFault if it lacks a channel of the model, has another rate, or no sample with all of the channels
     */
    public StateTrack(StateModel model, String name, Recording recording) {
        this.model = model;
        this.recording = recording;
        features = FeatureRows.of(model.features(), recording, name);
        if (Arrays.stream(features).noneMatch(Rows::complete)) {
            throw DataFault.in(name, "no sample has all of " + model.features().channels() + " and "
                    + 2 * model.features().delay() + " more beside it; nothing can be told of it");
        }
        double[][] activity = new double[features.length][FeatureSpec.OF_ACTIVITY];
        double[][] evidence = new double[features.length][model.chain().states()];
        JoltEvidence jolts = new JoltEvidence(model);
        for (int i = 0; i < features.length; i++) {
            StateModel.activity(features[i], activity[i]);
            jolts.of(features[i], evidence[i]);
        }
        Trellis trellis = new Trellis(model.chain(), activity, evidence);
        logLikelihood = trellis.logLikelihood();
        int n = features.length;
        int delay = model.features().delay();
        smoothed = new double[n][MotionState.values().length];
        states = new MotionState[n];
        live = new MotionState[n];
        forecast = new double[HORIZONS.length][n];
        Forecast[] ahead = new Forecast[HORIZONS.length];
        for (int h = 0; h < ahead.length; h++) {
            ahead[h] = new Forecast(model.chain(), model.jerks(), delay + 1, delay + samples(h));
            Arrays.fill(forecast[h], Double.NaN);
        }
        double[] named = new double[MotionState.values().length];
        for (int i = 0; i < n; i++) {
            model.byName(trellis.posterior()[i], smoothed[i]);
            states[i] = likeliest(smoothed[i]);
            model.byName(trellis.filtered()[i], named);
            live[i] = likeliest(named);
            // The features of sample i are known when sample i + delay has come: the forecast is said then.
            for (int h = 0; h < ahead.length && i + delay < n; h++) {
                forecast[h][i + delay] = ahead[h].probability(trellis.filtered()[i]);
            }
        }
    }

    /** Samples of a horizon. */
    public int samples(int horizon) {
        return Math.max(1, (int) Math.round(HORIZONS[horizon] * model.features().rate()));
    }

    private static MotionState likeliest(double[] named) {
        int best = 0;
        for (int j = 1; j < named.length; j++) {
            best = named[j] > named[best] ? j : best;
        }
        return MotionState.values()[best];
    }

    /** What the states are told by. */
    public StateModel model() {
        return model;
    }

    /** What they are told of; not copied. */
    public Recording recording() {
        return recording;
    }

    /** Samples. */
    public int length() {
        return states.length;
    }

    /** ln p of the features [nat]. */
    public double logLikelihood() {
        return logLikelihood;
    }

    /** Features, length by {@link FeatureSpec#NAMES}, in their units; NaN where missing. Not a copy. */
    public double[][] features() {
        return features;
    }

    /** The likeliest state of a sample given the whole recording. */
    public MotionState state(int sample) {
        return states[sample];
    }

    /** Probability P(a state at a sample | the whole recording). */
    public double probability(int sample, MotionState state) {
        return smoothed[sample][state.ordinal()];
    }

    /** Its probability. */
    public double probability(int sample) {
        return smoothed[sample][states[sample].ordinal()];
    }

    /** The likeliest state given only what had come (and the {@link FeatureSpec#delay} samples that features need). */
    public MotionState live(int sample) {
        return live[sample];
    }

    /** Probability P(a jerk within the horizon after this sample | samples up to it); NaN for the first few. */
    public double forecast(int horizon, int sample) {
        return forecast[horizon][sample];
    }

    /** Whether the sample's features were complete. */
    public boolean told(int sample) {
        return Rows.complete(features[sample]);
    }
}
