package wbv.state;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.apache.commons.math3.random.Well19937c;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Recording;
import wbv.recording.format.RecordingFile;
import wbv.rig.RigRun;
import wbv.rig.RigSpec;
import wbv.state.markov.Rows;
import wbv.state.mixture.CovarianceShape;
import wbv.state.mixture.DirichletProcess;
import wbv.state.mixture.MessageLength;
import wbv.state.mixture.Mixture;
import weka.clusterers.EM;
import weka.core.Attribute;
import weka.core.DenseInstance;
import weka.core.Instances;

/**
 * How well states are told, jerk is foreseen and the head's lag is known on simulated people who took no part in the training, on a
 * cushion and without, under each of the regimes 1 to 8, against what the rig injected.
 *
 * <p>{@code regimes SECONDS PEOPLE} tries the model that ships, regime by regime; {@code methods SECONDS PEOPLE} other ways of telling,
 * learned from the same two recordings; {@code lag SECONDS RIDES PEOPLE} the deviation of the lag. People are as the rig's
 * {@code subject=}, separated by commas; SECONDS is the length of each ride.
 */
public final class StatesProof {

    private static final int REGIMES = 8;
    /** Under which the lag is tried: the strongest vertical motion, the weakest, the strongest across, and pitch. */
    private static final int[] LAGGED = {1, 4, 6, 7};
    private static final int COMPONENTS = 10;
    private static final String[] SITTING = {"usual", "usual,-cushion"};
    private static final List<String> SHIPPED = List.of("data/arff/states-train.arff", "data/arff/states-bare.arff");
    private static final String CHANNELS = " channels=seat.acc.z,head.acc.z,seat.gyr.x,seat.gyr.y";

    private StatesProof() {}

    private record Ride(int regime, String name, Recording recording, TrueStates truth) {}

    /** What was told. */
    private record Told(Confusion all, Confusion live, Confusion plain, List<Reliability> forecasts) {
        Told() {
            this(new Confusion(), new Confusion(), new Confusion(), List.of(new Reliability(), new Reliability(), new Reliability()));
        }
    }

    public static void main(String[] words) throws Exception {
        double seconds = Double.parseDouble(words[1]);
        String[] people = words[words.length - 1].split(",");
        switch (words[0]) {
            case "regimes" -> regimes(rides(people, seconds));
            case "methods" -> methods(rides(people, seconds));
            case "lag" -> lags(people, seconds, Integer.parseInt(words[2]));
            default -> throw new IllegalArgumentException("regimes, methods or lag: " + words[0]);
        }
    }

    private static List<Ride> rides(String[] people, double seconds) {
        List<Ride> rides = new ArrayList<>();
        int seed = 70_000;
        for (String person : people) {
            for (String sitting : SITTING) {
                for (int regime = 1; regime <= REGIMES; regime++) {
                    rides.add(ride(regime, "subject=" + person + " effects=" + sitting + " excitation=ride:" + regime + " seconds="
                            + seconds + " seed=" + seed++ + CHANNELS));
                }
            }
        }
        return rides;
    }

    private static Ride ride(int regime, String words) {
        RigSpec spec = RigSpec.parse(words);
        RigRun run = spec.run();
        int n = (int) spec.rows();
        Map<Channel, double[]> values = new LinkedHashMap<>();
        spec.channels().forEach(channel -> values.put(channel, new double[n]));
        double[][] columns = values.values().toArray(double[][]::new);
        double[] row = new double[1 + columns.length];
        double[] events = new double[run.events().size()];
        double[][] happened = new double[events.length][n];
        for (int i = 0; run.read(row); i++) {
            run.events(events);
            for (int c = 0; c < columns.length; c++) {
                columns[c][i] = row[1 + c];
            }
            for (int c = 0; c < events.length; c++) {
                happened[c][i] = events[c];
            }
        }
        return new Ride(regime, words, new Recording(new Clock(0, spec.rate()), values, run.metadata()),
                TrueStates.of(happened[0], happened[1], happened[2], happened[3], Thresholds.USUAL));
    }

    private static void regimes(List<Ride> rides) {
        StateModel model = StateModelFile.shipped();
        Told whole = new Told();
        System.out.println("| regime | accuracy | macro-F1 | accuracy live | macro-F1 live | accuracy by thresholds | macro-F1 by "
                + "thresholds |\n|---|---|---|---|---|---|---|");
        for (int regime = 1; regime <= REGIMES; regime++) {
            int number = regime;
            Told told = new Told();
            rides.stream().filter(ride -> ride.regime == number).forEach(ride -> {
                tell(told, ride, model);
                tell(whole, ride, model);
            });
            line(Integer.toString(regime), told);
        }
        line("all", whole);
        System.out.println("\n| state | samples | F1 | F1 live | F1 by thresholds |\n|---|---|---|---|---|");
        for (MotionState state : MotionState.values()) {
            System.out.printf(Locale.ROOT, "| %s | %d | %.2f | %.2f | %.2f |%n", state, whole.all.of(state), whole.all.f1(state),
                    whole.live.f1(state), whole.plain.f1(state));
        }
        forecasts(Map.of("shipped", whole));
    }

