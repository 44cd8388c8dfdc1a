package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.law.CoulombFriction;
import wbv.body.law.Law;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.Metadata;
import wbv.recording.Quantity;
import wbv.recording.Recording;

/** Bodies that no spring holds to the ground, against closed forms. */
class FreeBodyTest {

    private static final double MASS = 12;
    private static final double SECONDS = 20;
    private static final Channel FORCE = Channel.parse("mass.force.z");

    /** F t²/2m, F t/m, F/m. */
    @ParameterizedTest
    @CsvSource({"100, pos", "100, vel", "100, acc", "251, pos", "1000, pos", "1000, vel", "1000, acc"})
    void aSteadyForceAcceleratesEvenly(double rate, String read) {
        double force = 30;
        double[] y = run(rate, 0, 0, List.of(), read, t -> force);
        double a = force / MASS;
        for (int j = 5; j < y.length - 5; j++) {
            double t = j / rate;
            double truth = read.equals("pos") ? a * t * t / 2 : read.equals("vel") ? a * t : a;
            double size = read.equals("pos") ? a * SECONDS * t / 2 : read.equals("vel") ? a * SECONDS : a;
            // What jumps at the first sample rings a little in a band that ends.
            assertEquals(truth, y[j], (read.equals("acc") ? 3e-3 : 1e-3) * size, "after " + t + " s");
        }
        assertEquals(0, read.equals("acc") ? 0 : y[0], 1e-9);
    }

    /** A sine from rest drifts: x = F/(m w²) (w t - sin w t). */
    @ParameterizedTest
    @CsvSource({"100, pos", "100, vel", "100, acc", "400, pos", "1000, pos"})
    void aSineFromRestDrifts(double rate, String read) {
        double w = 2 * Math.PI * 1.7;
        double[] y = run(rate, 0, 0, List.of(), read, t -> 50 * Math.sin(w * t));
        double a = 50 / MASS;
        for (int j = 0; j < y.length - 20; j++) {
            double t = j / rate;
            double truth = read.equals("pos") ? a / (w * w) * (w * t - Math.sin(w * t))
                    : read.equals("vel") ? a / w * (1 - Math.cos(w * t)) : a * Math.sin(w * t);
            double size = read.equals("pos") ? a / w * Math.max(t, 1) : read.equals("vel") ? 2 * a / w : a;
            assertEquals(truth, y[j], (read.equals("acc") ? 5e-3 : 5e-4) * size, "after " + t + " s");
        }
    }

    /** m v' = F - c v, from a damper that holds hardly to one that holds at once. */
    @ParameterizedTest
    @CsvSource({"0.1, 100", "3, 100", "60, 100", "600, 100", "3, 1000"})
    void aDamperAloneLetsTheBodyCreep(double damping, double rate) {
        double force = 30;
        double[] y = run(rate, 0, damping, List.of(), "pos", t -> force);
        double[] v = run(rate, 0, damping, List.of(), "vel", t -> force);
        double tau = MASS / damping;
        for (int j = 5; j < y.length - 5; j++) {
            double t = j / rate;
            double speed = force / damping * -Math.expm1(-t / tau);
            assertEquals(speed, v[j], 2e-3 * force / damping * Math.min(1, SECONDS / tau) + (t < 0.1 ? 0.05 * speed : 0), "after " + t);
            assertEquals(force / damping * (t + tau * Math.expm1(-t / tau)), y[j], 2e-3 * force / damping * t * Math.min(1, SECONDS / tau));
        }
    }

    /** Coulomb's friction against a steady push: a = (F - f)/m. */
    @ParameterizedTest
    @ValueSource(doubles = {100, 1000})
    void frictionTakesItsShareOfTheForce(double rate) {
        double[] y = run(rate, 0, 0, List.of(new CoulombFriction(20, 1e-3)), "pos", t -> 50);
        for (int j = 10; j < y.length - 10; j++) {
            double t = j / rate;
            assertEquals(30 / MASS * t * t / 2, y[j], 3e-3 * 30 / MASS * SECONDS * t / 2);
        }
    }

    /** Sent off with a speed: x = v t alone, v τ (1 - e^(-t/τ)) against a damper, and until it sticks against friction. */
    @ParameterizedTest
    @CsvSource({"100, 0, 0", "1000, 0, 0", "100, 6, 0", "1000, 6, 0", "100, 0, 4", "1000, 0, 4"})
    void aBodyInMotionGoesOn(double rate, double damping, double friction) {
        double v = 1.5;
        double[] y = run(rate, 0, damping, friction == 0 ? List.of() : List.of(new CoulombFriction(friction, 1e-4)), "pos", t -> 0,
                List.of(new Drive.Launch(v)));
        for (int j = 0; j < y.length - 5; j++) {
            double t = j / rate;
            double slowing = friction / MASS;
            double moving = slowing == 0 ? t : Math.min(t, v / slowing);
            double truth = damping > 0 ? v * MASS / damping * -Math.expm1(-damping * t / MASS) : v * moving - slowing * moving * moving / 2;
            assertEquals(truth, y[j], 2e-3 + 2e-3 * truth, "after " + t + " s");
        }
    }

