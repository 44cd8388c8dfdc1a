package wbv.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;
import wbv.diagnosis.fit.Readings;
import wbv.diagnosis.fit.Window;
import wbv.recording.Channel;
import wbv.signal.LostSamples;

/**
 * The data held out beside what the last model makes of them: what the errors of {@link Diagnosis.Fit#channels} are errors of. The root
 * mean square of {@code recorded - read} over that of {@code recorded}, samples that do not count left out, is
 * {@link Diagnosis.Fit#nrmseAfter}. Arrays are not copied: treat them as read-only.
 *
 * @param time     by sample [s]: the recording's clock, or the slower one to which a fast recording was brought
 * @param recorded by output and sample, in its unit, without its mean over the whole recording where constants do not count; NaN where it
 *                 does not count
 * @param model    likewise, the model alone, run free from the recording's start; of a surrogate, with what the simulation gave beside it
 * @param read     likewise, the same as its sensors read it, with the small errors that were found on the data of the fit
 */
public record Predicted(double[] time, List<Channel> outputs, double[][] recorded, double[][] model, double[][] read) {

    static Predicted of(Diagnosis diagnosis, Evidence evidence, Fitter.State chosen) {
        Window held = evidence.heldOut();
        double[] time = new double[held.length()];
        Arrays.setAll(time, i -> evidence.recording().time(held.start() + i));
        Excitation whole = Excitation.of(diagnosis.model(), evidence.recording(), evidence.recording().length());
        double[][] model = new Simulator(whole).outputs(diagnosis.model().assembly());
        double[][] read = new Readings(evidence).of(chosen);
        double[][] recorded = IntStream.range(0, read.length).mapToObj(o -> LostSamples.marked(evidence.measured(o), evidence.valid(o)))
                .toArray(double[][]::new);
        return new Predicted(time, evidence.outputs(), part(recorded, held), part(model, held), part(read, held));
    }

    /**
     * The same on a clock that began later.
     *
     * @param seconds how much [s]
     */
    public Predicted earlier(double seconds) {
        return new Predicted(Arrays.stream(time).map(t -> t - seconds).toArray(), outputs, recorded, model, read);
    }

    private static double[][] part(double[][] series, Window held) {
        return Arrays.stream(series).map(y -> Arrays.copyOfRange(y, held.start(), held.start() + held.length())).toArray(double[][]::new);
    }
}
