package wbv.state;

/** Says by thresholds alone what a row of features is: what people mean by the names. Clusters are named after it. */
public final class PhysicalLabels {

    private PhysicalLabels() { }

    /** @param features as {@link FeatureSpec#NAMES}, complete. Not modified. */
    public static MotionState of(double[] features, Thresholds thresholds) {
        int seat = MotionState.sign(features[FeatureSpec.SEAT_JERK], thresholds.jerk());
        int head = MotionState.sign(features[FeatureSpec.HEAD_JERK], thresholds.jerk());
        if (seat != 0 || head != 0) {
            return MotionState.jerk(seat, head);
        }
        if (Math.pow(10, features[FeatureSpec.ROCKING]) > thresholds.rocking()) {
            return MotionState.ROCKING;
        }
        return Math.pow(10, features[FeatureSpec.SHAKING]) < thresholds.rest() ? MotionState.IDLE : MotionState.RIDING;
    }

    /**
     * What a row of the rig's truth is.
     *
     * @param episode 0 idle, 1 riding, 2 rocking @param jolting whether a jolt acts
     * @param seatJerk how the seat really jerks [m/s³] @param headJerk how the head does
     */
    public static MotionState truth(int episode, boolean jolting, double seatJerk, double headJerk, Thresholds thresholds) {
        int seat = MotionState.sign(seatJerk, thresholds.jerk());
        int head = MotionState.sign(headJerk, thresholds.jerk());
        if (jolting && (seat != 0 || head != 0)) {
            return MotionState.jerk(seat, head);
        }
        return episode == 0 ? MotionState.IDLE : episode == 1 ? MotionState.RIDING : MotionState.ROCKING;
    }
}
