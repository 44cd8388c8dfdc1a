package wbv.diagnosis.mechanism;

/** A sensor that reads something where nothing is: seen by its mean, without a fit. */
public record SensorBias() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("sensor.bias", Family.SENSOR, "The sensor %s has a bias", SensorMisalignment.POSE);
    }

    @Override
    public boolean showsWithoutFit() {
        return true;
    }
}
