package wbv.diagnosis.convention;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import wbv.body.Model;
import wbv.diagnosis.measured.Coherence;
import wbv.diagnosis.measured.Measured;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * What no linear model explains of what its sensors measured, whatever its numbers: what does not go with what moves it (Bendat and
 * Piersol, Random Data, 2010, section 6.1.4). A sign or a unit changes nothing of that.
 */
final class Incoherence {

    /** Samples of a segment, an effort: eight seconds of a person, thirty periods of a bench at 16 samples each: what rings is heard. */
    private static final int SEGMENT = 512;
    /** Of what is integrated the slow drift goes with nothing in a segment. */
    private static final Set<Quantity> STEADY = Set.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE, Quantity.FORCE);

    private final Model model;
    private final Recording recording;
    private final Map<Set<Channel>, Double> known = new ConcurrentHashMap<>();

    Incoherence(Model model, Recording recording) {
        this.model = model;
        this.recording = recording;
    }

    /**
     * The least part of what some outputs measured that is left, their mean [1]; 0 where that is not known, as of several inputs at once.
     *
     * @param convention as which all is read
     */
    double least(Convention convention, List<Channel> outputs) {
        return model.excitations().size() > 1 ? 0
                : outputs.stream().mapToDouble(
                        output -> least(convention.source(model.excitations().get(0)), convention.source(output))).average().orElse(0);
    }

    private double least(Channel input, Channel output) {
        return known.computeIfAbsent(Set.of(input, output), any -> {
            boolean told = List.of(input, output).stream().allMatch(channel -> STEADY.contains(channel.quantity())
                    && Arrays.stream(recording.values(channel)).noneMatch(Double::isNaN));
            Coherence shared = told ? Coherence.of(recording.clock().rate(), Measured.centred(recording.values(input)),
                    Measured.centred(recording.values(output)), Coherence.Weight.OUTPUT, SEGMENT) : Coherence.NONE;
            return shared == Coherence.NONE ? 0 : Math.max(0, 1 - shared.share() - shared.sure());
        });
    }
}
