package wbv.diagnosis.surrogate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.rig.concealed.ConcealedCase;
import wbv.rig.concealed.ConcealedSpec;
import wbv.rig.concealed.Concealer;
import wbv.rig.concealed.Setting;
import wbv.signal.LostSamples;

class SimulatedPlaneTest {

    private static final Channel INPUT = Channel.parse("platform.acc.z");
    private static final List<String> PLACES = List.of("pelvis", "sternum", "head");

    /**
     * Where the sensors of a simulated person sit, and what his masses are to each other, follows from what he did: the plant is Newton's
     * and Euler's, not wbv's.
     */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(longs = {71, 72, 73})
    void placesAndMassesFollowFromWhatASimulationDid(long seed) {
        ConcealedCase made = Concealer.make(new ConcealedSpec("plane", List.of(), 1, Setting.PLANAR, false, seed));
        Recording simulation = made.beside().get("simulation.csv.gz");
        SimulatedPlane plane = SimulatedPlane.of(made.recording(), all(simulation), INPUT, PLACES).orElseThrow();
        PlaneNet net = plane.best(plane.plain(), (step, share) -> {});
        double[][] sensors = {{-0.1, 0.12}, {0.1, 0.45}, {0.0, 0.88}};
        double[] widths = {0.01, 0.01, 0.02};
        for (int i = 0; i < PLACES.size(); i++) {
            PlaneNet.Part part = net.parts().get(i);
            assertEquals(PLACES.get(i), part.name());
            assertEquals(sensors[i][0], part.sensors().x(), widths[i], part.name() + " x [m]");
            assertEquals(sensors[i][1], part.sensors().z(), widths[i], part.name() + " z [m]");
        }
        Model model = plane.model(net, 55);
        double[][] read = SimulatedPlane.outputs(model, made.recording());
        for (int o = 0; o < read.length; o++) {
            double missed = Missed.share(plane.given(model.outputs().get(o)), read[o], 180);
            assertTrue(missed < 0.01, model.outputs().get(o) + " misses " + missed);
        }
    }

    /** A net read as its user would write it does what its matrices say: the fit that begins there has nothing to do. */
    @Test
    void aNetAndItsModelAreOneThing() {
        Model model = ModelFile.parse(TWO_BODIES, "two bodies");
        Model.Base base = model.base();
        Model flat = new Model(model.name(), model.source(), model.axis(),
                new Model.Base(base.name(), base.sensor(), 0, base.further(), java.util.Optional.empty()),
                model.bodies(), model.links(), model.inputs(), model.declared(), model.sensors());
        Recording ride = ride(new Well19937c(5), 9600);
        double[][] read = SimulatedPlane.outputs(flat, ride);
        Map<Channel, double[]> simulated = new LinkedHashMap<>();
        IntStream.range(0, read.length).forEach(o -> simulated.put(model.outputs().get(o), read[o]));
        SimulatedPlane plane = SimulatedPlane.of(ride, simulated, INPUT, List.of("pelvis", "head")).orElseThrow();
        PlaneNet net = plane.plain();
        Model found = plane.model(net, model.mass());
        double[][] again = SimulatedPlane
                .outputs(new Model(found.name(), found.source(), found.axis(), flat.base(), found.bodies(), found.links(), found.inputs(),
                        found.declared(), found.sensors()), ride);
        for (int o = 0; o < read.length; o++) {
            double missed = Missed.share(read[model.outputs().indexOf(found.outputs().get(o))], again[o], 180);
            assertTrue(missed < 3e-3, found.outputs().get(o) + " misses " + missed);
        }
        assertEquals(0.8, net.parts().get(1).sensors().z(), 0.01);
        assertEquals(40.0 / 6, net.parts().get(0).mass() / net.parts().get(1).mass(), 1.5);
    }

