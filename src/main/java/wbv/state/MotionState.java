package wbv.state;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/**
 * What a seated person does at a moment, in words that a person understands. Jerk is vertical; up is positive. Seat or head
 * alone: the other's jerk is below the threshold. Both at once: in phase (both up or both down) or out of phase.
 */
public enum MotionState {
    IDLE("nothing moves"),
    RIDING("ordinary vibration"),
    ROCKING("slow swaying in roll or pitch"),
    SEAT_UP("seat jerks up"),
    SEAT_DOWN("seat jerks down"),
    HEAD_UP("head jerks up"),
    HEAD_DOWN("head jerks down"),
    BOTH_UP("seat and head jerk up, in phase"),
    BOTH_DOWN("seat and head jerk down, in phase"),
    OPPOSED("seat and head jerk against each other, out of phase");

    private final String meaning;

    MotionState(String meaning) {
        this.meaning = meaning;
    }

    /** What it is, in a few words. */
    public String meaning() {
        return meaning;
    }

    /** Whether something jerks. */
    public boolean jerk() {
        return compareTo(SEAT_UP) >= 0;
    }

    /** Which way the seat jerks: -1, 0 or 1; 0 where seat and head are opposed, for that may be either. */
    int seatSign() {
        return this == SEAT_UP || this == BOTH_UP ? 1 : this == SEAT_DOWN || this == BOTH_DOWN ? -1 : 0;
    }

    /** Which way the head jerks, likewise. */
    int headSign() {
        return this == HEAD_UP || this == BOTH_UP ? 1 : this == HEAD_DOWN || this == BOTH_DOWN ? -1 : 0;
    }

    /**
     * The state of the signs of two jerks, of which at least one is not 0.
     *
     * @param seat
     * @param head -1, 0 or 1
     */
    static MotionState jerk(int seat, int head) {
        if (seat * head < 0) {
            return OPPOSED;
        }
        if (seat != 0 && head != 0) {
            return seat > 0 ? BOTH_UP : BOTH_DOWN;
        }
        if (seat != 0) {
            return seat > 0 ? SEAT_UP : SEAT_DOWN;
        }
        return head > 0 ? HEAD_UP : HEAD_DOWN;
    }

    /** -1, 0 or 1: whether a jerk is beyond a threshold, and which way. */
    static int sign(double jerk, double threshold) {
        return Math.abs(jerk) > threshold ? (int) Math.signum(jerk) : 0;
    }

    /** The word of this state, such as {@code seat-up}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The state of a word. */
    public static Optional<MotionState> named(String word) {
        return Arrays.stream(values()).filter(state -> state.toString().equals(word)).findFirst();
    }
}
