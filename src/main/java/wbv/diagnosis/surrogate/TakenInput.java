package wbv.diagnosis.surrogate;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import wbv.body.Model;
import wbv.diagnosis.measured.AccelerationUnit;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Recording;

/**
 * How a simulation took its input: as it was recorded, or held over each sample. Which of them it was shows in what the measured bodies in
 * a chain, driven by it, miss of the outputs.
 *
 * @param driven the input as it was taken, and the outputs
 * @param plain  the measured bodies in a chain, and no more
 * @param held   whether it was held over each sample
 */
record TakenInput(Recording driven, FittedChain plain, boolean held) {

    /** What is missed beyond this may be the unit's fault, or that of an input held over each sample. */
    private static final double DOUBTFUL = 0.025;
    /** Units of acceleration that simulations are saved in beside m/s², in that. */
    private static final List<Map.Entry<String, Double>> UNITS = List.of(Map.entry("g", AccelerationUnit.GRAVITY),
            Map.entry("mg", AccelerationUnit.GRAVITY / 1000));

    /**
     * The input of a simulation.
     *
     * @param recorded the input, and the outputs that it drove
     * @param subject that is simulated
     * @throws DataFault if the outputs look to be in another unit than the input
     */
    static TakenInput of(Recording recorded, Channel input, List<Channel> outputs, Model.Subject subject) {
        TakenInput asRecorded = taken(recorded, input, outputs, subject, false);
        return asRecorded.plain.worst() > DOUBTFUL ? asRecorded.doubted(input, outputs, subject) : asRecorded;
    }

    private static TakenInput taken(Recording driven, Channel input, List<Channel> outputs, Model.Subject subject, boolean held) {
        return new TakenInput(driven, new ChainSearch(driven, input, outputs, subject).plain(), held);
    }

    private TakenInput doubted(Channel input, List<Channel> outputs, Model.Subject subject) {
        double[] values = driven.values(input);
        for (Map.Entry<String, Double> unit : UNITS) {
            double[] scaled = Arrays.stream(values).map(value -> value / unit.getValue()).toArray();
            if (taken(with(input, scaled), input, outputs, subject, false).plain.worst() < Math.min(Surrogate.MOST, plain.worst() / 2)) {
                throw new DataFault("looks to be in " + unit.getKey() + ", the recording in m/s2; save it in m/s2");
            }
        }
        TakenInput steps = taken(with(input, ZeroOrderHold.of(values, driven.clock().rate())), input, outputs, subject, true);
        return steps.plain.worst() < plain.worst() / 2 ? steps : this;
    }

    private Recording with(Channel input, double[] values) {
        Map<Channel, double[]> all = new LinkedHashMap<>();
        driven.channels().forEach(each -> all.put(each, each.equals(input) ? values : driven.values(each)));
        return driven.with(all);
    }
}
