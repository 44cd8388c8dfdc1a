package wbv.diagnosis.mechanism;

import static wbv.diagnosis.mechanism.Hypothesis.Number.factor;
import static wbv.diagnosis.mechanism.Hypothesis.Number.sum;
import static wbv.diagnosis.mechanism.Start.fixed;
import static wbv.diagnosis.mechanism.Start.grid;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import wbv.body.Drive;
import wbv.body.SensorFault;
import wbv.diagnosis.mechanism.Hypothesis.Number;

/** A sensor that is late, always by as much, ever more, or by what comes and goes. */
record SensorDelay() implements Mechanism {

    /** A drift of a clock that is held at none. */
    private static final double HELD = 1e-9;
    /** How often a delay comes and goes [Hz]: less is a drift, more is scatter. */
    private static final double SELDOM = 0.01;
    private static final double OFTEN = 0.2;
    /** Frequencies that are begun with, half of them apart at least: a minute tells a sixtieth of a hertz apart. */
    private static final double[] WANDERING = {0.0125, 0.025, 0.0375, 0.05, 0.075, 0.1, 0.15};

    private static final Number DELAY = sum(0.001, -0.2, 0.3);

    @Override
    public Entry entry() {
        return new Entry("sensor.delay", Family.SENSOR, "The sensor %s is late",
                "Tap the rig once at the start and once at the end: all sensors see the same instant, and only a late one does not.");
    }

    @Override
    public List<Hypothesis> atSensor(Scene scene, int output) {
        if (scene.onRig()) {
            double step = scene.step();
            // No sensor reads what is yet to come: the only one that seems early is in time, and what pushes is late.
            double earliest = scene.model().inputs().size() == 1 && scene.outputs().size() == 1 ? 0 : -50 * step;
            return List.of(Hypothesis.fault(this, scene, output, new SensorFault.Delay(step, 0),
                    List.of(sum(0.3 * step, earliest, 50 * step), sum(1e-5, -HELD, HELD)),
                    List.of(Start.of(new double[] {step, 0}, new int[] {0}))));
        }
        List<Integer> device = scene.device(output);
        return device.get(0) != output ? List.of() : List.of(late(scene, device, new SensorFault.Delay(0.004, 0), HELD,
                Stream.concat(Stream.of(Start.of(new double[] {0.004, 0}, new int[] {0})),
                        DoubleStream.of(-0.05, 0.02, 0.05, 0.08, 0.12, 0.2).mapToObj(late -> fixed(late, 0))).toList()),
                late(scene, device, new SensorFault.Delay(0, 1e-5), 0.005, List.of(Start.of(new double[] {0, 1e-5}, new int[] {1}))),
                late(scene, device, new SensorFault.WanderingDelay(0.004, 0.001, 0.001, 0.05),
                        List.of(DELAY, sum(0.001, -0.05, 0.05), sum(0.001, -0.05, 0.05), factor(SELDOM, OFTEN)),
                        grid(WANDERING, hz -> Start.of(new double[] {0.004, 0.001, 0.001, hz}, new int[] {0}, new int[] {1},
                                new int[] {2}))));
    }

    /**
     * @param device outputs of one clock
     * @param drift most of it [s/s]
     */
    private Hypothesis late(Scene scene, List<Integer> device, SensorFault.Delay fault, double drift, List<Start> starts) {
        return late(scene, device, fault, List.of(DELAY, sum(1e-5, -drift, drift)), starts);
    }

    private Hypothesis late(Scene scene, List<Integer> device, SensorFault fault, List<Number> bounds, List<Start> starts) {
        return device.size() == 1 ? Hypothesis.fault(this, scene, device.get(0), fault, bounds, starts)
                : Hypothesis.fault(this, scene, device, Collections.nCopies(device.size(), fault),
                        Collections.nCopies(device.size(), Collections.nCopies(bounds.size(), 1.0)), bounds, starts);
    }

    /** The channel of a force that pushes. */
    @Override
    public List<Hypothesis> onBody(Scene scene, int body) {
        double step = scene.step();
        return scene.inputsOn(body)
                .map(channel -> new Hypothesis(this, channel.toString(), "",
                        List.of(new Addition.Driven(body, new Drive.Late(channel, step))),
                        Number.named(Drive.Late.class, List.of(sum(0.3 * step, 0, 50 * step))), List.of(Start.scaled(step))))
                .toList();
    }

    /** Of what comes and goes its size, whatever its phase; nothing of a clock that was not let drift. */
    @Override
    public List<Told> told(List<Number> numbers) {
        List<Told> all = Mechanism.super.told(numbers);
        if (numbers.size() > 2) {
            return List.of(all.get(0), Told.amplitude("wander_s", 1, 2), all.get(3));
        }
        return numbers.size() > 1 && numbers.get(1).high() > HELD ? all : all.subList(0, 1);
    }

    @Override
    public Doubt doubt(String key) {
        return key.equals("delay_s") ? Doubt.DELAY : Doubt.SHARE;
    }

    @Override
    public Optional<String> against(Mechanism rival) {
        boolean told = rival.family() == Family.COUPLING || rival instanceof SensorMount || rival instanceof SensorGain;
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
