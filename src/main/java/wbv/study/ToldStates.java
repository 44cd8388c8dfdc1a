package wbv.study;

import java.util.LinkedHashMap;
import java.util.Map;
import wbv.state.MotionState;
import wbv.state.StateRuns;

/**
 * The motion states of one recording as the shipped model tells them.
 *
 * @param runs what it told
 */
public record ToldStates(StateRuns runs) {

    /**
     * Agreement of the model with the thresholds that name its states, below which it says nothing. On eight simulated rides of four
     * people, accuracy was agreement less 0.01 to 0.04: three in four are right then.
     */
    private static final double LEAST_AGREEMENT = 0.75;

    /** Whether the model fits what it was shown. */
    static boolean fits(StateRuns runs) {
        double told = runs.seconds().values().stream().mapToDouble(Double::doubleValue).sum();
        return runs.agreement() >= LEAST_AGREEMENT && told > runs.silence();
    }

    /** Time of which a state is told [s]. */
    public double all() {
        return runs.seconds().values().stream().mapToDouble(Double::doubleValue).sum();
    }

    /** Time in a state [s]. */
    public double seconds(MotionState state) {
        return runs.seconds().getOrDefault(state, 0.0);
    }

    /** For machines. */
    AnalysisResults.StateFacts facts() {
        Map<String, Double> seconds = new LinkedHashMap<>();
        runs.seconds().forEach((state, time) -> seconds.put(state.toString(), time));
        return new AnalysisResults.StateFacts(seconds, runs.silence(), runs.agreement());
    }
}
