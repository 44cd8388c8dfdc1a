package wbv.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import wbv.recording.DataFault;
import wbv.recording.Recording;
import wbv.state.markov.HiddenMarkov;
import wbv.state.markov.Rows;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.DirichletProcess;
import wbv.state.mixture.Gaussian;
import wbv.state.mixture.MessageLength;
import wbv.state.mixture.Mixture;

/**
 * Trains a {@link StateModel}: every row is named, by the truth where it lies beside a recording and by thresholds where not; a
 * mixture is fitted to the rows of every activity, every component of it becomes a state of a hidden chain, that of a jolt one state
 * for each way to jerk, and the chain's transitions are counted.
 */
public final class StateTraining {

    /** Rows that a name needs to become a state. */
    public static final int FEWEST = 25;
    /** Rows of an activity that its mixture is fitted to, at most; more are thinned. */
    private static final int MOST = 4000;
    private static final int COMPONENTS = 10;
    private static final double PSEUDO = 0.02;
    /** Error of a jerk where no truth tells it [m/s³] (assumed: more than the 2.5 of people whom the rig tells). */
    private static final double USUAL_ERROR = 4;
    /** Of a standard normal distribution. */
    private static final double QUARTILE = 0.6745;

    private final FeatureSpec features;
    private final Thresholds thresholds;
    private final List<String> trials = new ArrayList<>();
    private final List<double[][]> sequences = new ArrayList<>();
    private final List<List<Optional<Label>>> labels = new ArrayList<>();
    private final Map<Activity, List<double[]>> acted = new EnumMap<>(Activity.class);
    private final Map<MotionState, Integer> named = new EnumMap<>(MotionState.class);
    private final Map<MotionState, Integer> jolted = new EnumMap<>(MotionState.class);
    private final List<Double> errors = new ArrayList<>();

    /** What a row is. */
    private record Label(Activity activity, MotionState state) {}

    /** How mixtures are found. */
    public enum Mixing {
        /** {@link wbv.state.mixture.MessageLength}. */
        MESSAGE_LENGTH,
        /** {@link wbv.state.mixture.DirichletProcess}. */
        DIRICHLET,
        /** One normal density for each name. */
        SINGLE;

        /** The word of this way, such as {@code message-length}. */
        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }

