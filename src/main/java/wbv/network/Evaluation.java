package wbv.network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import wbv.filter.Method;
import wbv.filter.drift.Alarm;

/**
 * Networks and their peers on the same trials, none of which a network has seen.
 *
 * @param bodies  what the trials were drawn from
 * @param trials  the trials
 * @param rows    one for each method
 */
public record Evaluation(Bodies bodies, List<LabelledMotion> trials, List<Row> rows) {

    /**
     * A method.
     *
     * @param method    its name
     * @param scores    by target; means over networks trained from other seeds
     * @param spread    standard deviation of the standardised error [1] over those, by target; NaN for one
     * @param unlike    share of trials that it found unlike any trained on; NaN where it does not say
     * @param estimates trial by trial, of the first of those
     */
    public record Row(String method, List<Score> scores, double[] spread, double unlike, List<Estimate> estimates) {}

    public Evaluation {
        rows = List.copyOf(rows);
    }

    /**
     * Asks all.
     *
     * @param models networks of the same modes; those that differ in their seed alone make one row
     * @param ridges by name; may be empty
     * @param alarms for the streaming estimators
     */
    public static Evaluation of(Bodies bodies, List<LabelledMotion> trials, List<TrainedNetwork> models, Map<String, Ridge> ridges,
            Supplier<? extends Alarm> alarms) {
        Asked asked = new Asked(bodies, trials, models.get(0).scaling());
        List<Row> rows = new ArrayList<>();
        Map<String, List<List<Reading>>> readings = new LinkedHashMap<>();
        for (TrainedNetwork model : models) {
            String together = model.members().size() == 1 ? "" : ", " + model.members().size() + " together";
            readings.computeIfAbsent(label(model) + together, name -> new ArrayList<>()).add(read(model, trials));
        }
        readings.forEach((name, seeds) -> {
            rows.add(asked.row(name, seeds, Reading::network));
            if (!seeds.get(0).isEmpty() && Double.isFinite(seeds.get(0).get(0).misfit())) {
                rows.add(asked.row(name + ", then fitted", seeds, Reading::fitted));
            }
        });
        Map<String, Function<LabelledMotion, Estimate>> peers = new LinkedHashMap<>();
        ridges.forEach((name, ridge) -> peers.put(name, trial -> ridge.read(trial.motion())));
        if (bodies.modes() == 1 && models.stream().anyMatch(model -> !model.architecture().excited())) {
            peers.put("spectrum of the answer alone", trial -> Peers.spectrum(trial.motion()[1]));
        }
        peers.put("fit in frequency", trial -> Peers.fit(vertical(trial), bodies.modes()));
        Estimate all = new Estimate(models.get(0).scaling().mean(), models.get(0).scaling().deviation());
        peers.put("fit in frequency, from the mean of all", trial -> Peers.fit(vertical(trial), all));
        peers.put("refined instruments", trial -> Peers.instruments(trial.motion(), bodies.modes()));
        for (Method method : List.of(Method.EKF_ADWIN, Method.FUSED)) {
            peers.put(method.word(), trial -> Peers.stream(vertical(trial), bodies.modes(), method, alarms));
        }
        if (bodies.channels().size() > 2) {
            peers.put("fit in frequency, three axes", trial -> Peers.fit(trial.motion(), bodies.modes()));
            peers.put("ekf-adwin, --cross", trial -> Peers.stream(trial.motion(), bodies.modes(), Method.EKF_ADWIN, alarms));
            peers.put("fused, --cross", trial -> Peers.stream(trial.motion(), bodies.modes(), Method.FUSED, alarms));
        }
        double[] unknown = new double[2 * bodies.modes()];
        Arrays.fill(unknown, Double.NaN);
        peers.put("the mean of all", trial -> new Estimate(models.get(0).scaling().mean(), unknown));
        peers.forEach((name, peer) -> rows.add(asked.row(name, trials.stream().map(peer).toList())));
        return new Evaluation(bodies, trials, rows);
    }

    /** Excitation and answer, without what else moves the base. */
    private static double[][] vertical(LabelledMotion trial) {
        return Arrays.copyOf(trial.motion(), 2);
    }

    /** What models that differ in their seed alone have in common. */
    private static String label(TrainedNetwork model) {
        String bodies = model.card().getOrDefault("bodies", "");
        return model.architecture().word() + ", " + model.card().getOrDefault("images", "?") + " images"
                + (List.of(Bodies.COUPLED.word(), "recordings").contains(bodies) ? " of " + bodies : "");
    }

    private static List<Reading> read(TrainedNetwork model, List<LabelledMotion> trials) {
        try (Reader reader = new Reader(model)) {
            return reader.readAll(trials.stream().map(LabelledMotion::motion).toList());
        }
    }

    /** The trials that all are asked about. */
    private record Asked(Bodies bodies, List<LabelledMotion> trials, Scaling scaling) {

        /** A row of networks that differ in their seed. */
        Row row(String name, List<List<Reading>> seeds, Function<Reading, Estimate> what) {
            List<List<Estimate>> estimates = seeds.stream().map(each -> each.stream().map(what).toList()).toList();
            List<List<Score>> bySeed = estimates.stream().map(this::scores).toList();
            int targets = 2 * bodies.modes();
            double[] spread = new double[targets];
            List<Score> mean = new ArrayList<>();
            for (int j = 0; j < targets; j++) {
                int target = j;
                List<Score> scores = bySeed.stream().map(each -> each.get(target)).toList();
                double average = mean(scores, Score::standardised);
                double squares = scores.stream().mapToDouble(each -> Math.pow(each.standardised() - average, 2)).sum();
                spread[j] = scores.size() == 1 ? Double.NaN : Math.sqrt(squares / (scores.size() - 1));
                mean.add(new Score(scores.get(0).count(), scores.get(0).missing(), mean(scores, Score::rmse),
                        mean(scores, Score::deviation), average, mean(scores, Score::covered), mean(scores, Score::stated)));
            }
            double unlike = seeds.stream().flatMap(List::stream)
                    .mapToDouble(each -> Double.isNaN(each.misfit()) ? Double.NaN : each.unlike() ? 1 : 0).average().orElse(0);
            String of = seeds.size() == 1 ? "" : " (" + seeds.size() + " seeds)";
            return new Row(name + of, mean, spread, unlike, estimates.get(0));
        }

        Row row(String name, List<Estimate> estimates) {
            double[] none = new double[2 * bodies.modes()];
            Arrays.fill(none, Double.NaN);
            return new Row(name, scores(estimates), none, Double.NaN, estimates);
        }

        private List<Score> scores(List<Estimate> estimates) {
            List<Score> scores = new ArrayList<>();
            for (int j = 0; j < 2 * bodies.modes(); j++) {
                scores.add(Score.of(j, trials, estimates, scaling.mean()[j], scaling.deviation()[j]));
            }
            return scores;
        }

        private static double mean(List<Score> scores, ToDoubleFunction<Score> what) {
            return scores.stream().mapToDouble(what).average().orElseThrow();
        }
    }
}
