package wbv.state;

import java.util.Locale;

/** What is being done to the sitter at a moment. What he does then, a {@link MotionState}, is more: which way seat and head jerk. */
public enum Activity {
    /** Nothing. */
    IDLE(MotionState.IDLE),
    /** Ordinary vibration. */
    RIDING(MotionState.RIDING),
    /** Slow swaying in roll or pitch. */
    ROCKING(MotionState.ROCKING),
    /** A shock carries the seat along, or has just done so and the sitter rings. */
    JOLT(MotionState.RIDING);

    private final MotionState quiet;

    Activity(MotionState quiet) {
        this.quiet = quiet;
    }

    /**
     * The state of someone to whom this is done. Beyond the threshold jerk counts only in a jolt.
     *
     * @param seat
     * @param head -1, 0, 1
     */
    MotionState state(int seat, int head) {
        return this != JOLT || seat == 0 && head == 0 ? quiet : MotionState.jerk(seat, head);
    }

    /** The word of this activity, such as {@code jolt}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
