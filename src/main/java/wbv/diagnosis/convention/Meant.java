package wbv.diagnosis.convention;

import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.Recording;

/**
 * How a recording and a model are meant.
 *
 * @param model     makes of a model the one that is meant
 * @param recording as it is meant
 * @param sentence  that says what was done, why, and what the user does about it
 */
public record Meant(UnaryOperator<Model> model, Recording recording, String sentence) {

    /** Without sensors that carry nothing. */
    static Meant without(List<Channel> silent, Recording recording) {
        boolean one = silent.size() == 1;
        String names = silent.stream().map(Channel::toString).collect(Collectors.joining(" and "));
        return new Meant(
                model -> model.seenBy(model.outputs().stream().filter(output -> !silent.contains(output)).toList()), recording,
                String.format(
                        "%s %s nothing of the motion: no more of %s goes with any other channel than chance gives; %s noise alone, and "
                                + "%s left out; see to the %s, or take %s out of the model.",
                        names, one ? "carries" : "carry",
                        one ? "it" : "them", one ? "it is" : "they are", one ? "was" : "were", one ? "sensor" : "sensors",
                        one ? "it" : "them"));
    }
}