    /** Two masses on a spring that nothing holds: the centre of mass goes as if they were one, and they swing about it. */
    @Test
    void twoMassesOnASpringFlyTogether() {
        double rate = 200;
        double m1 = 3;
        double m2 = 5;
        double k = 2000;
        Channel first = Channel.parse("one.pos.z");
        Channel second = Channel.parse("two.pos.z");
        Model model = new Model("pair", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(body("one", m1, first, List.of()), body("two", m2, second, List.of())),
                List.of(new Model.Link("ground", "one", 0, 0, Optional.empty(), List.of(), List.of()),
                        new Model.Link("one", "two", k, 0.5, Optional.empty(), List.of(), List.of())),
                List.of(new Model.Input("one", Channel.parse("one.force.z"))));
        double w = 2 * Math.PI;
        double[] u = series(rate, t -> 40 * Math.sin(w * t));
        Recording recording = new Recording(new Clock(0, rate), Map.of(Channel.parse("one.force.z"), u), Metadata.NONE);
        double[][] y = new Simulator(Excitation.of(model, recording, u.length)).outputs(model.assembly());
        for (int j = 0; j < u.length - 20; j++) {
            double t = j / rate;
            double centre = 40 / (m1 + m2) / (w * w) * (w * t - Math.sin(w * t));
            assertEquals(centre, (m1 * y[0][j] + m2 * y[1][j]) / (m1 + m2), 1e-3 * Math.max(1, t));
            assertTrue(Math.abs(y[0][j] - y[1][j]) < 0.05, "they stay together");
        }
    }

    /** The derivatives that fits use are those of the runs. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void derivativesAreThoseOfTheRuns(boolean rubs) {
        double rate = 100;
        List<Law> laws = rubs ? List.of(new CoulombFriction(5, 0.05)) : List.of();
        Model model = model(0, 4, laws, "pos", List.of(new Drive.Launch(0.3)));
        double[] u = series(rate, t -> 30 * Math.sin(2 * Math.PI * 0.8 * t) + 12 * Math.sin(2 * Math.PI * 3.1 * t));
        Excitation excitation = Excitation.of(model, new Recording(new Clock(0, rate), Map.of(FORCE, u), Metadata.NONE), u.length);
        Simulator simulator = new Simulator(excitation);
        Assembly assembly = model.assembly();
        Simulator.Response response = simulator.run(assembly, true);
        double[] values = assembly.values();
        for (int p : rubs ? new int[] {1, 2, 3, 5} : new int[] {1, 2, 3}) {   // damping, mass, friction, start
            double h = 1e-4 * values[p];
            double[] more = values.clone();
            more[p] += h;
            double[] less = values.clone();
            less[p] -= h;
            double[] high = simulator.outputs(assembly.with(more))[0];
            double[] low = simulator.outputs(assembly.with(less))[0];
            double[] slope = excitation.series(response.slopes()[p][0]);
            double size = java.util.Arrays.stream(slope).map(Math::abs).max().orElseThrow();
            for (int j = 0; j < slope.length - 10; j++) {
                assertEquals((high[j] - low[j]) / (2 * h), slope[j], 0.01 * size, "parameter " + p + " at " + j);
            }
        }
    }

    private static double[] run(double rate, double stiffness, double damping, List<Law> laws, String read, DoubleUnaryOperator force) {
        return run(rate, stiffness, damping, laws, read, force, List.of());
    }

    private static double[] run(double rate, double stiffness, double damping, List<Law> laws, String read, DoubleUnaryOperator force,
            List<Drive> start) {
        Model model = model(stiffness, damping, laws, read, start);
        double[] u = series(rate, force);
        Recording recording = new Recording(new Clock(0, rate), Map.of(FORCE, u), Metadata.NONE);
        return new Simulator(Excitation.of(model, recording, u.length)).outputs(model.assembly())[0];
    }

    private static double[] series(double rate, DoubleUnaryOperator force) {
        double[] u = new double[(int) (SECONDS * rate)];
        for (int j = 0; j < u.length; j++) {
            u[j] = force.applyAsDouble(j / rate);
        }
        return u;
    }

    private static Model.Body body(String name, double mass, Channel sensor, List<Drive> start) {
        return new Model.Body(name, mass, Optional.of(sensor), List.of(), Optional.empty(), start);
    }

    private static Model model(double stiffness, double damping, List<Law> laws, String read, List<Drive> start) {
        Channel sensor = new Channel("mass", Quantity.ofSymbol(read).orElseThrow(), 'z');
        return new Model("slider", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(body("mass", MASS, sensor, start)),
                List.of(new Model.Link("ground", "mass", stiffness, damping, Optional.empty(), laws, List.of())),
                List.of(new Model.Input("mass", FORCE)));
    }
}
