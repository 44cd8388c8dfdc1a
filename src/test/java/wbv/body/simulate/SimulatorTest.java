package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.body.law.Backlash;
import wbv.body.law.BoucWen;
import wbv.body.law.CubicSpring;
import wbv.body.law.Law;
import wbv.body.law.LearnedLimited;
import wbv.body.law.LearnedMemory;
import wbv.body.law.LearnedTerm;
import wbv.body.law.MaxwellArm;
import wbv.body.law.MuscleReflex;
import wbv.body.law.ProgressiveSpring;
import wbv.body.law.QuadraticDamping;
import wbv.body.law.Reflex;
import wbv.body.law.Saturation.SaturatingSpring;
import wbv.body.number.Modulator;
import wbv.body.number.Shape;
import wbv.recording.Channel;

class SimulatorTest {

    private static final Channel RATE = Channel.parse("platform.gyr.y");
    private static final Channel ACROSS = Channel.parse("head.acc.x");
    private static final Channel BESIDE = Channel.parse("head.acc.y");
    private static final Structure CHAIN = new Structure(new int[] {-1, 0, 1}, new int[] {0, 1, 2},
            new double[] {90000, 75000, 20000}, new double[] {1300, 1500, 170}, new double[] {12, 45, 5.5});
    private static final Structure ALLEN = new Structure(new int[] {-1, 0}, new int[] {0, 1},
            new double[] {74300, 41000}, new double[] {2807, 318}, new double[] {50.2, 5.5});

    /** Seat-to-head transmissibility of the Allen set, recomputed from its mass matrix (closed form). */
    @Test
    void transmissibilityOfAllensChainIsTheClosedForm() {
        double rate = 64;
        int n = 3840;   // with the silence behind it 4096, so that the frequencies below are lines
        double[] base = new double[n];
        base[400] = 1;
        Excitation excitation = new Excitation(rate, base, Map.of());
        Assembly assembly = new Assembly(ALLEN, List.of(), List.of(),
                List.of(new Assembly.Output(1, Assembly.Reading.ACCELERATION, List.of())));
        double[] y = new Simulator(excitation).run(assembly, false).outputs()[0];
        double[] frequency = {2, 5, 10};
        double[] expected = {1.129444, 1.458062, 1.279637};
        for (int i = 0; i < 3; i++) {
            int k = (int) Math.round(frequency[i] * 2 * Math.PI / excitation.omega()[1]);
            assertEquals(expected[i],
                    Math.hypot(y[2 * k], y[2 * k + 1]) / Math.hypot(excitation.baseSpectrum()[2 * k], excitation.baseSpectrum()[2 * k + 1]),
                    1e-6);
        }
    }

