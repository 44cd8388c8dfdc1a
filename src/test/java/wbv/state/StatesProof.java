package wbv.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.random.Well19937c;
import wbv.filter.Estimator;
import wbv.filter.Method;
import wbv.filter.Recipe;
import wbv.filter.Spec;
import wbv.learn.AdwinAlarm;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Recording;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;
import weka.clusterers.EM;
import weka.core.Attribute;
import weka.core.DenseInstance;
import weka.core.Instances;

/**
 * How well states are told and jerk is foreseen on simulated people who took no part in the training, each of the four in turn,
 * against what the rig injected. Arguments: seconds of each of the rides 1, 4 and 7; {@code chain} for the chain alone.
 */
public final class StatesProof {

    private static final int[] REGIMES = {1, 4, 7};
    private static final int COMPONENTS = 10;

    private static final String BEST = "hidden Markov model over them (message-length)";

    private StatesProof() { }

    private record Ride(int subject, String name, Recording recording, TrueStates truth) { }

    /** Tells the state of every sample of a ride; the tracks are empty where there is no chain. */
    private record Told(Confusion all, Confusion live, List<Reliability> forecasts, List<double[]> ways) {
        Told() {
            this(new Confusion(), new Confusion(), List.of(new Reliability(), new Reliability(), new Reliability()),
                    new ArrayList<>());
        }
    }

    public static void main(String[] words) throws Exception {
        List<Ride> rides = new ArrayList<>();
        for (int subject = 1; subject <= 4; subject++) {
            for (int regime : REGIMES) {
                rides.add(ride(subject, regime, Double.parseDouble(words[0])));
            }
        }
        Map<String, Told> table = new LinkedHashMap<>();
        for (int held = 1; held <= 4; held++) {
            int out = held;
            System.err.println("without subject " + held);
            boolean alone = words.length > 1;
            fold(alone, rides.stream().filter(ride -> ride.subject != out).toList(), rides.stream()
                    .filter(ride -> ride.subject == out)
                    .toList(),
                    table);
        }
        print(table);
    }

    private static Ride ride(int subject, int regime, double seconds) {
        RigSpec spec = RigSpec.parse("subject=" + subject + " excitation=ride:" + regime + " seconds=" + seconds + " seed="
                + (100 * subject + regime) + " channels=seat.acc.z,head.acc.z,seat.gyr.x,seat.gyr.y");
        RigRun run = spec.run();
        int n = (int) spec.rows();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        spec.channels().forEach(channel -> values.put(channel, new double[n]));
        double[][] columns = values.values().toArray(double[][]::new);
        double[] row = new double[1 + columns.length];
        double[] events = new double[run.events().size()];
        double[][] jerks = new double[2][n];
        List<MotionState> states = new ArrayList<>();
        for (int i = 0; run.read(row); i++) {
            run.events(events);
            for (int c = 0; c < columns.length; c++) {
                columns[c][i] = row[1 + c];
            }
            jerks[0][i] = events[2];
            jerks[1][i] = events[3];
            states.add(PhysicalLabels.truth((int) events[0], events[1] > 0, events[2], events[3], Thresholds.USUAL));
        }
        return new Ride(subject, "subject " + subject + " ride " + regime, new Recording(new Clock(0, spec.rate()), values,
                run.metadata()),
                new TrueStates(states, jerks[0], jerks[1]));
    }

