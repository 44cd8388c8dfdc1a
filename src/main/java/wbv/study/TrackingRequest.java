package wbv.study;

import java.util.List;
import java.util.Map;
import wbv.filter.EstimatorDesign;
import wbv.filter.model.Spec;
import wbv.recording.Channel;
import wbv.recording.Quantity;
import wbv.recording.inspect.RowSource;

/**
 * What is to be tracked.
 *
 * @param source     the recording
 * @param title      what the report calls it
 * @param input      motion that excites; empty to choose the platform's, else the seat's
 * @param outputs    motions that answer; none to take every other place along the input's axis
 * @param others     motions of the base beside the input, whose part in the outputs is learned and taken away; may be none
 * @param designs    estimators, one or more
 * @param frequency  natural frequency at which they start [Hz]
 * @param damping    damping ratio at which they start
 * @param density    noise density of the sensors, NaN for the usual [m/s²/√Hz or rad/s/√Hz]
 * @param detector   change detector that listens beside the estimators' own tests, as {@link wbv.learn.Detectors} reads it
 * @param provenance what the report says of its own making, by name
 */
public record TrackingRequest(RowSource source, String title, List<Channel> input, List<Channel> outputs,
        List<Channel> others, List<EstimatorDesign> designs,
        double frequency, double damping, double density, String detector,
        Map<String, String> provenance) {

    public TrackingRequest {
        if (input.size() > 1) {
            throw new IllegalArgumentException("there is one input: " + input);
        }
        if (designs.isEmpty()) {
            throw new IllegalArgumentException("at least one estimator is needed");
        }
        input = List.copyOf(input);
        outputs = List.copyOf(outputs);
        others = List.copyOf(others);
        designs = List.copyOf(designs);
    }

    /** How channels are chosen where they are not named: as an analysis does. */
    AnalysisRequest channels() {
        return new AnalysisRequest(source, title, java.util.Optional.empty(), input, outputs, frequency, damping, provenance);
    }

    /** Degrees of freedom of the body over the recording: two if they were asked for, else as many as the data ask for. */
    int degrees() {
        return designs.stream().anyMatch(design -> design.degrees() == 2) ? 2 : 0;
    }

    /**
     * What estimators of a quantity are told.
     *
     * @param rate [Hz]
     */
    Spec spec(Quantity quantity, double rate) {
        Spec usual = quantity == Quantity.ANGULAR_RATE ? Spec.rotary(rate) : Spec.at(rate);
        Spec told = Double.isNaN(density) ? usual : usual.withNoise(density * Math.sqrt(rate / 2));
        return told.startingAt(frequency, damping);
    }
}
