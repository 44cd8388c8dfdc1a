package wbv.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import wbv.body.simulate.Excitation;
import wbv.body.simulate.Simulator;
import wbv.recording.Channel;
import wbv.recording.DataFault;

/** Models given as matrices, against the same model as bodies in a plane, and against Z⁻¹ solved outright. */
class MatrixFormTest {

    private static final double RATE = 100;
    private static final int SAMPLES = 600;

    @Test
    void isThePlaneThatItsMatricesComeFrom() {
        Model plane = ModelFile.parse(String.format(PlaneFormTest.MODEL, ""), "plane.json");
        Structure s = plane.assembly().structure();
        RealMatrix m = diagonal(s.mass());
        RealMatrix k = stiffness(s, s.stiffness());
        RealMatrix c = stiffness(s, s.damping());
        RealMatrix r = new Array2DRowRealMatrix(s.kinematics().carried());
        RealMatrix reads = new Array2DRowRealMatrix(4, 6);
        int row = 0;
        for (Assembly.Output output : plane.assembly().outputs()) {
            for (int i = 0; i < output.reads().at().length; i++) {
                reads.setEntry(row, output.reads().at()[i], output.reads().by()[i]);
            }
            row++;
        }
        double[][] expected = new Simulator(excitation()).outputs(plane.assembly());
        alike(expected, matrices(m, c, k, r, reads));
        // The same in coordinates of which M is full: q = T p.
        Random random = new Random(5);
        RealMatrix turn = new Array2DRowRealMatrix(6, 6);
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < 6; j++) {
                turn.setEntry(i, j, (i == j ? 1 : 0) + 0.2 * random.nextGaussian());
            }
        }
        RealMatrix by = turn.transpose();
        RealMatrix back = new LUDecomposition(turn).getSolver().getInverse();
        alike(expected, matrices(by.multiply(m).multiply(turn), by.multiply(c).multiply(turn), by.multiply(k).multiply(turn),
                back.multiply(r), reads.multiply(turn)));
    }

    @Test
    void joinsWhatItsEntriesJoin() {
        Model net = ModelFile.parse("""
                {"name": "net", "subject": "rig", "axis": "z", "base": {"name": "table", "sensors": ["table.acc.z"]},
                 "matrices": {"coordinates": ["a", "b"], "M": [[2, 0], [0, 3]], "C": [[5, -2], [-2, 2]],
                  "K": [[900, -400], [-400, 700]], "R": [[1], [1]],
                  "sensors": [{"sensor": "b.acc.z", "reads": [0, 1]}, {"sensor": "strain.pos.z", "reads": [-1, 1]}]}}
                """, "net.json");
        assertEquals("[a-b 400.0 2.0, table-a 500.0 3.0, table-b 300.0 0.0]", net.links().stream()
                .map(link -> link.name() + " " + link.stiffness() + " " + link.damping()).sorted().toList().toString());
        assertEquals(net, ModelFile.parse(ModelFile.text(net), "again.json"));
    }

    @Test
    void refusesWhatIsNoPassiveNet() {
        String text = """
                {"name": "net", "subject": "rig", "axis": "z", "base": {"name": "table", "sensors": ["table.acc.z"]},
                 "matrices": {"coordinates": ["a", "b"], "M": [[2, 0], [0, 3]], "C": [[5, 0], [0, 2]], "K": %s, "R": [[1], [1]]}}
                """;
        for (Map.Entry<String, String> each : Map
                .of("[[900, -400], [-300, 700]]", "'K' must be symmetric", "[[900, -900], [-900, 700]]", "must not give energy",
                        "[[1e16, -400], [-400, 700]]", "'K' is 1.0E16, which no body or link has; at most 1.0E15 is read",
                        "[[900, \"x\"], [-400, 700]]", "'K' must hold numbers only", "[[900, -400]]", "'K' must have 2 rows of 2 numbers",
                        "[{\"a\": 900}, [-400, 700]]", "'K' must hold numbers only")
                .entrySet()) {
            DataFault fault = assertThrows(DataFault.class, () -> ModelFile.parse(String.format(text, each.getKey()), "net.json"));
            assertTrue(fault.getMessage().contains(each.getValue()), fault.getMessage());
        }
    }

    private static void alike(double[][] expected, String text) {
        Model model = ModelFile.parse(text, "matrices.json");
        double[][] outputs = new Simulator(excitation()).outputs(model.assembly());
        for (int o = 0; o < outputs.length; o++) {
            double size = Arrays.stream(expected[o]).map(Math::abs).max().orElseThrow();
            assertEquals(4, outputs.length);
            for (int i = 0; i < SAMPLES; i++) {
                assertEquals(expected[o][i], outputs[o][i], 1e-6 * size, model.outputs().get(o) + " at " + i);
            }
        }
    }

    private static String matrices(RealMatrix m, RealMatrix c, RealMatrix k, RealMatrix r, RealMatrix reads) {
        String[] sensors = {"trunk.acc.z", "trunk.gyr.y", "head.acc.z", "sternum.acc.x"};
        return "{\"name\": \"of matrices\", \"subject\": \"rig\", \"axis\": \"z\", \"base\": {\"name\": \"floor\", \"sensors\": "
                + "[\"floor.acc.z\", \"floor.acc.x\", \"floor.gyr.y\"]}, \"matrices\": {\"coordinates\": [\"a\", \"b\", \"c\", \"d\", "
                + "\"e\", \"f\"], \"M\": " + text(m) + ", \"C\": " + text(c)
                + ", \"K\": " + text(k) + ", \"R\": " + text(r)
                + ", \"sensors\": "
                + IntStream.range(0, 4)
                        .mapToObj(i -> "{\"sensor\": \"" + sensors[i] + "\", \"reads\": " + Arrays.toString(reads.getRow(i)) + "}").toList()
                + "}}";
    }

    private static String text(RealMatrix matrix) {
        return Arrays.stream(matrix.getData()).map(row -> Arrays.stream(row).mapToObj(value -> String.format(Locale.ROOT, "%.17g", value))
                .collect(Collectors.joining(", ", "[", "]"))).collect(Collectors.joining(", ", "[", "]"));
    }

    private static RealMatrix stiffness(Structure s, double[] values) {
        RealMatrix out = new Array2DRowRealMatrix(s.bodies(), s.bodies());
        for (int l = 0; l < s.links(); l++) {
            for (int i = 0; i < s.bodies(); i++) {
                for (int j = 0; j < s.bodies(); j++) {
                    out.addToEntry(i, j, s.incidence(i, l) * s.incidence(j, l) * values[l]);
                }
            }
        }
        return out;
    }

    private static RealMatrix diagonal(double[] values) {
        RealMatrix out = new Array2DRowRealMatrix(values.length, values.length);
        IntStream.range(0, values.length).forEach(i -> out.setEntry(i, i, values[i]));
        return out;
    }

    private static Excitation excitation() {
        Random random = new Random(11);
        double[][] base = new double[3][SAMPLES];
        for (double[] axis : base) {
            for (int i = 20; i < SAMPLES - 100; i++) {
                axis[i] = 1e-6 * random.nextGaussian();   // small motions, which matrices are of
            }
        }
        Map<Channel, double[]> others = new HashMap<>();
        return new Excitation(RATE, base, others);
    }
}
