package wbv.fmi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.complex.ComplexField;
import org.apache.commons.math3.linear.Array2DRowFieldMatrix;
import org.apache.commons.math3.linear.ArrayFieldVector;
import org.apache.commons.math3.linear.FieldLUDecomposition;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.Model;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Recording;

/** Units of both versions, run in every way, against wbv's own simulator and closed forms. */
class FmuSimulationTest {

    private static final double RATE = 60;
    private static final Channel BASE = Channel.parse("platform.acc.z");

    @TempDir
    private Path folder;

    @BeforeAll
    static void compiler() {
        BuiltUnit.needsCompiler();
    }

    static Stream<Arguments> ways() {
        return Stream.of(Arguments.of(2, "steps", BuiltUnit.STEPS), Arguments.of(2, "slopes", BuiltUnit.SLOPES),
                Arguments.of(2, "derivatives", BuiltUnit.DERIVATIVES),
                Arguments.of(3, "steps", BuiltUnit.STEPS), Arguments.of(3, "derivatives", BuiltUnit.DERIVATIVES));
    }

    /** Random noise from 0.7 to 12 Hz that begins and ends in silence. */
    static double[] noise(int samples, double rate, double level, long seed) {
        Random random = new Random(seed);
        double[] out = new double[samples];
        for (int k = 0; k < 60; k++) {
            double f = 0.7 + 11.3 * random.nextDouble();
            double phase = 2 * Math.PI * random.nextDouble();
            for (int i = 0; i < samples; i++) {
                out[i] += level / Math.sqrt(30) * Math.sin(2 * Math.PI * f * i / rate + phase);
            }
        }
        for (int i = 0; i < samples; i++) {
            double edge = Math.min(1, Math.min(i, samples - 1 - i) / (2 * rate));
            out[i] *= Math.pow(Math.sin(Math.PI / 2 * edge), 2);
        }
        return out;
    }

    static Model quarterCar() {
        double[] p = BuiltUnit.QUARTER_CAR.parameters().stream().mapToDouble(BuiltUnit.Parameter::start).toArray();
        String[] names = {"platform", "axle", "body", "seat"};
        List<Model.Body> bodies = new ArrayList<>();
        List<Model.Link> links = new ArrayList<>();
        for (int b = 0; b < 3; b++) {
            bodies.add(new Model.Body(names[b + 1], p[3 * b], Optional.of(Channel.parse(names[b + 1] + ".acc.z")), List.of(),
                    Optional.empty(), List.of()));
            links.add(new Model.Link(names[b], names[b + 1], p[3 * b + 1], p[3 * b + 2], Optional.empty(), List.of(), List.of()));
        }
        return new Model("quarter car", Optional.empty(), 'z', new Model.Base("platform", Optional.of(BASE)), bodies, links);
    }

    @Tag("slow")
    @ParameterizedTest(name = "FMI {0}.0 by {1}")
    @MethodSource("ways")
    void theQuarterCarIsThatOfTheSimulator(int version, String way, List<String> ways) throws IOException {
        double[] base = noise(1800, RATE, 1, 1);
        Recording recording = new Recording(new Clock(0, RATE), Map.of(BASE, base), Metadata.NONE);
        Path file = BuiltUnit.build(folder, "car.fmu", BuiltUnit.QUARTER_CAR, version, ways);
        double mean = java.util.Arrays.stream(base).average().orElse(0);
        double[][] expected = new Simulator(new Excitation(RATE, java.util.Arrays.stream(base).map(x -> x - mean).toArray(), Map.of()))
                .outputs(quarterCar().assembly());
        try (FmuSimulation simulation = FmuSimulation.open(file, recording, Map.of(), Map.of())) {
            Recording found = simulation.run(Map.of());
            for (int o = 0; o < 3; o++) {
                assertEquals(0, error(expected[o], found.values(simulation.outputs().get(o)), 0), 1e-4, simulation.notes().toString());
            }
            assertEquals(List.of("force.suspension", "force.seat"), simulation.places());
            assertTrue(simulation.notes().toString()
                    .contains("no channel for the input force.suspension, held at 0.0 N; a place where a force may act"));
        }
    }

    /** Root mean square of the difference over that of the first. @param from first sample that counts */
    private static double error(double[] expected, double[] found, int from) {
        double sum = 0;
        double whole = 0;
        for (int i = from; i < expected.length; i++) {
            sum += Math.pow(expected[i] - found[i], 2);
            whole += Math.pow(expected[i], 2);
        }
        return Math.sqrt(sum / whole);
    }

