package wbv.report.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import wbv.report.page.ChartAxis;
import wbv.report.page.Gauge;
import wbv.report.page.LineChart;
import wbv.report.page.Series;
import wbv.report.page.Tiles;
import wbv.result.Digits;
import wbv.state.MotionState;
import wbv.state.StateRuns;
import wbv.study.ToldStates;

/** The motion states of one recording in a tile and over time, as the shipped model tells them. */
final class StateTile {

    private final ToldStates told;
    private final StateRuns runs;

    StateTile(ToldStates told) {
        this.told = told;
        this.runs = told.runs();
    }

    Tiles.Tile tile() {
        double all = told.all() + runs.silence();
        double jerks = Arrays.stream(MotionState.values()).filter(MotionState::jerk).mapToDouble(told::seconds).sum();
        Map<String, Double> kinds = new LinkedHashMap<>();
        List.of(MotionState.IDLE, MotionState.RIDING, MotionState.ROCKING)
                .forEach(state -> kinds.put(state.toString(), told.seconds(state)));
        kinds.put("jerking", jerks);
        List<Gauge.Range> ranges = new ArrayList<>();
        double edge = 0;
        for (Map.Entry<String, Double> kind : kinds.entrySet()) {
            double share = 100 * kind.getValue() / all;
            ranges.add(new Gauge.Range(edge, edge + share, kind.getKey(), percent(share) + " " + kind.getKey()));
            edge += share;
        }
        String most = Collections.max(kinds.entrySet(), Map.Entry.comparingByValue()).getKey();
        String others = kinds.entrySet().stream().filter(kind -> !kind.getKey().equals(most) && kind.getValue() > 0)
                .map(kind -> kind.getKey() + " " + percent(100 * kind.getValue() / all)).collect(Collectors.joining(", "));
        long bouts = runs.runs().stream().filter(run -> run.state().map(MotionState::jerk).orElse(false)).count();
        List<String> lines = new ArrayList<>();
        lines.add(bouts == 0 ? String.format(Locale.ROOT, "No jerk beyond %.0f\u00a0m/s³.", runs.model().thresholds().jerk())
                : String.format(Locale.ROOT, "%d jerk%s beyond %.0f\u00a0m/s³, %s\u00a0s of them.", bouts, bouts == 1 ? "" : "s",
                        runs.model().thresholds().jerk(), Digits.significant(jerks, 2)));
        if (!others.isEmpty()) {
            lines.add(BodyTile.capital(others) + ".");
        }
        if (runs.silence() >= 0.02 * all) {
            lines.add("Untold: " + percent(100 * runs.silence() / all) + ", unlike the simulated rides that the model learned from.");
        } else {
            lines.add("By a model trained on simulated rides.");
        }
        return new Tiles.Tile("Motion states", percent(100 * kinds.get(most) / all), most, new Gauge(0, 100, ranges, List.of(),
                List.of()), lines, Tiles.Tone.PLAIN);
    }

    private static String percent(double share) {
        return (share > 0 && share < 0.95 ? Digits.significant(share, 1) : Digits.rounded(share, 0)) + "\u00a0%";
    }

    /**
     * The states over time, one line a state.
     *
     * @param start time of the first sample [s]
     */
    LineChart chart(double start) {
        List<MotionState> met = Arrays.stream(MotionState.values()).filter(state -> told.seconds(state) > 0).toList();
        double rate = runs.model().features().rate();
        List<Series> strips = new ArrayList<>();
        for (int k = 0; k < met.size(); k++) {
            MotionState state = met.get(k);
            List<StateRuns.Run> own = runs.runs().stream().filter(run -> run.state().equals(Optional.of(state))).toList();
            double[] x = new double[3 * own.size()];
            double[] y = new double[x.length];
            for (int i = 0; i < own.size(); i++) {
                x[3 * i] = start + own.get(i).from() / rate;
                x[3 * i + 1] = start + own.get(i).to() / rate;
                x[3 * i + 2] = x[3 * i + 1];
                y[3 * i] = met.size() - k;
                y[3 * i + 1] = met.size() - k;
                y[3 * i + 2] = Double.NaN;
            }
            strips.add(Series.strip(state.toString(), x, y));
        }
        List<String> names = new ArrayList<>(met.stream().map(MotionState::toString).toList());
        Collections.reverse(names);
        List<LineChart.Shade> untold = runs.runs().stream().filter(run -> run.state().isEmpty()).map(run -> new LineChart.Shade(
                start + run.from() / rate, start + run.to() / rate, "unlike what the model learned")).toList();
        return new LineChart("Motion state", ChartAxis.linear("Time", "s"), ChartAxis.named(names), strips).shaded(untold);
    }

    /** How the states are told, in a sentence. */
    String way() {
        return "States from " + runs.model().features().seat() + ", " + runs.model().features().head() + " and the seat's roll and pitch"
                + " rate, each from what had come until then; the model that ships with wbv"
                + " learned them from simulated rides (" + String.join(", ", runs.model().trials()) + "). Of each sample by itself its"
                + " thresholds say the same in " + Digits.rounded(100 * runs.agreement(), 0) + " %.";
    }
}
