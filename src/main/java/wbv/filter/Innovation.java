package wbv.filter;

import java.io.Serializable;
import wbv.filter.model.Spec;

/** What an output sample told beyond what was foreseen. One object is reused. */
final class Innovation implements Serializable {

    private static final long serialVersionUID = 1;
    /** Largest normalised innovation that is believed [1]: what is beyond counts as this much. */
    private final double most;
    private double value;
    private double believed;
    private double predicted;

    /** @param spec with the adaptation */
    Innovation(Spec spec) {
        this.most = spec.adaptation().noise().mostBelieved();
    }

    /**
     * Takes a sample's.
     *
     * @param innovation ν
     * @param predictedVariance H P Hᵀ, the output's noise not counted
     * @param limit      variance by which ν is limited, +∞ to believe all of it
     */
    void set(double innovation, double predictedVariance, double limit) {
        value = innovation;
        predicted = predictedVariance;
        believed = limited(innovation, limit);
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
    double limited(double innovation, double variance) {
        if (innovation * innovation <= most * most * variance) {
            return innovation;
        }
        return Math.copySign(most * Math.sqrt(variance), innovation);
    }
}
