package wbv.diagnosis.surrogate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.Random;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import wbv.body.Model;
import wbv.body.law.CoulombFriction;
import wbv.body.law.CubicSpring;
import wbv.body.law.Law;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.diagnosis.Diagnosis;
import wbv.diagnosis.Predicted;
import wbv.diagnosis.fit.Evidence;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;
import wbv.signal.LostSamples;

/** A simulation of which only the outputs are known, and the linear model that does the same. */
class SurrogateTest {

    private static final double RATE = 60;
    private static final int N = 2400;
    private static final Channel BASE = Channel.parse("platform.acc.z");
    private static final double G = 9.80665;

    /** Up to a common factor, which accelerations do not know. */
    @Test
    void theSurrogateOfAChainIsTheChain() {
        Model truth = chain(List.of("pelvis", "sternum", "head"), List.of());
        Surrogate found = of(recording(truth), simulation(truth));
        assertEquals(55, found.model().mass(), 1e-9);
        double factor = truth.mass() / found.model().mass();
        for (int i = 0; i < 3; i++) {
            Model.Link link = truth.links().get(i);
            assertEquals(link.name(), found.model().links().get(i).name());
            assertEquals(link.stiffness(), factor * found.model().links().get(i).stiffness(), 1e-3 * link.stiffness());
            assertEquals(link.damping(), factor * found.model().links().get(i).damping(), 1e-3 * link.damping());
            assertEquals(truth.bodies().get(i).mass(), factor * found.model().bodies().get(i).mass(),
                    1e-3 * truth.bodies().get(i).mass());
        }
        found.errors().values().forEach(error -> assertEquals(0, error, 1e-3));
        assertTrue(found.sentence().contains("55.0 kg is assumed") && found.sentence().contains("under 0.01 % of head.acc.z"),
                found.sentence());
    }

    /** Places that say nothing of their order, in columns that are in none. */
    @Tag("slow")
    @Test
    void theOrderOfTheBodiesIsFound() {
        Model truth = chain(List.of("q", "r", "p"), List.of());
        Recording simulation = simulation(truth);
        Map<Channel, double[]> sorted = new LinkedHashMap<>();
        simulation.channels().stream().sorted(Comparator.comparing(Channel::toString))
                .forEach(channel -> sorted.put(channel, simulation.values(channel)));
        Surrogate found = of(recording(truth), new Recording(simulation.clock(), sorted, Metadata.NONE));
        assertEquals(List.of("platform-q", "q-r", "r-p"), found.model().links().stream().map(Model.Link::name).toList());
    }

    /** On a platform that shakes up to 100 Hz; their order is no usual one. */
    @Test
    void whichBodyHangsOnWhichIsReadFromTheirMotion() {
        Model truth = chain(List.of("head", "frame", "pelvis"), List.of());
        Random random = new Random(8);
        double[] platform = random.doubles(N, -1, 1).toArray();
        Recording base = new Recording(new Clock(0, 200), Map.of(BASE, platform), Metadata.NONE);
        double[][] outputs = new Simulator(Excitation.of(truth, base, N)).outputs(truth.assembly());
        Map<Channel, double[]> values = new LinkedHashMap<>();
        for (int o : new int[] {2, 0, 1}) {
            values.put(truth.outputs().get(o), outputs[o]);
        }
        Recording simulation = new Recording(base.clock(), values, Metadata.NONE);
        Model read = ReadChain.of(with(simulation, BASE, platform), BASE, simulation.channels()).orElseThrow();
        assertEquals(List.of("platform-head", "head-frame", "frame-pelvis"),
                read.links().stream().map(Model.Link::name).toList());
        double factor = truth.mass() / read.mass();
        for (Model.Link link : truth.links()) {
            Model.Link own = read.links().stream().filter(each -> each.name().equals(link.name())).findFirst().orElseThrow();
            assertEquals(link.stiffness(), factor * own.stiffness(), 1e-5 * link.stiffness(), link.name());
            assertEquals(link.damping(), factor * own.damping(), 1e-5 * link.damping(), link.name());
        }
    }

