package wbv.diagnosis;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Assembly;
import wbv.body.LawAt;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.fit.Evidence;
import wbv.diagnosis.fit.Fitter;

/**
 * What the laws that were found do in their links, run free from the recording's start. Arrays are not copied: treat them as read-only.
 *
 * @param time    by sample [s]
 * @param newtons by link, positive where the force pulls its ends together
 */
public record FoundForces(double[] time, Map<String, double[]> newtons) {

    /** Empty where no law was found, or the run leaves all bounds. */
    static Optional<FoundForces> of(Diagnosis diagnosis, Evidence evidence, Fitter.State base, Fitter.State chosen) {
        Assembly assembly = chosen.candidate().at(chosen.x());
        List<LawAt> laws = assembly.laws();
        // Behind the model's own links hang hidden masses.
        int[] found = IntStream.range(base.candidate().template().laws().size(), laws.size())
                .filter(i -> laws.get(i).link() < evidence.model().links().size()).toArray();
        if (found.length == 0) {
            return Optional.empty();
        }
        Excitation whole = Excitation.of(diagnosis.model(), evidence.recording(), evidence.recording().length());
        Simulator.Response response = new Simulator(whole).run(assembly, false);
        if (response.diverged()) {
            return Optional.empty();
        }
        Map<String, double[]> newtons = new LinkedHashMap<>();
        for (int i : found) {
            double[] force = whole.series(response.forces()[i]);
            double[] sum = newtons.computeIfAbsent(evidence.model().links().get(laws.get(i).link()).name(),
                    link -> new double[force.length]);
            Arrays.setAll(sum, s -> sum[s] + force[s]);
        }
        double[] time = new double[evidence.recording().length()];
        Arrays.setAll(time, evidence.recording()::time);
        return Optional.of(new FoundForces(time, newtons));
    }
}
