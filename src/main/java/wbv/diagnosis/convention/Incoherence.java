package wbv.diagnosis.convention;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import wbv.body.Model;
import wbv.diagnosis.measured.Coherence;
import wbv.diagnosis.measured.Measured;
import wbv.diagnosis.search.Priors;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/**
 * What no linear model explains of what its sensors measured, whatever its numbers: what does not go with what moves it (Bendat and
 * Piersol, Random Data, 2010, section 6.1.4). A sign or a unit changes nothing of that.
 *
 * <p>What rings on beyond a segment goes with nothing inside it. Of a mode that dies down with a time constant τ the product of a segment
 * of T under a Hann window w and of what it was τ later is less by 1 - (∫w'²/∫w²) τ²/2, where ∫w'²/∫w² = 4π²/(3T²); of an exponential
 * decay, the mean of whose squared ages is 2τ², the coherence at its resonance is less by (4π²/3)(τ/T)².
 */
final class Incoherence {

    /** Samples of a segment, an effort: eight seconds of a person. */
    private static final int SEGMENT = 512;
    /** Times as long as the model's numbers say a mode may ring [1]: two standard deviations of a damping that a user gives. */
    private static final double LONGER = Math.exp(2 * Priors.NUMBER_DEVIATION);
    /** Of what is integrated the slow drift goes with nothing in a segment. */
    private static final Set<Quantity> STEADY = Set.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE, Quantity.FORCE);

    private final Model model;
    private final Recording recording;
    private final Map<List<Channel>, Double> known = new ConcurrentHashMap<>();

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
        if (model.excitations().size() > 1) {
            return 0;
        }
        double beyond = beyond(convention.read(model));
        return outputs.stream().mapToDouble(output -> Math.max(0,
                least(convention.source(model.excitations().get(0)), convention.source(output)) - beyond)).average().orElse(0);
    }

    /** The part that rings on beyond a segment, at most [1]. */
    private double beyond(Model meant) {
        double rate = recording.clock().rate();
        double segment = Coherence.segment(rate, recording.length(), SEGMENT) / rate;
        return 4 * Math.PI * Math.PI / 3 * Math.pow(LONGER / meant.assembly().structure().slowestDecay() / segment, 2);
    }

    private double least(Channel input, Channel output) {
        return known.computeIfAbsent(List.of(input, output), any -> {
            boolean told = List.of(input, output).stream().allMatch(channel -> STEADY.contains(channel.quantity())
                    && Arrays.stream(recording.values(channel)).noneMatch(Double::isNaN));
            Coherence shared = told ? Coherence.of(recording.clock().rate(), Measured.centred(recording.values(input)),
                    Measured.centred(recording.values(output)), Coherence.Weight.OUTPUT, SEGMENT) : Coherence.NONE;
            return shared == Coherence.NONE ? 0 : 1 - shared.share() - shared.sure();
        });
    }
}
