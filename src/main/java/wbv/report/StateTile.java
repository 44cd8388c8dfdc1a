package wbv.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import wbv.state.MotionState;
import wbv.state.StateRuns;

/** The motion states of one recording in a tile and over time, as the shipped model tells them. */
final class StateTile {

    /**
     * Agreement of the model with the thresholds that name its states, below which it says nothing. On eight simulated rides of four
     * people, accuracy was agreement less 0.01 to 0.04: three in four are right then.
     */
    static final double LEAST_AGREEMENT = 0.75;

    private final StateRuns runs;

    StateTile(StateRuns runs) {
        this.runs = runs;
    }

    /** Whether the model fits what it was shown. */
    static boolean fits(StateRuns runs) {
        double told = runs.seconds().values().stream().mapToDouble(Double::doubleValue).sum();
        return runs.agreement() >= LEAST_AGREEMENT && told > runs.silence();
    }

    private double whole() {
        return runs.seconds().values().stream().mapToDouble(Double::doubleValue).sum();
    }

    private double seconds(MotionState state) {
        return runs.seconds().getOrDefault(state, 0.0);
    }

    private double jerking() {
        return Arrays.stream(MotionState.values()).filter(MotionState::jerk).mapToDouble(this::seconds).sum();
    }

    Tiles.Tile tile() {
        double all = whole();
        double jerks = jerking();
        List<Gauge.Range> ranges = new ArrayList<>();
        List<String> words = new ArrayList<>();
        double edge = 0;
        for (MotionState state : List.of(MotionState.IDLE, MotionState.RIDING, MotionState.ROCKING)) {
            double share = 100 * seconds(state) / all;
            ranges.add(new Gauge.Range(edge, edge + share, state.toString(), percent(share) + " " + state));
            words.add(state + " " + percent(share));
            edge += share;
        }
        ranges.add(new Gauge.Range(edge, 100, "jerking", percent(100 * jerks / all) + " jerks"));
        long bouts = runs.runs().stream().filter(run -> run.state().map(MotionState::jerk).orElse(false)).count();
        MotionState most = Collections.max(runs.seconds().entrySet(), Map.Entry.comparingByValue()).getKey();
        double share = most.jerk() ? 100 * jerks / all : 100 * seconds(most) / all;
        return new Tiles.Tile("Motion states", percent(share), most.jerk() ? "jerks" : most.toString(),
                new Gauge(0, 100, ranges, List.of(), List.of()),
                lines(jerks, bouts, words), Tiles.Tone.PLAIN);
    }

    private List<String> lines(double jerks, long bouts, List<String> words) {
        List<String> lines = new ArrayList<>(List.of(String.format(Locale.ROOT, "Jerks beyond %.0f m/s³ for %s s, %d times.", runs.model().thresholds().jerk(),
                Digits.significant(jerks, 2), bouts), BodyTile.capital(String.join(", ", words)) + ".",
                String.format(Locale.ROOT, "By a model trained on simulated rides; %.0f %% as its thresholds alone would say.",
                        100 * runs.agreement())));
        if (runs.silence() >= 0.05 * whole()) {
            lines.add("Nothing is told of " + Digits.significant(runs.silence(), 2) + " s unlike what it learned.");
        }
        return lines;
    }

    private static String percent(double share) {
        return (share > 0 && share < 0.95 ? Digits.significant(share, 1) : Digits.rounded(share, 0)) + "\u00a0%";
    }

    /** The states over time, one line a state. @param start time of the first sample [s] */
    LineChart chart(double start) {
        List<MotionState> met = Arrays.stream(MotionState.values()).filter(state -> seconds(state) > 0).toList();
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
        return new LineChart("State", Axis.linear("Time", "s"), Axis.named(names), strips);
    }

    /** How the states are told, in a sentence. */
    String way() {
        return "States from " + runs.model().features().seat() + ", " + runs.model().features().head() + " and the seat's roll and pitch"
                + " rate, each from what had come until then; the model that ships with wbv"
                + " learned them from simulated rides (" + String.join(", ", runs.model().trials()) + ").";
    }
}
