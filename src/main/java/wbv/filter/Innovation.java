package wbv.filter;

import java.io.Serializable;

/** What an output sample told beyond what was foreseen. One object is reused. */
final class Innovation implements Serializable {

    private static final long serialVersionUID = 1;
    /** Largest normalised innovation that is believed: what is beyond counts as this much. */
    private static final double LARGEST = 5;

    private double value;
    private double believed;
    private double predicted;

    /**
     * Takes a sample's.
     *
     * @param innovation ν
     * @param predictedVariance H P Hᵀ, the output's noise not counted
     * @param most       variance by which ν is limited, +∞ to believe all of it
     */
    void set(double innovation, double predictedVariance, double most) {
        value = innovation;
        predicted = predictedVariance;
        believed = limited(innovation, most);
    }

    /** ν of the last correction. */
    double value() {
        return value;
    }

    /** ν as far as it was believed. */
    double believed() {
        return believed;
    }

    /** Variance of the output that the filter expected before the correction, its noise not counted. */
    double predictedVariance() {
        return predicted;
    }

    /** An innovation as far as its variance lets it be believed. */
    static double limited(double innovation, double variance) {
        if (innovation * innovation <= LARGEST * LARGEST * variance) {
            return innovation;
        }
        return Math.copySign(LARGEST * Math.sqrt(variance), innovation);
    }
}
