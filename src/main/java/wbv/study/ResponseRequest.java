package wbv.study;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import wbv.body.Model;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.inspect.RowSource;
import wbv.sensing.SkinMount;

/**
 * What frequency responses are asked for.
 *
 * @param source     the recording
 * @param title      what the report calls it
 * @param people     recordings of further people, to be averaged with the first, by title
 * @param inputs     channels that act at once; none to choose the platform's, else the seat's
 * @param outputs    channels that answer; none to take all others of the inputs' quantities, and forces, along their axes
 * @param segment    length of a segment [s]; empty to choose
 * @param level      confidence of the bands, such as 0.95
 * @param model      what to draw over the responses
 * @param plate      mass between load cell and sitter, to be taken off apparent masses [kg]
 * @param wavelet    whether the response is followed through time, from one input
 * @param skin       skin under the sensors, by location
 * @param map        column map that the source was read with, for the task string
 * @param provenance what the report says of its own making, by name
 */
public record ResponseRequest(RowSource source, String title, Map<String, RowSource> people, List<Channel> inputs,
        List<Channel> outputs, OptionalDouble segment, double level, Optional<Model> model, double plate, boolean wavelet,
        Map<String, SkinMount> skin, Optional<java.nio.file.Path> map, Map<String, String> provenance) {

    public ResponseRequest {
        if (!(level > 0 && level < 1)) {
            throw new IllegalArgumentException("level of confidence must be between 0 and 1: " + level);
        }
        if (!(plate >= 0) || Double.isInfinite(plate)) {
            throw new IllegalArgumentException("mass of the plate must be >= 0 kg: " + plate);
        }
        if (wavelet && inputs.size() > 1) {
            throw new IllegalArgumentException("a response is followed through time from one input, not from " + inputs);
        }
        inputs = List.copyOf(inputs);
        outputs = List.copyOf(outputs);
    }

    /**
     * The inputs among the channels of a recording.
     *
     * @throws DataFault if none can be chosen, or one is named twice
     */
    List<Channel> chooseInputs(List<Channel> channels, String name) {
        List<Channel> chosen = inputs.isEmpty() ? List.of(new AnalysisRequest(source, title, map, List.of(), List.of(), 5, 0.4,
                provenance).chooseInput(channels, name)) : inputs;
        if (chosen.stream().distinct().count() < chosen.size()) {
            throw new DataFault("an input is named twice: " + chosen);
        }
        return chosen;
    }

    /** The outputs among the channels of a recording, in its order. */
    List<Channel> chooseOutputs(List<Channel> channels, List<Channel> chosen, String name) {
        List<Channel> found = outputs.isEmpty() ? channels.stream().filter(channel -> !chosen.contains(channel)
                && chosen.stream().anyMatch(input -> input.axis() == channel.axis()
                        && (input.quantity() == channel.quantity() || channel.quantity() == Quantity.FORCE)))
                .toList() : outputs;
        if (found.isEmpty()) {
            throw DataFault.in(name, "has no other channel along the axis of " + chosen
                    + " that could answer; name one with --output");
        }
        for (Channel output : found) {
            if (chosen.contains(output)) {
                throw new DataFault(output + " is both input and output; choose two channels");
            }
        }
        return found;
    }
}