    private static void fold(boolean alone, List<Ride> learned, List<Ride> held, Map<String, Told> table) throws Exception {
        FeatureSpec features = FeatureSpec.of(60, "seat", "head", learned.get(0).recording.channels(), "rig");
        StateTraining training = new StateTraining(features, Thresholds.USUAL);
        learned.forEach(ride -> training.add(ride.name, ride.recording));
        if (alone) {
            chain(table, BEST, held, training.finish(StateTraining.Mixing.MESSAGE_LENGTH, 0, 1, share -> { }));
            return;
        }
        double[][] rows = Rows.thinned(training.sequences(), 3000);
        told(table, "thresholds alone", held, features, row -> PhysicalLabels.of(row, Thresholds.USUAL));
        MessageLength plain = MessageLength.USUAL.between(COMPONENTS, COMPONENTS);
        byCluster(table, "plain mixture of 10, argmax", held, training, features, plain.fit(rows, new Well19937c(1),
                share -> { }).mixture());
        weka(table, held, training, features, rows);
        byCluster(table, "mixture by message length, argmax", held, training, features,
                MessageLength.USUAL.fit(rows, new Well19937c(1), share -> { }).mixture());
        byCluster(table, "Dirichlet-process mixture, argmax", held, training, features,
                DirichletProcess.fit(rows, 0.1, 60, 20, Shape.FULL, new Well19937c(1), share -> { }));
        for (StateTraining.Mixing mixing : List.of(StateTraining.Mixing.MESSAGE_LENGTH, StateTraining.Mixing.DIRICHLET)) {
            Map<MotionState, Mixture> mixtures = training.mixtures(mixing, new Well19937c(1), share -> { });
            double[] logs = new double[100];
            double[] scratch = new double[FeatureSpec.NAMES.size()];
            told(table, "a mixture for every name (" + mixing + "), argmax", held, features, row -> mixtures.keySet().stream()
                    .max((a, b) -> Double.compare(Math.log(training.rows(a)) + mixtures.get(a).logDensity(row, logs, scratch),
                            Math.log(training.rows(b)) + mixtures.get(b).logDensity(row, logs, scratch))).orElseThrow());
            chain(table, "hidden Markov model over them (" + mixing + ")", held, training.finish(mixing, 0, 1, share -> { }));
        }
        chain(table, "the same (message-length), 3 rounds of Baum-Welch", held,
                training.finish(StateTraining.Mixing.MESSAGE_LENGTH, 3, 1, share -> { }));
    }

    private interface Rule {
        MotionState of(double[] row);
    }

    private static void told(Map<String, Told> table, String name, List<Ride> held, FeatureSpec features, Rule rule) {
        Told told = table.computeIfAbsent(name, key -> new Told());
        for (Ride ride : held) {
            double[][] rows = FeatureRows.of(features, ride.recording, ride.name);
            MotionState last = MotionState.IDLE;
            for (int i = 0; i < rows.length; i++) {
                last = Rows.complete(rows[i]) ? rule.of(rows[i]) : last;
                told.all.add(ride.truth.states().get(i), last);
            }
        }
    }

    /** Clusters that were found without names are named after what most of their training rows are by the thresholds. */
    private static void byCluster(Map<String, Told> table, String name, List<Ride> held, StateTraining training,
            FeatureSpec features,
            Mixture mixture) {
        MotionState[] names = names(training, mixture.size(), row -> mixture.labels(new double[][] {row})[0]);
        told(table, name, held, features, row -> names[mixture.labels(new double[][] {row})[0]]);
    }

    private interface Cluster {
        int of(double[] row);
    }

    private static MotionState[] names(StateTraining training, int clusters, Cluster cluster) {
        int[][] counts = new int[clusters][MotionState.values().length];
        for (double[] row : Rows.thinned(training.sequences(), 20_000)) {
            counts[cluster.of(row)][PhysicalLabels.of(row, Thresholds.USUAL).ordinal()]++;
        }
        return Arrays.stream(counts).map(row -> {
            int most = 0;
            for (int j = 1; j < row.length; j++) {
                most = row[j] > row[most] ? j : most;
            }
            return MotionState.values()[most];
        }).toArray(MotionState[]::new);
    }

    private static void weka(Map<String, Told> table, List<Ride> held, StateTraining training, FeatureSpec features,
            double[][] rows)
            throws Exception {
        ArrayList<Attribute> attributes = new ArrayList<>();
        FeatureSpec.NAMES.forEach(name -> attributes.add(new Attribute(name)));
        Instances data = new Instances("rows", attributes, rows.length);
        for (double[] row : rows) {
            data.add(new DenseInstance(1, row.clone()));
        }
        EM em = new EM();
        em.setNumClusters(COMPONENTS);
        em.buildClusterer(data);
        Cluster cluster = row -> {
            try {
                DenseInstance instance = new DenseInstance(1, row.clone());
                instance.setDataset(data);
                return em.clusterInstance(instance);
            } catch (Exception wrong) { // Weka declares nothing narrower
                throw new IllegalStateException(wrong);
            }
        };
        MotionState[] names = names(training, em.numberOfClusters(), cluster);
        told(table, "Weka's EM with 10, argmax", held, features, row -> names[cluster.of(row)]);
    }