    /** All inputs at once, each a sum of tones of its own; after six seconds what is left is the answer to the tones. */
    @Tag("slow")
    @ParameterizedTest(name = "FMI {0}.0 by {1}")
    @MethodSource("ways")
    void thePlanarPersonAnswersTonesAsAlgebraSays(int version, String way, List<String> ways) throws IOException {
        int n = 1200;
        Channel[] inputs = {Channel.parse("platform.acc.x"), BASE, Channel.parse("platform.gyr.y")};
        double[][] tones = {{1, 2.5, 6}, {1.5, 4, 9}, {0.5, 3, 5}};
        Map<Channel, double[]> values = new LinkedHashMap<>();
        Channel[] outputs = Stream.of("sternum.acc.x", "sternum.acc.z", "sternum.gyr.y", "head.acc.x", "head.acc.z", "head.gyr.y")
                .map(Channel::parse).toArray(Channel[]::new);
        double[][] expected = new double[6][n];
        for (int i = 0; i < 3; i++) {
            double[] own = new double[n];
            for (double f : tones[i]) {
                Complex[] answer = planar(2 * Math.PI * f, i);
                // A whole number of periods, so that the mean is 0.
                for (int t = 0; t < n; t++) {
                    double angle = 2 * Math.PI * f * t / RATE;
                    own[t] += (i == 2 ? 0.1 : 1) * Math.sin(angle);
                    for (int o = 0; o < 6; o++) {
                        expected[o][t] += (i == 2 ? 0.1 : 1)
                                * answer[o].multiply(new Complex(Math.cos(angle), Math.sin(angle))).getImaginary();
                    }
                }
            }
            values.put(inputs[i], own);
        }
        Recording recording = new Recording(new Clock(0, RATE), values, Metadata.NONE);
        Path file = BuiltUnit.build(folder, "person.fmu", BuiltUnit.PLANAR_PERSON, version, ways);
        try (FmuSimulation simulation = FmuSimulation.open(file, recording, Map.of(), Map.of())) {
            Recording found = simulation.run(Map.of());
            for (int o = 0; o < 6; o++) {
                // The last second is left out: beyond the end nobody knows the input.
                double[] whole = java.util.Arrays.copyOf(expected[o], n - 60);
                assertEquals(0, error(whole, found.values(outputs[o]), 480), 1e-4, outputs[o] + " " + simulation.notes());
            }
        }
    }

    /**
     * Amplitudes of the outputs over one of the inputs: M q'' = sum of J' (k + jwc) (J_plate q_plate - J q), written with the rows of
     * bushings, not with forces on bodies as the unit does.
     */
    private static Complex[] planar(double w, int input) {
        Complex jw = new Complex(0, w);
        double[] mass = {45, 45, 3.2, 5.2, 5.2, 0.035};
        // Extension of each spring by trunk x z pitch, head x z pitch, plate pitch; stiffness, damping.
        double[][] rows = {{-1, 0, 0.25, 0, 0, 0, 0.1}, {0, -1, 0, 0, 0, 0, 0}, {-1, 0, -0.15, 0, 0, 0, 0.5}, {0, 0, -1, 0, 0, 0, 1},
            {-1, 0, -0.33, 1, 0, -0.09, 0}, {0, -1, 0.02, 0, 1, 0.02, 0}, {0, 0, -1, 0, 0, 1, 0}};
        double[][] values = {{20000, 500}, {60000, 900}, {15000, 400}, {450, 22}, {60000, 260}, {60000, 260}, {90, 3.5}};
        Complex[][] dynamic = new Complex[6][6];
        Complex[] right = new Complex[6];
        for (int i = 0; i < 6; i++) {
            right[i] = Complex.ZERO;
            for (int j = 0; j < 6; j++) {
                dynamic[i][j] = i == j ? new Complex(-w * w * mass[i]) : Complex.ZERO;
            }
        }
        Complex platePitch = input == 2 ? Complex.ONE.divide(jw) : Complex.ZERO;
        for (int s = 0; s < rows.length; s++) {
            Complex stiffness = new Complex(values[s][0], w * values[s][1]);
            for (int i = 0; i < 6; i++) {
                for (int j = 0; j < 6; j++) {
                    dynamic[i][j] = dynamic[i][j].add(stiffness.multiply(rows[s][i] * rows[s][j]));
                }
                right[i] = right[i].subtract(stiffness.multiply(rows[s][i] * rows[s][6]).multiply(platePitch));
            }
        }
        for (int i = 0; i < 6; i++) {
            boolean pushed = input < 2 && i % 3 == input;
            right[i] = pushed ? right[i].subtract(mass[i]) : right[i];
        }
        Complex[] q = new FieldLUDecomposition<>(new Array2DRowFieldMatrix<>(ComplexField.getInstance(), dynamic)).getSolver()
                .solve(new ArrayFieldVector<>(ComplexField.getInstance(), right)).toArray();
        Complex[] out = new Complex[6];
        for (int i = 0; i < 6; i++) {
            Complex moved = q[i].multiply(jw);
            out[i] = i % 3 == 2 ? moved : moved.multiply(jw).add(input < 2 && i % 3 == input ? 1 : 0);
        }
        return out;
    }

