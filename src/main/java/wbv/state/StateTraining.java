package wbv.state;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleConsumer;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * Trains a {@link StateModel}: thresholds name every row, a mixture is fitted to the rows of every name, every component
 * becomes a
 * state of a hidden chain, and the chain's transitions are counted.
 */
public final class StateTraining {

    /** Rows that a name needs to become a state. */
    public static final int FEWEST = 25;
    /** Rows of a name that its mixture is fitted to, at most; more are thinned. */
    private static final int MOST = 2500;
    private static final int COMPONENTS = 10;
    private static final double PSEUDO = 0.02;

    private final FeatureSpec features;
    private final Thresholds thresholds;
    private final List<String> trials = new ArrayList<>();
    private final List<double[][]> sequences = new ArrayList<>();
    private final Map<MotionState, List<double[]>> named = new EnumMap<>(MotionState.class);

    /** How mixtures are found. */
    public enum Mixing {
        /** {@link wbv.state.MessageLength}. */
        MESSAGE_LENGTH,
        /** {@link wbv.state.DirichletProcess}. */
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
                case MESSAGE_LENGTH -> MessageLength.USUAL.between(1, COMPONENTS).fit(rows, random, share -> { }).mixture();
                case DIRICHLET -> DirichletProcess.fit(rows, 0.2, 100, 20, Shape.FULL, random, share -> { });
                case SINGLE -> MessageLength.USUAL.between(1, 1).fit(rows, random, share -> { }).mixture();
            };
        }
    }

    public StateTraining(FeatureSpec features, Thresholds thresholds) {
        this.features = features;
        this.thresholds = thresholds;
    }

    /**
     * Takes a recording.
     *
     * @param name for messages and provenance
     * @throws DataFault if it lacks a channel or has another rate
     */
    public void add(String name, Recording recording) {
        double[][] rows = FeatureRows.of(features, recording, name);
        trials.add(name);
        sequences.add(rows);
        for (double[] row : rows) {
            if (Rows.complete(row)) {
                named.computeIfAbsent(PhysicalLabels.of(row, thresholds), state -> new ArrayList<>()).add(row);
            }
        }
    }

    /** The features of the recordings taken so far. Not copies. */
    public List<double[][]> sequences() {
        return List.copyOf(sequences);
    }

    /** Names whose rows are too few for a state. */
    public List<MotionState> tooFew() {
        return named.keySet().stream().filter(state -> named.get(state).size() < FEWEST).toList();
    }

    /** The mixture of every name that has enough rows. @throws DataFault if fewer than two names have enough rows */
    public Map<MotionState, Mixture> mixtures(Mixing mixing, RandomGenerator random, DoubleConsumer progress) {
        List<MotionState> states = named.keySet().stream().filter(state -> named.get(state).size() >= FEWEST).toList();
        if (states.size() < 2) {
            int rows = named.values().stream().mapToInt(List::size).sum();
            throw new DataFault(String.join(", ", trials) + ": " + (rows == 0 ? "no sample has all of " + features.channels()
                    : "only " + (states.isEmpty() ? "too few samples (" + rows + ")" : "'" + states.get(0) + "'") + " is seen")
                    + "; states need at least two kinds of motion, each in " + FEWEST + " samples, such as rest and riding");
        }
        Map<MotionState, Mixture> mixtures = new EnumMap<>(MotionState.class);
        for (MotionState state : states) {
            mixtures.put(state, mixing.fit(Rows.thinned(List.<double[][]>of(named.get(state).toArray(double[][]::new)), MOST),
                    random));
            progress.accept(mixtures.size() / (double) states.size());
        }
        return mixtures;
    }

    /** How many rows a name has. */
    public int rows(MotionState state) {
        return named.getOrDefault(state, List.of()).size();
    }

    /**
     * Trains.
     *
     * @param rounds of Baum-Welch after the counting, &gt;= 0. Rounds raise the likelihood, and move the states away from their
     *               names. @param seed chooses where mixtures begin @param progress hears the share that is done
     * @throws DataFault if fewer than two names have enough rows
     */
    public StateModel finish(Mixing mixing, int rounds, long seed, DoubleConsumer progress) {
        Map<MotionState, Mixture> mixtures = mixtures(mixing, new Well19937c(seed), progress);
        List<MotionState> names = new ArrayList<>();
        List<Gaussian> components = new ArrayList<>();
        List<Double> weights = new ArrayList<>();
        double all = mixtures.keySet().stream().mapToInt(this::rows).sum();
        mixtures.forEach((state, mixture) -> {
            for (int m = 0; m < mixture.size(); m++) {
                names.add(state);
                components.add(mixture.components().get(m));
                weights.add(mixture.weights()[m] * rows(state) / all);
            }
        });
        Mixture whole = new Mixture(weights.stream().mapToDouble(Double::doubleValue).toArray(), components);
        HiddenMarkov chain = HiddenMarkov.of(whole, sequences, PSEUDO);
        if (rounds > 0) {
            chain = BaumWelch.USUAL.withRounds(rounds).fit(chain, sequences, progress).model();
        }
        Map<MotionState, Integer> rows = new EnumMap<>(MotionState.class);
        mixtures.keySet().forEach(state -> rows.put(state, rows(state)));
        return new StateModel(features, thresholds, mixing.toString(), chain, names, trials, rows);
    }
}
