package wbv.study;

import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Quantity;
import wbv.recording.inspect.RowSource;

/**
 * What is to be analysed.
 *
 * @param source     the recording
 * @param title      what the report calls it
 * @param map        column map that the source was read with, for the task string
 * @param input      acceleration that excites; empty to choose the platform's, else the seat's
 * @param outputs    accelerations that answer; none to take every other place along the input's axis
 * @param frequency  natural frequency at which the estimators start [Hz]
 * @param damping    damping ratio at which they start [1]
 * @param provenance what the report says of its own making, by name: command, version, SHA-256 of the inputs
 */
public record AnalysisRequest(RowSource source, String title, Optional<Path> map, List<Channel> input, List<Channel> outputs,
        double frequency, double damping, Map<String, String> provenance) {

    private static final List<String> BASES = List.of("platform", "floor", "seat");

    public AnalysisRequest {
        if (input.size() > 1) {
            throw new IllegalArgumentException("there is one input: " + input);
        }
        input = List.copyOf(input);
        outputs = List.copyOf(outputs);
    }

    /**
     * The input among the channels of a recording.
     *
     * @throws DataFault if none can be chosen
     */
    Channel chooseInput(List<Channel> channels, String name) {
        if (!input.isEmpty()) {
            return input.get(0);
        }
        return usualInput(channels).orElseThrow(() -> DataFault.in(name,
                "has no platform.acc.z, floor.acc.z or seat.acc.z; name the exciting channel with --input: " + channels));
    }

    /** What moves the rest where nobody says so: a platform, a floor or a seat along z, gravity removed or in it. */
    public static Optional<Channel> usualInput(Collection<Channel> channels) {
        return Stream.of(Quantity.ACCELERATION, Quantity.SPECIFIC_FORCE)
                .flatMap(quantity -> BASES.stream().map(base -> new Channel(base, quantity, 'z'))).filter(channels::contains).findFirst();
    }

    /** The outputs among the channels of a recording, in its order. */
    List<Channel> chooseOutputs(List<Channel> channels, Channel chosenInput, String name) {
        if (!outputs.isEmpty()) {
            return outputs;
        }
        List<Channel> found = channels.stream().filter(c -> c.quantity() == chosenInput.quantity() && c.axis() == chosenInput.axis()
                && !c.equals(chosenInput)).toList();
        if (found.isEmpty()) {
            throw DataFault.in(name, "has no other " + chosenInput.quantity().symbol() + " channel along "
                    + chosenInput.axis() + " that could answer " + chosenInput + "; name one with --output");
        }
        return found;
    }
}
