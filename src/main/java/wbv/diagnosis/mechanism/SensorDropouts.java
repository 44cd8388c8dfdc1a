package wbv.diagnosis.mechanism;

/** Samples that a receiver lost and repeats: seen without a fit. */
public record SensorDropouts() implements Mechanism {

    @Override
    public Entry entry() {
        return new Entry("sensor.dropouts", Family.SENSOR, "The sensor %s drops samples",
                "Bring the receiver nearer and record again: what drops must vanish.");
    }

    @Override
    public boolean showsWithoutFit() {
        return true;
    }
}