        Mixture fit(double[][] rows, RandomGenerator random) {
            return switch (this) {
                case MESSAGE_LENGTH -> MessageLength.USUAL.between(1, COMPONENTS).fit(rows, random, share -> {}).mixture();
                case DIRICHLET -> DirichletProcess.fit(rows, 0.2, 100, 20, CovarianceShape.FULL, random, share -> {});
                case SINGLE -> MessageLength.USUAL.between(1, 1).fit(rows, random, share -> {}).mixture();
            };
        }
    }

    /**
     * A training that knows no recording yet.
     *
     * @param thresholds by which rows are named where no truth is known
     */
    public StateTraining(FeatureSpec features, Thresholds thresholds) {
        this.features = features;
        this.thresholds = thresholds;
    }

    /**
     * Takes a recording that nobody labelled: thresholds name its rows.
     *
     * @param name for messages and provenance
     */
    public void add(String name, Recording recording) {
        add(name, recording, Optional.empty());
    }

    /**
     * Takes a recording.
     *
     * @param name for messages and provenance
     * @param truth what truly happened, where it is known
     * @throws DataFault if it lacks a channel or has another rate, or the truth another length
     */
    public void add(String name, Recording recording, Optional<TrueStates> truth) {
        double[][] rows = FeatureRows.of(features, recording, name);
        truth.ifPresent(known -> known.require(rows.length));
        List<Optional<Label>> own = new ArrayList<>();
        for (int i = 0; i < rows.length; i++) {
            if (!Rows.complete(rows[i])) {
                own.add(Optional.empty());
                continue;
            }
            Label label = truth.isPresent() ? new Label(truth.get().activities().get(i), truth.get().states().get(i))
                    : new Label(PhysicalLabels.activity(rows[i], thresholds), PhysicalLabels.of(rows[i], thresholds));
            own.add(Optional.of(label));
            take(label, rows[i]);
        }
        truth.ifPresent(known -> measure(known, rows));
        trials.add(name);
        sequences.add(rows);
        labels.add(own);
    }

    private void take(Label label, double[] row) {
        double[] activity = new double[FeatureSpec.OF_ACTIVITY];
        StateModel.activity(row, activity);
        acted.computeIfAbsent(label.activity, each -> new ArrayList<>()).add(activity);
        named.merge(label.state, 1, Integer::sum);
        if (label.activity == Activity.JOLT) {
            jolted.merge(label.state, 1, Integer::sum);
        }
    }

    /** How far jerks that were read in jolts are off. */
    private void measure(TrueStates truth, double[][] rows) {
        for (int i = 0; i < rows.length; i++) {
            if (truth.activities().get(i) == Activity.JOLT && Rows.complete(rows[i])) {
                errors.add(Math.abs(rows[i][FeatureSpec.SEAT_JERK] - truth.seatJerk()[i]));
                errors.add(Math.abs(rows[i][FeatureSpec.HEAD_JERK] - truth.headJerk()[i]));
            }
        }
    }

    /** The standard deviation of a normal distribution whose middle half is that of the errors. */
    private double error() {
        double[] sorted = errors.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        return sorted.length == 0 ? USUAL_ERROR : Math.max(1e-3, sorted[sorted.length / 2] / QUARTILE);
    }

    /** The features of the recordings taken so far. Not copies. */
    public List<double[][]> sequences() {
        return List.copyOf(sequences);
    }

    /** Names whose rows are too few for a state. */
    public List<MotionState> tooFew() {
        return named.keySet().stream().filter(state -> named.get(state) < FEWEST).toList();
    }

    /** How many rows a name has. */
    public int rows(MotionState state) {
        return named.getOrDefault(state, 0);
    }

    /** How many rows an activity has. */
    int rows(Activity activity) {
        return acted.getOrDefault(activity, List.of()).size();
    }

    /**
     * The mixture of every activity that has enough rows.
     *
     * @throws DataFault if fewer than two have enough rows
     */
    Map<Activity, Mixture> mixtures(Mixing mixing, RandomGenerator random, DoubleConsumer progress) {
        List<Activity> activities = acted.keySet().stream().filter(each -> rows(each) >= FEWEST).toList();
        if (activities.size() < 2) {
            int rows = acted.values().stream().mapToInt(List::size).sum();
            throw new DataFault(String.join(", ", trials) + ": " + (rows == 0 ? "no sample has all of " + features.channels()
                    : "only " + (activities.isEmpty() ? "too few samples (" + rows + ")" : "'" + activities.get(0) + "'") + " is seen")
                    + "; states need at least two kinds of motion, each in " + FEWEST + " samples, such as rest and riding");
        }
        Map<Activity, Mixture> mixtures = new EnumMap<>(Activity.class);
        for (Activity activity : activities) {
            mixtures.put(activity, mixing.fit(Rows.thinned(List.<double[][]>of(acted.get(activity).toArray(double[][]::new)), MOST),
                    random));
            progress.accept(mixtures.size() / (double) activities.size());
        }
        return mixtures;
    }

    /**
     * Trains.
     *
     * @param seed chooses where mixtures begin
     * @param progress hears the share that is done
     * @throws DataFault if fewer than two activities have enough rows
     */
    public StateModel finish(Mixing mixing, long seed, DoubleConsumer progress) {
        Map<Activity, Mixture> mixtures = mixtures(mixing, new Well19937c(seed), progress);
        List<Activity> activities = new ArrayList<>();
        List<MotionState> names = new ArrayList<>();
        List<Double> shares = new ArrayList<>();
        List<Mixture> emissions = new ArrayList<>();
        mixtures.forEach((activity, mixture) -> {
            if (activity == Activity.JOLT) {
                jolted.forEach((state, count) -> {
                    if (count >= FEWEST) {
                        activities.add(activity);
                        names.add(state);
                        shares.add(count / (double) rows(activity));
                        emissions.add(mixture);
                    }
                });
            } else {
                for (Gaussian component : mixture.components()) {
                    activities.add(activity);
                    names.add(activity.state(0, 0));
                    shares.add(1.0);
                    emissions.add(Mixture.of(component));
                }
            }
        });
        Map<MotionState, Integer> rows = new EnumMap<>(MotionState.class);
        names.forEach(state -> rows.put(state, rows(state)));
        return new StateModel(features, thresholds, mixing.toString(), chain(mixtures, activities, names, emissions),
                activities, names, shares.stream().mapToDouble(Double::doubleValue).toArray(), error(), trials, rows);
    }

    /** Transitions are counted between the states that labelled rows are in: of an activity, the likeliest component. */
    private HiddenMarkov chain(Map<Activity, Mixture> mixtures, List<Activity> activities, List<MotionState> names,
            List<Mixture> emissions) {
        int k = names.size();
        double[] initial = new double[k];
        double[][] transition = new double[k][k];
        Arrays.fill(initial, PSEUDO);
        for (double[] row : transition) {
            Arrays.fill(row, PSEUDO);
        }
        double[] activity = new double[FeatureSpec.OF_ACTIVITY];
        for (int s = 0; s < sequences.size(); s++) {
            int before = -1;
            for (int t = 0; t < labels.get(s).size(); t++) {
                StateModel.activity(sequences.get(s)[t], activity);
                int state = labels.get(s).get(t).map(label -> state(label, activity, mixtures, activities, names)).orElse(-1);
                if (state >= 0 && before >= 0) {
                    transition[before][state]++;
                } else if (state >= 0 && t == 0) {
                    initial[state]++;
                }
                before = state;
            }
        }
        HiddenMarkov.normalise(initial);
        for (double[] row : transition) {
            HiddenMarkov.normalise(row);
        }
        return new HiddenMarkov(initial, transition, emissions);
    }

    /** The state of the chain that a labelled row is in; -1 where its name or activity has none. */
    private static int state(Label label, double[] row, Map<Activity, Mixture> mixtures, List<Activity> activities,
            List<MotionState> names) {
        int first = activities.indexOf(label.activity);
        if (first < 0) {
            return -1;
        }
        if (label.activity != Activity.JOLT) {
            return first + mixtures.get(label.activity).labels(new double[][] {row})[0];
        }
        for (int k = first; k < names.size() && activities.get(k) == Activity.JOLT; k++) {
            if (names.get(k) == label.state) {
                return k;
            }
        }
        return -1;
    }
}
