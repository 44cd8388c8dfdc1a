package wbv.diagnosis.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.SmallError;

/**
 * How a rig begins anew after each pause so long that nothing is known of what it did meanwhile, as between two recordings: an encoder may
 * count from elsewhere, and what no spring holds stands anywhere and may move already. Counted among the small errors, since both add to
 * the outputs; how large they are is not known beforehand.
 */
final class Beginnings {

    private Beginnings() {}

    /**
     * One for each output that measures a position and each body that no spring holds, for each pause; none of a person, of driven links or
     * of what was computed.
     *
     * @param excitation of as much of the recording as shapes are asked for
     * @param x of the candidate: coordinates [1], one a knob. Not modified.
     */
    static ErrorShapes of(Evidence evidence, Excitation excitation, Candidate candidate, double[] x) {
        ErrorShapes all = new ErrorShapes(new ArrayList<>(), new ArrayList<>());
        if (!evidence.onRig() || evidence.model().driven() || evidence.measured().computed()) {
            return all;
        }
        boolean[] any = new boolean[evidence.recording().length()];
        for (int o = 0; o < evidence.outputs().size(); o++) {
            boolean[] valid = evidence.valid(o);
            IntStream.range(0, any.length).forEach(i -> any[i] |= valid[i]);
            for (Stretch stretch : isPosition(evidence, o) ? stretches(evidence, valid) : List.<Stretch>of()) {
                all.addStart(o, zero(evidence, excitation, o, stretch));
            }
        }
        Assembly assembly = candidate.at(x);
        boolean[] unheld = assembly.structure().unheld();
        for (int body = 0; body < unheld.length; body++) {
            for (Stretch stretch : unheld[body] ? stretches(evidence, any) : List.<Stretch>of()) {
                all.addStart(SmallError.INPUT, moving(evidence, excitation, assembly, body, stretch));
            }
        }
        return all;
    }

    /**
     * What lies between two pauses, or after the last.
     *
     * @param from first sample
     * @param to sample after the last
     */
    private record Stretch(int from, int to) {

        /** A series that is nothing elsewhere. Modified, and returned. */
        double[] alone(double[] series) {
            Arrays.fill(series, 0, Math.min(from, series.length), 0);
            Arrays.fill(series, Math.min(to, series.length), series.length, 0);
            return series;
        }
    }

    /** All but the first, of which the model itself tells how it begins. */
    private static List<Stretch> stretches(Evidence evidence, boolean[] valid) {
        int pause = (int) Math.round(Excitation.PAUSE * evidence.recording().clock().rate());
        int[] known = IntStream.range(0, valid.length).filter(i -> valid[i]).toArray();
        int[] starts = IntStream.range(1, known.length).filter(k -> known[k] - known[k - 1] > pause).map(k -> known[k]).toArray();
        return IntStream.range(0, starts.length).mapToObj(k -> new Stretch(starts[k], k + 1 < starts.length ? starts[k + 1] : valid.length))
                .toList();
    }

    private static double[][] zero(Evidence evidence, Excitation excitation, int output, Stretch stretch) {
        double[][] out = new double[evidence.outputs().size()][0];
        out[output] = new double[excitation.samples()];
        Arrays.fill(out[output], Baseline.ANYHOW * Motion.rms(evidence.measured(output), evidence.fit().length()));
        stretch.alone(out[output]);
        return out;
    }

    /** What outputs read of a body that is struck at a sample, where the model moves as at the coordinates. */
    private static double[][] moving(Evidence evidence, Excitation excitation, Assembly assembly, int body, Stretch stretch) {
        double[] blow = new double[excitation.samples()];
        if (stretch.from() < blow.length) {
            blow[stretch.from()] = Baseline.ANYHOW * assembly.structure().mass()[body] * Baseline.speed(evidence) * excitation.rate();
        }
        double[][] answer = new Simulator(excitation).linearised(assembly).answerOn(body, excitation.spectrum(blow));
        // A blow that has no more lines than an excitation rings before it too.
        return Arrays.stream(answer).map(excitation::series).map(stretch::alone).toArray(double[][]::new);
    }

    private static boolean isPosition(Evidence evidence, int output) {
        return evidence.model().assembly().outputs().get(output).reading() == Assembly.Reading.POSITION;
    }
}