    /** Viscera and legs that hang loose: no sensor is on them, and neither alone makes up for half of what the other does. */
    @Test
    void bodiesThatNobodyMeasuredAreFoundThoughNoneHalvesWhatIsMissed() {
        Recording ride = ride(new Well19937c(7), 4800);
        Map<Channel, double[]> simulated = simulated(ModelFile.parse(LOOSE, "loose"), ride);
        SimulatedPlane plane = SimulatedPlane.of(ride, simulated, INPUT, List.of("pelvis", "head")).orElseThrow();
        PlaneNet net = plane.best(plane.plain(), (step, share) -> {});
        assertEquals(List.of("pelvis", "head", "unmeasured1", "unmeasured2"), net.parts().stream().map(PlaneNet.Part::name).toList());
        simulated(plane.model(net, 63), ride).forEach((channel, read) -> {
            double missed = Missed.share(simulated.get(channel), read, 180);
            assertTrue(missed < 0.02, channel + " misses " + missed);
        });
    }

    /** Of a simulation whose head is said to move along x as no linear body does, all but that is asked; along z it would be refused. */
    @Test
    void whatNoBodyInThePlaneDoesIsNotAsked() {
        Recording ride = ride(new Well19937c(8), 2400);
        Map<Channel, double[]> simulated = simulated(ModelFile.parse(TWO_BODIES, "two bodies"), ride);
        Channel strange = Channel.parse("head.acc.x");
        simulated.put(strange, new java.util.Random(9).doubles(2400, -1, 1).toArray());
        Surrogate found = surrogate(ride, simulated);
        assertEquals(Set.of(strange), found.unasked().keySet());
        assertTrue(!found.model().outputs().contains(strange) && found.model().outputs().size() == 5, found.model().outputs().toString());
        assertTrue(found.sentence().contains("; not asked, since it misses 1"), found.sentence());
    }

    /** Noise of what drove a simulation above the band that models are run in. */
    @Test
    void whatLiesBeyondTheBandIsNotMissed() {
        Recording ride = ride(new Well19937c(10), 2400);
        Map<Channel, double[]> simulated = simulated(ModelFile.parse(TWO_BODIES, "two bodies"), ride);
        Channel head = Channel.parse("head.acc.x");
        double[] shrill = simulated.get(head).clone();
        java.util.Arrays.setAll(shrill, i -> shrill[i] + 0.3 * Math.sin(2 * Math.PI * 28.5 * i / 60));
        simulated.put(head, shrill);
        Surrogate found = surrogate(ride, simulated);
        assertEquals(0, found.errors().get(head), 0.04);
    }

    private static Surrogate surrogate(Recording ride, Map<Channel, double[]> simulated) {
        Map<Channel, double[]> all = new LinkedHashMap<>(simulated);
        ride.channels().forEach(channel -> all.put(channel, ride.values(channel)));
        return Surrogate.of(new Recording(ride.clock(), all, Metadata.NONE),
                Simulated.of(new Recording(ride.clock(), simulated, Metadata.NONE), "sim.csv", INPUT), (step, share) -> {});
    }

    /** What a model does to first order, by channel. */
    private static Map<Channel, double[]> simulated(Model model, Recording ride) {
        Model.Base base = model.base();
        Model flat = new Model(model.name(), model.source(), model.axis(),
                new Model.Base(base.name(), base.sensor(), 0, base.further(), java.util.Optional.empty()),
                model.bodies(), model.links(), model.inputs(), model.declared(), model.sensors());
        double[][] read = SimulatedPlane.outputs(flat, ride);
        Map<Channel, double[]> out = new LinkedHashMap<>();
        IntStream.range(0, read.length).forEach(o -> out.put(model.outputs().get(o), read[o]));
        return out;
    }

    /** Along one axis there is no plane. */
    @Test
    void verticalsAloneAreNoPlane() {
        Recording ride = ride(new Well19937c(6), 1200);
        Map<Channel, double[]> heads = Map.of(Channel.parse("head.acc.z"), ride.values(INPUT));
        assertTrue(SimulatedPlane.of(ride, heads, INPUT, List.of("head")).isEmpty());
        Recording alone = new Recording(ride.clock(), Map.of(INPUT, ride.values(INPUT)), Metadata.NONE);
        assertTrue(SimulatedPlane.of(alone, Map.of(Channel.parse("head.acc.x"), ride.values(INPUT)), INPUT, List.of("head")).isEmpty());
    }

