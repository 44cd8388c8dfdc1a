package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import wbv.body.Drive;
import wbv.body.Model;
import wbv.body.ModelFile;
import wbv.body.SensorFault;
import wbv.body.law.CubicSpring;
import wbv.body.law.EngagingFriction;
import wbv.body.law.Law;
import wbv.body.law.PolynomialSpring;
import wbv.body.law.QuadraticSpring;
import wbv.recording.Channel;
import wbv.recording.Clock;
import wbv.recording.DataFault;
import wbv.recording.Metadata;
import wbv.recording.Recording;

class ForceInputTest {

    private static final double RATE = 400;
    private static final int N = 4000;
    private static final Channel FORCE = Channel.parse("mass.force.z");
    private static final Channel POSITION = Channel.parse("mass.pos.z");

    /** A Duffing oscillator under a multisine, against Runge and Kutta's fourth order at 20 steps a sample. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 4e8})
    void aForcedOscillatorMovesAsRungeAndKuttaSay(double cubic) {
        double m = 2;
        double k = 8000;
        double c = 25;
        double h = 1 / RATE / 20;
        double[] u = new double[N];
        double[] y = new double[N];
        double x = 0;
        double v = 0;
        for (int j = 0; j < N; j++) {
            u[j] = force(j / RATE);
            y[j] = x;
            for (int i = 0; i < 20; i++) {
                double t = j / RATE + i * h;
                double a1 = (force(t) - c * v - k * x - cubic * x * x * x) / m;
                double x2 = x + h / 2 * v;
                double v2 = v + h / 2 * a1;
                double a2 = (force(t + h / 2) - c * v2 - k * x2 - cubic * x2 * x2 * x2) / m;
                double x3 = x + h / 2 * v2;
                double v3 = v + h / 2 * a2;
                double a3 = (force(t + h / 2) - c * v3 - k * x3 - cubic * x3 * x3 * x3) / m;
                double x4 = x + h * v3;
                double v4 = v + h * a3;
                double a4 = (force(t + h) - c * v4 - k * x4 - cubic * x4 * x4 * x4) / m;
                x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
                v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
            }
        }
        List<Law> laws = cubic == 0 ? List.of() : List.of(new CubicSpring(cubic));
        Model model = oscillator(m, k, c, laws);
        double[] simulated = run(model, u);
        double error = 0;
        double size = 0;
        for (int j = 200; j < N - 200; j++) {
            error += Math.pow(simulated[j] - y[j], 2);
            size += y[j] * y[j];
        }
        assertTrue(Math.sqrt(error / size) < 4e-3, "error " + Math.sqrt(error / size));
    }

    @Test
    void anOffsetOfTheForceSensorPushesNothing() {
        double[] u = new double[N];
        java.util.Arrays.fill(u, 3);
        Model model = oscillator(2, 8000, 25, List.of());
        Model offset = new Model(model.name(), model.source(), 'z', model.base(), model.bodies(), model.links(),
                List.of(new Model.Input("mass", FORCE, 3)));
        assertEquals(0, run(offset, u)[N / 2], 1e-9);
        assertEquals(3 / 8000.0, run(model, u)[N / 2], 1e-6);
    }

    /** A steady push against a dashpot alone: velocity F / c. */
    @Test
    void aBodyHeldByADashpotAloneHasASteadyVelocity() {
        Channel speed = Channel.parse("rotor.vel.z");
        Model motor = new Model("motor", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(new Model.Body("rotor", 0.1, Optional.of(speed), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("ground", "rotor", 0, 0.5, Optional.empty(), List.of(), List.of())),
                List.of(new Model.Input("rotor", FORCE)));
        double[] u = new double[N];
        java.util.Arrays.fill(u, 1.5);
        assertEquals(3, run(motor, u)[N - 400], 3e-3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"vel", "pos"})
    void aBaseMovesTheSameWhicheverWayItsMotionWasMeasured(String quantity) {
        double[] a = new double[N];
        double[] moved = new double[N];
        for (int j = 0; j < N; j++) {
            double t = j / RATE;
            for (double w : new double[] {2 * Math.PI * 2, 2 * Math.PI * 5.3}) {
                a[j] += Math.sin(w * t);
                moved[j] += quantity.equals("vel") ? -Math.cos(w * t) / w : -Math.sin(w * t) / (w * w);
            }
        }
        double[] by = seat("acc", a);
        double[] as = seat(quantity, moved);
        for (int j = 1200; j < N - 400; j++) {
            assertEquals(by[j], as[j], 0.02);
        }
    }

    @Test
    void inputsFixedBodiesAndFaultsOfLinkSensorsSurviveTheFile() {
        Model forced = oscillator(2, 8000, 25, List.of(new PolynomialSpring(3, 4), new QuadraticSpring(5)));
        assertEquals(forced, ModelFile.parse(ModelFile.text(forced), "forced"));
        Model driven = new Model("damper", Optional.of("assumed"), 'z',
                new Model.Base("table", Optional.of(Channel.parse("table.pos.z"))),
                List.of(Model.Body.fixed("frame")),
                List.of(new Model.Link("table", "frame", 10, 20, Optional.of(Channel.parse("damper.force.z")),
                        List.of(new EngagingFriction(900, 700, 0.004, 2.5)),
                        List.of(new Drive.Given(Channel.parse("other.force.z"), 0.5)),
                        List.of(new SensorFault.Bias(2)))));
        assertEquals(driven, ModelFile.parse(ModelFile.text(driven), "driven"));
    }

    @ParameterizedTest
    @ValueSource(strings = {
        "\"sensor\": \"ground.acc.z\"}, \"inputs\": [{\"body\": \"mass\", \"sensor\": \"mass.force.z\"}]|must be at rest",
        "\"sensor\": null}, \"inputs\": [{\"body\": \"head\", \"sensor\": \"mass.force.z\"}]|'head', which is no body",
        "\"sensor\": null}, \"inputs\": [{\"body\": \"mass\", \"sensor\": \"mass.acc.z\"}]|must be a measured force",
        "\"sensor\": null}, \"inputs\": [{\"body\": \"mass\"}]|'sensor' names no channel"})
    void whatIsWrongWithAnInputIsSaid(String line) {
        String[] parts = line.split("\\|");
        String text = "{\"name\": \"n\", \"bodies\": [{\"name\": \"mass\", \"mass_kg\": 1, \"sensor\": \"mass.pos.z\"}], \"links\": "
                + "[{\"from\": \"ground\","
                + " \"to\": \"mass\", \"stiffness_N_per_m\": 1, \"damping_Ns_per_m\": 1}], \"base\": {\"name\": \"ground\", "
                + parts[0] + "}";
        DataFault fault = assertThrows(DataFault.class, () -> ModelFile.parse(text, "m.json"));
        assertTrue(fault.getMessage().contains(parts[1]), fault.getMessage());
    }

    private static double force(double t) {
        double fade = Math.min(1, t / 0.2);
        return fade * fade * (3 - 2 * fade) * (12 * Math.sin(2 * Math.PI * 7 * t) + 9 * Math.sin(2 * Math.PI * 11.3 * t + 1)
                + 5 * Math.sin(2 * Math.PI * 2 * t));
    }

    private static Model oscillator(double m, double k, double c, List<Law> laws) {
        return new Model("oscillator", Optional.empty(), 'z', new Model.Base("ground", Optional.empty()),
                List.of(new Model.Body("mass", m, Optional.of(POSITION), List.of(), Optional.empty(), List.of())),
                List.of(new Model.Link("ground", "mass", k, c, Optional.empty(), laws, List.of())),
                List.of(new Model.Input("mass", FORCE)));
    }

    private static double[] seat(String quantity, double[] base) {
        Channel input = Channel.parse("platform." + quantity + ".z");
        Model model = new Model("seat", Optional.empty(), 'z', new Model.Base("platform", Optional.of(input)),
                List.of(new Model.Body("seat", 50, Optional.of(Channel.parse("seat.acc.z")), List.of(), Optional.empty(),
                        List.of())),
                List.of(new Model.Link("platform", "seat", 60000, 1500, Optional.empty(), List.of(), List.of())));
        return run(model, input, base);
    }

    private static double[] run(Model model, double[] force) {
        return run(model, FORCE, force);
    }

    private static double[] run(Model model, Channel channel, double[] series) {
        Map<Channel, double[]> channels = new LinkedHashMap<>(Map.of(channel, series));
        Recording recording = new Recording(new Clock(0, RATE), channels, Metadata.NONE);
        return new Simulator(Excitation.of(model, recording, series.length)).outputs(model.assembly())[0];
    }
}
