package wbv.state;

/** Says by thresholds alone what a row of features is: what people mean by the names, where no truth lies beside a recording. */
public final class PhysicalLabels {

    private PhysicalLabels() {}

    /**
     * The state that a row of features shows.
     *
     * @param features as long as {@link FeatureSpec#NAMES}, in their units, complete. Not modified.
     */
    public static MotionState of(double[] features, Thresholds thresholds) {
        return activity(features, thresholds).state(MotionState.sign(features[FeatureSpec.SEAT_JERK], thresholds.jerk()),
                MotionState.sign(features[FeatureSpec.HEAD_JERK], thresholds.jerk()));
    }

    /**
     * What is being done to the sitter.
     *
     * @param features likewise
     */
    static Activity activity(double[] features, Thresholds thresholds) {
        if (features[FeatureSpec.SURGE] > FeatureSpec.surge(thresholds.surge())) {
            return Activity.JOLT;
        }
        if (features[FeatureSpec.SWAY] > FeatureSpec.sway(thresholds.rocking())) {
            return Activity.ROCKING;
        }
        return features[FeatureSpec.SHAKING] < FeatureSpec.shaking(thresholds.rest()) ? Activity.IDLE : Activity.RIDING;
    }

    /**
     * What is done to the sitter in a row of the rig's truth.
     *
     * @param episode 0 idle, 1 riding, 2 rocking
     * @param jolting whether a jolt acts
     */
    static Activity activity(int episode, boolean jolting) {
        return jolting ? Activity.JOLT : episode == 0 ? Activity.IDLE : episode == 1 ? Activity.RIDING : Activity.ROCKING;
    }

    /**
     * What a row of the rig's truth is.
     *
     * @param activity what is done to the sitter
     * @param seatJerk how the seat really jerks [m/s³]
     * @param headJerk how the head does
     */
    static MotionState truth(Activity activity, double seatJerk, double headJerk, Thresholds thresholds) {
        return activity.state(MotionState.sign(seatJerk, thresholds.jerk()), MotionState.sign(headJerk, thresholds.jerk()));
    }
}
