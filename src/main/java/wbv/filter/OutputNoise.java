package wbv.filter;

import java.io.Serializable;

/**
 * Variance R of what the model does not explain in the output: never below the sensor's, otherwise learned from the
 * innovations, {@code R = E[ν²] - H P Hᵀ} (Mehra, IEEE Trans. Automatic Control 1970). For the first seconds, and as long as
 * nothing better is known, the model is taken to be wrong by {@value #MODEL_ERROR} of the output.
 */
final class OutputNoise implements Serializable {

    private static final long serialVersionUID = 1;
    private static final double MODEL_ERROR = 1;
    private static final double TRIAL = 2;
    private static final double LONGEST_MEMORY = 10;
    private static final double SHORTEST_MEMORY = 0.5;
    private static final double LARGEST_SURPRISE = 25;
    /** A fall is believed sooner than a rise: R is at most this many times what the last second shows. */
    private static final double SHORT_MEMORY = 1;
    private static final double MOST_ABOVE_LATELY = 3;

    private final double rate;
    private final double sensor;
    private double r;
    private double age;
    private double outputPower;
    private double lately;

    OutputNoise(double rate, double sensorDeviation) {
        this.rate = rate;
        this.sensor = sensorDeviation * sensorDeviation;
        reset();
    }

    void reset() {
        r = sensor;
        age = 0;
        outputPower = 0;
        lately = sensor;
    }

    /** R [m²/s⁴]. */
    double variance() {
        return Math.max(sensor, r);
    }

    /** Forgets quickly again, as after a change. */
    void relearn() {
        age = Math.min(age, 2 * TRIAL * rate);
    }

    /** @param y output [m/s²]  @param innovation ν [m/s²]  @param predicted H P Hᵀ, the part of ν² that the filter expects */
    void learn(double y, double innovation, double predicted) {
        age++;
        if (age <= TRIAL * rate) {
            outputPower += (y * y - outputPower) / age;
            r = Math.max(sensor, MODEL_ERROR * MODEL_ERROR * outputPower);
            lately = r;
            return;
        }
        double memory = rate * Math.min(LONGEST_MEMORY, Math.max(SHORTEST_MEMORY, (age / rate - TRIAL) / 4));
        double s = predicted + variance();
        double surprise = Math.min(innovation * innovation, LARGEST_SURPRISE * s);
        // an innovation tells about R only as far as R is its larger part
        double share = variance() / s;
        r = Math.max(sensor, r + share * (surprise - predicted - r) / memory);
        lately += share * (Math.max(0, surprise - predicted) - lately) / (rate * SHORT_MEMORY);
        r = Math.max(sensor, Math.min(r, MOST_ABOVE_LATELY * lately));
    }
}