    static Stream<Assembly> assemblies() {
        Assembly.Output torso = output(1);
        Assembly.Output head = output(2);
        return Stream.of(
                new Assembly(CHAIN, List.of(), List.of(), List.of(torso, head)),
                new Assembly(CHAIN, List.of(new LawAt(1, new MaxwellArm(30000, 0.05))), List.of(), List.of(torso, head)),
                new Assembly(CHAIN, List.of(new LawAt(1, new Reflex(20000, 300, 0.06))), List.of(), List.of(head)),
                new Assembly(CHAIN, List.of(new LawAt(1, new SaturatingSpring(1e-3))),
                        List.of(new Assembly.DriveAt(0, new Drive.Rotation(RATE, 0.1))), List.of(torso, head)),
                new Assembly(CHAIN, List.of(), List.of(new Assembly.DriveAt(0, new Drive.Rotation(RATE, 0.1)),
                        new Assembly.DriveAt(1, new Drive.Tone(10, 5, 7)),
                        new Assembly.DriveAt(1, new Drive.CrossAxis(ACROSS, BESIDE, 3000))),
                        List.of(torso, head)),
                new Assembly(CHAIN, List.of(),
                        List.of(new Assembly.DriveAt(1, new Drive.UpperSwings(ACROSS, RATE, BESIDE, 3000, 3, 0.3, 0.8)),
                                new Assembly.DriveAt(2, new Drive.LowerSwings(ACROSS, RATE, BESIDE, -2000, 1.5, 0.6, 0.4))),
                        List.of(torso, head)),
                new Assembly(CHAIN, List.of(new LawAt(0, new ProgressiveSpring(60000, 1e-3))), List.of(
                        new Assembly.DriveAt(1, new Drive.AcrossBody(ACROSS, 6)),
                        new Assembly.DriveAt(2, new Drive.AcrossLink(BESIDE, -2))),
                        List.of(torso, head)),
                new Assembly(CHAIN, List.of(new LawAt(0, new BoucWen(0.4, 8e-4)), new LawAt(1, new QuadraticDamping(8000))), List.of(),
                        List.of(head)),
                new Assembly(CHAIN, List.of(new LawAt(1, new BoucWen(0.4, 8e-4)), new LawAt(0, new QuadraticDamping(500)),
                        new LawAt(1, new QuadraticDamping(8000))), List.of(),
                        List.of(head, new Assembly.Output(1, Assembly.Reading.LINK_FORCE, List.of()))),
                new Assembly(CHAIN, List.of(new LawAt(1, new MaxwellArm(30000, 0.05))), List.of(lifted(1, 0.1), lifted(0, -0.05)),
                        List.of(torso, head)),
                new Assembly(CHAIN, List.of(new LawAt(1, new BoucWen(0.4, 8e-4)), new LawAt(0, new QuadraticDamping(500))),
                        List.of(lifted(1, 0.1), lifted(0, -0.05), lifted(1, 0.02)),
                        List.of(head, new Assembly.Output(1, Assembly.Reading.LINK_FORCE, List.of()))),
                new Assembly(CHAIN, List.of(new LawAt(1, learned("r", "load of link 3", 300)),
                        new LawAt(0, learned("|v|v", "magnitude of the deflection of link 3", 4e6))), List.of(lifted(2, 0.1)),
                        List.of(torso, head)),
                new Assembly(CHAIN, List.of(new LawAt(1, learned("r", "load of link 3", 300)), new LawAt(2, new QuadraticDamping(300))),
                        List.of(), List.of(torso, head)),
                new Assembly(CHAIN, List.of(new LawAt(0, learned("1", "positive part of the deflection of link 2", 30000)),
                        new LawAt(0, learned("|v|v", "magnitude of the deflection of link 3", 4e6))), List.of(), List.of(head)),
                new Assembly(CHAIN, List.of(
                        new LawAt(1, new LearnedLimited(Shape.DEFLECTION, Modulator.parse("speed of link 1"), 4e5, 0.02)),
                        new LawAt(0, new LearnedMemory(Shape.SPEED, Shape.ONE, Modulator.parse("negative part of the load of link 2"), 30,
                                0.05))),
                        List.of(), List.of(torso, head)),
                faulty(new SensorFault.MountResonance(9, 0.3)), faulty(new SensorFault.StiffeningMount(9, 0.3, 2e5)),
                faulty(new SensorFault.AcCoupling(0.7)), faulty(new SensorFault.Delay(0.02, 0)), faulty(new SensorFault.Delay(0.02, 1e-3)),
                faulty(new SensorFault.WanderingDelay(0.02, 0.004, -0.003, 0.15)),
                faulty(new SensorFault.Gain(1.1)), faulty(new SensorFault.Bias(0.2)), faulty(new SensorFault.Clipping(-1.5, 1.2)),
                faulty(new SensorFault.Misalignment(ACROSS, BESIDE, 0.1, -0.05)), faulty(new SensorFault.Turned(ACROSS, 0.1)),
                faulty(new SensorFault.LeverArm(RATE, 0.04)),
                new Assembly(CHAIN, List.of(), List.of(), List.of(new Assembly.Output(1, Assembly.Reading.LINK_FORCE, List.of()),
                        new Assembly.Output(2, Assembly.Reading.VELOCITY, List.of()))));
    }