    /** Two bounces and a throw, at moments that no step hits. */
    @ParameterizedTest
    @org.junit.jupiter.params.provider.ValueSource(ints = {2, 3})
    void eventsAreFoundWhereTheyAre(int version) throws IOException {
        Recording recording = new Recording(new Clock(0, RATE), Map.of(BASE, new double[120]), Metadata.NONE);
        Path file = BuiltUnit.build(folder, "ball.fmu", BuiltUnit.BALL, version, BuiltUnit.DERIVATIVES);
        try (FmuSimulation simulation = FmuSimulation.open(file, recording, Map.of(), Map.of())) {
            double[] found = simulation.run(Map.of()).values(Channel.parse("ball.pos.z"));
            double g = 9.81;
            double first = Math.sqrt(2 / g);
            double up = 0.8 * g * first;
            double second = first + 2 * up / g;
            double kicked = 0.64 * g * first * (1.25 - second) - g / 2 * Math.pow(1.25 - second, 2);
            for (int i = 0; i < 115; i++) {
                double t = i / RATE;
                double expected = t < first ? 1 - g / 2 * t * t : t < second ? up * (t - first) - g / 2 * Math.pow(t - first, 2)
                        : t < 1.25 ? 0.8 * up * (t - second) - g / 2 * Math.pow(t - second, 2)
                                : kicked + 3 * (t - 1.25) - g / 2 * Math.pow(t - 1.25, 2);
                assertEquals(expected, found[i], 1e-7, "at " + t + " s");
            }
        }
    }

    /** Steps of 7 ms, which divide no sample. */
    @Test
    void aUnitWithAStepOfItsOwnIsRunByThat() throws IOException {
        double[] base = noise(1800, RATE, 1, 2);
        Recording recording = new Recording(new Clock(0, RATE), Map.of(BASE, base), Metadata.NONE);
        Path own = BuiltUnit.build(folder, "own.fmu", BuiltUnit.QUARTER_CAR, 3,
                List.of("<CoSimulation fixedInternalStepSize=\"0.0007\"/>"));
        Path any = BuiltUnit.build(folder, "any.fmu", BuiltUnit.QUARTER_CAR, 3, BuiltUnit.STEPS);
        try (FmuSimulation stepped = FmuSimulation.open(own, recording, Map.of(), Map.of());
                FmuSimulation free = FmuSimulation.open(any, recording, Map.of(), Map.of())) {
            Recording a = stepped.run(Map.of());
            Recording b = free.run(Map.of());
            a.channels().forEach(channel -> assertEquals(0, error(b.values(channel), a.values(channel), 0), 2e-3, channel.toString()));
            assertTrue(stepped.notes().get(0).contains("in its own steps of 0.0007"), stepped.notes().get(0));
        }
    }

    /** Millimetres in and out, names of its own. */
    @Test
    void namesAndUnitsAreTranslated() throws IOException {
        Recording recording = new Recording(new Clock(0, RATE), Map.of(BASE, noise(600, RATE, 1, 3)), Metadata.NONE);
        BuiltUnit.Plan plain = BuiltUnit.QUARTER_CAR;
        BuiltUnit.Plan odd = plain.inputs(BuiltUnit.ordered("road", "m/s2", "f1", "", "f2", ""))
                .outputs(BuiltUnit.ordered("axle", "m/s2", "car.body_acc_z", "m/s2",
                        "y", "m/s2"));
        Path file = BuiltUnit.build(folder, "plain.fmu", plain, 2, BuiltUnit.DERIVATIVES);
        Path other = BuiltUnit.build(folder, "odd.fmu", odd, 2, BuiltUnit.DERIVATIVES);
        BuiltUnit.Plan small = plain.outputs(BuiltUnit.ordered("axle.acc.z", "mm/s2", "body.acc.z", "m/s2", "seat.acc.z", "m/s2"));
        Path third = BuiltUnit.build(folder, "small.fmu", small, 2, BuiltUnit.DERIVATIVES);
        Channel seat = Channel.parse("seat.acc.z");
        Channel axle = Channel.parse("axle.acc.z");
        try (FmuSimulation a = FmuSimulation.open(file, recording, Map.of(), Map.of());
                FmuSimulation b = FmuSimulation.open(other, recording, Map.of("road", BASE), Map.of("y", seat));
                FmuSimulation c = FmuSimulation.open(third, recording, Map.of(), Map.of())) {
            assertEquals(List.of(Channel.parse("body.acc.z"), seat), b.outputs());
            assertTrue(b.notes().toString().contains("left out: [axle]") && b.notes().toString().contains("road = platform.acc.z"),
                    b.notes().toString());
            Recording first = a.run(Map.of());
            assertEquals(0, error(first.values(seat), b.run(Map.of()).values(seat), 0), 1e-5);
            assertEquals(first.values(axle)[300] / 1000, c.run(Map.of()).values(axle)[300], 1e-9);
        }
    }

