package wbv.diagnosis.mechanism;

/** A sensor that reads in steps: seen without a fit. What rounding adds counts as noise. */
public record SensorQuantised() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("sensor.quantised", Family.SENSOR, "The sensor %s reads in steps",
                "Set the sensor's range to what it has to measure, or read it finer, and record again: the steps must become smaller "
                        + "with the range.");
    }

    @Override
    public boolean showsWithoutFit() {
        return true;
    }
}
