package wbv.diagnosis.surrogate;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.recording.Channel;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/**
 * A simulation over the input that drove it, as long as both last. Other channels of the base may have moved the simulation too: what they
 * did is told apart, so that a chain has to do only what the input did.
 */
final class DrivenSimulation {

    /** An output that differs less from the input moves with the base. */
    private static final double RIGID = 0.01;

    private final Recording recording;
    private final Simulated simulated;
    private final Recording simulation;
    private final String name;
    private final Channel input;
    private final List<Channel> outputs;
    private final OtherInputs others;
    /** The input, and what it alone did to the outputs. */
    private final TakenInput taken;

    /**
     * @param recording  as long as the simulation
     * @param simulated as long as the recording
     * @param outputs    that do not just move with the input
     */
    private DrivenSimulation(Recording recording, Simulated simulated, List<Channel> outputs) {
        this.recording = recording;
        this.simulated = simulated;
        this.simulation = simulated.outputs();
        this.name = simulated.name();
        this.input = simulated.input();
        this.outputs = List.copyOf(outputs);
        others = new OtherInputs(recording, input);
        Map<Channel, double[]> alone = new LinkedHashMap<>(Map.of(input, recording.values(input)));
        outputs.forEach(output -> alone.put(output, Missed.of(simulation.values(output), others.partOf(given(output)))));
        taken = TakenInput.of(new Recording(recording.clock(), alone, Metadata.NONE), input, this.outputs, simulated.simulates());
    }

    /**
     * Of what was recorded of the base and a simulation of it.
     *
     * @throws DataFault if the two have no output or no time in common, or are not in one unit
     */
    static DrivenSimulation of(Recording recording, Simulated simulated) {
        Channel input = simulated.input();
        String name = simulated.name();
        if (input.quantity() != Quantity.ACCELERATION || !recording.has(input)) {
            throw new DataFault("what drove the simulation must be an acceleration that was recorded: " + input + "; there are "
                    + along(recording, input));
        }
        List<Channel> outputs = new ArrayList<>(along(simulated.outputs(), input));
        outputs.remove(input);
        if (outputs.stream().noneMatch(recording::has)) {
            throw DataFault.in(name, "has no acceleration along " + input.axis() + " that was recorded too; name its columns "
                    + "as the recording's channels: " + along(recording, input));
        }
        Overlap overlap = Overlap.of(recording, simulated.outputs(), name);
        Recording measured = overlap.ofRecording(recording);
        Recording simulation = overlap.ofSimulation(simulated.outputs());
        outputs.removeIf(output -> Missed.share(measured.values(input), simulation.values(output), 0) < RIGID);
        if (outputs.isEmpty()) {
            throw DataFault.in(name, "moves as " + input + " does, in all that was recorded too: there is nothing to identify");
        }
        try {
            return new DrivenSimulation(measured, simulated.with(simulation), outputs);
        } catch (DataFault fault) {
            throw DataFault.in(name, fault.getMessage());
        }
    }

    private static List<Channel> along(Recording recording, Channel input) {
        return recording.channels().stream().filter(channel -> along(input, channel)).toList();
    }

    private static boolean along(Channel input, Channel channel) {
        return channel.quantity() == Quantity.ACCELERATION && channel.axis() == input.axis();
    }

    /** What the simulation gave of a channel, gaps bridged. */
    private double[] given(Channel channel) {
        return LostSamples.filled(simulation.values(channel));
    }

    /** What the simulation did in a plane, if it gave that; nothing where what drove it was held over each sample. */
    Optional<SimulatedPlane> plane() {
        Map<Channel, double[]> all = new LinkedHashMap<>();
        simulation.channels().stream().filter(recording::has).forEach(channel -> all.put(channel, given(channel)));
        // Of how the input was taken a chain tells nothing that misses much with it either way.
        return taken.held() && taken.plain().worst() < Surrogate.MOST ? Optional.empty()
                : SimulatedPlane.of(recording, all, input, outputs.stream().map(Channel::location).toList());
    }

    /** The measured bodies in a chain, and no more. */
    FittedChain plain() {
        return taken.plain();
    }

    /** The least arrangement along one axis that does what the simulation did. */
    FittedChain best(BiConsumer<String, Double> progress) {
        try {
            return new ChainSearch(taken.driven(), input, outputs, simulated.simulates()).best(taken.plain(), progress);
        } catch (DataFault fault) {
            throw DataFault.in(name, fault.getMessage());
        }
    }

    /** Bodies along one axis, with what the simulation gave beside them. */
    Surrogate surrogate(FittedChain chain) {
        String how = (taken.held() ? ", its input held over each sample" : "") + (others.channels().isEmpty() ? ""
                : ", beside what " + others.channels().stream().map(Channel::toString).collect(Collectors.joining(", ")) + " did");
        AssumedMass mass = AssumedMass.of(simulated.mass(), recording.metadata());
        Model model = mass.told(mass.given(chain.model()).seenBy(recording.channels()), name, how);
        return surrogate(model, SimulatedPlane.outputs(model, taken.driven()), this::given, chain.errors(), Map.of());
    }

    /** Bodies in a plane, with what the simulation gave beside them. */
    Surrogate surrogate(SimulatedPlane plane, PlaneNet net) {
        AssumedMass mass = AssumedMass.of(simulated.mass(), recording.metadata());
        Model all = mass.told(plane.model(net, mass.sitting()).declaredAs(simulated.simulates()).seenBy(recording.channels()), name,
                " in the plane of x and z");
        double[][] own = SimulatedPlane.outputs(all, recording);
        Map<Channel, Double> missed = missed(plane, all.outputs(), own);
        Map<Channel, Double> errors = new LinkedHashMap<>(missed);
        errors.entrySet().removeIf(entry -> entry.getValue() > Surrogate.MOST && !along(input, entry.getKey()));
        missed.keySet().removeAll(errors.keySet());
        Model model = all.seenBy(errors.keySet());
        double[][] asked = model.outputs().stream().map(sensor -> own[all.outputs().indexOf(sensor)]).toArray(double[][]::new);
        return surrogate(model, asked, plane::given, errors, missed);
    }

    /** What a model in the plane misses of each output, as a share of it in the band that a model is run in: beyond, it does not move. */
    private Map<Channel, Double> missed(SimulatedPlane plane, List<Channel> sensors, double[][] own) {
        Excitation band = new Excitation(recording.clock().rate(), new double[recording.length()], Map.of());
        Map<Channel, Double> out = new LinkedHashMap<>();
        for (int o = 0; o < own.length; o++) {
            Channel sensor = sensors.get(o);
            double[] given = band.series(band.spectrum(plane.given(sensor)));
            out.put(sensor, Missed.settledShare(given, own[o], recording.clock().rate()));
        }
        return out;
    }

    private Surrogate surrogate(Model model, double[][] own, Function<Channel, double[]> given, Map<Channel, Double> errors,
            Map<Channel, Double> unasked) {
        GivenBeside both = GivenBeside.of(model, own, given, recording);
        return new Surrogate(both.model(), errors, unasked, both.recording(), name);
    }
}