    private static Law learned(String shape, String modulator, double coefficient) {
        return new LearnedTerm(Shape.parse(shape), Modulator.parse(modulator), coefficient);
    }

    private static Assembly faulty(SensorFault fault) {
        return new Assembly(CHAIN, List.of(), List.of(),
                List.of(output(1), new Assembly.Output(2, Assembly.Reading.ACCELERATION, List.of(fault))));
    }

    private static Assembly.DriveAt lifted(int link, double arm) {
        return new Assembly.DriveAt(link, new Drive.Rotation(RATE, arm));
    }

    private static Assembly.Output output(int body) {
        return new Assembly.Output(body, Assembly.Reading.ACCELERATION, List.of());
    }

    @ParameterizedTest
    @MethodSource("assemblies")
    void slopesEqualCentralDifferences(Assembly assembly) {
        Simulator simulator = new Simulator(excitation(60, 900));
        Simulator.Response response = simulator.run(assembly, true);
        double[] values = assembly.values();
        for (int p = 0; p < values.length; p++) {
            double h = 1e-5 * Math.max(Math.abs(values[p]), 1e-3);
            double[] high = values.clone();
            high[p] += h;
            double[] low = values.clone();
            low[p] -= h;
            double[][] a = simulator.run(assembly.with(high), false).outputs();
            double[][] b = simulator.run(assembly.with(low), false).outputs();
            for (int o = 0; o < a.length; o++) {
                double error = 0;
                double size = 0;
                for (int i = 0; i < a[o].length; i++) {
                    double slope = (a[o][i] - b[o][i]) / (2 * h);
                    error += Math.pow(slope - response.slopes()[p][o][i], 2);
                    size += slope * slope;
                }
                boolean threshold = assembly.outputs().stream().flatMap(x -> x.faults().stream())
                        .anyMatch(f -> f instanceof SensorFault.Clipping);
                assertTrue(Math.sqrt(error) <= (threshold ? 1e-2 : 1e-5) * Math.sqrt(size) + 1e-8,
                        assembly + " parameter " + p + " output " + o + ": " + Math.sqrt(error / size) + " of " + Math.sqrt(size));
            }
        }
    }

    @ParameterizedTest
    @MethodSource("assemblies")
    void slopesWithoutTheStructuresAreTheSame(Assembly assembly) {
        Simulator simulator = new Simulator(excitation(60, 900));
        double[][][] all = simulator.run(assembly, true).slopes();
        double[][][] own = simulator.run(assembly, Sensitivities.OWN, Optional.empty()).slopes();
        assertEquals(all.length, own.length);
        for (int p = CHAIN.parameters(); p < all.length; p++) {
            for (int o = 0; o < all[p].length; o++) {
                double largest = Arrays.stream(all[p][o]).map(Math::abs).max().orElseThrow();
                assertArrayEquals(all[p][o], own[p][o], 1e-10 * largest, assembly + " parameter " + p);
            }
        }
    }

    /** On a mount that stiffens by nothing a sensor reads what the second-order response says, but for the start from rest. */
    @Test
    void aMountThatDoesNotStiffenIsALinearOne() {
        Excitation excitation = excitation(60, 900);
        Simulator simulator = new Simulator(excitation);
        double[] linear = excitation.series(simulator.run(faulty(new SensorFault.MountResonance(9, 0.3)), false).outputs()[1]);
        double[] stepped = excitation.series(simulator.run(faulty(new SensorFault.StiffeningMount(9, 0.3, 0)), false).outputs()[1]);
        double error = 0;
        double size = 0;
        for (int i = 120; i < 780; i++) {
            error += Math.pow(stepped[i] - linear[i], 2);
            size += linear[i] * linear[i];
        }
        assertTrue(Math.sqrt(error / size) < 3e-4, "" + Math.sqrt(error / size));
    }

