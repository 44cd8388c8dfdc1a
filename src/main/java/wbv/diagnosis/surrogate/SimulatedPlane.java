package wbv.diagnosis.surrogate;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.measured.Measured;
import wbv.recording.Channel;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * What a simulation did in the plane of x and z on a base that moves along both: the places of which it gave more than the motion along z,
 * and the rigid bodies that do the same.
 */
final class SimulatedPlane {

    private final Recording together;
    private final List<Channel> axes;
    private final List<String> places;
    private final List<Channel> outputs;

    private SimulatedPlane(Recording together, List<Channel> axes, List<String> places, List<Channel> outputs) {
        this.together = together;
        this.axes = axes;
        this.places = places;
        this.outputs = outputs;
    }

    /**
     * The plane of a simulation; none where the base was recorded along one axis alone, or the simulation gave only what moves along z.
     *
     * @param recording of the base
     * @param simulated by channel, as long as that
     * @param input the base's motion along z
     * @param moving the places that do not just move with it
     */
    static Optional<SimulatedPlane> of(Recording recording, Map<Channel, double[]> simulated, Channel input, List<String> moving) {
        List<Channel> axes = inPlane(input.location()).stream().filter(recording::has).toList();
        List<String> places = PlaneSearch.ordered(moving);
        List<Channel> outputs = places.stream().flatMap(place -> inPlane(place).stream()).filter(simulated::containsKey).toList();
        boolean alone = outputs.stream().allMatch(output -> output.axis() == 'z');
        if (input.axis() != 'z' || axes.stream().filter(axis -> axis.quantity() == Quantity.ACCELERATION).count() < 2 || alone) {
            return Optional.empty();
        }
        Map<Channel, double[]> values = new LinkedHashMap<>();
        axes.forEach(axis -> values.put(axis, LostSamples.centred(recording.values(axis))));
        outputs.forEach(output -> values.put(output, Measured.centred(simulated.get(output))));
        return Optional.of(new SimulatedPlane(new Recording(recording.clock(), values, Metadata.NONE), axes, places, outputs));
    }

    /** What moves in the plane, that along z first. */
    private static List<Channel> inPlane(String place) {
        return List.of(new Channel(place, Quantity.ACCELERATION, 'z'), new Channel(place, Quantity.ACCELERATION, 'x'),
                new Channel(place, Quantity.ANGULAR_RATE, 'y'));
    }

    /** What the simulation gave, mean left out. Not a copy. */
    double[] given(Channel output) {
        return together.values(output);
    }

    /** The measured bodies, no more. */
    PlaneNet plain() {
        return search((step, share) -> {}).plain().net();
    }

    /**
     * The least arrangement that does what the simulation did.
     *
     * @param plain as {@link #plain()} gives it
     */
    PlaneNet best(PlaneNet plain, BiConsumer<String, Double> progress) {
        progress.accept(Enrichment.STEP, 0.0);
        SimulatedPlane small = straightened(plain);
        PlaneNet found = small.search(progress).enriched(plain).net();
        SimulatedPlane smaller = straightened(found);
        return smaller.fit().fit(found).net();
    }

    private PlaneSearch search(BiConsumer<String, Double> progress) {
        return new PlaneSearch(places, fit(), progress);
    }

    /** What is left where bodies that turn by whole angles, as these do, go beyond small motions. */
    private SimulatedPlane straightened(PlaneNet net) {
        Model model = model(net, 1);
        Model.Base base = model.base();
        Model flat = new Model(model.name(), model.source(), model.axis(),
                new Model.Base(base.name(), base.sensor(), base.mass(), base.further(), Optional.empty()),
                model.bodies(), model.links(), model.inputs(), model.declared(), model.sensors());
        double[][] whole = outputs(model, together);
        double[][] small = outputs(flat, together);
        Map<Channel, double[]> values = new LinkedHashMap<>();
        axes.forEach(axis -> values.put(axis, together.values(axis)));
        for (Channel output : outputs) {
            int at = model.outputs().indexOf(output);
            double[] own = together.values(output).clone();
            Arrays.setAll(own, i -> own[i] - whole[at][i] + small[at][i]);
            values.put(output, own);
        }
        return new SimulatedPlane(new Recording(together.clock(), values, Metadata.NONE), axes, places, outputs);
    }

    /** What a model's sensors read, in its order. */
    static double[][] outputs(Model model, Recording driven) {
        return new Simulator(Excitation.of(model, driven, driven.length())).outputs(model.assembly());
    }

    /**
     * A net as a model.
     *
     * @param mass of all of it [kg]
     */
    Model model(PlaneNet net, double mass) {
        Map<String, List<String>> sensors = new LinkedHashMap<>();
        places.forEach(place -> sensors.put(place,
                outputs.stream().filter(output -> output.location().equals(place)).map(Channel::toString).toList()));
        return new PlaneDescription(net, axes.get(0).location(), axes.stream().map(Channel::toString).toList(), sensors,
                mass / net.mass()).model();
    }

    private PlaneFit fit() {
        return new PlaneFit(PlaneSpectra.of(together, axes, places, outputs), FittedNet.GOOD);
    }
}
