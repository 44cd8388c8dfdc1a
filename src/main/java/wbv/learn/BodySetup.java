package wbv.learn;

import java.io.Serializable;
import wbv.filter.Estimator;
import wbv.filter.EstimatorDesign;
import wbv.filter.model.Spec;

/**
 * What a learner's options say of its estimator; the sampling rate comes later, from the instances.
 *
 * @param density noise of both sensors [m/s²/√Hz or rad/s/√Hz]
 * @param detector as {@link Detectors} reads it
 */
record BodySetup(EstimatorDesign design, double frequency, double damping, double density, double drift, String detector)
        implements Serializable {

    /** @param rate [Hz] */
    Estimator estimator(double rate) {
        double noise = density * Math.sqrt(rate / 2);
        return design.estimator(new Spec(rate, frequency, damping, noise, noise, drift), Detectors.named(detector));
    }
}