    /** |H| = f/fc / √(1 + (f/fc)²), and a lead of arctan(fc/f), for what the bodies do and for what a force does alike. */
    @Test
    void anAcCoupledSensorReadsItsHighPass() {
        Excitation excitation = excitation(60, 900);
        Simulator simulator = new Simulator(excitation);
        double[] plain = simulator.run(faulty(new SensorFault.Gain(1)), false).outputs()[1];
        double[] coupled = simulator.run(faulty(new SensorFault.AcCoupling(0.7)), false).outputs()[1];
        double[] force = simulator.linearised(faulty(new SensorFault.Gain(1))).ofBodyForce(1)[1];
        double[] coupledForce = simulator.linearised(faulty(new SensorFault.AcCoupling(0.7))).ofBodyForce(1)[1];
        for (int k = 1; k < excitation.omega().length; k++) {
            double u = excitation.omega()[k] / (2 * Math.PI * 0.7);
            double gain = u / Math.sqrt(1 + u * u);
            double lead = Math.atan(1 / u);
            for (double[][] pair : new double[][][] {{plain, coupled}, {force, coupledForce}}) {
                double size = 1e-12 + 1e-9 * Math.hypot(pair[0][2 * k], pair[0][2 * k + 1]);
                assertEquals(gain * (pair[0][2 * k] * Math.cos(lead) - pair[0][2 * k + 1] * Math.sin(lead)), pair[1][2 * k], size);
                assertEquals(gain * (pair[0][2 * k] * Math.sin(lead) + pair[0][2 * k + 1] * Math.cos(lead)), pair[1][2 * k + 1], size);
            }
        }
    }

    /** What a sensor reads that is turned with all its axes: z' = z cos α + x sin α, x' = x cos α - z sin α, of which x' was recorded. */
    @Test
    void aTurnedSensorReadsARotation() {
        Simulator simulator = new Simulator(excitation(60, 900));
        double[] z = simulator.run(new Assembly(CHAIN, List.of(), List.of(), List.of(output(2))), false).outputs()[0];
        double angle = 0.35;
        double[] recorded = excitation(60, 900).other(ACROSS);
        for (SensorFault fault : List.of(new SensorFault.Misalignment(ACROSS, BESIDE, angle, 0), new SensorFault.Turned(ACROSS, angle))) {
            Simulator.Response response = simulator.run(faulty(fault), false);
            double[] read = response.outputs()[1];
            assertEquals(0, response.recorded()[0].length);
            for (int i = 0; i < z.length; i++) {
                double x = (recorded[i] + z[i] * Math.sin(angle)) / Math.cos(angle);
                assertEquals(z[i] * Math.cos(angle) + x * Math.sin(angle), read[i], 1e-9 * (1 + Math.abs(z[i])));
                assertEquals(recorded[i] * Math.tan(angle), response.recorded()[1][i], 1e-9 * (1 + Math.abs(z[i])));
            }
        }
    }