    /** Derivatives to parameters are those of wbv's own simulator. */
    @Tag("slow")
    @Test
    void sensitivitiesAreThoseOfTheSimulator() throws IOException {
        double[] base = noise(1200, RATE, 1, 4);
        double mean = java.util.Arrays.stream(base).average().orElse(0);
        double[] centred = java.util.Arrays.stream(base).map(x -> x - mean).toArray();
        Recording recording = new Recording(new Clock(0, RATE), Map.of(BASE, base), Metadata.NONE);
        Excitation excitation = new Excitation(RATE, centred, Map.of());
        Simulator.Response response = new Simulator(excitation).run(quarterCar().assembly(), true);
        Path file = BuiltUnit.build(folder, "car.fmu", BuiltUnit.QUARTER_CAR, 3, BuiltUnit.DERIVATIVES);
        try (FmuSimulation simulation = FmuSimulation.open(file, recording, Map.of(), Map.of())) {
            double[][][] found = simulation.sensitivities(Map.of(),
                    List.of("tyre.k", "suspension.k", "seat.k", "tyre.c", "suspension.c", "seat.c"), 1200);
            for (int p = 0; p < 6; p++) {
                for (int o = 0; o < 3; o++) {
                    double[] expected = excitation.series(response.slopes()[p][o]);
                    assertEquals(0, error(expected, found[p][o], 0), 2e-3, "parameter " + p + ", output " + o);
                }
            }
        }
    }

    /** A tone of force between body and seat, against the algebra of M q'' = - E (K + jw C) E' q - e f. */
    @Test
    void aForceAtAPlacePullsWhatItJoinsTogether() throws IOException {
        int n = 900;
        double w = 2 * Math.PI * 4;
        Recording recording = new Recording(new Clock(0, RATE), Map.of(BASE, noise(n, RATE, 1, 5)), Metadata.NONE);
        Path file = BuiltUnit.build(folder, "car.fmu", BuiltUnit.QUARTER_CAR, 2, BuiltUnit.STEPS);
        double[] force = new double[n];
        java.util.Arrays.setAll(force, i -> 20 * Math.sin(w * i / RATE));
        double[] p = BuiltUnit.QUARTER_CAR.parameters().stream().mapToDouble(BuiltUnit.Parameter::start).toArray();
        double[][] stretch = {{1, 0, 0}, {-1, 1, 0}, {0, -1, 1}};
        Complex[][] dynamic = new Complex[3][3];
        Complex[] right = new Complex[3];
        for (int i = 0; i < 3; i++) {
            right[i] = new Complex(-20 * stretch[2][i]);
            for (int j = 0; j < 3; j++) {
                dynamic[i][j] = new Complex(i == j ? -w * w * p[3 * i] : 0);
                for (int l = 0; l < 3; l++) {
                    dynamic[i][j] = dynamic[i][j].add(new Complex(p[3 * l + 1], w * p[3 * l + 2]).multiply(stretch[l][i] * stretch[l][j]));
                }
            }
        }
        Complex[] q = new FieldLUDecomposition<>(new Array2DRowFieldMatrix<>(ComplexField.getInstance(), dynamic)).getSolver()
                .solve(new ArrayFieldVector<>(ComplexField.getInstance(), right)).toArray();
        try (FmuSimulation simulation = FmuSimulation.open(file, recording, Map.of(), Map.of())) {
            double[][] moved = simulation.pushed("force.seat", force);
            for (int o = 0; o < 3; o++) {
                Complex answer = q[o].multiply(-w * w);
                double[] expected = new double[n - 60];
                java.util.Arrays.setAll(expected,
                        i -> answer.multiply(new Complex(Math.cos(w * i / RATE), Math.sin(w * i / RATE))).getImaginary());
                assertEquals(0, error(expected, moved[o], 600), 2e-4, "output " + o);
            }
        }
    }

    /** What was unpacked is gone. */
    @Test
    void nothingIsLeftBehind() throws IOException {
        Recording recording = new Recording(new Clock(0, RATE), Map.of(BASE, noise(120, RATE, 1, 7)), Metadata.NONE);
        Path file = BuiltUnit.build(folder, "car.fmu", BuiltUnit.QUARTER_CAR, 2, BuiltUnit.STEPS);
        long before = BuiltUnit.unpacked();
        try (FmuSimulation simulation = FmuSimulation.open(file, recording, Map.of(), Map.of())) {
            simulation.run(Map.of());
            assertEquals(before + 1, BuiltUnit.unpacked());
        }
        assertEquals(before, BuiltUnit.unpacked());
    }
}