    private static void chain(Map<String, Told> table, String name, List<Ride> held, StateModel model) {
        Told told = table.computeIfAbsent(name, key -> new Told());
        for (Ride ride : held) {
            StateTrack track = new StateTrack(model, ride.name, ride.recording);
            boolean[] jerks = new boolean[track.length()];
            for (int i = 0; i < track.length(); i++) {
                told.all.add(ride.truth.states().get(i), track.state(i));
                told.live.add(ride.truth.states().get(i), track.live(i));
                jerks[i] = ride.truth.states().get(i).jerk();
            }
            for (int h = 0; h < told.forecasts.size(); h++) {
                ride.truth.addTo(told.forecasts.get(h), track, h);
            }
            SeatToHead way = SeatToHead.of(track);
            SeatToHead truth = SeatToHead.of(ride.truth.seatJerk(), ride.truth.headJerk(), jerks, 60);
            Optional<double[]> kalman = kalman(ride.recording);
            told.ways.add(new double[] {way.lag(), truth.lag(), way.frequency(), truth.frequency(), way.damping(),
                    truth.damping(),
                kalman.map(body -> body[0]).orElse(Double.NaN), kalman.map(body -> body[1]).orElse(Double.NaN)});
        }
    }

    private static Optional<double[]> kalman(Recording recording) {
        Estimator estimator = Recipe.of(Method.FUSED).estimator(Spec.at(60), () -> new AdwinAlarm(0.002));
        double[] seat = recording.values(Channel.parse("seat.acc.z"));
        double[] head = recording.values(Channel.parse("head.acc.z"));
        for (int i = 0; i < seat.length; i++) {
            estimator.step(seat[i], head[i]);
        }
        return estimator.track().found() ? Optional.of(new double[] {estimator.track().frequency(), estimator.track().damping()})
                : Optional.empty();
    }

    private static void print(Map<String, Told> table) {
        System.out.println("| method | accuracy | macro-F1 | accuracy live |\n|---|---|---|---|");
        table.forEach((name, told) -> System.out.printf(Locale.ROOT, "| %s | %.1f %% | %.2f | %s |%n", name,
                100 * told.all.accuracy(),
                told.all.macroF1(), told.live.all() == 0 ? "–" : String.format(Locale.ROOT, "%.1f %%",
                        100 * told.live.accuracy())));
        System.out.println("\n| state | samples | F1 by thresholds | F1 by the chain |\n|---|---|---|---|");
        Told best = table.get(BEST);
        for (MotionState state : MotionState.values()) {
            System.out.printf(Locale.ROOT, "| %s | %d | %.2f | %.2f |%n", state, best.all.of(state),
                    table.getOrDefault("thresholds alone", best).all.f1(state), best.all.f1(state));
        }
        System.out.println("\n| chain | horizon | AUC | mean calibration error | worst bin of 500 samples or more | came "
                + "|\n|---|---|---|---|---|---|");
        table.forEach((name, told) -> {
            for (int h = 0; h < told.forecasts.size() && told.live.all() > 0; h++) {
                Reliability forecast = told.forecasts.get(h);
                System.out.printf(Locale.ROOT, "| %s | %.0f ms | %.3f | %.1f %% | %.0f %% | %.1f %% |%n", name,
                        1000 * StateTrack.HORIZONS[h], forecast.area(), 100 * forecast.calibrationError(),
                        100 * forecast.bins().stream().filter(bin -> bin.count() >= 500)
                                .mapToDouble(bin -> Math.abs(bin.said() - bin.came())).max().orElse(0), 100 * forecast.base());
            }
        });
        System.out.println("\n| recording | lag by states [ms] | true lag [ms] | Hz by states | Hz by true jerks | ζ by states | "
                + "ζ by true jerks | "
                + "Kalman Hz | Kalman ζ |\n|---|---|---|---|---|---|---|---|---|");
        for (int i = 0; i < best.ways.size(); i++) {
            double[] way = best.ways.get(i);
            System.out.printf(Locale.ROOT, "| subject %d ride %d | %.1f | %.1f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |%n",
                    1 + i / REGIMES.length, REGIMES[i % REGIMES.length], 1000 * way[0], 1000 * way[1], way[2], way[3], way[4],
                            way[5],
                    way[6], way[7]);
        }
    }
}