    private static Map<Channel, double[]> all(Recording simulation) {
        Map<Channel, double[]> out = new LinkedHashMap<>();
        simulation.channels().forEach(channel -> out.put(channel, LostSamples.filled(simulation.values(channel))));
        return out;
    }

    /** A base that is shaken along and about everything, below 12 Hz. */
    private static Recording ride(Well19937c random, int samples) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (String axis : List.of("acc.z", "acc.x", "gyr.y")) {
            double[] x = new double[samples];
            for (int line = 0; line < 150; line++) {
                double f = 0.3 + 12 * random.nextDouble();
                double phase = 2 * Math.PI * random.nextDouble();
                double size = axis.startsWith("gyr") ? 0.004 : 0.1;
                for (int i = 0; i < samples; i++) {
                    x[i] += size * Math.cos(2 * Math.PI * f * i / 60 + phase);
                }
            }
            values.put(Channel.parse("platform." + axis), x);
        }
        return new Recording(new Clock(0, 60), values, Metadata.NONE);
    }

    private static final String TWO_BODIES = """
            {"name": "two bodies", "plane": "xz", "axis": "z",
             "base": {"name": "platform", "at_m": [0, 0], "sensors": ["platform.acc.z", "platform.acc.x", "platform.gyr.y"]},
             "bodies": [
               {"name": "pelvis", "at_m": [0.02, 0.2], "mass_kg": 40, "inertia_kgm2": 1.2, "sensors": [
                 {"sensor": "pelvis.acc.z", "at_m": [0.1, 0.2]}, {"sensor": "pelvis.acc.x", "at_m": [0.1, 0.2]},
                 {"sensor": "pelvis.gyr.y", "at_m": [0.1, 0.2]}]},
               {"name": "head", "at_m": [0, 0.75], "mass_kg": 6, "inertia_kgm2": 0.04, "sensors": [
                 {"sensor": "head.acc.z", "at_m": [0, 0.8]}, {"sensor": "head.acc.x", "at_m": [0, 0.8]},
                 {"sensor": "head.gyr.y", "at_m": [0, 0.8]}]}],
             "links": [
               {"from": "platform", "to": "pelvis", "along": "z", "at_m": [0, 0.02], "stiffness_N_per_m": 45000, "damping_Ns_per_m": 900},
               {"from": "platform", "to": "pelvis", "along": "x", "at_m": [0, 0.02], "stiffness_N_per_m": 30000, "damping_Ns_per_m": 700},
               {"from": "platform", "to": "pelvis", "about": "y", "stiffness_Nm_per_rad": 2500, "damping_Nms_per_rad": 60},
               {"from": "pelvis", "to": "head", "along": "z", "at_m": [0, 0.55], "stiffness_N_per_m": 30000, "damping_Ns_per_m": 300},
               {"from": "pelvis", "to": "head", "along": "x", "at_m": [0, 0.55], "stiffness_N_per_m": 16000, "damping_Ns_per_m": 150},
               {"from": "pelvis", "to": "head", "about": "y", "stiffness_Nm_per_rad": 60, "damping_Nms_per_rad": 1.5}]}
            """;

    private static final String LOOSE = TWO_BODIES.replace("\"bodies\": [", """
            "bodies": [
               {"name": "viscera", "at_m": [0.05, 0.35], "mass_kg": 8}, {"name": "legs", "at_m": [0.25, 0.15], "mass_kg": 9},
            """).replace("\"links\": [", """
            "links": [
               {"from": "pelvis", "to": "viscera", "along": "z", "at_m": [0.05, 0.35], "stiffness_N_per_m": 9000,
                "damping_Ns_per_m": 130},
               {"from": "pelvis", "to": "viscera", "along": "x", "at_m": [0.05, 0.35], "stiffness_N_per_m": 8000,
                "damping_Ns_per_m": 130},
               {"from": "pelvis", "to": "legs", "along": "z", "at_m": [0.25, 0.15], "stiffness_N_per_m": 20000,
                "damping_Ns_per_m": 250},
               {"from": "pelvis", "to": "legs", "along": "x", "at_m": [0.25, 0.15], "stiffness_N_per_m": 60000,
                "damping_Ns_per_m": 400},
            """);
}