    /** Places that are no sitter's, unless the user says otherwise: nothing of it is slowed down or left out. */
    @Test
    void whatNamesNoPlaceOfASitterIsARigAtItsOwnRate() {
        Model truth = chain(List.of("table", "frame"), List.of()).declaredAs(Model.Subject.RIG);
        double[] platform = new Random(9).doubles(2 * N, -1, 1).toArray();
        Recording base = new Recording(new Clock(0, 200), Map.of(BASE, platform), Metadata.NONE);
        double[][] outputs = new Simulator(Excitation.of(truth, base, platform.length)).outputs(truth.assembly());
        Recording simulation = new Recording(base.clock(),
                Map.of(truth.outputs().get(0), outputs[0], truth.outputs().get(1), outputs[1]), Metadata.NONE);
        Recording both = with(simulation, BASE, platform);
        Surrogate found = Surrogate.of(both, new Simulated(simulation, "sim.csv", BASE, Optional.empty(), OptionalDouble.of(48)),
                (step, share) -> {});
        assertTrue(found.model().isRig() && found.sentence().contains("as a rig; its mass of 48.0 kg is given"), found.sentence());
        assertEquals(62000, found.model().links().get(0).stiffness(), 62);
        found.errors().values().forEach(error -> assertEquals(0, error, 1e-3));
        Surrogate person = Surrogate.of(both,
                new Simulated(simulation, "sim.csv", BASE, Optional.of(Model.Subject.PERSON), OptionalDouble.empty()), (step, share) -> {});
        assertTrue(!person.model().isRig(), person.sentence());
    }

    /** Neither the pelvis nor its sensor: a body between the two that are known does it. */
    @Tag("slow")
    @Test
    void aBodyThatNobodyMeasuredIsAdded() {
        Model truth = chain(List.of("pelvis", "sternum", "head"), List.of());
        List<Channel> known = List.of(Channel.parse("sternum.acc.z"), Channel.parse("head.acc.z"));
        Surrogate found = of(recording(truth), simulation(truth.seenBy(known)));
        assertEquals(3, found.model().bodies().size(), found.sentence());
        assertEquals(known, found.model().outputs());
        found.errors().values().forEach(error -> assertEquals(0, error, 5e-3));
    }

    /** An output that was simulated and not recorded helps to identify, and is no sensor afterwards. */
    @Test
    void onlyWhatWasRecordedIsASensor() {
        Model truth = chain(List.of("pelvis", "sternum", "head"), List.of());
        Recording recording = recording(truth.seenBy(List.of(Channel.parse("head.acc.z"))));
        Surrogate found = of(recording, simulation(truth));
        assertEquals(List.of(Channel.parse("head.acc.z")), found.model().outputs());
        assertEquals(3, found.errors().size());
        // What it gave beside the model is in the recording that is asked of then, and was not measured.
        assertEquals(Set.of(Channel.parse("head_beside.acc.z")), new Evidence(found.model(), found.recording()).beside());
    }

    @Test
    void aPersonsMassIsUsedWhereItIsKnown() {
        Model truth = chain(List.of("head"), List.of());
        Recording recording = recording(truth);
        Metadata.Subject person = new Metadata.Subject(OptionalDouble.of(80), OptionalDouble.empty(), OptionalDouble.empty(),
                Optional.empty());
        Metadata metadata = new Metadata(OptionalDouble.empty(), Map.of(), Optional.of(person), Optional.empty(),
                OptionalDouble.empty(), Optional.empty(), Map.of());
        Map<Channel, double[]> values = recording.channels().stream().collect(Collectors.toMap(c -> c, recording::values));
        assertEquals(0.73 * 80, of(new Recording(recording.clock(), values, metadata), simulation(truth)).model().mass(), 1e-9);
    }

