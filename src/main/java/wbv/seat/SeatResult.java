package wbv.seat;

import java.util.List;
import java.util.Optional;
import wbv.exposure.Directive;
import wbv.exposure.SeatAxis;
import wbv.recording.Channel;
import wbv.state.MotionState;

/**
 * What is known of a seat at a moment of its sensor's clock.
 *
 * @param seat     its name
 * @param time     of the last sample that it rests on [s]
 * @param sample   number of samples since the seat was first heard of, those that are missing included
 * @param bodies   natural frequency and damping, one for each body that is followed
 * @param exposure of the shift so far; empty where no acceleration of the seat comes
 * @param state    empty without a model of states, and before anything can be told
 * @param losses   counted since the seat was first heard of
 * @param alarms   since the result before
 */
public record SeatResult(String seat, double time, long sample, List<Body> bodies, Optional<Exposure> exposure,
        Optional<State> state, Losses losses, List<SeatAlarm> alarms) {

    public SeatResult {
        bodies = List.copyOf(bodies);
        alarms = List.copyOf(alarms);
    }

    /**
     * A body that is followed.
     *
     * @param output    channel of its motion
     * @param modes     slowest first
     * @param explained share of the output's variance that predictions explained so far, at most 1; NaN before it moves
     * @param excited   whether the last second told about it
     * @param settled   whether it was found and its alarm listens
     */
    public record Body(Channel output, List<Mode> modes, double explained, boolean excited, boolean settled) {

        public Body {
            modes = List.copyOf(modes);
        }
    }

    /**
     * Natural frequency and damping with their standard deviations.
     *
     * @param frequency [Hz]
     * @param frequencyDeviation [Hz]
     * @param damping [1]
     * @param dampingDeviation [1]
     */
    public record Mode(double frequency, double frequencyDeviation, double damping, double dampingDeviation) {}

    /**
     * Exposure of the shift so far.
     *
     * @param since           beginning of the shift [s by the sensor's clock]
     * @param seconds         measured
     * @param missing         time that was not measured [s]
     * @param axes            that are measured
     * @param a8              daily exposure of the time measured, on the worst axis [m/s²]
     * @param vdv             dose of the time measured, on the worst axis [m/s^1.75]
     * @param minutesToAction [min] until A(8) or the dose reaches the action value if it goes on as so far; 0 when reached, infinite
     *                        without vibration
     * @param minutesToLimit  likewise for the limit value
     */
    public record Exposure(double since, double seconds, double missing, List<Axis> axes, double a8, double vdv,
            double minutesToAction, double minutesToLimit) {

        public Exposure {
            axes = List.copyOf(axes);
        }

        /** By whichever of A(8) and dose is worse. */
        public Directive.Verdict verdict() {
            Directive.Verdict one = Directive.Verdict.ofA8(a8);
            Directive.Verdict other = Directive.Verdict.ofVdv(vdv);
            return one == Directive.Verdict.UNKNOWN || other.compareTo(one) > 0 && other != Directive.Verdict.UNKNOWN ? other : one;
        }
    }

    /**
     * Along one axis.
     *
     * @param rms     a_w of the time measured, without k [m/s²]
     * @param running of the last second, linear, without k [m/s²]
     * @param a8      of the time measured, with k [m/s²]
     * @param vdv     of the time measured, with k [m/s^1.75]
     */
    public record Axis(SeatAxis axis, double rms, double running, double a8, double vdv) {}

    /**
     * What the person does.
     *
     * @param state       the likeliest
     * @param probability of it
     * @param jerk        probability of a jerk within each of {@link wbv.state.StateTrack#HORIZONS}
     */
    public record State(MotionState state, double probability, List<Double> jerk) {

        public State {
            jerk = List.copyOf(jerk);
        }
    }

    /**
     * What came and what did not.
     *
     * @param packets   taken
     * @param reordered that waited for one before them
     * @param twice     that came again and were dropped
     * @param late      that came after they were given up and were dropped
     * @param lost      that never came in time
     * @param refused   that were not of this seat's plan
     * @param samples   lost with packets, or left out between two
     * @param missing   values that were no numbers in packets that came
     * @param restarts  of the sensor's counter or clock
     */
    public record Losses(long packets, long reordered, long twice, long late, long lost, long refused, long samples, long missing,
            long restarts) {}
}
