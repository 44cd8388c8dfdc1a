package wbv.network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import wbv.filter.Alarm;
import wbv.filter.Method;

/**
 * Networks and their peers on the same trials, none of which a network has seen.
 *
 * @param bodies  what the trials were drawn from
 * @param trials  the trials
 * @param rows    one for each method
 */
public record Evaluation(Bodies bodies, List<Trial> trials, List<Row> rows) {

    /**
     * A method.
     *
     * @param method    its name
     * @param scores    by target
     * @param spread    standard deviation of the standardised error over members trained from other seeds, by target; NaN for one
     * @param estimates trial by trial
     */
    public record Row(String method, List<Score> scores, double[] spread, List<Estimate> estimates) { }

    public Evaluation {
        rows = List.copyOf(rows);
    }

    /**
     * Asks all.
     *
     * @param models networks of the same modes, each on its own and, where it has several members, by member
     * @param ridges by name; may be empty
     * @param alarms for the streaming estimators
     */
    public static Evaluation of(Bodies bodies, List<Trial> trials, List<Model> models, Map<String, Ridge> ridges,
                                Supplier<? extends Alarm> alarms) {
        Scaling scaling = models.get(0).scaling();
        List<Row> rows = new ArrayList<>();
        for (Model model : models) {
            List<Estimate> estimates = ask(model, trials);
            List<List<Score>> byMember = new ArrayList<>();
            for (int i = 0; i < model.members().size() && model.members().size() > 1; i++) {
                byMember.add(scores(bodies, trials, ask(model.member(i), trials), scaling));
            }
            double[] spread = new double[2 * bodies.modes()];
            if (!byMember.isEmpty()) {
                List<Score> mean = new ArrayList<>();
                for (int j = 0; j < spread.length; j++) {
                    int target = j;
                    double[] each = byMember.stream().mapToDouble(scores -> scores.get(target).standardised()).toArray();
                    double average = Arrays.stream(each).average().orElseThrow();
                    spread[j] = Math.sqrt(Arrays.stream(each).map(e -> (e - average) * (e - average)).sum() / (each.length - 1));
                    mean.add(mean(byMember.stream().map(scores -> scores.get(target)).toList()));
                }
                rows.add(new Row(model.architecture().word() + ", one of " + byMember.size() + " seeds", mean, spread,
                        List.of()));
            }
            rows.add(row(model.architecture().word() + (byMember.isEmpty() ? "" : ", " + byMember.size() + " together"), bodies,
                    trials, estimates, scaling));
        }
        Map<String, List<Estimate>> peers = new LinkedHashMap<>();
        ridges.forEach((name, ridge) -> peers.put(name, trials.stream().map(trial -> ridge.read(trial.motion())).toList()));
        peers.put("refined instruments", trials.stream().map(trial -> Peers.instruments(trial.motion(),
                bodies.modes())).toList());
        for (Method method : List.of(Method.EKF_ADWIN, Method.FUSED)) {
            peers.put(method.word(), trials.stream()
                    .map(trial -> Peers.stream(trial.motion(), bodies.modes(), method, alarms)).toList());
        }
        double[] unknown = new double[2 * bodies.modes()];
        Arrays.fill(unknown, Double.NaN);
        peers.put("the mean of all", trials.stream().map(trial -> new Estimate(scaling.mean(), unknown)).toList());
        peers.forEach((name, estimates) -> rows.add(row(name, bodies, trials, estimates, scaling)));
        return new Evaluation(bodies, trials, rows);
    }

    private static List<Estimate> ask(Model model, List<Trial> trials) {
        try (Reader reader = new Reader(model)) {
            return reader.readAll(trials.stream().map(Trial::motion).toList());
        }
    }

    private static Row row(String name, Bodies bodies, List<Trial> trials, List<Estimate> estimates, Scaling scaling) {
        double[] none = new double[2 * bodies.modes()];
        Arrays.fill(none, Double.NaN);
        return new Row(name, scores(bodies, trials, estimates, scaling), none, estimates);
    }

    private static List<Score> scores(Bodies bodies, List<Trial> trials, List<Estimate> estimates, Scaling scaling) {
        List<Score> scores = new ArrayList<>();
        for (int j = 0; j < 2 * bodies.modes(); j++) {
            scores.add(Score.of(j, trials, estimates, scaling.mean()[j], scaling.deviation()[j]));
        }
        return scores;
    }

    private static Score mean(List<Score> scores) {
        return new Score(scores.get(0).count(), scores.get(0).missing(), mean(scores, Score::rmse), mean(scores,
                Score::deviation),
                mean(scores, Score::standardised), mean(scores, Score::covered), mean(scores, Score::stated));
    }

    private static double mean(List<Score> scores, ToDoubleFunction<Score> what) {
        return scores.stream().mapToDouble(what).average().orElseThrow();
    }
}