    /** The same samples at the same times, whichever of the two files begins first. */
    @Test
    void aSimulationOfAPartServes() {
        Model truth = chain(List.of("sternum", "head"), List.of());
        Recording simulation = simulation(truth);
        Map<Channel, double[]> late = new LinkedHashMap<>();
        simulation.channels().forEach(channel -> late.put(channel, Arrays.copyOfRange(simulation.values(channel), 300, N)));
        Surrogate found = of(recording(truth), new Recording(new Clock(300 / RATE, RATE), late, Metadata.NONE));
        found.errors().values().forEach(error -> assertEquals(0, error, 1e-3));
        assertTrue(refused(recording(truth), new Recording(new Clock(300.5 / RATE, RATE), late,
                Metadata.NONE)).contains("not on the recording's clock"));
    }

    @Test
    void gapsOfTheInputAreNoErrorOfTheSurrogate() {
        Model truth = chain(List.of("sternum", "head"), List.of());
        Recording gaps = changed(recording(truth), "platform", x -> {
            double[] y = x.clone();
            for (int k = 0; k < 5; k++) {
                Arrays.fill(y, 300 + 400 * k, 306 + 400 * k, Double.NaN);
            }
            return y;
        });
        double[][] outputs = new Simulator(new Excitation(RATE, LostSamples.filled(gaps.values(BASE)), Map.of())).outputs(truth.assembly());
        Recording simulation = new Recording(gaps.clock(), Map.of(truth.outputs().get(0), outputs[0], truth.outputs().get(1), outputs[1]),
                Metadata.NONE);
        of(gaps, simulation).errors().values().forEach(error -> assertEquals(0, error, 5e-3));
    }

    /** An integrator of its own, with 32 steps a sample, that takes the input for constant over each. */
    @Tag("slow")
    @Test
    void aSimulationThatHoldsItsInputIsSeenThrough() {
        Model truth = chain(List.of("sternum", "head"), List.of());
        double[] base = base();
        double[][] outputs = new double[2][N];
        double[] q = new double[2];
        double[] v = new double[2];
        double step = 1 / RATE / 32;
        for (int i = 0; i < 32 * N; i++) {
            double[] force = new double[3];
            for (int l = 0; l < 2; l++) {
                Model.Link link = truth.links().get(l);
                force[l] = link.stiffness() * (q[l] - (l == 0 ? 0 : q[l - 1]))
                        + link.damping() * (v[l] - (l == 0 ? 0 : v[l - 1]));
            }
            for (int b = 0; b < 2; b++) {
                double absolute = (force[b + 1] - force[b]) / truth.bodies().get(b).mass();
                if (i % 32 == 0) {
                    outputs[b][i / 32] = absolute;
                }
                v[b] += step * (absolute - base[i / 32]);
                q[b] += step * v[b];
            }
        }
        Map<Channel, double[]> values = new LinkedHashMap<>();
        values.put(Channel.parse("sternum.acc.z"), outputs[0]);
        values.put(Channel.parse("head.acc.z"), outputs[1]);
        Surrogate found = of(recording(truth), new Recording(new Clock(0, RATE), values, Metadata.NONE));
        assertTrue(found.sentence().contains("its input held over each sample"), found.sentence());
        double[][] right = outputs(truth);
        double[][] surrogate = new Simulator(Excitation.of(found.model(), found.recording(), N)).outputs(found.model().assembly());
        for (int b = 0; b < 2; b++) {
            assertTrue(Missed.share(right[b], surrogate[b], 60) < Missed.share(right[b], outputs[b], 60) / 3);
        }
    }

