package wbv.live;

import java.util.List;
import java.util.Optional;
import wbv.filter.Method;
import wbv.recording.Channel;
import wbv.recording.format.ReadOptions;
import wbv.state.StateModel;

/**
 * What is to be done with the samples of a stream.
 *
 * @param reading   what the user says of the rows
 * @param columns   header for senders that send none; empty where they do
 * @param method    estimator
 * @param input     channel that shakes the body; empty to choose
 * @param outputs   channels that answer; none to choose one
 * @param place     where the vibration enters the sitter; empty to choose
 * @param boxcar    true if samples are means over the sampling period
 * @param states    model of motion states; empty for none
 * @param every     sensor time between results [s]
 * @param mostSeats seats that are followed; more are refused, so that names made up by a sender cannot fill the memory
 */
public record LiveSettings(ReadOptions reading, Optional<String> columns, Method method, Optional<Channel> input, List<Channel> outputs,
        Optional<String> place, boolean boxcar, Optional<StateModel> states, double every, int mostSeats) {

    /** Seats that one machine follows in time. */
    public static final int USUAL_SEATS = 1000;

    public LiveSettings {
        outputs = List.copyOf(outputs);
        if (!(every > 0) || mostSeats < 1) {
            throw new IllegalArgumentException("results come every > 0 s, of 1 seat at least: " + every + ", " + mostSeats);
        }
    }

    /** Everything as it is usual. */
    public static LiveSettings usual() {
        return new LiveSettings(ReadOptions.DEFAULT, Optional.empty(), Method.EKF_ADWIN, Optional.empty(), List.of(), Optional.empty(),
                false, Optional.empty(), 1, USUAL_SEATS);
    }
}
