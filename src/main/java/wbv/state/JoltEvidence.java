package wbv.state;

import java.io.Serializable;
import java.util.Arrays;

/** What the jerks of a row say of a model's states: see {@link StateModel}. Outside of jolts they say nothing. */
final class JoltEvidence implements Serializable {

    private static final long serialVersionUID = 1;
    /** Slope of the logistic distribution that is nearest to the normal one. */
    private static final double LOGISTIC = 1.702;
    private static final double LEAST = 1e-9;

    private final double threshold;
    private final double error;
    /** Places of the states of jolts, what they are called and how often each is met. */
    private final int[] places;
    private final MotionState[] names;
    private final double[] shares;

    JoltEvidence(StateModel model) {
        threshold = model.thresholds().jerk();
        error = model.error();
        int[] all = new int[model.names().size()];
        int count = 0;
        for (int k = 0; k < all.length; k++) {
            if (model.activities().get(k) == Activity.JOLT) {
                all[count++] = k;
            }
        }
        places = Arrays.copyOf(all, count);
        names = Arrays.stream(places).mapToObj(model.names()::get).toArray(MotionState[]::new);
        shares = Arrays.stream(places).mapToDouble(k -> model.shares()[k]).toArray();
    }

    /**
     * @param row as {@link FeatureSpec#NAMES}. Not modified.
     * @param into K logarithms. Those of jolts are modified, the others stay.
     */
    void of(double[] row, double[] into) {
        double seatUp = beyond(row[FeatureSpec.SEAT_JERK]);
        double seatDown = beyond(-row[FeatureSpec.SEAT_JERK]);
        double headUp = beyond(row[FeatureSpec.HEAD_JERK]);
        double headDown = beyond(-row[FeatureSpec.HEAD_JERK]);
        double seatStill = 1 - seatUp - seatDown;
        double headStill = 1 - headUp - headDown;
        for (int i = 0; i < places.length; i++) {
            double chance = switch (names[i]) {
                case SEAT_UP -> seatUp * headStill;
                case SEAT_DOWN -> seatDown * headStill;
                case HEAD_UP -> seatStill * headUp;
                case HEAD_DOWN -> seatStill * headDown;
                case BOTH_UP -> seatUp * headUp;
                case BOTH_DOWN -> seatDown * headDown;
                case OPPOSED -> seatUp * headDown + seatDown * headUp;
                case IDLE, RIDING, ROCKING -> seatStill * headStill;
            };
            into[places[i]] = Math.log(Math.max(LEAST, chance) / shares[i]);
        }
    }

    /** P(the true jerk is above the threshold | the jerk that was read). */
    private double beyond(double jerk) {
        return 1 / (1 + Math.exp(-LOGISTIC * (jerk - threshold) / error));
    }
}
