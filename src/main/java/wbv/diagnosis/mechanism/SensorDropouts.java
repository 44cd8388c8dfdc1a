package wbv.diagnosis.mechanism;

/** Samples that a receiver lost and repeats: seen without a fit. */
public record SensorDropouts() implements Mechanism {

    @Override
    public String word() {
        return "sensor.dropouts";
    }

    @Override
    public Family family() {
        return Family.SENSOR;
    }

    @Override
    public String sentence() {
        return "The sensor %s drops samples";
    }

    @Override
    public String experiment() {
        return "Bring the receiver nearer and record again: what drops must vanish.";
    }

    @Override
    public boolean showsWithoutFit() {
        return true;
    }
}