    @Test
    void anOutputThatMovesWithTheBaseIsNoBody() {
        Model truth = chain(List.of("sternum", "head"), List.of());
        Recording simulation = simulation(truth);
        Map<Channel, double[]> more = new LinkedHashMap<>(Map.of(Channel.parse("seat.acc.z"), base()));
        simulation.channels().forEach(channel -> more.put(channel, simulation.values(channel)));
        Map<Channel, double[]> recorded = new LinkedHashMap<>(Map.of(Channel.parse("seat.acc.z"), base()));
        Recording recording = recording(truth);
        recording.channels().forEach(channel -> recorded.put(channel, recording.values(channel)));
        Surrogate found = of(new Recording(recording.clock(), recorded, Metadata.NONE),
                new Recording(simulation.clock(), more, Metadata.NONE));
        assertEquals(truth.links().stream().map(Model.Link::name).toList(),
                found.model().links().stream().map(Model.Link::name).toList());
    }

    @Tag("slow")
    @Test
    void whatNoChainDoesIsRefused() {
        Model truth = chain(List.of("sternum", "head"), List.of());
        String turned = refused(recording(truth), changed(simulation(truth), "head", y -> Arrays.stream(y)
                .map(v -> -v).toArray()));
        assertTrue(turned.startsWith("sim.csv: as it is,") && turned.contains("no chain of bodies driven by platform.acc.z does"), turned);
        Model sticking = chain(List.of("sternum", "head"), List.of(new CoulombFriction(60, 1e-3)));
        String friction = refused(recording(truth), simulation(sticking));
        assertTrue(friction.startsWith("sim.csv: ") && friction.contains("misses") && friction.contains("--model"), friction);
    }

