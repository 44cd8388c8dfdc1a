package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import wbv.body.Drive;
import wbv.body.SensorFault;

/**
 * A sensor that is AC coupled.
 *
 * <p>Its corner lies where a recording can show one. Below one turn in the whole stretch all that is left of it is a trend, which offsets
 * make too. Above a tenth of the sampling rate a sensor reads a factor of the derivative over most of what is sampled: not that sensor's
 * reading coupled to AC, but that of another quantity.
 */
record SensorAcCoupling() implements Mechanism {

    /** Highest corner, in parts of the sampling rate. */
    private static final double HIGHEST = 0.1;
    /** Corners to start from: a few octaves apart over any recording, less than a phase of 45° at a corner spreads to either side. */
    private static final int STARTS = 4;

    @Override
    public Entry entry() {
        return new Entry("sensor.ac-coupled", Family.SENSOR, "The sensor %s is AC coupled",
                "Load or turn the sensor and hold it so: what is AC coupled creeps back to zero. Or switch its amplifier to DC.");
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        double[] corners = corners(scene);
        return List.of(Hypothesis.fault(this, scene, output, new SensorFault.AcCoupling(corners[0]), List.of(bounds(scene)),
                grid(corners, corner -> fixed(corner))));
    }

    /** The channel of a force that pushes. */
    @Override
    public List<Hypothesis> onBody(Scene scene, int body) {
        double[] corners = corners(scene);
        return scene.inputsOn(body).map(channel -> new Hypothesis(this, channel.toString(), "",
                List.of(new Addition.Driven(body, new Drive.Coupled(channel, corners[0]))),
                Hypothesis.Number.named(Drive.Coupled.class, List.of(bounds(scene))), grid(corners, corner -> fixed(corner)))).toList();
    }

    private static Hypothesis.Number bounds(Scene scene) {
        return factor(1 / scene.end(), HIGHEST / scene.step());
    }

    private static double[] corners(Scene scene) {
        double low = 1 / scene.end();
        double high = HIGHEST / scene.step();
        return IntStream.range(0, STARTS).mapToDouble(i -> low * Math.pow(high / low, (i + 0.5) / STARTS)).toArray();
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        boolean told = rival.family() == Family.COUPLING || rival.family() == Family.DYNAMIC || rival instanceof SensorGain
                || rival instanceof SensorDelay || rival instanceof SensorMount;
        return told ? Optional.of(entry().experiment()) : Optional.empty();
    }

    @Override
    public boolean isAlwaysRefitted() {
        return true;
    }

    @Override
    public boolean imitatesAt(String key, boolean low) {
        return true;
    }
}
