package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import wbv.body.Drive;
import wbv.body.SensorFault;
import wbv.diagnosis.mechanism.Addition;
import wbv.diagnosis.mechanism.Hypothesis.Number;
import wbv.recording.Channel;
import wbv.recording.Quantity;

/**
 * Rotation that lifts the lower end of a link, or a sensor that sits beside the axis. Where a rotation was recorded, and not on a rig.
 */
record RotationalCoupling() implements Mechanism {

    /** Lever arm to start from, and its unit [m]. */
    private static final double ARM = 0.02;

    @Override
    public Entry entry() {
        return new Entry("coupling.rotation", Family.COUPLING, "Rotation lifts %s");
    }

    @Override
    public List<Hypothesis> inLink(Scene scene, Scene.Link link) {
        if (scene.onRig()) {
            return List.of();
        }
        String lower = scene.location(scene.model().links().get(link.index()).from());
        String at = lower.isEmpty() ? scene.location(scene.model().base().name()) : lower;
        List<Channel> rates = scene.across(at, Quantity.ANGULAR_RATE).stream().sorted((a, b) -> b.axis() - a.axis()).toList();
        return of(link.name(), rates, rate -> new Addition.Driven(link.index(), new Drive.Rotation(rate, ARM)));
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        Channel channel = scene.outputs().get(output);
        boolean turned = !scene.onRig() && channel.quantity() == Quantity.ACCELERATION;
        return of(channel.toString(), turned ? scene.beside(channel, Quantity.ANGULAR_RATE) : List.of(),
                rate -> new Addition.AtSensor(output, new SensorFault.LeverArm(rate, ARM)));
    }

    /** An arm for each rate; none where there is no rate. */
    private List<Hypothesis> of(String where, List<Channel> rates, Function<Channel, Addition> addition) {
        double[] arms = new double[rates.size()];
        Arrays.fill(arms, ARM);
        List<Number> numbers = rates.stream().map(rate -> sum(ARM, -1, 1).named("lever_arm_m on " + rate)).toList();
        int[][] columns = IntStream.range(0, arms.length).mapToObj(i -> new int[] {i}).toArray(int[][]::new);
        return rates.isEmpty() ? List.of()
                : List.of(
                        new Hypothesis(this, where, "", rates.stream().map(addition).toList(), numbers, List.of(Start.of(arms, columns))));
    }

    @Override
    public Doubt doubt(String key) {
        return Doubt.ARM;
    }
}