    /** A simulation that no chain does is right where it does what was recorded. */
    @Test
    void anExactSimulationIsRightWhateverItsSurrogateMisses() {
        Model truth = chain(List.of("sternum", "head"), List.of(new CoulombFriction(20, 1e-3)));
        Surrogate.Examined examined = examined(recording(truth), simulation(truth));
        assertTrue(examined.surrogate().errors().values().stream().anyMatch(missed -> missed > 0.05), examined.surrogate().sentence());
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, examined.diagnosed().diagnosis().verdict(),
                examined.diagnosed().diagnosis().sentence());
        double[] simulated = simulation(truth).values(Channel.parse("head.acc.z"));
        Predicted predicted = examined.diagnosed().predicted();
        int first = (int) Math.round(predicted.time()[0] * RATE);
        for (int i = 0; i < predicted.time().length; i++) {
            assertEquals(simulated[first + i] - Arrays.stream(simulated).average().orElseThrow(), predicted.model()[1][i], 0.02,
                    "sample " + i);
        }
    }

    /**
     * A law in a person of whom the surrogate lacks a backrest, soft parts and arms: it is named, and data that nobody fitted are met,
     * since the way from its force to the sensors may differ from the surrogate's.
     */
    @Tag("slow")
    @Test
    void aLawIsCarriedBesideASurrogateThatMissesBodies() {
        Model person = person(List.of());
        Model truth = person(List.of(new CubicSpring(1.5e10)));
        Surrogate.Examined examined = examined(recording(truth), simulation(person));
        assertTrue(examined.surrogate().errors().values().stream().anyMatch(missed -> missed > 0.005), examined.surrogate().sentence());
        Diagnosis found = examined.diagnosed().diagnosis();
        assertTrue(!found.missing().isEmpty(), found.sentence());
        // Play in a link that is stiff outside it and a link that hardens are nearly one law where nothing is known of the spring.
        assertTrue(Stream.concat(found.missing().stream(), found.alternatives().stream())
                .anyMatch(named -> named.mechanism().equals("stiffness.hardening") && named.where().equals("pelvis-sternum")),
                found.sentence());
        assertEquals("pelvis-sternum", found.missing().get(0).where(), found.sentence());
        found.fit().nrmseAfter().forEach((channel, after) -> {
            double floor = found.fit().nrmseFloor().get(channel);
            assertTrue(after < 2 * floor, channel + ": " + after + " of " + found.fit().nrmseBefore().get(channel) + ", noise " + floor);
        });
    }

    /** @param laws between pelvis and sternum */
    private static Model person(List<Law> laws) {
        List<Model.Body> bodies = new java.util.ArrayList<>(chain(List.of("pelvis", "sternum", "head"), List.of()).bodies());
        List<Model.Link> links = new java.util.ArrayList<>(chain(List.of("pelvis", "sternum", "head"), List.of()).links());
        Model.Link spine = links.get(1);
        links.set(1, new Model.Link(spine.from(), spine.to(), spine.stiffness(), spine.damping(), Optional.empty(), laws, List.of()));
        bodies.add(new Model.Body("viscera", 6, Optional.empty(), List.of(), Optional.empty(), List.of()));
        bodies.add(new Model.Body("arms", 5, Optional.empty(), List.of(), Optional.empty(), List.of()));
        links.add(new Model.Link("pelvis", "viscera", 6000, 80, Optional.empty(), List.of(), List.of()));
        links.add(new Model.Link("sternum", "arms", 12000, 120, Optional.empty(), List.of(), List.of()));
        links.add(new Model.Link("platform", "sternum", 12000, 400, Optional.empty(), List.of(), List.of()));
        return new Model("person", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)), bodies, links);
    }

    /** Rotation of the base that lifts the head is no part of the chain, and none of what it misses. */
    @Tag("slow")
    @Test
    void theOtherChannelsOfTheBaseAreInputs() {
        Model truth = chain(List.of("sternum", "head"), List.of());
        Recording simulation = rocked(simulation(truth), 1);
        Recording recording = with(rocked(recording(truth), 1), PITCH, pitch());
        double alone = of(rocked(recording(truth), 1), simulation).errors().get(Channel.parse("head.acc.z"));
        Surrogate found = of(recording, simulation);
        assertTrue(alone > 0.1, "missed by z alone: " + alone);
        found.errors().values().forEach(error -> assertEquals(0, error, 0.01, found.sentence()));
        assertTrue(found.sentence().contains("beside what platform.gyr.y did"), found.sentence());
        Diagnosis exact = examined(recording, simulation).diagnosed().diagnosis();
        assertEquals(Diagnosis.Verdict.NOTHING_MISSING, exact.verdict(), exact.sentence());
        Model stiffer = new Model(truth.name(), truth.source(), truth.axis(), truth.base(), truth.bodies(),
                truth.links().stream().map(link -> new Model.Link(link.from(), link.to(), 1.1 * link.stiffness(), link.damping(),
                        link.sensor(), link.laws(), link.drives())).toList());
        Diagnosis wrong = examined(recording, rocked(simulation(stiffer), 1)).diagnosed().diagnosis();
        assertEquals(Diagnosis.Verdict.PARAMETERS_ONLY, wrong.verdict(), wrong.sentence());
    }

    /** The head on an arm over the axis about which the base turns, with a resonance of its own. @param metres of arm */
    private static Recording rocked(Recording recording, double metres) {
        double[] turning = pitch();
        double[] moved = new double[N];
        double state = 0;
        for (int j = 1; j < N; j++) {
            state += 0.3 * ((turning[j] - turning[j - 1]) * RATE - state);
            moved[j] = metres * state;
        }
        return changed(recording, "head", y -> {
            double[] out = y.clone();
            for (int j = 0; j < N; j++) {
                out[j] += moved[j];
            }
            return out;
        });
    }

    private static final Channel PITCH = Channel.parse("platform.gyr.y");

    private static double[] pitch() {
        Random random = new Random(31);
        double[] phase = random.doubles(60, 0, 2 * Math.PI).toArray();
        double[] out = new double[N];
        for (int j = 0; j < N; j++) {
            for (int k = 0; k < phase.length; k++) {
                out[j] += 0.002 * Math.min(1, j / RATE / 2) * Math.sin(2 * Math.PI * (0.4 + 0.11 * k) * j / RATE + phase[k]);
            }
        }
        return out;
    }

    private static Recording with(Recording recording, Channel channel, double[] x) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(each -> values.put(each, recording.values(each)));
        values.put(channel, x);
        return new Recording(recording.clock(), values, recording.metadata());
    }

    private static Surrogate.Examined examined(Recording recording, Recording simulation) {
        return Surrogate.examine(recording, Simulated.of(simulation, "sim.csv", BASE), OptionalDouble.empty(), false, (step, share) -> {});
    }

    @Test
    void aSimulationInGIsRefused() {
        Model truth = chain(List.of("sternum", "head"), List.of());
        Recording simulation = simulation(truth);
        for (String place : List.of("sternum", "head")) {
            simulation = changed(simulation, place, y -> Arrays.stream(y).map(v -> v / G).toArray());
        }
        String fault = refused(recording(truth), simulation);
        assertTrue(fault.contains("in g"), fault);
    }

    private static Surrogate of(Recording recording, Recording simulation) {
        return Surrogate.of(recording, Simulated.of(simulation, "sim.csv", BASE), (step, share) -> {});
    }

    private static String refused(Recording recording, Recording simulation) {
        return assertThrows(DataFault.class, () -> examined(recording, simulation)).getMessage();
    }

    /** @param laws on the lowest link */
    private static Model chain(List<String> places, List<Law> laws) {
        double[] mass = {14, 34, 6};
        double[] stiffness = {62000, 75000, 22000};
        double[] damping = {1500, 1100, 160};
        List<Model.Body> bodies = new java.util.ArrayList<>();
        List<Model.Link> links = new java.util.ArrayList<>();
        String below = "platform";
        for (int i = 0; i < places.size(); i++) {
            String place = places.get(i);
            bodies.add(new Model.Body(place, mass[i], Optional.of(Channel.parse(place + ".acc.z")), List.of(), Optional.empty(),
                    List.of()));
            links.add(new Model.Link(below, place, stiffness[i], damping[i], Optional.empty(), i == 0 ? laws : List.of(),
                    List.of()));
            below = place;
        }
        return new Model("chain", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)), bodies, links);
    }

    /** What sensors with noise make of the model's ride. */
    private static Recording recording(Model model) {
        Random random = new Random(4);
        Map<Channel, double[]> values = new LinkedHashMap<>();
        values.put(BASE, base());
        double[][] outputs = outputs(model);
        for (int o = 0; o < outputs.length; o++) {
            values.put(model.outputs().get(o), Arrays.stream(outputs[o]).map(y -> y + 0.01 * random.nextGaussian()).toArray());
        }
        return new Recording(new Clock(0, RATE), values, Metadata.NONE);
    }

    private static Recording simulation(Model model) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        double[][] outputs = outputs(model);
        for (int o = 0; o < outputs.length; o++) {
            values.put(model.outputs().get(o), outputs[o]);
        }
        return new Recording(new Clock(0, RATE), values, Metadata.NONE);
    }

    private static double[][] outputs(Model model) {
        return new Simulator(new Excitation(RATE, base(), Map.of())).outputs(model.assembly());
    }

    private static Recording changed(Recording recording, String place, UnaryOperator<double[]> change) {
        Map<Channel, double[]> values = new LinkedHashMap<>();
        recording.channels().forEach(channel -> values.put(channel, channel.location().equals(place)
                ? change.apply(recording.values(channel))
                : recording.values(channel)));
        return new Recording(recording.clock(), values, recording.metadata());
    }

    private static double[] base() {
        Random random = new Random(9);
        double[] phase = random.doubles(150, 0, 2 * Math.PI).toArray();
        double[] base = new double[N];
        for (int j = 0; j < N; j++) {
            for (int k = 0; k < phase.length; k++) {
                base[j] += 0.08 * Math.min(1, j / RATE / 2) * Math.sin(2 * Math.PI * (0.5 + 0.08 * k) * j / RATE + phase[k]);
            }
            base[j] += 0.01 * random.nextGaussian();
        }
        return base;
    }
}
