package wbv.body.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import wbv.body.Assembly;
import wbv.body.Drive;
import wbv.body.LawAt;
import wbv.body.SensorFault;
import wbv.body.Structure;
import wbv.body.law.BoucWen;
import wbv.body.law.BristleFriction;
import wbv.body.law.BumpStop;
import wbv.body.law.CoulombFriction;
import wbv.body.law.EngagingFriction;
import wbv.body.law.Law;
import wbv.body.law.LinkMotion;
import wbv.body.law.MaxwellArm;
import wbv.body.law.PolynomialSpring;
import wbv.body.law.QuadraticSpring;
import wbv.body.law.Slider;
import wbv.recording.Channel;
import wbv.recording.DataFault;

class DrivenLinksTest {

    private static final double RATE = 200;
    private static final int N = 1200;
    private static final Channel GIVEN = Channel.parse("other.force.z");

    static Stream<Law> laws() {
        return Stream.of(new EngagingFriction(900, 700, 0.004, 2.5), new QuadraticSpring(4e5),
                new PolynomialSpring(3e5, 2e7),
                new BristleFriction(300, 360, 0.05, 2e5), new CoulombFriction(200, 0.01), new BoucWen(0.4, 2e-3), new Slider(0.4, 2e-3),
                new BumpStop(9e5, 6e-3, Law.Side.BOTH), new MaxwellArm(40000, 0.05));
    }

    @ParameterizedTest
    @MethodSource("laws")
    void sensitivitiesEqualCentralDifferences(Law law) {
        Assembly assembly = assembly(law);
        double[] values = assembly.values();
        Simulator simulator = new Simulator(excitation(150));
        Simulator.Response response = simulator.run(assembly, true);
        for (int p = 0; p < values.length; p++) {
            if (p == 2) {
                continue;   // the mass of a fixed body
            }
            double h = 1e-5 * Math.max(Math.abs(values[p]), 1e-3);
            double kept = values[p];
            values[p] = kept + h;
            double[] high = simulator.run(assembly.with(values), false).outputs()[0];
            values[p] = kept - h;
            double[] low = simulator.run(assembly.with(values), false).outputs()[0];
            values[p] = kept;
            double error = 0;
            double size = 0;
            for (int k = 0; k < high.length; k++) {
                double slope = (high[k] - low[k]) / (2 * h);
                error += Math.pow(slope - response.slopes()[p][0][k], 2);
                size += slope * slope;
            }
            assertTrue(size > 0, law + " parameter " + p + " does nothing");
            assertTrue(Math.sqrt(error / size) < 2e-3, law + " parameter " + p + ": " + Math.sqrt(error / size));
        }
    }

    @Test
    void aLinearLinkCarriesItsSpringAndDashpotAlongAStrokeOfAnyLengthAndSlowness() {
        double[] y = new Simulator(excitation(Double.NaN)).outputs(new Assembly(structure(), List.of(), List.of(),
                List.of(output(List.of()))))[0];
        Stroke stroke = excitation(Double.NaN).stroke().orElseThrow();
        for (int j = 100; j < N - 100; j++) {
            assertEquals(-2000 * stroke.position()[j] - 300 * stroke.velocity()[j], y[j], 0.2);
        }
    }

    @Test
    void engagingFrictionIsFullAfterItsTravelAndGoneAfterAReversal() {
        Law law = new EngagingFriction(900, 700, 0.004, 2.5);
        LinkMotion m = new LinkMotion();
        double[] path = {0, 0.004, 0.01, 0.006, -0.02};
        double[] force = {0, 900, 900, 0, -700};
        for (int j = 1; j < path.length; j++) {
            m.before = path[j - 1];
            m.displacement = path[j];
            assertEquals(force[j], law.force(m), 1e-9);
            m.memory = law.remember(m);
        }
    }

    @ParameterizedTest
    @MethodSource("laws")
    void aLawWithMemoryStartsFromTheMeasuredForce(Law law) {
        if (law instanceof EngagingFriction || law instanceof BristleFriction) {
            LinkMotion m = new LinkMotion();
            m.step = 0.01;
            m.memory = law.memoryOf(-123);
            assertEquals(-123, law.force(m), 1e-6);
        }
    }

    @Test
    void aStrokeMustBeAPositionOrAVelocity() {
        Assembly assembly = assembly(new QuadraticSpring(1));
        DataFault fault = assertThrows(DataFault.class,
                () -> new Simulator(new Excitation(RATE, new double[N], Map.of())).run(assembly, false));
        assertTrue(fault.getMessage().contains("position or velocity"), fault.getMessage());
    }

    private static Assembly assembly(Law law) {
        return new Assembly(structure(), List.of(new LawAt(0, law)),
                List.of(new Assembly.DriveAt(0, new Drive.Given(GIVEN, 0.8))),
                List.of(output(List.of(new SensorFault.Bias(5)))));
    }

    private static Structure structure() {
        return new Structure(new int[] {-1}, new int[] {0}, new double[] {2000}, new double[] {300}, new double[] {1}, true);
    }

    private static Assembly.Output output(List<SensorFault> faults) {
        return new Assembly.Output(0, Assembly.Reading.LINK_FORCE, faults);
    }

    private static Excitation excitation(double start) {
        double[] x = new double[N];
        double[] given = new double[N];
        for (int j = 0; j < N; j++) {
            double t = j / RATE;
            x[j] = 0.012 * Math.sin(2 * Math.PI * 0.4 * t) + 0.004 * Math.sin(2 * Math.PI * 1.7 * t + 1);
            given[j] = 100 * Math.sin(2 * Math.PI * 0.9 * t + 0.3);
        }
        return Excitation.ofStroke(RATE, Stroke.ofPosition(x, 1 / RATE, start), Map.of(GIVEN, given));
    }
}