    private static void line(String name, Told told) {
        System.out.printf(Locale.ROOT, "| %s | %.1f %% | %.2f | %.1f %% | %.2f | %.1f %% | %.2f |%n", name, 100 * told.all.accuracy(),
                told.all.macroF1(), 100 * told.live.accuracy(), told.live.macroF1(), 100 * told.plain.accuracy(),
                told.plain.macroF1());
    }

    private static void forecasts(Map<String, Told> table) {
        System.out.println("\n| chain | horizon | AUC | mean calibration error | worst bin of 500 samples or more | came "
                + "|\n|---|---|---|---|---|---|");
        table.forEach((name, told) -> {
            for (int h = 0; h < told.forecasts.size() && told.live.all() > 0; h++) {
                Reliability forecast = told.forecasts.get(h);
                System.out.printf(Locale.ROOT, "| %s | %.0f ms | %.3f | %.1f %% | %.0f %% | %.1f %% |%n", name,
                        1000 * StateTrack.HORIZONS[h], forecast.area(), 100 * forecast.calibrationError(),
                        100 * forecast.bins().stream().filter(bin -> bin.count() >= 500)
                                .mapToDouble(bin -> Math.abs(bin.said() - bin.came())).max().orElse(0),
                        100 * forecast.base());
            }
        });
    }

    private static void tell(Told told, Ride ride, StateModel model) {
        StateTrack track = new StateTrack(model, ride.name, ride.recording);
        MotionState plain = MotionState.IDLE;
        for (int i = 0; i < track.length(); i++) {
            MotionState truth = ride.truth.states().get(i);
            plain = track.told(i) ? PhysicalLabels.of(track.features()[i], Thresholds.USUAL) : plain;
            told.all.add(truth, track.state(i));
            told.live.add(truth, track.live(i));
            told.plain.add(truth, plain);
        }
        for (int h = 0; h < told.forecasts.size(); h++) {
            ride.truth.addTo(told.forecasts.get(h), track, h);
        }
    }

    /** In the shape of the thesis' Table 7-2. */
    private static void methods(List<Ride> held) throws Exception {
        Recording first = new RecordingFile(Path.of(SHIPPED.get(0))).load();
        FeatureSpec features = FeatureSpec.of(first.clock().rate(), "seat", "head", first.channels(), SHIPPED.get(0));
        StateTraining training = new StateTraining(features, Thresholds.USUAL);
        StateTraining unlabelled = new StateTraining(features, Thresholds.USUAL);
        List<MotionState> truth = new ArrayList<>();
        for (String file : SHIPPED) {
            Recording recording = new RecordingFile(Path.of(file)).load();
            Optional<TrueStates> known = TrueStates.beside(Path.of(file), Thresholds.USUAL);
            training.add(file, recording, known);
            unlabelled.add(file, recording);
            truth.addAll(known.orElseThrow().states());
        }
        Map<String, Told> table = new LinkedHashMap<>();
        told(table, "thresholds alone", held, features, row -> PhysicalLabels.of(row, Thresholds.USUAL));
        double[][] rows = Rows.thinned(training.sequences(), 3000);
        clusters(table, "normal mixture of 10 (the thesis' GMM)", held, training, truth, features,
                MessageLength.USUAL.between(COMPONENTS, COMPONENTS).fit(rows, new Well19937c(1), share -> {}).mixture());
        weka(table, held, training, truth, features, rows);
        clusters(table, "mixture by message length", held, training, truth, features,
                MessageLength.USUAL.fit(rows, new Well19937c(1), share -> {}).mixture());
        clusters(table, "Dirichlet-process mixture", held, training, truth, features,
                DirichletProcess.fit(rows, 0.1, 60, 20, CovarianceShape.FULL, new Well19937c(1), share -> {}));
        for (StateTraining.Mixing mixing : List.of(StateTraining.Mixing.MESSAGE_LENGTH, StateTraining.Mixing.DIRICHLET)) {
            chain(table, "hidden Markov model (" + mixing + "), named by thresholds", held, unlabelled.finish(mixing, 1, share -> {}));
            chain(table, "hidden Markov model (" + mixing + "), named by the truth", held, training.finish(mixing, 1, share -> {}));
        }
        System.out.println("| method | accuracy | macro-F1 | accuracy live |\n|---|---|---|---|");
        table.forEach((name, told) -> System.out.printf(Locale.ROOT, "| %s | %.1f %% | %.2f | %s |%n", name,
                100 * told.all.accuracy(), told.all.macroF1(), told.live.all() == 0 ? "–"
                        : String.format(Locale.ROOT, "%.1f %%", 100 * told.live.accuracy())));
    }

