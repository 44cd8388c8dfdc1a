package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;

import java.util.List;
import wbv.body.SensorFault;

/** A sensor that reads a factor of what it should. Not looked for on a rig, whose constants are fitted. */
record SensorGain() implements Mechanism {

    private static final double FACTOR = 1.02;

    @Override
    public Entry entry() {
        return new Entry("sensor.gain", Family.SENSOR, "The sensor %s has a wrong gain",
                "Tape a second sensor beside it: the two must read alike.");
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        // The only sensor of what forces drive reads what a model of other numbers does.
        boolean alone = scene.outputs().size() == 1 && scene.model().base().sensor().isEmpty();
        return alone ? List.of() : List.of(Hypothesis.fault(this, scene, output, new SensorFault.Gain(FACTOR),
                List.of(sum(0.01, 0.3, 3).about(1)),
                List.of(new Start(new double[] {FACTOR}, new double[] {FACTOR - 1}, List.of(new int[] {0})))));
    }

    @Override
    public Doubt doubt(String key) {
        return Doubt.GAIN;
    }
}