    /**
     * A mass that swings on a base which pushes and tilts it, in time: u" + 2ζωu' + ω²u = -(a + h θ"), seen at u + h θ (Runge and Kutta,
     * fourth order).
     */
    @Test
    void whatCarriesNoSensorSwingsAsAMassOnASpring() {
        double rate = 256;
        double height = 0.8;
        double own = 2 * Math.PI * 3;
        DoubleUnaryOperator envelope = t -> Math.exp(-Math.pow((t - 6) / 1.5, 2));
        DoubleUnaryOperator push = t -> envelope.applyAsDouble(t)
                * (Math.sin(2 * Math.PI * 2.2 * t) + 0.7 * Math.cos(2 * Math.PI * 4.1 * t));
        DoubleUnaryOperator angle = t -> 0.05 * envelope.applyAsDouble(t) * Math.sin(2 * Math.PI * 2.9 * t + 1);
        double d = 1e-3;
        DoubleUnaryOperator turning = t -> (angle.applyAsDouble(t + d) - angle.applyAsDouble(t - d)) / (2 * d);
        DoubleUnaryOperator spin = t -> (angle.applyAsDouble(t + d) - 2 * angle.applyAsDouble(t) + angle.applyAsDouble(t - d)) / (d * d);
        int n = (int) (12 * rate);
        Excitation excitation = new Excitation(rate, new double[n],
                Map.of(ACROSS, sampled(push, n, rate), RATE, sampled(turning, n, rate)));
        double[] got = excitation.series(Swing.of(new Drive.UpperSwings(ACROSS, RATE, ACROSS, 1, 3, 0.3, height), excitation.omega(),
                excitation.other(ACROSS), excitation.other(RATE)));
        double[] state = {0, 0};
        int parts = 16;
        double h = 1 / rate / parts;
        double size = 0;
        double apart = 0;
        for (int i = 0; i < n; i++) {
            double t = i / rate;
            double expected = state[0] + height * angle.applyAsDouble(t);
            size = Math.max(size, Math.abs(expected));
            apart = Math.max(apart, Math.abs(got[i] - expected));
            for (int part = 0; part < parts; part++) {
                double at = t + part * h;
                double[] k1 = swung(state, 0, state, at, push, spin, height, own);
                double[] k2 = swung(state, h / 2, k1, at + h / 2, push, spin, height, own);
                double[] k3 = swung(state, h / 2, k2, at + h / 2, push, spin, height, own);
                double[] k4 = swung(state, h, k3, at + h, push, spin, height, own);
                for (int j = 0; j < 2; j++) {
                    state[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
                }
            }
        }
        assertEquals(0, apart / size, 1e-4);
    }

    private static double[] swung(double[] state, double step, double[] slope, double t, DoubleUnaryOperator push, DoubleUnaryOperator spin,
            double height, double own) {
        double u = state[0] + step * slope[0];
        double v = state[1] + step * slope[1];
        return new double[] {v, -(push.applyAsDouble(t) + height * spin.applyAsDouble(t)) - 0.6 * own * v - own * own * u};
    }

    private static double[] sampled(DoubleUnaryOperator of, int samples, double rate) {
        return IntStream.range(0, samples).mapToDouble(i -> of.applyAsDouble(i / rate)).toArray();
    }

    /** One body on a base at rest, pushed by a mass times a measured acceleration: q = m_c a / (k + jωc - ω²m), by hand. */
    @Test
    void accelerationAcrossPushesByMassTimesAcceleration() {
        Structure one = new Structure(new int[] {-1}, new int[] {0}, new double[] {60000}, new double[] {1200}, new double[] {50});
        double[] across = new double[900];
        for (int i = 0; i < 800; i++) {
            across[i] = Math.sin(0.3 * i) * Math.exp(-i / 200.0);
        }
        Excitation excitation = new Excitation(60, new double[900], Map.of(ACROSS, across));
        double[] pushed = excitation.other(ACROSS);
        double[][] onBody = new Simulator(excitation)
                .run(new Assembly(one, List.of(), List.of(new Assembly.DriveAt(0, new Drive.AcrossBody(ACROSS, 7))),
                        List.of(output(0))), false)
                .outputs();
        double[][] inLink = new Simulator(excitation)
                .run(new Assembly(one, List.of(), List.of(new Assembly.DriveAt(0, new Drive.AcrossLink(ACROSS, 7))),
                        List.of(output(0))), false)
                .outputs();
        for (int k = 1; k < excitation.omega().length; k += 7) {
            double w = excitation.omega()[k];
            double re = 60000 - 50 * w * w;
            double im = 1200 * w;
            double scale = -7 * w * w / (re * re + im * im);
            double expectedRe = scale * (pushed[2 * k] * re + pushed[2 * k + 1] * im);
            double expectedIm = scale * (pushed[2 * k + 1] * re - pushed[2 * k] * im);
            assertEquals(expectedRe, onBody[0][2 * k], 1e-9);
            assertEquals(expectedIm, onBody[0][2 * k + 1], 1e-9);
            // A force in a link pulls its ends together: on the body it is the same with the other sign.
            assertEquals(-expectedRe, inLink[0][2 * k], 1e-9);
            assertEquals(-expectedIm, inLink[0][2 * k + 1], 1e-9);
        }
    }

    static Stream<Law> lawsThatSeeALift() {
        return Stream.of(new MaxwellArm(30000, 0.05), new CubicSpring(4e8), new QuadraticDamping(4000), new BoucWen(0.4, 8e-4),
                learned("r", "deflection of link 1", 2e6), learned("v", "positive part of the load of link 1", 5));
    }

    /** Whether the base carries a link up or rotation lifts its lower end: its spring, its dashpot and its laws cannot tell. */
    @ParameterizedTest
    @MethodSource("lawsThatSeeALift")
    void liftingTheLowestLinkIsMovingTheBase(Law law) {
        double rate = 60;
        double arm = 0.3;
        double w = 2 * Math.PI * 2.9;
        DoubleUnaryOperator envelope = t -> 0.05 * Math.exp(-Math.pow((t - 7) / 1.5, 2));
        DoubleUnaryOperator slope = t -> -2 * (t - 7) / 2.25 * envelope.applyAsDouble(t);
        DoubleUnaryOperator bend = t -> (4 * Math.pow((t - 7) / 2.25, 2) - 2 / 2.25) * envelope.applyAsDouble(t);
        DoubleUnaryOperator turning = t -> slope.applyAsDouble(t) * Math.sin(w * t) + w * envelope.applyAsDouble(t) * Math.cos(w * t);
        DoubleUnaryOperator spin = t -> bend.applyAsDouble(t) * Math.sin(w * t) + 2 * w * slope.applyAsDouble(t) * Math.cos(w * t)
                - w * w * envelope.applyAsDouble(t) * Math.sin(w * t);
        int n = 900;
        List<Assembly.Output> outputs = List.of(output(0), output(2), new Assembly.Output(0, Assembly.Reading.LINK_FORCE, List.of()));
        double[] moved = Arrays.stream(sampled(spin, n, rate)).map(a -> arm * a).toArray();
        Simulator.Response carried = new Simulator(new Excitation(rate, moved, Map.of()))
                .run(new Assembly(CHAIN, List.of(new LawAt(0, law)), List.of(), outputs), false);
        Excitation still = new Excitation(rate, new double[n], Map.of(RATE, sampled(turning, n, rate)));
        Simulator.Response risen = new Simulator(still)
                .run(new Assembly(CHAIN, List.of(new LawAt(0, law)), List.of(lifted(0, arm)), outputs), false);
        double[][][] pairs = {{carried.outputs()[0], risen.outputs()[0]}, {carried.outputs()[1], risen.outputs()[1]},
            {carried.outputs()[2], risen.outputs()[2]}, {carried.stretch()[0], risen.stretch()[0]},
            {carried.forces()[0], risen.forces()[0]}};
        for (double[][] pair : pairs) {
            double size = 0;
            double apart = 0;
            for (int i = 2; i < pair[0].length; i++) {
                size = Math.max(size, Math.abs(pair[0][i]));
                apart = Math.max(apart, Math.abs(pair[0][i] - pair[1][i]));
            }
            assertEquals(0, apart / size, 1e-4, law.toString());   // a force is straight within a step, an acceleration too
        }
    }

    /** A sum of many forces in another order differs by rounding, which a search may enlarge: an answer has to be the same every time. */
    @Test
    void forcesThatAreKnownActInTheOrderOfTheirBodies() {
        Excitation pushed = new Excitation(60, new double[60], Map.of());
        int[] order = {11, 3, 7, 0, 5, 2, 9};
        for (int body : order) {
            pushed = pushed.pushed(body, new double[60]);
        }
        assertEquals(Arrays.stream(order).sorted().boxed().toList(), List.copyOf(pushed.pushes().keySet()));
    }

    /** A tone on a body is the same whether the model makes it or it is known beside the model; derivatives to the model's numbers too. */
    @ParameterizedTest
    @MethodSource("lawsThatSeeALift")
    void aForceThatIsKnownActsAsADriveOfIt(Law law) {
        double rate = 60;
        int n = 900;
        Excitation plain = new Excitation(rate, sampled(t -> Math.sin(17 * t) * Math.exp(-Math.pow((t - 7) / 3, 2)), n, rate), Map.of());
        List<LawAt> laws = List.of(new LawAt(0, law));
        List<Assembly.Output> outputs = List.of(output(0), output(2));
        Simulator.Response driven = new Simulator(plain)
                .run(new Assembly(CHAIN, laws, List.of(new Assembly.DriveAt(1, new Drive.Tone(10, 5, 7))), outputs), true);
        double[] force = sampled(t -> 10 * Math.cos(2 * Math.PI * 7 * t) + 5 * Math.sin(2 * Math.PI * 7 * t), n, rate);
        Simulator.Response pushed = new Simulator(plain.pushed(0, new double[n]).pushed(1, force))
                .run(new Assembly(CHAIN, laws, List.of(), outputs), true);
        double[] without = new Simulator(plain).run(new Assembly(CHAIN, laws, List.of(), outputs), false).outputs()[0];
        for (int o = 0; o < 2; o++) {
            assertArrayEquals(driven.outputs()[o], pushed.outputs()[o], 1e-9);
            for (int p = 0; p < CHAIN.parameters(); p++) {
                double size = Arrays.stream(driven.slopes()[p][o]).map(Math::abs).max().orElseThrow();
                assertArrayEquals(driven.slopes()[p][o], pushed.slopes()[p][o], 1e-9 * size);
            }
        }
        double[] apart = driven.outputs()[0];
        assertTrue(IntStream.range(0, without.length).mapToDouble(i -> Math.abs(without[i] - apart[i])).max().orElseThrow() > 0.1);
    }

    /** A linear law may be solved in frequency or stepped in time: two engines, one answer. */
    @ParameterizedTest
    @MethodSource("linearLaws")
    void bothEnginesAgree(Law law) {
        Simulator simulator = new Simulator(excitation(60, 1800));
        List<Assembly.Output> outputs = List.of(output(1), output(2));
        double[][] spectral = simulator.run(new Assembly(CHAIN, List.of(new LawAt(1, law)), List.of(), outputs), false).outputs();
        double[][] stepped = simulator
                .run(new Assembly(CHAIN, List.of(new LawAt(1, law), new LawAt(2, new Backlash(0))), List.of(), outputs),
                        false)
                .outputs();
        for (int o = 0; o < 2; o++) {
            double error = 0;
            double size = 0;
            for (int i = 0; i < spectral[o].length; i++) {
                error += Math.pow(spectral[o][i] - stepped[o][i], 2);
                size += spectral[o][i] * spectral[o][i];
            }
            assertEquals(0, Math.sqrt(error / size), 0.01, law.toString());
        }
    }

    static Stream<Law> linearLaws() {
        return Stream.of(new MaxwellArm(30000, 0.05), new Reflex(20000, 300, 0.06),
                new MuscleReflex(20000, 900, 0.06, 0.05, Law.Side.BOTH));
    }

    static Excitation excitation(double rate, int n) {
        return new Excitation(rate, noise(rate, n, 1, 3), Map.of(RATE, noise(rate, n, 0.2, 4), ACROSS, noise(rate, n, 0.6, 5),
                BESIDE, noise(rate, n, 0.5, 6)));
    }

    /** Forty lines from 0.5 to 10 Hz after two seconds of rest. */
    private static double[] noise(double rate, int n, double level, long seed) {
        double[] phase = new Random(seed).doubles(40, 0, 2 * Math.PI).toArray();
        double[] a = new double[n];
        for (int j = (int) (2 * rate); j < n; j++) {
            double t = j / rate;
            double fade = Math.min(1, t - 2) * Math.min(1, (n / rate - t) / 0.5);
            for (int k = 0; k < 40; k++) {
                a[j] += fade * level * 0.2 * Math.cos(2 * Math.PI * (0.5 + 0.2437 * k) * t + phase[k]);
            }
        }
        return a;
    }

    /**
     * A cubic spring that moves as a sine of amplitude A is as stiff as k + 3/4 k3 A², a damper c2 v|v| as strong as c + 8/(3π) c2 ωA
     * (describing functions, as in Gelb and Vander Velde 1968).
     */
    @Test
    void theEquivalentOfALawIsItsDescribingFunction() {
        double omega = 2 * Math.PI * 3;
        double[] base = new double[3600];
        for (int i = 0; i < base.length; i++) {
            base[i] = 2.5 * Math.min(1, i / 600.0) * Math.sin(omega * i / 60);
        }
        Structure one = new Structure(new int[] {-1}, new int[] {0}, new double[] {60000}, new double[] {1200}, new double[] {50});
        for (Law law : List.of(new CubicSpring(2e9), new QuadraticDamping(6000))) {
            Excitation excitation = new Excitation(60, base, Map.of());
            Assembly assembly = new Assembly(one, List.of(new LawAt(0, law)), List.of(), List.of(output(0)));
            Simulator simulator = new Simulator(excitation);
            double[] stretch = excitation.series(simulator.run(assembly, false).stretch()[0]);
            double amplitude = Math.sqrt(2)
                    * Math.sqrt(java.util.Arrays.stream(stretch, 1200, 3000).map(r -> r * r).average().orElseThrow());
            Assembly equivalent = simulator.equivalent(assembly);
            assertTrue(equivalent.laws().isEmpty());
            boolean cubic = law instanceof CubicSpring;
            double stiffness = cubic ? 60000 + 0.75 * 2e9 * amplitude * amplitude : 60000;
            double damping = cubic ? 1200 : 1200 + 8 / (3 * Math.PI) * 6000 * omega * amplitude;
            assertEquals(stiffness, equivalent.structure().stiffness()[0], 0.02 * stiffness);
            assertEquals(damping, equivalent.structure().damping()[0], 0.04 * damping);
            assertTrue(cubic ? stiffness > 66000 : damping > 1400, law + " does something: " + stiffness + " " + damping);
        }
    }

    /** Whatever reaches a late sensor is late, and one whose clock runs off is as late as on average. */
    @Test
    void aLateSensorIsLateForForcesToo() {
        Excitation excitation = excitation(60, 900);
        Simulator simulator = new Simulator(excitation);
        double[] plain = simulator.linearised(faulty(new SensorFault.Gain(1))).ofBodyForce(1)[1];
        double[] late = simulator.linearised(faulty(new SensorFault.Delay(0.012, 1e-12))).ofBodyForce(1)[1];
        double[] later = simulator.linearised(faulty(new SensorFault.Delay(0.002, 0.02 / (excitation.samples() / 60.0)))).ofBodyForce(1)[1];
        for (int k = 0; k < excitation.omega().length; k++) {
            double turn = excitation.omega()[k] * 0.012;
            double re = plain[2 * k] * Math.cos(turn) + plain[2 * k + 1] * Math.sin(turn);
            double im = plain[2 * k + 1] * Math.cos(turn) - plain[2 * k] * Math.sin(turn);
            assertEquals(re, late[2 * k], 1e-9);
            assertEquals(im, late[2 * k + 1], 1e-9);
            assertEquals(re, later[2 * k], 1e-9);
            assertEquals(im, later[2 * k + 1], 1e-9);
        }
    }
}