    private static void chain(Map<String, Told> table, String name, List<Ride> held, StateModel model) {
        Told told = table.computeIfAbsent(name, key -> new Told());
        held.forEach(ride -> tell(told, ride, model));
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

    private interface Cluster {
        int of(double[] row);
    }

    /** Clusters that were found without names are named after what most of their training rows truly are. */
    private static MotionState[] names(StateTraining training, List<MotionState> truth, int clusters, Cluster cluster) {
        int[][] counts = new int[clusters][MotionState.values().length];
        int at = 0;
        for (double[][] sequence : training.sequences()) {
            for (double[] row : sequence) {
                if (Rows.complete(row)) {
                    counts[cluster.of(row)][truth.get(at).ordinal()]++;
                }
                at++;
            }
        }
        MotionState[] names = new MotionState[clusters];
        Arrays.setAll(names, c -> Arrays.stream(MotionState.values())
                .max((a, b) -> Integer.compare(counts[c][a.ordinal()], counts[c][b.ordinal()])).orElseThrow());
        return names;
    }

    private static void clusters(Map<String, Told> table, String name, List<Ride> held, StateTraining training,
            List<MotionState> truth, FeatureSpec features, Mixture mixture) {
        MotionState[] names = names(training, truth, mixture.size(), row -> mixture.labels(new double[][] {row})[0]);
        told(table, name, held, features, row -> names[mixture.labels(new double[][] {row})[0]]);
    }

    private static void weka(Map<String, Told> table, List<Ride> held, StateTraining training, List<MotionState> truth,
            FeatureSpec features, double[][] rows) throws Exception {
        ArrayList<Attribute> attributes = new ArrayList<>();
        FeatureSpec.NAMES.forEach(name -> attributes.add(new Attribute(name)));
        Instances data = new Instances("features", attributes, rows.length);
        for (double[] row : rows) {
            data.add(new DenseInstance(1, row));
        }
        EM em = new EM();
        em.setNumClusters(COMPONENTS);
        em.buildClusterer(data);
        Cluster cluster = row -> {
            DenseInstance instance = new DenseInstance(1, row);
            instance.setDataset(data);
            try {
                return em.clusterInstance(instance);
            } catch (Exception wrong) { // Weka declares nothing narrower
                throw new IllegalStateException(wrong);
            }
        };
        MotionState[] names = names(training, truth, em.numberOfClusters(), cluster);
        told(table, "Weka's EM with 10", held, features, row -> names[cluster.of(row)]);
    }

    /** The lag of short rides against that of the same person's motion without sensor errors on a ride of eight minutes. */
    private static void lags(String[] people, double seconds, int rides) {
        System.out.println("| regime | rides | no lag said | true lags [ms] | r.m.s. error [ms] | r.m.s. deviation said [ms] | within ±2σ "
                + "|\n|---|---|---|---|---|---|---|");
        double[] all = new double[5];
        int seed = 60_000;
        for (int regime : LAGGED) {
            double[] sums = new double[5];
            double least = Double.POSITIVE_INFINITY;
            double most = 0;
            for (String person : people) {
                String words = "subject=" + person + " excitation=ride:" + regime + " channels=seat.acc.z,head.acc.z";
                double truth = lag(words + " seconds=480 seed=" + seed++, true).orElseThrow().seconds();
                least = Math.min(least, truth);
                most = Math.max(most, truth);
                for (int k = 0; k < rides; k++) {
                    Optional<HeadLag.Lag> said = lag(words + " seconds=" + seconds + " seed=" + seed++, false);
                    sums[0]++;
                    sums[1] += said.isEmpty() ? 1 : 0;
                    if (said.isPresent()) {
                        double error = said.get().seconds() - truth;
                        sums[2] += error * error;
                        sums[3] += said.get().deviation() * said.get().deviation();
                        sums[4] += Math.abs(error) <= 2 * said.get().deviation() ? 1 : 0;
                    }
                }
            }
            Arrays.setAll(all, i -> all[i] + sums[i]);
            lagLine(Integer.toString(regime), String.format(Locale.ROOT, "%.1f to %.1f", 1000 * least, 1000 * most), sums);
        }
        lagLine("all", "", all);
    }

    private static void lagLine(String name, String truth, double[] sums) {
        double told = sums[0] - sums[1];
        System.out.printf(Locale.ROOT, "| %s | %.0f | %.0f | %s | %.2f | %.2f | %.0f %% |%n", name, sums[0], sums[1], truth,
                1000 * Math.sqrt(sums[2] / told), 1000 * Math.sqrt(sums[3] / told), 100 * sums[4] / told);
    }

    private static Optional<HeadLag.Lag> lag(String words, boolean clean) {
        RigSpec spec = RigSpec.parse(words);
        RigRun run = spec.run();
        double[] row = new double[1 + spec.channels().size()];
        HeadLag lag = new HeadLag(spec.rate(), Thresholds.USUAL.surge(), Double.POSITIVE_INFINITY);
        while (run.read(row)) {
            if (clean) {
                run.ideal(row);
            }
            lag.accept(row[1], row[2]);
        }
        return lag.lag();
    }
}
