package wbv.diagnosis.mechanism;

/** A sensor that reads something where nothing is: seen by its mean, without a fit. */
public record SensorBias() implements Mechanism {

    @Override
    public String word() {
        return "sensor.bias";
    }

    @Override
    public Family family() {
        return Family.SENSOR;
    }

    @Override
    public String sentence() {
        return "The sensor %s has a bias";
    }

    @Override
    public String experiment() {
        return SensorMisalignment.POSE;
    }

    @Override
    public boolean showsWithoutFit() {
        return true;
    }
}
