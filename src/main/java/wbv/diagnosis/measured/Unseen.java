package wbv.diagnosis.measured;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * What of a rig's motion answers to nothing that was recorded: what it does in a gap of its input, and after it until that has died down.
 *
 * @param model of the rig
 * @param recording of it
 */
record Unseen(Model model, Recording recording) {

    /** Part of an amplitude that is left when outputs begin to count [1]: less than the sensors' noise is of it. */
    private static final double LEFT = 1e-3;
    /**
     * Part of what was recorded between two gaps that may pass until then [1]: with half as many samples intervals are 1.4 times as wide,
     * and what still rings passes for something that is missing.
     */
    private static final double MOST_SETTLING = 0.5;

    /** Time in which whatever it was doing dies down [s]; none where a stroke holds it, infinite where something goes on as it was sent. */
    static double settling(Model model) {
        return model.driven() ? 0 : -Math.log(LEFT) / model.assembly().structure().slowestDecay();
    }

    /** Samples in which its motion answers to its input. */
    boolean[] driven() {
        List<double[]> inputs = model.excitations().stream().map(recording::values).toList();
        int n = recording.length();
        boolean[] out = new boolean[n];
        Arrays.fill(out, true);
        int[] lost = IntStream.range(0, n).filter(i -> inputs.stream().anyMatch(x -> Double.isNaN(x[i]))).toArray();
        for (int first = 0; first < lost.length;) {
            int last = first;
            while (last + 1 < lost.length && lost[last + 1] == lost[last] + 1) {
                last++;
            }
            if (last - first >= Dropouts.BRIDGED) {
                int next = IntStream.range(last + 1, lost.length).map(i -> lost[i]).findFirst().orElse(n);
                Arrays.fill(out, lost[first], lost[last] + 1 + settled(next - lost[last] - 1), false);
            }
            first = last + 1;
        }
        return out;
    }

    /** Samples after a gap that do not count, of those up to the next; none where nothing ever settles. */
    private int settled(int seen) {
        double wanted = settling(model) * recording.clock().rate();
        return Double.isInfinite(wanted) ? 0 : (int) Math.min(wanted, MOST_SETTLING * seen);
    }
}
