package wbv.diagnosis.mechanism;

import java.util.Set;

/** A sensor that reads something where nothing is: seen by its mean, without a fit. */
public record SensorBias() implements Mechanism {

    /** Key of how far a zero that drifts is at one time from where it is at another, in the channel's unit. */
    public static final String RANGE = "bias_range";

    @Override
    public Entry entry() {
        return new Entry("sensor.bias", Family.SENSOR, "The sensor %s has a bias", SensorMisalignment.POSE);
    }

    @Override
    public String sentence(Set<String> keys) {
        return keys.contains(RANGE) ? "The zero of the sensor %s drifts" : entry().sentence();
    }

    @Override
    public boolean showsWithoutFit() {
        return true;
    }
}
